#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/real_set.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// A polytope P(p) = conv(+-v_1, .., +-v_N) in R^n whose vertices move with one parameter p = x_0, with the
/// reason why matrices T_0(p), T_1(p), .. map it into factor(p) times itself:
///
///     T_i v_j = sum over k of (c_i)_{kj} v_k,    sum over k of |(c_i)_{kj}| <= factor.
///
/// Where that holds and the vertices span R^n, P is the unit ball of a norm in which every T_i(p) is at most
/// factor(p): the joint spectral radius of the family is at most factor(p), and products are bounded by
/// powers of it, also products that take a different p for every matrix when P does not depend on p.
struct ParametricPolytope {
  std::vector<Matrix<RationalFunction>> matrices;      ///< n x n each
  Matrix<RationalFunction> vertices;                   ///< n x N, one vertex a column
  std::vector<Matrix<RationalFunction>> combinations;  ///< N x N each, one for each matrix
  RationalFunction factor;  ///< how much the polytope shrinks: below 1 in a proof of contraction
};

/// closed: sums <= factor, radius <= factor; interior: sums < factor, radius < factor.
enum class Containment { closed, interior };

/// What keeps the polytope from being a proof for every p in the range ("T_1 v_3 is not its combination",
/// ..); nothing when it is one. Identities are checked over Q(p), inequalities by exact root isolation on the
/// whole range, for every choice of signs that the coefficients may take there. At most 12 coefficients of a
/// vertex may change their sign.
[[nodiscard]] std::optional<std::string> find_flaw(const ParametricPolytope& polytope,
                                                   const RealInterval& range,
                                                   Containment containment = Containment::closed);

/// The coefficients of x in a basis of n of the vertices (Cramer's rule over Q(p)), zero elsewhere; nothing
/// when these vertices are dependent over Q(p).
[[nodiscard]] std::optional<Vector<RationalFunction>> combine(const Matrix<RationalFunction>& vertices,
                                                              const std::vector<int>& basis,
                                                              const Vector<RationalFunction>& x);

/// The polytope with combinations that are near the best ones at p = at: floating point proposes bases, the
/// coefficients are exact. Nothing when the vertices do not span there. It proves nothing before find_flaw.
[[nodiscard]] std::optional<ParametricPolytope> propose_combinations(
    std::vector<Matrix<RationalFunction>> matrices, Matrix<RationalFunction> vertices,
    RationalFunction factor, const Rational& at);

/// A polytope without a flaw on a range.
struct PolytopeProof {
  RealInterval range;           ///< of p, where the polytope has no flaw
  ParametricPolytope polytope;  ///< and its combinations
};

/// Proofs for ranges that cover the given one, made by bisection with proposed combinations; nothing when
/// that takes more than `most` ranges. Both ends of the range are finite; its midpoints are rational.
[[nodiscard]] std::optional<std::vector<PolytopeProof>> prove_containment(
    const std::vector<Matrix<RationalFunction>>& matrices, const Matrix<RationalFunction>& vertices,
    const RationalFunction& factor, const RealInterval& range, Containment containment, int most = 16);

/// Whether value(p) is an eigenvalue of the matrix for every p: a zero of the characteristic polynomial over
/// Q(p).
[[nodiscard]] bool is_eigenvalue(const Matrix<RationalFunction>& matrix, const RationalFunction& value);

}  // namespace subdiv
