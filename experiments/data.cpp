#include "experiments/data.h"

#include <filesystem>

#include "experiments/polygon_file.h"
#include "schemes/input_error.h"

namespace subdiv {

std::vector<std::pair<Rational, Rational>> polygon_from_data(const std::string& file_name) {
  const std::filesystem::path path = std::filesystem::path(SUBDIVLAB_DATA_DIR) / file_name;
  const PointList<Rational> points = read_points<Rational>(path);
  if (points.dimension() != 2) throw InputError(path.string() + ": expected lines x,y");
  std::vector<std::pair<Rational, Rational>> polygon;
  for (std::size_t i = 0; i < points.size(); ++i)
    polygon.emplace_back(points.coordinates[0][i], points.coordinates[1][i]);
  return polygon;
}

}  // namespace subdiv
