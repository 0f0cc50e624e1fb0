#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Surfaces over grids and their popping (js-report 9, 13, 14; jsplines 10, 11): footprint and work of
/// Ringing on surfaces, counted; topology of what comes out; geomorphs; silhouettes of consecutive levels;
/// figures 11, 15 and 16 of js-report, which are 16, 11 and 12 of jsplines.
[[nodiscard]] std::span<const ClaimHead> surface_heads();
[[nodiscard]] Results run_surfaces();

/// The figures and the series behind them.
void add_surface_figures(Results& results);

}  // namespace subdiv
