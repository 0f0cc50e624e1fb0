#pragma once

#include "analysis/enclosure.h"
#include "analysis/three_tap_radius.h"

namespace subdiv {

// Smoothness of the stationary schemes with the symbol 2 ((1+z)/2)^n (p + (1-2p) z + p z^2), n >= 1, for all
// data, over all real p. With rho(p) as in three_tap_radius.h:
//
// - The differences of the m-th divided differences, m <= n - 1, are refined with the radius max(1/2,
// 2^(m-n+1) rho):
//   the scheme is C^m exactly when rho < 2^(n-1-m), and its Hoelder exponent is n - 1 - log2 rho. The
//   polytopes have interior points, so that normalised products are bounded and an exponent that is no
//   integer is attained.
// - At p = 1/4 the last factor is ((1+z)/2)^2: the limits are splines of degree n + 1, exponent n + 1.
// - The shifts of the basis function are unstable at p = 1/2 and p = 1 only (unstable_conditions.h). The
// symbols are those
//   of ((1+z)/2)^(n+1) and ((1+z)/2)^n times t(z^2)/t(z), t = (1+z)/2 and (1+z+z^2)/3: limits are
//   combinations of B-splines of degree n and n - 1, as smooth as the scheme. So everything here holds for
//   the scheme and for its limits.

/// All p for which the limits are C^continuity, continuity >= 0: an open interval, the point 1/4, or nothing.
/// Throws std::domain_error for n < 1 or a negative order.
[[nodiscard]] RealSet three_tap_continuity_set(int factors, int continuity);

/// The Hoelder exponent for one p: exact where it is rational, else certified; the closed form as text, such
/// as "3-log2(1311/1000)". Divergent schemes (rho >= 2^(n-1)) have none: std::domain_error.
[[nodiscard]] Enclosure three_tap_exponent(int factors, const Algebraic& p);

/// The largest m with C^m limits; -1 when the scheme diverges.
[[nodiscard]] int three_tap_continuity(int factors, const Algebraic& p);

/// n - log2 x as an answer: exact when x is a power of two.
[[nodiscard]] Enclosure minus_log2(int n, const Algebraic& x);

}  // namespace subdiv
