#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/mesh/bernstein_patch.h"
#include "experiments/plane_diagram.h"
#include "experiments/speed_characteristic_ring.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {
namespace {

constexpr int drawn_valence = 5;

using Patch = BezierPatch<RingPoint<double>>;
using Lines = std::vector<std::vector<Spot>>;

/// Where a ring is drawn: turned about 0, its first border's corner a unit from `centre`.
struct Stand {
  Spot centre;
  double angle = 0;
  double factor = 1;  // lambda for the next ring
};

/// Points of a ring in the plane, t_00 at the distance 1.
class RingPlane {
 public:
  RingPlane(int valence, const CharacteristicRing<double>& ring)
      : cosine_(std::cos(std::numbers::pi / valence)),
        sine_(std::sin(std::numbers::pi / valence)),
        unit_(1 / (cosine_ * ring.border[0][0])) {}

  [[nodiscard]] Spot spot(const RingPoint<double>& p, const Stand& stand) const {
    const double x = stand.factor * unit_ * cosine_ * p[0];
    const double y = stand.factor * unit_ * sine_ * p[1];
    const double c = std::cos(stand.angle);
    const double s = std::sin(stand.angle);
    return stand.centre + Spot{c * x - s * y, s * x + c * y};
  }

 private:
  double cosine_;
  double sine_;
  double unit_;
};

RingPoint<double> point_at(const Patch& patch, double u, double v) {
  const auto basis = [](double t) {
    const double r = 1 - t;
    return std::array<double, 4>{r * r * r, 3 * r * r * t, 3 * r * t * t, t * t * t};
  };
  const std::array<double, 4> a = basis(u);
  const std::array<double, 4> b = basis(v);
  RingPoint<double> sum{0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) add_weighted(sum, a.at(i) * b.at(j), patch[4 * i + j]);
  }
  return sum;
}

/// The lines u or v = k/parts of a patch; its borders alone for parts = 1.
void add_isolines(Lines& lines, const Patch& patch, int parts, const RingPlane& plane, const Stand& stand) {
  constexpr int steps = 12;
  for (int k = 0; k <= parts; ++k) {
    for (const bool along : {true, false}) {
      std::vector<Spot>& line = lines.emplace_back();
      for (int step = 0; step <= steps; ++step) {
        const double t = static_cast<double>(step) / steps;
        const double fixed = static_cast<double>(k) / parts;
        line.push_back(plane.spot(along ? point_at(patch, t, fixed) : point_at(patch, fixed, t), stand));
      }
    }
  }
}

std::array<const Patch*, 3> patches(const RingSector<RingPoint<double>>& sector) {
  return {&sector.corner, &sector.next_side, &sector.first_side};
}

/// The net of the coefficients of a patch for which `shown(i, j)`.
template <class Shown>
void add_net(Lines& lines, std::vector<NamedSpot>& dots, const Patch& patch, Shown&& shown,
             const RingPlane& plane, const Stand& stand) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (!shown(i, j)) continue;
      const Spot here = plane.spot(patch[4 * i + j], stand);
      dots.push_back({"", here});
      if (i < 3 && shown(i + 1, j)) lines.push_back({here, plane.spot(patch[4 * (i + 1) + j], stand)});
      if (j < 3 && shown(i, j + 1)) lines.push_back({here, plane.spot(patch[4 * i + j + 1], stand)});
    }
  }
}

// ---- Figure 7 --------------------------------------------------------------------------------------------

/// Coefficients of the sector that are lambda times one of the outermost line of the border, each counted
/// once.
std::size_t scaled_coefficients() {
  using Function = RationalFunction;
  const RingShape<Function> shape{Function::variable(0), Function::variable(1)};
  const CharacteristicRing<Function> ring = characteristic_ring(shape);
  std::set<std::size_t> found;
  for (const auto* patch : {&ring.sector.corner, &ring.sector.next_side, &ring.sector.first_side}) {
    for (const RingPoint<Function>& point : *patch) {
      for (std::size_t k = 0; k < 16; ++k) {
        if (k > 3 && k % 4 != 0) continue;
        const RingPoint<Function>& outer = ring.border[k];
        if (point[0] == shape.eigenvalue() * outer[0] && point[1] == shape.eigenvalue() * outer[1])
          found.insert(k);
      }
    }
  }
  return found.size();
}

}  // namespace

void add_ring_construction_figure(Results& results, const ClaimHead& head) {
  constexpr double sigma = 2.0 / 3;
  constexpr double step = 1.05;  // from panel to panel
  const CharacteristicRing<double> ring = characteristic_ring(ring_shape(sigma, drawn_valence));
  const RingPlane plane(drawn_valence, ring);
  const auto stand = [](int panel) { return Stand{{panel * step, 0}}; };
  PlaneDiagram diagram("speed-ring-construction",
                       "One sector of the characteristic ring, n = 5, speed 2/3 (speed figure 7)");

  Lines net;
  std::vector<NamedSpot> dots;
  add_net(
      net, dots, ring.border, [](std::size_t i, std::size_t j) { return i < 3 || j < 3; }, plane, stand(0));
  const std::size_t known = dots.size();
  for (std::size_t k = 0; k < 15; ++k)
    dots[k].name = k % 4 == 0 || k < 4 ? fmt::format("t{}{}", k / 4, k % 4) : "";
  diagram.add_lines("border-net", net, style::line);
  diagram.add_dots("border", dots, style::dot);

  Lines patch_lines;
  Lines split_net;
  std::vector<NamedSpot> split_dots;
  std::vector<NamedSpot> scaled_dots;
  for (const int panel : {1, 2}) {
    Lines& nets = split_net;
    const auto outside = [panel](std::size_t layer) { return panel == 2 || layer < 3; };
    add_net(
        nets, split_dots, ring.sector.corner,
        [&](std::size_t i, std::size_t j) { return outside(i < 3 || j < 3 ? 0 : 3); }, plane, stand(panel));
    add_net(
        nets, split_dots, ring.sector.next_side, [&](std::size_t, std::size_t j) { return outside(j); },
        plane, stand(panel));
    add_net(
        nets, split_dots, ring.sector.first_side, [&](std::size_t i, std::size_t) { return outside(i); },
        plane, stand(panel));
  }
  for (const Patch* patch : patches(ring.sector)) add_isolines(patch_lines, *patch, 1, plane, stand(2));
  for (std::size_t k = 0; k < 4; ++k) {
    scaled_dots.push_back({"", plane.spot(ring.sector.first_side[12 + k], stand(2))});
    scaled_dots.push_back({"", plane.spot(ring.sector.next_side[4 * k + 3], stand(2))});
  }
  diagram.add_lines("split-net", split_net, style::line);
  diagram.add_lines("patches", patch_lines, style::thick);
  diagram.add_dots("split", split_dots, style::dot);
  diagram.add_dots("scaled", scaled_dots, style::bright_dot);
  constexpr std::array captions{"tensor border", "subdivided, 2 : 1", "λ times the border"};
  constexpr double below = -0.62;
  for (std::size_t panel = 0; panel < captions.size(); ++panel)
    diagram.add_text(captions.at(panel), {static_cast<double>(panel) * step + 0.62, below});
  diagram.add_to(results, {"figure.speed.7"});

  std::size_t defined = 0;
  for (const auto& coefficient : tensor_border(Rational(2, 3))) defined += coefficient ? 1 : 0;
  const std::size_t scaled = scaled_coefficients();
  if (known != defined) throw std::logic_error("all coefficients of the tensor border are drawn");
  results.claims.push_back(
      settle_statement(head, defined == 15 && scaled == 7, fmt::format("{} of 16; {}", defined, scaled),
                       "The latter over Q(sigma, v), for all speeds and valences, each counted once."));
}

// ---- Figure 8 --------------------------------------------------------------------------------------------

namespace {

Interval mean(const SquarePatch& f) {
  Interval sum(0);
  for (const Interval& c : f.coefficients()) sum += c;
  return sum / Interval(static_cast<int>(f.coefficients().size()));
}

/// A coordinate of a patch, or of its line i = 0.
SquarePatch coordinate(const BezierPatch<RingPoint<Interval>>& patch, std::size_t k, bool line) {
  SquarePatch result(line ? 0 : 3, 3);
  for (std::size_t slot = 0; slot < (line ? 4 : patch.size()); ++slot)
    result(static_cast<int>(slot / 4), static_cast<int>(slot % 4)) = patch[slot][k];
  return result;
}

/// What the area of a ring over that inside of its outer border differs from 1 - lambda^2.
Interval area_difference(const Rational& speed) {
  constexpr long precision = 256;
  const RingShape<Interval> shape = ring_shape(Interval(speed, precision), drawn_valence);
  const RingSector<RingPoint<Interval>> sector = characteristic_ring(shape).sector;
  Interval ring(0);    // of the sector
  Interval inside(0);  // by twice the outer border's half from the bisectrix to the first spoke
  for (const auto* patch : {&sector.corner, &sector.next_side, &sector.first_side}) {
    const SquarePatch x = coordinate(*patch, 0, false);
    const SquarePatch y = coordinate(*patch, 1, false);
    ring += mean(derivative_u(x) * derivative_v(y) - derivative_u(y) * derivative_v(x));
  }
  for (const auto* patch : {&sector.corner, &sector.first_side}) {
    const SquarePatch x = coordinate(*patch, 0, true);
    const SquarePatch y = coordinate(*patch, 1, true);
    inside += mean(y * derivative_v(x) - x * derivative_v(y));
  }
  return ring / inside - (Interval(1) - shape.eigenvalue() * shape.eigenvalue());
}

}  // namespace

void add_ring_speeds_figure(Results& results, const ClaimHead& head) {
  constexpr std::array speeds{std::array{1, 4}, std::array{1, 2}, std::array{3, 4}, std::array{9, 10}};
  constexpr double step = 2.2;
  constexpr double sectors_at = 1.9;  // the row of sectors above that of whole rings
  PlaneDiagram diagram(
      "speed-ring-shapes",
      "Characteristic rings, n = 5: one sector, and all with the next ring (speed figure 8)");
  Lines thin;
  Lines thick;
  Lines next;
  Interval largest(0);
  for (std::size_t column = 0; column < speeds.size(); ++column) {
    const auto [above, below] = speeds.at(column);
    const double at = static_cast<double>(column) * step;
    const RingShape<double> shape = ring_shape(static_cast<double>(above) / below, drawn_valence);
    const CharacteristicRing<double> ring = characteristic_ring(shape);
    const RingPlane plane(drawn_valence, ring);
    constexpr double half_turn = std::numbers::pi / 2;
    for (const Patch* patch : patches(ring.sector)) {
      const Stand stand{{at, sectors_at - 0.5}, half_turn, 1.4};
      add_isolines(thin, *patch, 6, plane, stand);
      add_isolines(thick, *patch, 1, plane, stand);
      for (int sector = 0; sector < drawn_valence; ++sector) {
        const double angle = half_turn + 2 * std::numbers::pi * sector / drawn_valence;
        add_isolines(thick, *patch, 1, plane, {{at, 0}, angle, 1});
        add_isolines(thin, *patch, 3, plane, {{at, 0}, angle, 1});
        add_isolines(next, *patch, 1, plane, {{at, 0}, angle, shape.eigenvalue()});
      }
    }
    diagram.add_text(fmt::format("speed {}/{}", above, below), {at, -1.3});
    largest = max(largest, abs(area_difference(Rational(above, below))));
  }
  diagram.add_lines("isolines", thin, style::thin);
  diagram.add_lines("next", next, style::line);
  diagram.add_lines("patches", thick, style::thick);
  diagram.add_to(results, {"figure.speed.8"});

  const Interval bound(Rational(1) / pow(Rational(10), 30));
  if (!certainly_less(largest, bound)) throw std::logic_error("the areas of characteristic rings");
  results.claims.push_back(settle_statement(head, true, "at most 1e-30",
                                            "Four speeds; the Jacobian is positive, so that both areas count "
                                            "every point once.",
                                            Rigour::certified));
}

}  // namespace subdiv
