#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Continuity of the curves that the papers name or recommend, with Hoelder exponents (js-report 2 .. 8,
/// jsplines 2 .. 12).
[[nodiscard]] std::span<const ClaimHead> named_smoothness_heads();
[[nodiscard]] Results run_named_smoothness();

}  // namespace subdiv
