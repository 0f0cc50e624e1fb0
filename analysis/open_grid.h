#pragma once

#include "analysis/open_polygon.h"
#include "schemes/evaluate/control_grid.h"

namespace subdiv {

/// Opens a grid along its rows (js-report 13): to every row, taken without points added before, the points
/// are added that the weights say. Throws as with_ends does.
template <class R, class Point>
ControlGrid<Point> open_along(const ControlGrid<Point>& grid, const EndWeights<R>& weights) {
  ControlGrid<Point> result{grid.rows, {}};
  for (const ControlPolygon<Point>& line : grid.lines)
    result.lines.push_back(with_ends(curve_points(line), weights));
  return result;
}

/// The same across: rows are added at both ends.
template <class R, class Point>
ControlGrid<Point> open_across(const ControlGrid<Point>& grid, const EndWeights<R>& weights) {
  return transposed(open_along(transposed(grid), weights));
}

}  // namespace subdiv
