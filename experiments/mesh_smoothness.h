#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// The eigenvalue condition at extraordinary vertices (jsplines 10; notes 4, 5): exact ranges of s for each
/// valence, and Loop's, Catmull and Clark's and the butterfly scheme.
[[nodiscard]] std::span<const ClaimHead> mesh_smoothness_heads();
[[nodiscard]] Results run_mesh_smoothness();

}  // namespace subdiv
