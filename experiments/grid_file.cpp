#include "experiments/grid_file.h"

#include <string>
#include <utility>

#include "schemes/algebra/rational.h"
#include "schemes/input_error.h"

namespace subdiv {

template <class T>
bool holds_grid(const PointList<T>& points) {
  return points.header.size() > 2 && points.header[0] == "row" && points.header[1] == "column";
}

template <class T>
GridPoints<T> grid_points(PointList<T> points, const std::filesystem::path& path) {
  if (!holds_grid(points)) throw InputError(path.string() + ": expected the columns row,column,x,y,z");
  const std::vector<T>& row = points.coordinates[0];
  const std::vector<T>& column = points.coordinates[1];
  const T first(0);
  GridPoints<T> grid;
  while (grid.columns < points.size() && row[grid.columns] == first) ++grid.columns;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool next = grid.columns > 0 && row[i] == T(static_cast<int>(i / grid.columns)) &&
                      column[i] == T(static_cast<int>(i % grid.columns));
    if (!next) {
      throw InputError(path.string() + ": point " + std::to_string(i + 1) +
                       " is not the next one of a grid: rows follow each other, counted from 0, and so do "
                       "the columns in each, as many as in the first");
    }
  }
  grid.rows = count / grid.columns;
  if (count % grid.columns != 0)
    throw InputError(path.string() + ": the last row has fewer points than the first");
  points.coordinates.erase(points.coordinates.begin(), points.coordinates.begin() + 2);
  points.header.erase(points.header.begin(), points.header.begin() + 2);
  grid.points = std::move(points);
  return grid;
}

template bool holds_grid<double>(const PointList<double>&);
template bool holds_grid<Rational>(const PointList<Rational>&);
template GridPoints<double> grid_points<double>(PointList<double>, const std::filesystem::path&);
template GridPoints<Rational> grid_points<Rational>(PointList<Rational>, const std::filesystem::path&);

}  // namespace subdiv
