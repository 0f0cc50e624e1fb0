#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Continuity of J_s by eigenvalues and by norms of iterates (js-report 3, jsplines 3).
[[nodiscard]] std::span<const ClaimHead> smoothness_heads();
[[nodiscard]] Results run_smoothness();

}  // namespace subdiv
