#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "schemes/evaluate/control_polygon.h"
#include "schemes/evaluate/level_by_level.h"

namespace subdiv {

/// A grid of control points (js-report 13): each row is the control polygon of a trajectory, and the points
/// that all rows have at one time form the control polygon of a transversal curve. Either direction is closed
/// or open; rows added at the ends of an open `rows` direction are rows like all others. Closed in both the
/// surface is a torus, in one a cylinder, in none a disk.
template <class Point>
struct ControlGrid {
  Topology rows;                             ///< how the rows follow each other
  std::vector<ControlPolygon<Point>> lines;  ///< the rows, element i in slot i, all of the same topology

  /// How the points of each row follow each other.
  [[nodiscard]] Topology columns() const { return lines.empty() ? Topology{} : lines.front().topology; }
  /// The point in a row and a column, both from 0, added ones included.
  [[nodiscard]] const Point& at(long long row, long long column) const {
    return lines[rows.slot(row)].at(column);
  }
};

/// A grid from its points, row after row. Throws std::invalid_argument when their number is not rows x
/// columns.
template <class Point>
ControlGrid<Point> control_grid(const Topology& rows, const Topology& columns, std::vector<Point> points) {
  if (points.size() != rows.points * columns.points)
    throw std::invalid_argument("a grid of " + std::to_string(rows.points) + " rows of " +
                                std::to_string(columns.points) + " points has no " +
                                std::to_string(points.size()) + " points");
  ControlGrid<Point> grid{rows, {}};
  for (std::size_t row = 0; row < rows.points; ++row) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(row * columns.points);
    grid.lines.push_back({columns, {begin, begin + static_cast<std::ptrdiff_t>(columns.points)}});
  }
  return grid;
}

/// Throws std::invalid_argument unless the rows are as many as their topology says and all alike.
template <class Point>
void require_grid(const ControlGrid<Point>& grid) {
  if (grid.lines.size() != grid.rows.points)
    throw std::invalid_argument("a grid has " + std::to_string(grid.lines.size()) + " rows instead of " +
                                std::to_string(grid.rows.points));
  for (std::size_t row = 0; row < grid.lines.size(); ++row) {
    const ControlPolygon<Point>& line = grid.lines[row];
    if (!(line.topology == grid.columns()) || line.points.size() != line.topology.points)
      throw std::invalid_argument("row " + std::to_string(row) + " of a grid differs from the first in size");
  }
}

/// Rows become columns.
template <class Point>
ControlGrid<Point> transposed(const ControlGrid<Point>& grid) {
  ControlGrid<Point> result{grid.columns(), {}};
  for (std::size_t column = 0; column < result.rows.points; ++column) {
    ControlPolygon<Point> line{grid.rows, {}};
    for (const ControlPolygon<Point>& row : grid.lines) line.points.push_back(row.points[column]);
    result.lines.push_back(std::move(line));
  }
  return result;
}

/// How often and by which scheme one direction of a grid is refined.
template <class R>
struct Refinement {
  Scheme<R> scheme;  ///< with which
  int depth = 0;     ///< how many steps
};

/// The tensor product, level by level: all rows are refined by `along`, then all columns of the result by
/// `across`. Throws as refine_level_by_level does.
template <class R, class Point>
ControlGrid<Point> refine_grid_level_by_level(ControlGrid<Point> grid, const Refinement<R>& along,
                                              const Refinement<R>& across) {
  require_grid(grid);
  const auto refine_lines = [](ControlGrid<Point>& g, const Refinement<R>& r) {
    for (ControlPolygon<Point>& line : g.lines)
      line = refine_level_by_level(r.scheme, std::move(line), r.depth);
  };
  refine_lines(grid, along);
  ControlGrid<Point> columns = transposed(grid);
  refine_lines(columns, across);
  return transposed(columns);
}

}  // namespace subdiv
