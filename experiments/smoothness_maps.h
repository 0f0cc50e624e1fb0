#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Continuity of J_{a,b} over both parameters: where limits are C2, exact ranges on exceptional lines, and
/// certified maps of C0 and C1 (jsplines 6).
[[nodiscard]] std::span<const ClaimHead> smoothness_map_heads();
[[nodiscard]] Results run_smoothness_maps();

}  // namespace subdiv
