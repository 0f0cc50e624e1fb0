#pragma once

#include <optional>

#include "analysis/uniform_bspline.h"
#include "optimize/problem.h"
#include "schemes/mask.h"

namespace subdiv {

/// The centred B-spline of degree d moved to `centre`, an integer or half an integer: as a scheme of two
/// steps over any ring, whatever the parity of d. Throws std::domain_error for other centres and for d < 0.
[[nodiscard]] Scheme<RationalFunction> bspline_at(int degree, const Rational& centre);

/// The squared L2 distance of the scheme's basis function phi from B_d moved to `centre`: the rational
/// function <phi, phi> - 2 <phi, B_d> + <B_d, B_d> of the scheme's parameters, by exact inner products. Arity
/// 2; throws std::domain_error when the inner products are not determined.
[[nodiscard]] RationalFunction squared_distance(const Scheme<RationalFunction>& scheme, int degree,
                                                const Rational& centre);

/// Where a squared distance, a function of one parameter that is never negative and has no pole in the range,
/// is 0: the exact answer to its minimisation, and to that of every other norm of the same difference.
/// Nothing when it has no zero or several.
[[nodiscard]] std::optional<Summary> only_zero(const RationalFunction& distance, const Range& range);

/// The range of s where *J_s is known to be C^1 (js-report 3), so that phi_s exists.
[[nodiscard]] Range jspline_fit_range();

/// Minimises over s in `range` the L1 or Linf norm of phi_s - B_d over the real line, phi_s the basis
/// function of *J_s.
///
/// The proof has three parts. (1) An upper bound U of the minimum: the norm at one rational s0
/// (bspline_distance.h). (2) Near s0, functionals G(s) = integral of sigma (phi_s - B_d), |sigma| <= 1 fixed,
/// or G(s) = +-(phi_s - B_d)(tau), tau fixed, bound the norm from below for every s; a walk from s0 +-
/// width/2 outward, by Taylor's theorem with remainder in ball arithmetic, shows G > U. (3) Farther away, the
/// sum of |integrals over cells of width 1/64|, or the largest |value| at multiples of 1/64, bounds the norm
/// from below: branch and bound (one_parameter.h). So every minimiser in the range lies within width/2 of s0.
/// Where phi_s is B_d for one s the answer is exact, and 0.
///
/// options.width is the width of the minimiser's enclosure. Throws InputError for degrees outside 1 .. 5 and
/// for ranges outside jspline_fit_range(). Termination: proved; or not_isolated, when a part of the proof
/// fails, for instance as the minimiser is an end of the range or above 3.
[[nodiscard]] Summary minimise_continuum_fit(int degree, Norm norm, const Range& range,
                                             const Options& options = {});

}  // namespace subdiv
