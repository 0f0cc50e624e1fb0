#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/mesh/characteristic_map.h"
#include "analysis/mesh/lattice_limits.h"
#include "experiments/characteristic_maps.h"
#include "experiments/surface_pictures.h"

namespace subdiv {
namespace {

constexpr std::array drawn_valences{3, 5, 6, 7, 8, 20};
constexpr int drawn_rows = 4;

std::string decimal(double x, int digits) { return to_decimal(Rational::from_double(x), digits); }

/// The limit point at lattice steps (a, b), a >= b >= 0 in sector 0, from f(x) = lambda^k f(2^k x): at row 3
/// and beyond faces around are regular.
PlaneNumber<double> point_at(const CharacteristicNet<double>& net, const LatticeLimits& limits, int a,
                             int b) {
  if (a == 0) return {};
  double scale = 1;
  while (std::max(a, b) < 3) {
    a *= 2;
    b *= 2;
    scale *= net.eigenvalue();
  }
  return scale * limits.point(net, a, b);
}

/// Where a map is drawn: its outermost points a unit from the centre.
struct Cell {
  double x;
  double y;
  double unit;
};

void add_map(Series& series, const CharacteristicNet<double>& net, const LatticeLimits& limits,
             const Cell& cell) {
  const PlaneNumber<double> corner = point_at(net, limits, drawn_rows, drawn_rows);
  const double size = std::max(std::hypot(corner.x, corner.y), point_at(net, limits, drawn_rows, 0).x);
  const auto at = [&](int sector, int a, int b) {
    const PlaneNumber<double> w = turn<double>(net.mode() * sector, net.valence());
    const PlaneNumber<double> half =
        b <= a ? point_at(net, limits, a, b)
               : turn<double>(net.mode(), net.valence()) * conjugate(point_at(net, limits, b, a));
    return (1 / size) * (w * half);
  };
  constexpr int digits = 5;
  for (int sector = 0; sector < net.valence(); ++sector) {
    for (int line = 0; line <= drawn_rows; ++line) {
      for (const bool along : {true, false}) {
        if (along && line == 0) continue;  // the last spoke: the next sector's first
        for (int step = 0; step <= drawn_rows; ++step) {
          const PlaneNumber<double> p = along ? at(sector, line, step) : at(sector, step, line);
          series.rows.push_back({decimal(cell.x + cell.unit * p.x, 1), decimal(cell.y + cell.unit * p.y, 1),
                                 decimal(p.x, digits), decimal(p.y, digits)});
        }
        series.rows.push_back({"", "", "", ""});
      }
    }
  }
}

/// The largest distance of the net after a step of the scheme on the mesh of all sectors from the net times
/// its eigenvalue, over the distance of the first neighbour from the vertex.
double residual(const MeshScheme<double>& scheme, const CharacteristicNet<double>& net) {
  const int n = net.valence();
  const int rings = scheme.reach + 4;
  const MeshTopology mesh = fan_topology(net.sides(), n, rings);
  const std::vector<FanPlace> places = sector_places(net.sides(), rings);
  std::vector<std::array<double, 2>> points{{0, 0}};
  for (int k = 0; k < n; ++k) {
    for (const FanPlace& place : places) {
      const PlaneNumber<double> p = turn<double>(net.mode() * k, n) * net.at(place.a, place.b);
      points.push_back({p.x, p.y});
    }
  }
  const std::vector<std::array<double, 2>> fine = refined_points(mesh, scheme, points);
  const MeshTopology fine_mesh = split(mesh, scheme.split);
  int spoke = -1;  // the half of the first spoke
  for_each_outgoing(fine_mesh, 0, [&](int h) {
    const int edge = fine_mesh.target(h) - mesh.vertices();
    const int along = mesh.half_edge(edge);
    if (mesh.origin(along) + mesh.target(along) == 1) spoke = h;
  });
  const std::optional<std::vector<int>> order = fan_vertices(fine_mesh, spoke, rings);
  if (!order) throw std::logic_error("a refined fan is a fan");
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& found = fine[static_cast<std::size_t>((*order)[i])];
    largest = std::max(largest, std::hypot(found[0] - net.eigenvalue() * points[i][0],
                                           found[1] - net.eigenvalue() * points[i][1]));
  }
  return largest / net.at(1, 0).x;
}

}  // namespace

void add_characteristic_map_figure(Results& results, const ClaimHead& head) {
  constexpr double cell = 100;
  const std::array<std::pair<const char*, std::string_view>, 3> rows{
      {{"-1/4", style::blue}, {"1/2", style::green}, {"3/2", style::vermilion}}};
  bool smooth = true;
  double largest = 0;
  std::vector<Curve> curves;
  std::vector<FigureText> labels;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto& [s, colour] = rows.at(row);
    const MeshSchemeForms scheme = mesh_scheme_forms(parse_mesh_scheme(fmt::format("jspline-mesh:s={}", s)));
    const std::optional<LatticeLimits> limits = lattice_limits(scheme.rounded);
    Series series{fmt::format("characteristic-maps-{}", row + 1), {"x", "y", "px", "py"}, {}};
    for (std::size_t column = 0; column < drawn_valences.size(); ++column) {
      const int n = drawn_valences.at(column);
      const CharacteristicMap map = characteristic_map(scheme, n);
      const std::optional<CharacteristicNet<double>> net =
          characteristic_net(scheme.rounded, n, 2 * drawn_rows + scheme.rounded.reach + 1);
      if (!limits || !net) throw std::logic_error("a characteristic map of figure 13 does not exist");
      smooth = smooth && map.rigour == Rigour::certified && map.mode == 1 && map.regular == Decision::yes &&
               map.injective == Decision::yes;
      largest = std::max(largest, residual(scheme.rounded, *net));
      constexpr double share = 0.46;
      add_map(series, *net, *limits,
              {static_cast<double>(column) * cell, -static_cast<double>(row) * cell, share * cell});
      if (row == 0)
        labels.push_back({fmt::format("n = {}", n), static_cast<double>(column) * cell, -2.65 * cell});
    }
    curves.push_back(drawn(series, fmt::format("s = {}", s), style::in_colour(colour, 1)));
    results.series.push_back(std::move(series));
  }
  results.figures.push_back(
      bare_figure("characteristic-maps",
                  "Characteristic maps at vertices of n edges (jsplines figure 13); rows: s = -1/4, 1/2, 3/2",
                  std::move(curves), std::move(labels), {"figure.characteristic-maps"}));
  constexpr double rounding = 1e-10;
  results.claims.push_back(settle_statement(
      head, smooth && largest < rounding,
      fmt::format("18 maps, {}", smooth ? "regular and injective" : "not all smooth"),
      fmt::format("One step of the scheme changes no net by more than {} but for the factor.",
                  largest < rounding ? "1e-10 of its first edge" : decimal(largest, 6)),
      Rigour::certified));
}

}  // namespace subdiv
