#pragma once

#include "analysis/enclosure.h"
#include "analysis/joint_spectral_radius.h"
#include "analysis/transition_matrices.h"

namespace subdiv {

/// The Sobolev exponent sup { s : the basis function has s derivatives in L_2 } of a scheme with the symbol's
/// normal form, when its shifts are independent:
///
///   s = n - 1/2 - 1/2 log_m rho(M),   M = (r_{m i - j}), |i|, |j| <= K,   r(z) = b(z) b(1/z),
///
/// n the number of factors, rho(M) the largest eigenvalue of the transfer operator (Eirola, SIAM J. Math.
/// Anal. 23, 1992; Villemoes, SIAM J. Math. Anal. 23, 1992). The Hoelder exponent lies in [s - 1/2, s].
/// Where coefficients are intervals that do not exclude further factors, rho(M) tells s only above 1/m.
[[nodiscard]] Enclosure sobolev_exponent(const NormalForm<Rational>& form,
                                         const JointSpectralRadiusBudget& budget = {});
/// The same for symbols known as intervals: encloses the exponents of all symbols in them.
[[nodiscard]] Enclosure sobolev_exponent(const NormalForm<Interval>& form,
                                         const JointSpectralRadiusBudget& budget = {});

}  // namespace subdiv
