#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "analysis/limit_points.h"
#include "analysis/limit_sampling.h"
#include "analysis/open_grid.h"
#include "analysis/retrofit_polygon.h"
#include "experiments/cli/control_points.h"
#include "experiments/cli/refine_mesh.h"
#include "experiments/cli/verbs.h"
#include "experiments/details_file.h"
#include "experiments/grid_file.h"
#include "experiments/report/curve_writer.h"
#include "experiments/report/surface_writer.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Curve = CoordinateArrays<double>;

/// Files of more points help nobody.
constexpr std::size_t most_points = std::size_t{1} << 30U;

/// Throws InputError unless rows x columns control points, refined, stay below the limit: exact counts, which
/// may be far beyond any integer type.
void require_count(const std::vector<Topology>& directions, int arity, int levels) {
  const auto count = [&](int depth) {
    Rational points(1);
    for (const Topology& t : directions) {
      points *= Rational(static_cast<std::int64_t>(t.spans())) * pow(Rational(arity), depth) +
                Rational(t.closed ? 0 : 1);
    }
    return points;
  };
  const Rational most(static_cast<std::int64_t>(most_points));
  if (count(levels) <= most) return;
  int possible = levels;
  while (possible > 0 && count(possible) > most) --possible;
  throw InputError(fmt::format(
      "--levels {}: {} points, more than the {} that are written; {}", levels, count(levels).to_string(),
      most_points,
      count(possible) <= most ? fmt::format("--levels {} makes {}", possible, count(possible).to_string())
                              : "the control points alone are too many"));
}

/// What rounding lets the iteration reach: 1e-12 of the longest side of the box around the points.
double small_part(const Curve& curve) {
  constexpr double part = 1e-12;
  double extent = 0;
  for (const std::vector<double>& c : curve.coordinates) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    extent = std::max({extent, *high - *low, std::abs(*high), std::abs(*low)});
  }
  return extent > 0 ? extent * part : part;
}

Curve retrofitted(const Curve& target, const SchemeDescription& scheme, const std::string& how) {
  if (!target.topology.closed)
    throw InputError("--retrofit is for closed curves; open ones meet their end points by --open clamped");
  const Laurent<Interval> mask = [&] {
    try {
      return vertex_limit_mask(interval_scheme(scheme));
    } catch (const std::domain_error& error) {
      throw InputError("--retrofit: " + scheme.text + ": " + error.what());
    }
  }();
  try {
    return how == "iteration" ? retrofit_by_iteration(mask, target, {.tolerance = small_part(target)}).polygon
                              : retrofit_directly(mask, target).polygon;
  } catch (const InputError& error) {
    throw InputError("--retrofit " + how + ": " + error.what());
  }
}

/// The curve at the level of the last detail, all of them applied.
Curve with_details(const Curve& controls, const Scheme<double>& scheme,
                   const std::vector<DetailRecord<double>>& records, int level) {
  Curve result;
  for (std::size_t c = 0; c < controls.coordinates.size(); ++c) {
    std::vector<Detail<double>> details;
    for (const auto& r : records) details.push_back({r.level, r.index, r.displacement[c]});
    ControlPolygon<double> polygon =
        refine_level_by_level(scheme, ControlPolygon<double>{controls.topology, controls.coordinates[c]},
                              level, Details<double>(std::move(details)));
    result.topology = polygon.topology;
    result.coordinates.push_back(std::move(polygon.points));
  }
  return result;
}

/// The limit points of the vertices of a control polygon, as a polygon without added points.
template <class R>
Curve limits_of_vertices(const Curve& controls, const Scheme<R>& scheme) {
  const Laurent<double> mask =
      map_coefficients(vertex_limit_mask(scheme), [](const R& x) { return detail::rounded(x); });
  const std::size_t count = refined_points(controls.topology, scheme.arity(), 0);
  Curve result{{count, controls.topology.closed, 0, 0}, {}};
  for (const std::vector<double>& coordinate : controls.coordinates) {
    const ControlPolygon<double> polygon{controls.topology, coordinate};
    std::vector<double> points;
    for (std::size_t i = 0; i < count; ++i)
      points.push_back(apply_mask(mask, polygon, static_cast<long long>(i)));
    result.coordinates.push_back(std::move(points));
  }
  return result;
}

void write(const CurveBlocks<double>& curve, const RefineOptions& options, bool closed) {
  OutputFile file(options.out);
  write_curve(file, curve_format(options.out), curve, closed);
  file.finish();
}

template <class R>
void refine_curve(const RefineOptions& options, Curve controls, const Scheme<R>& scheme, int levels) {
  if (!options.limit) {
    write(CurveBlocks<double>(scheme, controls, levels), options, controls.topology.closed);
    return;
  }
  try {
    if (levels == 0) {
      controls = limits_of_vertices(controls, scheme);
      write(CurveBlocks<double>(scheme, controls, 0), options, controls.topology.closed);
    } else {
      const Scheme<R> sampling = limit_sampling(scheme, levels);
      write(CurveBlocks<double>(sampling, controls, levels), options, controls.topology.closed);
    }
  } catch (const std::domain_error& error) {
    throw InputError("--limit: " + options.scheme + ": " + error.what());
  }
}

void refine_curve(const RefineOptions& options, const SchemeDescription& description,
                  const PointList<double>& points) {
  (void)curve_format(options.out);  // before anything is computed
  Curve controls = control_curve(points, options.open, description);
  const int arity = description.steps.front().arity();
  require_count({controls.topology}, arity, options.levels);
  if (!options.retrofit.empty()) controls = retrofitted(controls, description, options.retrofit);
  int done = 0;
  if (!options.details.empty()) {
    const auto records = read_details<double>(options.details, points.dimension());
    for (const auto& r : records) done = std::max(done, r.level);
    if (done > options.levels) {
      throw InputError(options.details +
                       fmt::format(": a detail of level {}; --levels is {}", done, options.levels));
    }
    constexpr std::size_t most = std::size_t{1} << 24U;  // the levels down to the last detail are kept
    if (refined_points(controls.topology, arity, done) > most) {
      throw InputError(options.details + fmt::format(": a detail of level {}, which has more than {} points; "
                                                     "details belong to coarser levels",
                                                     done, most));
    }
    try {
      controls = with_details(controls, scheme_in_double(description), records, done);
    } catch (const std::out_of_range& error) {
      throw InputError(options.details + ": " + error.what());
    }
  }
  with_masks(description, [&](const auto& scheme) {
    refine_curve(options, std::move(controls), after_steps(scheme, static_cast<std::size_t>(done)),
                 options.levels - done);
  });
}

// ---- Grids
// -------------------------------------------------------------------------------------------------------

using Point3 = Eigen::Vector3d;

struct GridSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// "3x5".
GridSize parse_grid(const std::string& text) {
  GridSize size;
  const char* end = text.data() + text.size();
  const auto [by, first] = std::from_chars(text.data(), end, size.rows);
  const bool times = first == std::errc() && by != end && *by == 'x';
  const auto [last, second] = std::from_chars(times ? by + 1 : end, end, size.columns);
  if (!times || second != std::errc() || last != end || size.rows == 0 || size.columns == 0)
    throw InputError("--grid: " + in_quotes(text) + " is no size; expected ROWSxCOLUMNS, such as 3x5");
  return size;
}

/// The points of the input as a grid: by its own columns row and column, or by --grid.
GridPoints<double> read_grid(const RefineOptions& options, PointList<double> points) {
  if (holds_grid(points)) {
    GridPoints<double> grid = grid_points(std::move(points), options.input);
    const GridSize said = options.grid.empty() ? GridSize{grid.rows, grid.columns} : parse_grid(options.grid);
    if (said.rows != grid.rows || said.columns != grid.columns) {
      throw InputError(fmt::format("--grid {}: {} says itself that it holds {}x{}", options.grid,
                                   options.input, grid.rows, grid.columns));
    }
    return grid;
  }
  const GridSize size = parse_grid(options.grid);
  if (size.rows > points.size() || size.rows * size.columns != points.size()) {
    throw InputError(fmt::format("--grid {}: {} holds {} points, a row after the other", options.grid,
                                 options.input, points.size()));
  }
  return {size.rows, size.columns, std::move(points)};
}

ControlGrid<Point3> control_surface(const RefineOptions& options, const SchemeDescription& description,
                                    const GridPoints<double>& given) {
  const PointList<double>& points = given.points;
  if (points.dimension() > 3)
    throw InputError(options.input + ": grids have up to three coordinates, not " +
                     std::to_string(points.dimension()));
  std::vector<Point3> corners(points.size(), Point3::Zero());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t c = 0; c < points.dimension(); ++c)
      corners[i](static_cast<Eigen::Index>(c)) = points.coordinates[c][i];
  }
  ControlGrid<Point3> grid =
      control_grid(Topology{given.rows, true, 0, 0}, Topology{given.columns, true, 0, 0}, std::move(corners));
  if (!options.open.empty())
    grid = open_along(grid, end_weights_in_double(description, open_end(options.open)));
  if (!options.open_across.empty())
    grid = open_across(grid, end_weights_in_double(description, open_end(options.open_across)));
  return grid;
}

void refine_grid(const RefineOptions& options, const SchemeDescription& description,
                 PointList<double> points) {
  for (const auto& [given, name] : {std::pair{!options.details.empty(), "--details"},
                                    {!options.retrofit.empty(), "--retrofit"},
                                    {options.limit, "--limit"}}) {
    if (given) throw InputError(std::string(name) + " is for curves; leave it out for grids");
  }
  const SurfaceFormat format = surface_format(options.out);
  const GridPoints<double> given = read_grid(options, std::move(points));
  const ControlGrid<Point3> grid = control_surface(options, description, given);
  const Refinement<double> refinement{scheme_in_double(description), options.levels};
  require_count({grid.rows, grid.columns()}, refinement.scheme.arity(), options.levels);
  OutputFile file(options.out);
  write_surface(file, format, grid, refinement, given.points.dimension());
  file.finish();
}

}  // namespace

int refine(const RefineOptions& options) {
  if (is_about_meshes(options)) return refine_mesh_file(options);
  if (options.threads > 0)
    throw InputError("--threads is for meshes; curves and grids are written as they come");
  const SchemeDescription description = evaluated_scheme(options.scheme);
  PointList<double> points = read_points<double>(options.input);
  if (!options.grid.empty() || holds_grid(points)) {
    refine_grid(options, description, std::move(points));
  } else if (!options.open_across.empty()) {
    throw InputError("--open-across is for grids; a curve takes --open, a grid --grid ROWSxCOLUMNS as well");
  } else {
    refine_curve(options, description, points);
  }
  return ExitCode::done;
}

}  // namespace subdiv::cli
