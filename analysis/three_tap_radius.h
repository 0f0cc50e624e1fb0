#pragma once

#include <string>
#include <vector>

#include "analysis/jsr/word.h"
#include "analysis/parametric_polytope.h"

namespace subdiv {

/// The joint spectral radius rho(p) of the symmetric mask b(z) = p + (1 - 2p) z + p z^2 of arity 2, in closed
/// form for every real p. Its transition matrices, which decide the smoothness of every symbol 2 ((1+z)/2)^n
/// b(z), are
///
///     T_0 = [p 0; p 1-2p],  T_1 = [1-2p p; 0 p].
///
/// On each of five intervals of p one product of these matrices has the spectral radius rho^k, and a polytope
/// proves that no product exceeds it.
struct RadiusPiece {
  RealInterval range;           ///< of p, closed
  RationalFunction p;           ///< as a function of the piece's own parameter u = x_0
  RealInterval parameters;      ///< of u, sent to the range monotonically
  RationalFunction radius;      ///< rho as a function of u
  Word word;                    ///< its product has the eigenvalue +-radius^|word|
  ParametricPolytope polytope;  ///< shows that the radius is not larger
  std::string shape;            ///< "hexagon", "diamond", "octagon"
};

/// The five pieces, ascending. Each is proved when this is called; std::logic_error should a proof fail.
[[nodiscard]] const std::vector<RadiusPiece>& three_tap_radius_pieces();

/// rho(p), exact.
[[nodiscard]] Algebraic three_tap_radius(const Algebraic& p);

/// All real p with rho(p) < bound, exact.
[[nodiscard]] RealSet three_tap_radius_below(const Rational& bound);

/// The matrices for p = x_0 and the vertices (1,0), (0,1), (1,1) of a hexagon that serves for all p at once.
[[nodiscard]] std::vector<Matrix<RationalFunction>> three_tap_matrices();

/// A number N such that T_0(p) and T_1(p) map the hexagon conv +-{(1,0), (0,1), (1,1)} into N times itself
/// for every p in [lower, upper]: in the norm with this unit ball, any product of k of these matrices, each
/// with a p of its own, is at most N^k. N(p) = 1 - 2p, 1 - p, p and 2p - 1 on (-inf, 0], [0, 1/2], [1/2, 1]
/// and [1, inf), where it is proved.
[[nodiscard]] Rational three_tap_common_norm(const Rational& lower, const Rational& upper);

}  // namespace subdiv
