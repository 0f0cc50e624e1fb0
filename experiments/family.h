#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// The family J_{a,b} itself: its members, its symbol, what its parameters blend (js-report 1, 3, 4; jsplines
/// 1, 3, 4).
[[nodiscard]] std::span<const ClaimHead> family_heads();
[[nodiscard]] Results run_family();

}  // namespace subdiv
