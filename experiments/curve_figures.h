#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// The figures of curves in the documents (js-report 1 .. 10, 12, 13; jsplines 1 .. 10, 15; notes 2 .. 4), on
/// polygons of this project in place of the lost ones, each with a number.
[[nodiscard]] std::span<const ClaimHead> curve_figure_heads();
[[nodiscard]] Results run_curve_figures();

}  // namespace subdiv
