#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Limit and tangent masks, open ends, and retrofitting (js-report 5, 11; jsplines 5, 9).
[[nodiscard]] std::span<const ClaimHead> limit_mask_heads();
[[nodiscard]] Results run_limit_masks();

}  // namespace subdiv
