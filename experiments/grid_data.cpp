#include "experiments/grid_data.h"

#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/report/csv.h"
#include "experiments/report/files.h"
#include "schemes/input_error.h"

namespace subdiv {

ControlGrid<SpacePoint> grid_from_data(const std::string& file_name) {
  const std::filesystem::path path = std::filesystem::path(SUBDIVLAB_DATA_DIR) / file_name;
  const CsvRows lines = from_csv(read_file(path));
  constexpr std::size_t columns_of_the_file = 5;
  std::vector<SpacePoint> points;
  std::size_t rows = 0;
  std::size_t columns = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    try {
      if (lines[i].size() != columns_of_the_file)
        throw std::invalid_argument("it has " + std::to_string(lines[i].size()) + " columns");
      const auto row = static_cast<std::size_t>(Rational::parse(lines[i][0]).to_integer());
      const auto column = static_cast<std::size_t>(Rational::parse(lines[i][1]).to_integer());
      if (row == 0) columns = column + 1;
      if (column == 0) rows = row + 1;
      if (row + 1 != rows || column >= columns || points.size() != row * columns + column)
        throw std::invalid_argument("it is not the next point of the grid");
      points.emplace_back(Rational::parse(lines[i][2]), Rational::parse(lines[i][3]),
                          Rational::parse(lines[i][4]));
    } catch (const std::logic_error& error) {
      throw InputError(path.string() + ":" + std::to_string(i + 1) +
                       ": not a point of a grid: " + error.what() + "; a line holds row,column,x,y,z");
    }
  }
  if (points.size() != rows * columns)
    throw InputError(path.string() + ": the last row has fewer points than the first");
  return control_grid({rows, true, 0, 0}, {columns, true, 0, 0}, std::move(points));
}

Eigen::Vector3d rounded(const SpacePoint& p) {
  return {p.x().to_double(), p.y().to_double(), p.z().to_double()};
}

}  // namespace subdiv
