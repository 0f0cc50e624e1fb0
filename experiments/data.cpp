#include "experiments/data.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "experiments/polygon_file.h"
#include "schemes/input_error.h"

namespace subdiv {

std::filesystem::path data_folder() {
  if (const char* named = std::getenv("SUBDIVLAB_DATA"); named != nullptr && *named != '\0') return named;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  const std::array places{program / SUBDIVLAB_DATA_FROM_PROGRAM, program / "share/subdivlab/data"};
  for (const std::filesystem::path& place : places) {
    if (std::filesystem::is_directory(place, error)) return place.lexically_normal();
  }
  throw InputError("the data files of subdivlab are neither in " + places[0].lexically_normal().string() +
                   " nor in " + places[1].string() +
                   "; the environment variable SUBDIVLAB_DATA can name their folder");
}

std::vector<std::pair<Rational, Rational>> polygon_from_data(const std::string& file_name) {
  const std::filesystem::path path = data_folder() / file_name;
  const PointList<Rational> points = read_points<Rational>(path);
  if (points.dimension() != 2) throw InputError(path.string() + ": expected lines x,y");
  std::vector<std::pair<Rational, Rational>> polygon;
  for (std::size_t i = 0; i < points.size(); ++i)
    polygon.emplace_back(points.coordinates[0][i], points.coordinates[1][i]);
  return polygon;
}

}  // namespace subdiv
