#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Exact ranges of the tension of the two schemes that the papers compare with: the four-point scheme and the
/// dual four-point scheme of Dyn, Floater & Hormann (js-report 2, jsplines 2).
[[nodiscard]] std::span<const ClaimHead> tension_range_heads();
[[nodiscard]] Results run_tension_ranges();

}  // namespace subdiv
