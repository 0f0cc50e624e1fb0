#pragma once

#include <filesystem>
#include <string>

#include "experiments/report/output_file.h"
#include "schemes/evaluate/curve_blocks.h"

namespace subdiv {

enum class CurveFormat { csv, obj, svg };

/// By the extension; "-" and devices take CSV. Throws InputError for others.
[[nodiscard]] CurveFormat curve_format(const std::filesystem::path& path);

/// Appends the shortest decimal that reads back as the same double. Throws InputError when it is not finite.
void append_number(std::string& text, double x);

/// Writes the points of a curve, in memory that does not depend on their number:
///   csv  a header x,y,z (x1,x2,.. beyond three coordinates), then a point a line;
///   obj  vertices of up to three coordinates, missing ones 0, and line elements through them in order, back
///        to the first when the curve is closed;
///   svg  a path through the first two coordinates, y upwards, in a frame that fits them (the points are
///        evaluated twice).
/// Throws InputError when a coordinate leaves the range of doubles or the format cannot hold the dimension.
void write_curve(OutputFile& file, CurveFormat format, const CurveBlocks<double>& curve, bool closed);

}  // namespace subdiv
