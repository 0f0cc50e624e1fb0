#include "experiments/speed_figures.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/plane_diagram.h"
#include "experiments/speed_figure_parts.h"
#include "schemes/adjustable_speed/speed_rules.h"
#include "schemes/bspline.h"

namespace subdiv {
namespace {

using Line = std::vector<Spot>;

const std::array table{
    finding(
        "figure.speed.2", "speed II, figure 2",
        "Five control points over the knots -3 .. 3, all middles inserted, and over 0, +-1/3, +-1, +-3, the "
        "knots +-1/9 inserted (speed 2/3): Boehm's algorithm, knot after knot, against the mask (1, 4, 6, 4, "
        "1)/8 and the rules of adjustable speed, over Q."),
    ClaimHead{
        "figure.speed.3", "speed", "II, figure 3",
        "The adjustable knot spacings around an extraordinary node are consistent and define a sequence of "
        "C2 connected bi-3 surface rings in n = 5 sectors",
        ClaimKind::exact,
        "Bezier conditions of C2 over Q(sigma, beta, gamma), as identities between combinations of control "
        "points that hold for every valence: between neighbouring sectors, between the three patches of a "
        "sector's ring, between a ring and the tensor border of the next."},
    finding(
        "figure.speed.4", "speed II, figure 4",
        "Control points of a regular vertex at the means of their three knots in each direction: the Bezier "
        "points of the ring then stand at equal steps over each patch, over Q(sigma)."),
    finding(
        "figure.speed.5", "speed II, figure 5",
        "With the same control points the refined ones with the numbers k = 1 .. 7 are q times the points ij "
        "that they follow, over Q(sigma): the indexing is consistent."),
    finding("figure.speed.10", "speed V-C, figure 10",
            "With the same control points t_ij stands at ((3 - i)/3, (3 - j)/3) a, over Q(sigma)."),
};

/// Cubic splines: control point i stands at the mean of the knots i + 1, i + 2, i + 3.
struct Spline {
  std::vector<Rational> knots;
  std::vector<Rational> points;

  [[nodiscard]] Rational abscissa(std::size_t i) const {
    return (knots[i + 1] + knots[i + 2] + knots[i + 3]) / Rational(3);
  }
};

/// Boehm's algorithm: a knot t inside [knots[k], knots[k + 1]) replaces the points k - 2, k - 1 by three.
void insert_knot(Spline& spline, const Rational& t) {
  const auto above = std::upper_bound(spline.knots.begin(), spline.knots.end(), t);
  const auto k = static_cast<std::size_t>(above - spline.knots.begin()) - 1;
  std::vector<Rational> points(spline.points.begin(),
                               spline.points.begin() + static_cast<std::ptrdiff_t>(k) - 2);
  for (std::size_t i = k - 2; i <= k; ++i) {
    const Rational share = (t - spline.knots[i]) / (spline.knots[i + 3] - spline.knots[i]);
    points.push_back(share * spline.points[i] + (Rational(1) - share) * spline.points[i - 1]);
  }
  points.insert(points.end(), spline.points.begin() + static_cast<std::ptrdiff_t>(k), spline.points.end());
  spline.points = std::move(points);
  spline.knots.insert(above, t);
}

/// Knots -a_3 .. a_3, one more at each end that no point depends on.
Spline symmetric_spline(const LineKnots<Rational>& a, const std::vector<Rational>& points) {
  const Rational end = Rational(2) * a[2];
  return {{-end, -a[2], -a[1], -a[0], Rational(0), a[0], a[1], a[2], end}, points};
}

const std::vector<Rational> heights{Rational(1, 5), Rational(1), Rational(0), Rational(4, 5),
                                    Rational(3, 10)};

Line polygon_of(const Spline& spline, double right, double up) {
  constexpr double height = 1.6;
  Line line;
  for (std::size_t i = 0; i < spline.points.size(); ++i)
    line.push_back({right + spline.abscissa(i).to_double(), up + height * spline.points[i].to_double()});
  return line;
}

std::vector<NamedSpot> unnamed(const Line& line) {
  std::vector<NamedSpot> dots;
  for (const Spot& p : line) dots.push_back({"", p});
  return dots;
}

/// The knots of four levels as ticks.
std::vector<Line> knot_ticks(const std::vector<std::vector<Rational>>& levels, double right, double up) {
  constexpr double step = 0.62;
  constexpr double tick = 0.17;
  std::vector<Line> lines;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const double y = up - step * static_cast<double>(level);
    lines.push_back({{right - 3, y}, {right + 3, y}});
    for (const Rational& knot : levels[level]) {
      const double x = right + knot.to_double();
      lines.push_back({{x, y - tick}, {x, y + tick}});
    }
  }
  return lines;
}

void add_univariate(Results& results) {
  const Rational sigma(2, 3);
  const Rational third(1, 3);
  const Spline coarse = symmetric_spline({Rational(1), Rational(2), Rational(3)}, heights);
  Spline halved = coarse;
  for (const int twice : {-3, -1, 1, 3}) insert_knot(halved, Rational(twice, 2));
  // Points that stand at the triples of knots between -2 and 2.
  const Spline inner{{halved.knots.begin() + 1, halved.knots.end() - 1},
                     {halved.points.begin() + 1, halved.points.end() - 1}};
  const Mask<Rational> mask = bspline<Rational>(3);
  bool same = inner.points.size() == 7;
  for (std::size_t i = 0; i < inner.points.size(); ++i) {  // at (i - 3)/2, from the points at j - 2
    Rational sum(0);
    for (std::size_t j = 0; j < heights.size(); ++j)
      sum += mask.symbol[static_cast<int>(i) - 2 * static_cast<int>(j) + 1] * heights[j];
    same = same && inner.points[i] == sum;
  }
  const Spline geometric = symmetric_spline({third, Rational(1), Rational(3)}, heights);
  Spline fast = geometric;
  for (const int sign : {-1, 1}) insert_knot(fast, Rational(sign, 9));
  const auto rows = inserted_rows(sigma);
  same = same && fast.points.size() == 7;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Rational up(0);
    Rational down(0);
    for (std::size_t j = 0; j < 4; ++j) {
      up += rows[i][j] * heights[j + 1];
      down += rows[i][j] * heights[3 - j];
    }
    same = same && fast.points[3 + i] == up && fast.points[3 - i] == down;
  }
  results.claims.push_back(settle_statement(head(table, "figure.speed.2"), same, "the same seven points"));

  constexpr double right = 8.2;
  constexpr double refined_up = -2.7;
  constexpr double knots_up = -4.1;
  PlaneDiagram diagram(
      "speed-univariate",
      "Uniform and adjustable speed in one variable (eon: extraordinary node; speed figure 2)");
  const std::vector<std::pair<const Spline*, const Spline*>> columns{{&coarse, &inner}, {&geometric, &fast}};
  std::vector<Line> old_lines;
  std::vector<Line> new_lines;
  std::vector<NamedSpot> old_dots;
  std::vector<NamedSpot> new_dots;
  std::vector<NamedSpot> nodes;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double x = right * static_cast<double>(c);
    const Line before = polygon_of(*columns[c].first, x, 0);
    const Line below = polygon_of(*columns[c].first, x, refined_up);
    const Line after = polygon_of(*columns[c].second, x, refined_up);
    old_lines.push_back(before);
    old_lines.push_back(below);
    new_lines.push_back(after);
    for (const NamedSpot& dot : unnamed(before)) old_dots.push_back(dot);
    for (const NamedSpot& dot : unnamed(after)) new_dots.push_back(dot);
    nodes.push_back({"eon", before[2]});
    nodes.push_back({"", after[3]});
  }
  std::vector<std::vector<Rational>> uniform_levels;
  std::vector<std::vector<Rational>> speed_levels;
  std::vector<Rational> knots{Rational(-3), Rational(-1), -third,     Rational(0),
                              third,        Rational(1),  Rational(3)};
  for (int level = 0; level <= 3; ++level) {
    const int parts = 1 << level;
    uniform_levels.emplace_back();
    for (int i = -3 * parts; i <= 3 * parts; ++i) uniform_levels.back().emplace_back(i, parts);
    if (level > 0) {
      const Rational next = pow(third, level + 1);
      knots.push_back(next);
      knots.push_back(-next);
    }
    speed_levels.push_back(knots);
  }
  diagram.add_lines("polygons", old_lines, style::thin);
  diagram.add_lines("refined", new_lines, style::thick);
  diagram.add_dots("points", old_dots, style::dot);
  diagram.add_dots("refined-points", new_dots, style::dot);
  diagram.add_dots("nodes", nodes, style::bright_dot, {0, -0.8});
  diagram.add_lines("knots-uniform", knot_ticks(uniform_levels, 0, knots_up), style::line);
  diagram.add_lines("knots-speed", knot_ticks(speed_levels, right, knots_up), style::line);
  constexpr double caption = 2.1;
  diagram.add_text("uniform", {0, caption});
  diagram.add_text("speed 2/3", {right, caption});
  for (int level = 0; level <= 3; ++level)
    diagram.add_text(fmt::format("step {}", level), {right / 2, knots_up - 0.62 * level});
  diagram.add_to(results, {"figure.speed.2"});
}

}  // namespace

std::span<const ClaimHead> speed_figure_heads() { return table; }

Results run_speed_figures() {
  Results results;
  add_univariate(results);
  add_speed_knot_lines(results, table);
  add_speed_derivation(results, table);
  add_speed_indices(results, table);
  add_speed_border_indices(results, table);
  return results;
}

}  // namespace subdiv
