#pragma once

#include <string>

#include "schemes/algebra/matrix.h"
#include "schemes/evaluate/control_grid.h"

namespace subdiv {

using SpacePoint = Eigen::Matrix<Rational, 3, 1>;

/// A grid committed in experiments/data, closed in both directions, exact coordinates. Throws as read_points
/// and grid_points do.
[[nodiscard]] ControlGrid<SpacePoint> grid_from_data(const std::string& file_name);

/// The same grid in another arithmetic: every point is sent through the map.
template <class Point, class Map>
auto map_points(const ControlGrid<Point>& grid, Map map) {
  using Image = decltype(map(grid.lines[0].points[0]));
  ControlGrid<Image> result{grid.rows, {}};
  for (const ControlPolygon<Point>& line : grid.lines) {
    ControlPolygon<Image> image{line.topology, {}};
    for (const Point& p : line.points) image.points.push_back(map(p));
    result.lines.push_back(std::move(image));
  }
  return result;
}

/// In double.
[[nodiscard]] Eigen::Vector3d rounded(const SpacePoint& p);

}  // namespace subdiv
