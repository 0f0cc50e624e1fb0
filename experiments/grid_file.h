#pragma once

#include <cstddef>
#include <filesystem>

#include "experiments/polygon_file.h"

namespace subdiv {

/// The points of a grid, row after row: point (i, j) is number i columns + j.
template <class T>
struct GridPoints {
  std::size_t rows = 0;
  std::size_t columns = 0;
  PointList<T> points;
};

/// Whether the header of a CSV file says that it holds a grid: its first columns are row and column.
template <class T>
[[nodiscard]] bool holds_grid(const PointList<T>& points);

/// The grid of a file with the columns row, column and coordinates, both counted from 0, row after row, as
/// many points in each. T = double or Rational. Throws InputError that names the file and the point that is
/// not the next one.
template <class T>
[[nodiscard]] GridPoints<T> grid_points(PointList<T> points, const std::filesystem::path& path);

}  // namespace subdiv
