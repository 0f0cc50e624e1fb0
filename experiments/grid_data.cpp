#include "experiments/grid_data.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "experiments/data.h"
#include "experiments/grid_file.h"
#include "schemes/input_error.h"

namespace subdiv {

ControlGrid<SpacePoint> grid_from_data(const std::string& file_name) {
  const std::filesystem::path path = data_folder() / file_name;
  const GridPoints<Rational> grid = grid_points(read_points<Rational>(path), path);
  if (grid.points.dimension() != 3)
    throw InputError(path.string() + ": expected the columns row,column,x,y,z");
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const auto& at = grid.points.coordinates;
    points.emplace_back(at[0][i], at[1][i], at[2][i]);
  }
  return control_grid({grid.rows, true, 0, 0}, {grid.columns, true, 0, 0}, std::move(points));
}

Eigen::Vector3d rounded(const SpacePoint& p) {
  return {p.x().to_double(), p.y().to_double(), p.z().to_double()};
}

}  // namespace subdiv
