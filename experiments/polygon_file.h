#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace subdiv {

/// The points of a file, one array a coordinate, in the order of the curve.
template <class T>
struct PointList {
  std::vector<std::vector<T>> coordinates;
  std::vector<std::string> header;  // the names of the columns of a CSV file that has them
  /// What a line element of an OBJ file says: closed when it returns to its first point.
  std::optional<bool> closed;

  [[nodiscard]] std::size_t size() const { return coordinates.empty() ? 0 : coordinates.front().size(); }
  [[nodiscard]] std::size_t dimension() const { return coordinates.size(); }
};

/// Reads the points of a polygon or grid, T = double or Rational. A .csv file holds a point a line, its
/// coordinates separated by commas, after an optional header; a .obj file holds vertices "v x y z", and the
/// first line element "l 1 2 .." gives their order when there is one. Numbers are integers, decimals or p/q;
/// blank lines and those that begin with # do not count. Throws InputError with file and line for anything
/// else: lines of different lengths, NaN and infinities, indices without a vertex, faces, no points at all.
template <class T>
[[nodiscard]] PointList<T> read_points(const std::filesystem::path& path);

}  // namespace subdiv
