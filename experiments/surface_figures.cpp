#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/open_grid.h"
#include "experiments/grid_data.h"
#include "experiments/surface_pictures.h"
#include "experiments/surfaces.h"
#include "schemes/evaluate/grid_ringing.h"
#include "schemes/jspline.h"
#include "schemes/scheme_description.h"

namespace subdiv {
namespace {

using Eigen::Vector3d;

constexpr double cell = 200;  // width of a panel
constexpr unsigned gold = style::lit_orange;
constexpr unsigned blue = style::lit_sky;
constexpr unsigned grey = style::lit_grey;

Scheme<double> j(double s) { return stationary("J", jspline(s)); }

/// Vertices almost interpolated (js-report 6), then quintic.
Scheme<double> smooth_near_vertices() { return mixed(j(-33.0 / 26), j(1.5)); }

View usual_view() { return view_from({2, -5, 4}); }

Placement panel(double column, double row, double row_height, double scale) {
  return {usual_view(), scale, {column * cell, -row * row_height}};
}

DoubleGrid grid_of(const std::string& file) { return map_points(grid_from_data(file), rounded); }

std::vector<Vector3d> points_of(const Scheme<double>& scheme, const ControlPolygon<Vector3d>& polygon,
                                int depth) {
  std::vector<Vector3d> points;
  Ringing<double, Vector3d> rings(scheme, polygon, depth);
  for (const Vector3d& p : rings) points.push_back(p);
  return points;
}

/// Figure 15, top: trajectories, transversal curves, strips between them.
void add_torus(Results& results) {
  constexpr int depth = 3;
  constexpr double scale = 11;
  const DoubleGrid grid = grid_of("surface-torus.csv");
  const Scheme<double> scheme = j(1);
  const Placement left = panel(0, 0, 0, scale);
  const Placement middle = panel(1, 0, 0, scale);
  Series rows = polylines("surface-torus-rows");
  Series trajectories = polylines("surface-torus-trajectories");
  Series moving = polylines("surface-torus-moving-points");
  Series transversals = polylines("surface-torus-transversals");
  Series quads = polygons("surface-torus-quads");
  for (const ControlPolygon<Vector3d>& line : grid.lines) {
    const std::vector<Vector3d> curve = points_of(scheme, line, depth);
    add_line(rows, line.points, true, left);
    add_line(trajectories, curve, true, left);
    add_line(trajectories, curve, true, middle);
  }
  for (MovingPolygon<double, Vector3d> motion(scheme, grid, depth); !motion.done(); motion.advance()) {
    constexpr std::size_t every = 4;
    if (motion.frame() % every != 0) continue;
    add_line(moving, motion.polygon().points, true, middle);
    add_line(transversals, points_of(scheme, motion.polygon(), depth), true, middle);
  }
  add_quads(quads, space_quads(grid, scheme, depth), true, panel(2, 0, 0, scale), Paint::shaded, gold);
  results.figures.push_back(bare_figure("surface-torus",
                                        "A torus from 4 rows of 4 control points, *J_1 (js-report figure 15)",
                                        {filled(quads), drawn(rows, "rows", style::curve(2, 1.5)),
                                         drawn(trajectories, "trajectories", style::curve(1, 1.5)),
                                         drawn(moving, "moving points", style::polygon),
                                         drawn(transversals, "transversals", style::curve(0, 1.5))},
                                        {}, {"ringing.rings", "ringing.minimum-input.torus"}));
  for (Series* series : {&rows, &trajectories, &moving, &transversals, &quads})
    results.series.push_back(std::move(*series));
}

/// Figure 15, below: three control meshes, their cubic surfaces, and quintic ones near the vertices.
void add_rows(Results& results) {
  constexpr int depth = 3;
  constexpr double row_height = 125;
  constexpr double scale = 9;
  constexpr double captions_at = -2.6 * row_height;
  const std::vector<std::string> files{"surface-rows-3", "surface-torus", "surface-rows-6"};
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const DoubleGrid grid = grid_of(files[i] + ".csv");
    const int steps = grid.rows.points > 3 ? depth - 1 : depth;
    Series series = polygons(fmt::format("surface-rows-{}-quads", grid.rows.points));
    const auto place = [&](double column) {
      return panel(column, static_cast<double>(i), row_height, scale);
    };
    add_quads(series, space_quads(grid, j(1), 0), true, place(0), Paint::chequered, grey);
    add_quads(series, space_quads(grid, j(1), steps), true, place(1), Paint::shaded, gold);
    add_quads(series, space_quads(grid, smooth_near_vertices(), steps), true, place(2), Paint::shaded, blue);
    curves.push_back(filled(series));
    results.series.push_back(std::move(series));
  }
  results.figures.push_back(
      bare_figure("surface-rows", "Surfaces from 3, 4 and 6 rows of control points (js-report figure 15)",
                  std::move(curves),
                  {{"control mesh", 0, captions_at},
                   {"*J_1", cell, captions_at},
                   {"{J_{-33/26}, *J_{3/2}}", 2 * cell, captions_at}},
                  {"ringing.rings", "ringing.minimum-input.torus"}));
}

/// Figure 16: one grid closed, with one border, and its quads.
void add_borders(Results& results) {
  constexpr int depth = 3;
  constexpr double row_height = 130;
  constexpr double scale = 9.5;
  const DoubleGrid closed = grid_of("surface-borders.csv");
  std::vector<FigureText> texts;
  std::vector<Curve> curves;
  const auto surface = [&](const std::string& name, const DoubleGrid& grid, double s, int steps, bool border,
                           const Placement& placement, Paint paint, unsigned colour) {
    Series series = polygons("surface-borders-" + name);
    add_quads(series, space_quads(grid, j(s), steps), !border, placement, paint, colour);
    curves.push_back(filled(series));
    results.series.push_back(std::move(series));
  };
  surface("closed-control", closed, 1, 0, false, panel(0, 0, row_height, scale), Paint::chequered, grey);
  const std::vector<std::pair<std::string, Rational>> shapes{
      {"four-point", Rational(0)}, {"jarek", Rational(1, 2)}, {"quintic", Rational(3, 2)}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto& [name, s] = shapes[i];
    const double value = s.to_double();
    const auto place = [&](double row) { return panel(static_cast<double>(i) + 1, row, row_height, scale); };
    const EndWeights<double> ends =
        end_weights_in_double(parse_scheme(fmt::format("jspline:s={}", s.to_string())), OpenEnd::clamped);
    const DoubleGrid open = open_across(open_along(closed, ends), ends);
    if (i == 0)
      surface("open-control", open, value, 0, true, panel(0, 1, row_height, scale), Paint::chequered, grey);
    surface("closed-" + name, closed, value, depth, false, place(0), Paint::shaded, gold);
    texts.push_back(caption_above(results.series.back(), "*J_{" + shapes[i].second.to_string() + "}"));
    surface("open-" + name, open, value, depth, true, place(1), Paint::shaded, blue);
    surface("quads-" + name, open, value, depth - 1, true, place(2), Paint::chequered, blue);
  }
  results.figures.push_back(bare_figure(
      "surface-borders", "3 rows of 5 points: closed, with a border, its quads (js-report figure 16)",
      std::move(curves), std::move(texts), {"ringing.borders."}));
}

/// Figure 11, below: consecutive levels painted over each other.
void add_silhouettes(Results& results) {
  constexpr double scale = 11;
  constexpr unsigned previous = style::flat_blue;
  constexpr unsigned current = style::lit_orange;
  constexpr int depth = 2;
  const DoubleGrid grid = grid_of("surface-torus.csv");
  std::vector<FigureText> texts;
  std::vector<Curve> curves;
  double column = 0;
  for (const auto& [name, s] : {std::pair("0", 0.0), std::pair("3-8", 0.375), std::pair("1", 1.0)}) {
    Series series = polygons(std::string("surface-silhouettes-") + name);
    const Placement place = panel(column, 0, 0, scale);
    const auto paint = [&](int steps, unsigned colour) {
      add_quads(series, space_quads(grid, j(s), steps), true, place, Paint::flat, colour);
    };
    // The larger picture below: J_1 shrinks the surface, the others let it grow.
    if (s < 1) paint(depth, current);
    paint(depth - 1, previous);
    if (s >= 1) paint(depth, current);
    curves.push_back(filled(series));
    texts.push_back(caption_below(series, "J_{" + Rational::from_double(s).to_string() + "}"));
    results.series.push_back(std::move(series));
    ++column;
  }
  results.figures.push_back(
      bare_figure("surface-silhouettes", "Silhouettes of levels 1 (dark) and 2 (light) (js-report figure 11)",
                  std::move(curves), std::move(texts), {"popping.silhouettes", "popping.silhouettes.s"}));
}

}  // namespace

void add_surface_figures(Results& results) {
  add_torus(results);
  add_rows(results);
  add_borders(results);
  add_silhouettes(results);
}

}  // namespace subdiv
