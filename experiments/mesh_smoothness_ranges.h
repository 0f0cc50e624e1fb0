#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// The part of the experiment mesh-smoothness about ranges of s: where the condition on the eigenvalues
/// begins and ends at each valence, the conjecture of jsplines 10, and the formula as printed.
[[nodiscard]] std::vector<ClaimHead> mesh_range_heads();
void add_mesh_ranges(Results& results, std::span<const ClaimHead> heads);

}  // namespace subdiv
