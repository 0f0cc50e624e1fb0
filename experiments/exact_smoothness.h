#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Where limits of J_s are C^m, for all s at once, by the joint spectral radius of two 2 x 2 matrices; and
/// what follows for sequences of different s (jsplines 3, 11).
[[nodiscard]] std::span<const ClaimHead> exact_smoothness_heads();
[[nodiscard]] Results run_exact_smoothness();

}  // namespace subdiv
