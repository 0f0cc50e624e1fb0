#pragma once

#include <optional>

#include "analysis/mesh/spectral_condition.h"

namespace subdiv {

/// An end of the condition on the eigenvalues (spectral_condition.h) with many digits: the parameter at which
/// another eigenvalue, or a pair of complex ones, reaches the modulus of lambda.
struct ConditionEnd {
  Interval at;  ///< the only s of the cell with |rival| = lambda
  /// Whether the condition holds for parameters just below the end, and fails above.
  bool holds_below = false;
  Rival rival;  ///< its mode is proved, its value computed; `subdominant` is lambda, computed
};

/// Proved for the cell [lower, upper]: the condition holds on exactly one side of `at`, which is the only s
/// with a tie, and is enclosed to about 40 digits. The proof has three parts.
///
///   On the whole cell all eigenvalues but lambda and the rival (two when it is complex) lie inside one
///   circle (SpectralCondition::beyond).
///   Lambda and the rival are simple roots z(s) of their factors: Krawczyk's test for one complex unknown and
///   all s at once (Neumaier, Interval Methods for Systems of Equations, theorem 5.1.8) encloses them, and
///   z' = -P_s/P_x their derivatives.
///   g = |rival|^2 - lambda^2 is monotone: its derivative has no zero. Newton's method for intervals then
///   finds its zero (lower and upper have different signs).
///
/// Nothing when a part fails: the cell is too wide, or there is no such end in it, or the rival is a second
/// real eigenvalue of mode 1 that meets lambda.
[[nodiscard]] std::optional<ConditionEnd> condition_end(const SpectralCondition& condition,
                                                        const Rational& lower, const Rational& upper);

}  // namespace subdiv
