#pragma once

#include <vector>

#include "analysis/basis_piece.h"
#include "analysis/uniform_bspline.h"
#include "optimize/problem.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/taylor.h"

namespace subdiv {

/// The family phi_s of basis functions of *J_s beside a target B_d, as functions of s: e(s, t) = phi_s(t) -
/// B_d(t), even in t.
struct FitFamily {
  BasisTables<RationalFunction> tables;  ///< of phi_s over Q(s)
  UniformBspline bspline;                ///< B_d
  long precision;                        ///< of enclosures, in bits
};
/// The family for a target degree >= 0, with enclosures at a precision in bits.
[[nodiscard]] FitFamily fit_family(int degree, long precision);

/// A function G of s that never exceeds the objective F, the L1 or Linf norm of e(s, .), wherever it is
/// evaluated:
///   l1:   G(s) = 2 * integral over t > 0 of sigma(t) e(s, t), sigma = signs_j on [points_j, points_{j+1}].
///   When repeats is not
///         0, the points end at 5/2 and sigma(3 - u) = repeats * sigma(3 - 2u) for u <= 1/2. As phi_s(3 - u)
///         = c_3 phi_s(3 - 2u) there, c_3 the mask's last coefficient, that part is a geometric series (B_d
///         must vanish from t = 2 on). Otherwise they end at 3.
///   linf: G(s) = signs_0 * e(s, points_0).
/// So a lower bound of G proves one of F, whatever the points are; they are chosen so that G touches F at one
/// s.
struct FitFunctional {
  Norm norm = Norm::l1;          ///< l1 or linf
  std::vector<Rational> points;  ///< dyadic, ascending; for l1 from 0 on
  std::vector<int> signs;        ///< 1 or -1; for l1 one fewer than points
  int repeats = 0;               ///< of the geometric series; 0 for none
};

/// The Taylor coefficients G, G', G''/2, .. at s, N = 2 or 3 of them; over a ball s the last encloses its
/// values on all of it.
template <std::size_t N>
[[nodiscard]] Taylor<Interval, N> evaluate(const FitFamily& family, const FitFunctional& g,
                                           const Interval& s);

/// Functionals that touch the objective at s, as far as points of spacing 2^-depth can: for l1 the one that
/// has the signs of e(s, .); for linf one for each of the largest local maxima of |e(s, .)|, largest first.
/// Approximate: good guesses that prove nothing by themselves.
[[nodiscard]] std::vector<FitFunctional> touching_functionals(const FitFamily& family, Norm norm,
                                                              const Rational& s, int depth);

}  // namespace subdiv
