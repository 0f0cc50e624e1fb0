#include <array>
#include <cmath>
#include <filesystem>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "experiments/data.h"
#include "experiments/mesh_file.h"
#include "experiments/ring_shapes.h"
#include "experiments/speed_rings.h"
#include "experiments/surface_pictures.h"
#include "schemes/evaluate/bezier_patch.h"
#include "schemes/mesh/fan.h"

namespace subdiv {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const View above = view_from({1, -3, 6});

RingModel blend() {
  const MeshFile file = read_mesh(data_folder() / "speed-blend.obj");
  return {surface_of(file), file.points};
}

Vector3d vector_of(const Point3& p) { return {p[0], p[1], p[2]}; }

/// The quads of one group, pieces x pieces a patch.
std::vector<SpaceQuad> group_quads(const RingSurface& surface, std::size_t group, int pieces) {
  std::vector<SpaceQuad> quads;
  for (std::size_t p = surface.begin[group]; p < surface.begin[group + 1]; ++p) {
    const auto at = [&](int i, int j) {
      return vector_of(patch_point(surface.patches[p], bernstein(i, pieces), bernstein(j, pieces)));
    };
    for (int i = 0; i < pieces; ++i) {
      for (int j = 0; j < pieces; ++j)
        quads.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, quads.size(), 0});
    }
  }
  return quads;
}

constexpr std::array<unsigned, 4> colours{style::lit_grey, style::lit_orange, style::lit_sky,
                                          style::lit_vermilion};  // a group each

/// A panel: every group in its colour.
void add_panel(Results& results, std::vector<Curve>& curves, const std::string& name,
               const RingSurface& surface, const Placement& placement) {
  Series series = polygons(name);
  for (std::size_t g = 0; g < surface.groups(); ++g) {
    const bool cap = g + 1 == surface.groups();
    add_quads(series, group_quads(surface, g, g == 0 || cap ? 2 : 3), false, placement, Paint::shaded,
              cap ? colours[3] : colours.at(g));
  }
  curves.push_back(filled(series));
  results.series.push_back(std::move(series));
}

/// Lines on which the normal of the surface keeps its angle to a direction (isophotes), over rings and cap:
/// where two patches meet in an edge of the surface they break.
Series isophotes(const std::string& name, const RingSurface& surface, const Placement& placement) {
  constexpr int pieces = 6;
  constexpr double lines_per_unit = 60;
  const Vector3d direction = Vector3d(1, 0.3, 0.2).normalized();
  Series series{name, {"x", "y"}, {}};
  struct Sample {
    Vector2d place;
    double light = 0;
  };
  const auto crossing = [](const Sample& a, const Sample& b, double level) -> Vector2d {
    return a.place + (level - a.light) / (b.light - a.light) * (b.place - a.place);
  };
  const auto add_triangle = [&](const std::array<Sample, 3>& corner) {
    const auto [low, high] = std::minmax({corner[0].light, corner[1].light, corner[2].light});
    for (double level = std::ceil(low); level < high; level += 1) {
      std::vector<Vector2d> ends;
      for (std::size_t e = 0; e < 3; ++e) {
        const Sample& a = corner.at(e);
        const Sample& b = corner.at((e + 1) % 3);
        if ((a.light <= level) != (b.light <= level)) ends.push_back(crossing(a, b, level));
      }
      if (ends.size() != 2) continue;
      for (const Vector2d& p : ends)
        series.rows.push_back(
            {to_decimal(Rational::from_double(p.x()), 1), to_decimal(Rational::from_double(p.y()), 1)});
      series.rows.push_back({"", ""});
    }
  };
  for (std::size_t p = surface.begin[1]; p < surface.patches.size(); ++p) {
    const auto at = [&](int i, int j) {
      const double u = static_cast<double>(i) / pieces;
      const double v = static_cast<double>(j) / pieces;
      const Vector3d point = vector_of(patch_jet(surface.patches[p], u, v).point);
      return Sample{placement.centre + placement.scale * placement.view.project(point),
                    lines_per_unit * patch_normal(surface.patches[p], u, v).dot(direction)};
    };
    for (int i = 0; i < pieces; ++i) {
      for (int j = 0; j < pieces; ++j) {
        add_triangle({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        add_triangle({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return series;
}

/// Figure 1: blend with hole, two rings, highlight lines over the rings and the cap.
void add_completion(Results& results) {
  const RingModel model = blend();
  constexpr double scale = 0.25;
  constexpr double detail = 0.75;
  std::vector<Curve> curves;
  add_panel(results, curves, "speed-blend-hole", model.surface({}, false), {above, scale, {0, -110}});
  int row = 0;
  for (const auto& [name, sigma] : {std::pair{"half", Rational(1, 2)}, {"high", Rational(3, 4)}}) {
    const double y = -240.0 * row++;
    const RingSurface surface = model.surface({sigma, sigma}, true);
    add_panel(results, curves, fmt::format("speed-blend-rings-{}", name),
              model.surface({sigma, sigma}, false), {above, scale, {280, y}});
    Series lines =
        isophotes(fmt::format("speed-blend-highlight-{}", name), surface, {above, detail, {560, y}});
    curves.push_back({lines.name, "x", "y", "", style::in_colour(style::black, 1)});
    results.series.push_back(std::move(lines));
  }
  results.figures.push_back(bare_figure("speed-completion",
                                        "A blend with a hole; two steps at speed 1/2 (top) and 3/4; "
                                        "highlight lines with the cap (speed figure 1)",
                                        std::move(curves), {}, {"figure.speed.1."}));
}

/// The edges of three or two rings of quads around the vertex.
void add_net(Results& results, std::vector<Curve>& curves, const std::string& name, int rings,
             const std::vector<Point3>& points, const Placement& placement, const std::string& style) {
  const MeshTopology mesh = fan_topology(4, 5, rings);
  Series series = polylines(name);
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.half_edge(e);
    add_line(series,
             {vector_of(points[static_cast<std::size_t>(mesh.origin(h))]),
              vector_of(points[static_cast<std::size_t>(mesh.target(h))])},
             false, placement);
  }
  curves.push_back(drawn(series, "", style));
  results.series.push_back(std::move(series));
}

/// Figure 6: the refined net with three rings, which define a surface ring, and with two.
void add_refined_net(Results& results) {
  const RingModel model = blend();
  const double sigma = 0.5;
  constexpr double scale = 0.3;
  std::vector<Point3> inner;
  const std::vector<int> around = fan_vertices(model.mesh, model.mesh.outgoing(0), 2).value();
  for (const int v : around) inner.push_back(model.points[static_cast<std::size_t>(v)]);
  const SectorNet<Point3> net = changed_net(SectorNet<Point3>(5, inner),
                                            changed_places(uniform_knots<double>(), unit_speed_knots(sigma)));
  const Point3 vertex = refined_net(net, ring_rules(sigma), vertex_weights(sigma, 5)).centre();
  std::vector<Curve> curves;
  for (const int rings : {3, 2}) {
    std::vector<SectorStencil<double>> rules = refined_places(sigma);
    rules.resize(sector_places(4, rings).size());
    std::vector<Point3> points{vertex};
    for (int k = 0; k < 5; ++k) {
      for (const auto& rule : rules) points.push_back(apply(rule, net, k));
    }
    const Placement placement{above, scale, {rings == 3 ? 0.0 : 280.0, 0}};
    add_net(results, curves, fmt::format("speed-net-{}", rings), 2, net.points(), placement, style::polygon);
    add_net(results, curves, fmt::format("speed-net-refined-{}", rings), rings, points, placement,
            style::curve(0, 1.5));
  }
  results.figures.push_back(bare_figure(
      "speed-net",
      "A net refined at speed 1/2: points of a ring (left), points of the next step (speed figure 6)",
      std::move(curves), {}, {"figure.speed.6"}));
}

/// Figure 9: one and two steps at several speeds; sizes of what is left open.
void add_widths(Results& results) {
  const RingModel model = blend();
  constexpr double scale = 0.2;
  constexpr double cell = 220;
  constexpr int steps = 4;
  std::vector<Curve> curves;
  add_panel(results, curves, "speed-widths-input", model.surface({}, false), {above, 0.4 * scale, {60, -95}});
  Series sizes{"speed-widths", {"steps"}, {}};
  for (int m = 1; m <= steps; ++m) sizes.rows.push_back({std::to_string(m)});
  int column = 1;
  for (const Rational& sigma : {Rational(1, 4), Rational(1, 2), Rational(3, 4)}) {
    const std::string percent = (Rational(100) * sigma).to_string();
    sizes.columns.push_back("size at " + sigma.to_string());
    for (int m = 1; m <= steps; ++m) {
      const RingSurface surface =
          model.surface(std::vector<Rational>(static_cast<std::size_t>(m), sigma), false);
      const RingHole& hole = surface.holes.front();
      constexpr int digits = 9;
      sizes.rows[static_cast<std::size_t>(m) - 1].push_back(
          to_significant(Rational::from_double(hole.size / hole.first_size), digits));
      if (m > 2) continue;
      add_panel(results, curves, fmt::format("speed-widths-{}-{}", percent, m), surface,
                {above, scale, {cell * column, m == 1 ? 0.0 : -190.0}});
    }
    ++column;
  }
  results.series.push_back(std::move(sizes));
  results.figures.push_back(
      bare_figure("speed-widths",
                  "Input (scaled to 2/5); one (top) and two steps at speeds 1/4, 1/2, 3/4 (speed figure 9)",
                  std::move(curves), {}, {"figure.speed.9"}));
}

}  // namespace

void add_speed_ring_figures(Results& results) {
  add_completion(results);
  add_refined_net(results);
  add_widths(results);
}

}  // namespace subdiv
