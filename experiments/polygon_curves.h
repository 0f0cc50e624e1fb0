#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// What the documents say of curves on polygons in general ("usually", "typically", "works well"), measured
/// on the committed family of simple polygons (experiments/simple_polygons.h).
[[nodiscard]] std::span<const ClaimHead> polygon_curve_heads();
[[nodiscard]] Results run_polygon_curves();

/// Parts of the experiment, each settling its own heads.
/// Areas of limit curves (js-report 1, 8; jsplines 8).
[[nodiscard]] Results run_polygon_areas();
/// Disparity of consecutive levels (js-report 9; jsplines 11).
[[nodiscard]] Results run_polygon_popping();
/// Iterations of retrofitting (js-report 5; jsplines 5).
[[nodiscard]] Results run_polygon_retrofits();
/// Approximations of quadratic B-splines and of mid-edge points (js-report 4, 7; jsplines 4, 7).
[[nodiscard]] Results run_polygon_fits();

}  // namespace subdiv
