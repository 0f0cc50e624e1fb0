#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// Ringing: its footprint and work, counted; the same curve as level-by-level refinement; the printed code
/// and captions (js-report 12, 14, appendix).
[[nodiscard]] std::span<const ClaimHead> ringing_heads();
[[nodiscard]] Results run_ringing();

}  // namespace subdiv
