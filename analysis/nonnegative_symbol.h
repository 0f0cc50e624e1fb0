#pragma once

#include "analysis/decision.h"
#include "analysis/enclosure.h"
#include "analysis/transition_matrices.h"

namespace subdiv {

/// Whether b is symmetric and, centred, b(e^(it)) >= 0 for all t: decided by the real roots of b as a
/// polynomial in cos t.
[[nodiscard]] bool is_nonnegative(const NormalForm<Rational>& form);

/// The joint spectral radius of the transition matrices of a non-negative symbol: the spectral radius of the
/// single matrix (c_{m i - j}), |i|, |j| <= K, c_k the centred coefficients; for then the largest coefficient
/// of each iterate is the central one (Rioul, SIAM J. Math. Anal. 23, 1992, section 9). Throws
/// std::domain_error when the symbol is not non-negative.
[[nodiscard]] Enclosure nonnegative_radius(const NormalForm<Rational>& form);

}  // namespace subdiv
