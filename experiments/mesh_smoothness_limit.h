#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// The part of the experiment mesh-smoothness about all valences at once: Catmull and Clark's scheme, and
/// the limit of the upper ends of the ranges of s.
[[nodiscard]] std::vector<ClaimHead> valence_limit_heads();
void add_valence_limits(Results& results, std::span<const ClaimHead> heads);

}  // namespace subdiv
