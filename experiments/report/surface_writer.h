#pragma once

#include <cstddef>
#include <filesystem>

#include "experiments/report/output_file.h"
#include "schemes/algebra/matrix.h"
#include "schemes/evaluate/control_grid.h"

namespace subdiv {

enum class SurfaceFormat { csv, obj };

/// By the extension; "-" and devices take OBJ. Throws InputError for others.
[[nodiscard]] SurfaceFormat surface_format(const std::filesystem::path& path);

/// Writes the refined grid, the same refinement in both directions, in memory that does not grow with it:
///   csv  a header and the vertices, `dimension` coordinates each (1 to 3), curve after curve;
///   obj  vertices and quads that share them, so that closed directions are watertight.
/// Throws InputError when a coordinate leaves the range of doubles.
void write_surface(OutputFile& file, SurfaceFormat format, const ControlGrid<Eigen::Vector3d>& grid,
                   const Refinement<double>& refinement, std::size_t dimension);

}  // namespace subdiv
