#include <cmath>
#include <iostream>
#include <new>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/cli/verbs.h"
#include "experiments/polygon_file.h"
#include "experiments/report/curve_writer.h"
#include "experiments/report/output_file.h"
#include "schemes/evaluate/bezier_drawing.h"
#include "schemes/evaluate/curve_blocks.h"
#include "schemes/evaluate/geomorph.h"
#include "schemes/input_error.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Polylines are kept in memory.
constexpr std::size_t most_segments = std::size_t{1} << 24U;

std::vector<BezierCurve> curves_of(const BezierOptions& options) {
  const PointList<double> points = read_points<double>(options.input);
  std::vector<std::vector<double>> coordinates = points.coordinates;
  if (points.closed.value_or(false)) {
    for (std::vector<double>& c : coordinates) c.push_back(c.front());  // where its line element ends
  }
  try {
    std::vector<BezierCurve> curves = consecutive_curves(coordinates, options.degree);
    require_drawable(curves);
    return curves;
  } catch (const InputError& error) {
    throw InputError(options.input + ": " + error.what());
  }
}

BezierPolyline drawn(const std::vector<BezierCurve>& curves, const BezierOptions& options) {
  try {
    return options.tolerance > 0 ? draw_to_tolerance(curves, options.tolerance, most_segments)
                                 : draw_to_depth(curves, options.depth, most_segments);
  } catch (const InputError& error) {
    throw InputError((options.tolerance > 0 ? "--tolerance: " : "--depth: ") + std::string(error.what()));
  }
}

std::string report_text(const BezierPolyline& line, std::size_t curves, const BezierOptions& options) {
  return fmt::format(
      "{} Bezier curve{} of degree {}: {} segment{}, up to {} halving{}\n"
      "Hausdorff distance from the curve{}: at most {:.6g}{}\n",
      curves, curves == 1 ? "" : "s", options.degree, line.segments, line.segments == 1 ? "" : "s",
      line.deepest, line.deepest == 1 ? "" : "s", curves == 1 ? "" : "s", line.bound,
      options.tolerance > 0 ? fmt::format(" (tolerance {:.6g})", options.tolerance) : "");
}

Json report_json(const BezierPolyline& line, std::size_t curves, const BezierOptions& options) {
  Json json = {{"input", options.input},   {"degree", options.degree},
               {"curves", curves},         {"segments", line.segments},
               {"halvings", line.deepest}, {"distance_at_most", fmt::format("{}", line.bound)}};
  if (options.tolerance > 0) json["tolerance"] = fmt::format("{}", options.tolerance);
  return json;
}

}  // namespace

int bezier(const BezierOptions& options) {
  if ((options.tolerance > 0) == (options.depth >= 0)) {
    throw InputError(
        "say how fine the polyline is to be, in one way: --tolerance T for a distance from the curve, "
        "--depth K for a number of halvings");
  }
  const CurveFormat format = curve_format(options.out);
  if (options.out == "-" && options.json)
    throw InputError("--json: standard output takes the polyline (-o -); write one of them to a file");
  const std::vector<BezierCurve> curves = curves_of(options);
  try {
    const BezierPolyline line = drawn(curves, options);
    OutputFile file(options.out);
    const CoordinateArrays<double> points{{line.coordinates.front().size(), false, 0, 0}, line.coordinates};
    write_curve(file, format, CurveBlocks<double>(stationary("linear", linear_step<double>(2)), points, 0),
                false);
    file.finish();
    if (options.json) {
      std::cout << report_json(line, curves.size(), options).dump(2) << '\n';
    } else {
      (options.out == "-" ? std::cerr : std::cout) << report_text(line, curves.size(), options);
    }
  } catch (const std::bad_alloc&) {
    throw InputError(options.input +
                     ": there is not enough memory; take a larger --tolerance or a smaller "
                     "--depth");
  }
  return ExitCode::done;
}

}  // namespace subdiv::cli
