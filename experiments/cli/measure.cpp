#include <cmath>
#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/curve_measures.h"
#include "analysis/hausdorff_distance.h"
#include "experiments/cli/control_points.h"
#include "experiments/cli/local_estimates.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/utf8.h"
#include "schemes/input_error.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

/// What is measured of one polygon, and against its parent where it has one.
struct Measures {
  int level = 0;
  std::size_t points = 0;
  double length = 0;
  std::optional<double> area;                        // of closed plane polygons
  std::optional<std::array<double, 3>> vector_area;  // of closed ones in space
  NormalJerk jerk;
  std::optional<Disparity> disparity;
  bool primal = true;  // only then points of two levels belong to each other
};

Measures measures_of(const Polyline& polyline, int level) {
  Measures m{level, curve_size(polyline.topology), length(polyline), {}, {}, normal_jerk(polyline), {}};
  const std::size_t dimension = polyline.coordinates.size();
  if (polyline.topology.closed && dimension == 2) m.area = signed_area(polyline);
  if (polyline.topology.closed && dimension == 3) m.vector_area = vector_area(polyline);
  return m;
}

/// A millionth of the longest side of the box around the points.
double default_tolerance(const Polyline& polyline) {
  constexpr double part = 1e-6;
  double extent = 0;
  for (const std::vector<double>& c : polyline.coordinates) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    extent = std::max(extent, *high - *low);
  }
  return extent > 0 ? extent * part : part;
}

Polyline plain(const PointList<double>& points, bool closed) {
  return make_polyline(points.coordinates, closed);
}

Json to_json(const Measures& m) {
  Json json = {{"level", m.level}, {"points", m.points}, {"length", fmt::format("{}", m.length)}};
  if (m.area) json["area"] = fmt::format("{}", *m.area);
  if (m.vector_area) {
    for (const double x : *m.vector_area) json["vector_area"].push_back(fmt::format("{}", x));
  }
  json["normal_jerk"] = {{"largest", fmt::format("{}", m.jerk.largest)},
                         {"mean", fmt::format("{}", m.jerk.mean)}};
  if (m.disparity) {
    if (m.primal) json["displacement"] = fmt::format("{}", m.disparity->displacement);
    json["hausdorff"] = {{"lower", fmt::format("{}", m.disparity->hausdorff.lower)},
                         {"upper", fmt::format("{}", m.disparity->hausdorff.upper)}};
  }
  return json;
}

std::string area_text(const Measures& m) {
  if (m.area) return fmt::format("{:.12g}", *m.area);
  if (!m.vector_area) return "-";
  const auto& [x, y, z] = *m.vector_area;
  return fmt::format("({:.8g}, {:.8g}, {:.8g})", x, y, z);
}

void print_table(const std::vector<Measures>& all) {
  constexpr std::size_t wide = 17;
  constexpr std::size_t narrow = 12;
  const bool levels = all.size() > 1;
  std::cout << padded("level", 7) << padded("points", narrow) << padded("length", wide)
            << padded("area", wide) << padded("jerk, largest", wide) << padded("jerk, mean", wide);
  if (levels) std::cout << padded("displacement", wide) << "Hausdorff distance to the level before";
  std::cout << "\n";
  for (const Measures& m : all) {
    std::cout << padded(std::to_string(m.level), 7) << padded(std::to_string(m.points), narrow)
              << padded(fmt::format("{:.12g}", m.length), wide) << padded(area_text(m), wide)
              << padded(fmt::format("{:.8g}", m.jerk.largest), wide)
              << padded(fmt::format("{:.8g}", m.jerk.mean), wide);
    if (m.disparity) {
      std::cout << padded(m.primal ? fmt::format("{:.8g}", m.disparity->displacement) : "-", wide)
                << fmt::format("[{:.8g}, {:.8g}]", m.disparity->hausdorff.lower,
                               m.disparity->hausdorff.upper);
    }
    std::cout << "\n";
  }
}

/// Local estimates take some memory and a line for every vertex.
void require_few(std::size_t vertices) {
  constexpr std::size_t most = std::size_t{1} << 20U;
  if (vertices > most)
    throw InputError(fmt::format("--local: {} vertices; measure at most {}", vertices, most));
}

/// The polygon, and its refinements where a scheme is given.
std::vector<Measures> measure_levels(const MeasureOptions& options, const PointList<double>& points,
                                     double tolerance) {
  if (options.local) require_few(points.size());
  if (options.scheme.empty()) return {measures_of(plain(points, options.open.empty()), 0)};
  const SchemeDescription description = evaluated_scheme(options.scheme);
  const Scheme<double> scheme = scheme_in_double(description);
  const Polyline controls = control_curve(points, options.open, description);
  constexpr std::size_t most = std::size_t{1} << 24U;  // every level is kept in memory
  constexpr int deepest = 24;
  if (options.levels > deepest || refined_points(controls.topology, scheme.arity(), options.levels) > most)
    throw InputError(
        fmt::format("--levels {}: more than {} points; measure fewer levels", options.levels, most));
  if (options.local) require_few(refined_points(controls.topology, scheme.arity(), options.levels));
  std::vector<Measures> all;
  for (int level = 0; level <= options.levels; ++level) {
    const Polyline refined = refine(scheme, controls, level);
    require_measurable(refined, fmt::format("--scheme {}, level {}", options.scheme, level));
    all.push_back(measures_of(refined, level));
  }
  const std::vector<Disparity> between = disparities(scheme, controls, options.levels, tolerance);
  for (std::size_t k = 0; k < between.size(); ++k) {
    all[k + 1].disparity = between[k];
    all[k + 1].primal = std::ranges::all_of(
        scheme.steps, [](const Mask<double>& step) { return step.symbol == reverse(step.symbol); });
  }
  return all;
}

/// The polygon itself, or its last refinement.
Polyline finest(const MeasureOptions& options, const PointList<double>& points) {
  if (options.scheme.empty()) return plain(points, options.open.empty());
  const SchemeDescription description = evaluated_scheme(options.scheme);
  return refine(scheme_in_double(description), control_curve(points, options.open, description),
                options.levels);
}

}  // namespace

int measure(const MeasureOptions& options) {
  if (options.open == "plain" && !options.scheme.empty())
    throw InputError("--open plain has no ends to refine: choose clamped or reflected with --scheme");
  const PointList<double> points = read_points<double>(options.input);
  if (points.closed.has_value() && *points.closed != options.open.empty()) {
    throw InputError(options.input + (*points.closed ? ": its line element is closed; leave --open out"
                                                     : ": its line element is open; say --open plain"));
  }
  require_measurable(plain(points, options.open.empty()), options.input);
  const double tolerance =
      options.tolerance > 0 ? options.tolerance : default_tolerance(plain(points, options.open.empty()));
  const std::vector<Measures> all = measure_levels(options, points, tolerance);
  std::optional<DistanceBounds> distance;
  if (!options.against.empty()) {
    const PointList<double> other = read_points<double>(options.against);
    if (other.dimension() != points.dimension()) {
      throw InputError(fmt::format("--against {}: points of {} coordinates; {} has {}", options.against,
                                   other.dimension(), options.input, points.dimension()));
    }
    const bool closed = other.closed.value_or(options.open.empty());
    require_measurable(plain(other, closed), "--against " + options.against);
    distance = hausdorff_distance(plain(points, options.open.empty()), plain(other, closed), tolerance);
  }
  if (options.json) {
    Json json = {
        {"input", options.input}, {"closed", options.open.empty()}, {"dimension", points.dimension()}};
    for (const Measures& m : all) json["levels"].push_back(to_json(m));
    if (distance) {
      json["against"] = {
          {"input", options.against},
          {"hausdorff",
           {{"lower", fmt::format("{}", distance->lower)}, {"upper", fmt::format("{}", distance->upper)}}}};
    }
    if (options.local) json["local"] = local_estimates_json(finest(options, points));
    std::cout << json.dump(2) << "\n";
    return ExitCode::done;
  }
  const std::optional<Polyline> polygon =
      options.local ? std::optional(finest(options, points)) : std::nullopt;
  if (polygon) require_local_estimates(*polygon);
  print_table(all);
  if (distance) {
    std::cout << fmt::format("Hausdorff distance to {}: [{:.8g}, {:.8g}]\n", options.against, distance->lower,
                             distance->upper);
  }
  if (polygon) print_local_estimates(*polygon);
  return ExitCode::done;
}

}  // namespace subdiv::cli
