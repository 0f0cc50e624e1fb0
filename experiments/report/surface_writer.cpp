#include "experiments/report/surface_writer.h"

#include <array>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "experiments/report/curve_writer.h"
#include "schemes/evaluate/grid_ringing.h"
#include "schemes/input_error.h"

namespace subdiv {

SurfaceFormat surface_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".csv") return SurfaceFormat::csv;
  if (extension == ".obj" || path == "-" || path.string().starts_with("/dev/")) return SurfaceFormat::obj;
  throw InputError(path.string() +
                   ": surfaces are written to .obj or .csv files, or to - for standard output");
}

void write_surface(OutputFile& file, SurfaceFormat format, const ControlGrid<Eigen::Vector3d>& grid,
                   const Refinement<double>& refinement, std::size_t dimension) {
  const bool csv = format == SurfaceFormat::csv;
  if (csv) file.write(std::string("x,y,z").substr(0, 2 * dimension - 1) + "\n");
  std::string text;
  const auto vertex = [&](const Eigen::Vector3d& p) {
    text = csv ? "" : "v ";
    for (std::size_t c = 0; c < (csv ? dimension : 3); ++c) {
      if (c > 0) text += csv ? ',' : ' ';
      append_number(text, p(static_cast<Eigen::Index>(c)));
    }
    file.write(text + "\n");
  };
  const auto quad = [&](const std::array<std::size_t, 4>& corners) {
    if (csv) return;
    text.clear();
    fmt::format_to(std::back_inserter(text), "f {} {} {} {}\n", corners[0] + 1, corners[1] + 1,
                   corners[2] + 1, corners[3] + 1);
    file.write(text);
  };
  stream_surface(grid, refinement, refinement, vertex, quad);
}

}  // namespace subdiv
