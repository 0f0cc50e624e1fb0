#include "experiments/polyloop_parts.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "analysis/limit_points.h"
#include "analysis/polyloop/local_geometry.h"
#include "analysis/retrofit.h"
#include "experiments/polyloop_curves.h"
#include "experiments/report/figure_style.h"
#include "experiments/simple_polygons.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const ClaimHead& head_of(const std::string& id) { return head(polyloop_local_heads(), id); }

// ---- Which radius is better -------------------------------------------------------------------------------

struct Counts {
  int acute = 0;
  int better = 0;
  int others = 0;
  int better_of_others = 0;
};

using Point = Vector<Rational>;

/// u x v.
Rational cross(const Point& u, const Point& v) { return u(0) * v(1) - u(1) * v(0); }

/// The root of a squared curvature, with the sign of the turn.
Interval signed_root(const Rational& square, const Rational& turn) {
  const Interval root = sqrt(Interval(square));
  return turn.sign() < 0 ? -root : root;
}

/// The curve of *J_s through the vertices: squared length of f' and f' x f'' at each of them.
struct Derivatives {
  std::vector<Rational> squared_speed;
  std::vector<Rational> turn;
};

Derivatives derivatives(const Rational& s, const PlanePolygon& polygon) {
  const Scheme<Rational> scheme = stationary("J", jspline(s));
  std::array<std::vector<Rational>, 2> controls;
  for (const auto& [x, y] : polygon) {
    controls[0].push_back(x);
    controls[1].push_back(y);
  }
  std::array<std::vector<Rational>, 2> first;
  std::array<std::vector<Rational>, 2> second;
  for (std::size_t c = 0; c < 2; ++c) {
    const auto loop = closed_polygon(retrofit_directly(limit_mask(scheme.last()), controls[c]));
    first[c] = limit_derivatives(scheme, loop, 0, 1);
    second[c] = limit_derivatives(scheme, loop, 0, 2);
  }
  Derivatives result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    result.squared_speed.push_back(squared_length(pair_of(first[0][i], first[1][i])));
    result.turn.push_back(cross(pair_of(first[0][i], first[1][i]), pair_of(second[0][i], second[1][i])));
  }
  return result;
}

void compare(Counts& counts, const Rational& s, const PlanePolygon& polygon) {
  const Derivatives known = derivatives(s, polygon);
  const std::size_t n = polygon.size();
  const auto vertex = [&](std::size_t i) { return pair_of(polygon[i % n].first, polygon[i % n].second); };
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = vertex(i + n - 1);
    const Point b = vertex(i);
    const Point c = vertex(i + 1);
    const Rational turn = cross(b - a, c - b);
    const Interval truly =
        signed_root(known.turn[i] * known.turn[i] / pow(known.squared_speed[i], 3), known.turn[i]);
    const Interval off_circle = abs(signed_root(squared_circle_curvature(a, b, c), turn) - truly);
    const Interval off_parabola = abs(signed_root(squared_parabola_curvature(a, b, c), turn) - truly);
    const bool better = certainly_less(off_parabola, off_circle);
    if (!better && !certainly_less(off_circle, off_parabola))
      throw std::logic_error("two errors of curvatures cannot be told apart");
    const bool acute = Point(a - b).dot(Point(c - b)).sign() > 0;
    (acute ? counts.acute : counts.others) += 1;
    if (better) (acute ? counts.better : counts.better_of_others) += 1;
  }
}

Counts compare_all(const Rational& s) {
  Counts counts;
  for (const PlanePolygon& polygon : simple_polygons()) compare(counts, s, polygon);
  return counts;
}

void add_better(Results& results) {
  const Counts counts = compare_all(Rational(3, 2));
  const Counts cubic = compare_all(Rational(1));
  results.claims.push_back(settle_share(
      head_of("polyloops.radius.better"), counts.better, counts.acute,
      fmt::format("At the other vertices: {} of {}. For the cubic B-spline curve through the vertices {} of "
                  "{}, and {} of {}. Neither is better always: on circles the circle's radius is exact, on "
                  "parabolas about their vertex the parabola's.",
                  counts.better_of_others, counts.others, cubic.better, cubic.acute, cubic.better_of_others,
                  cubic.others),
      Rigour::certified));
}

// ---- Figures ----------------------------------------------------------------------------------------------

constexpr int digits = 12;

/// A curve of known curvature.
struct Known {
  std::string name;
  std::function<std::pair<double, double>(double)> point;
  double t;
  double curvature;
};

std::vector<Known> known_curves() {
  constexpr double growth = 0.3;
  constexpr double axis = 2;
  constexpr double at_spiral = 0.8;
  const double e = std::exp(growth * at_spiral);
  return {{"ellipse", [](double t) { return std::pair{axis * std::cos(t), std::sin(t)}; }, 0.7,
           axis / std::pow(axis * axis * std::pow(std::sin(0.7), 2) + std::pow(std::cos(0.7), 2), 1.5)},
          {"parabola", [](double t) { return std::pair{t, t * t}; }, 0.3, 2 / std::pow(1.36, 1.5)},
          {"cubic", [](double t) { return std::pair{t, t * t * t}; }, 0.5, 3 / std::pow(1 + 9.0 / 16, 1.5)},
          {"spiral",
           [](double t) {
             return std::pair{std::exp(growth * t) * std::cos(t), std::exp(growth * t) * std::sin(t)};
           },
           at_spiral, 1 / (e * std::sqrt(1 + growth * growth))},
          {"circle", [](double t) { return std::pair{std::cos(t), std::sin(t)}; }, 0.4, 1}};
}

double error_at(const Known& known, double before, double after, bool circle) {
  std::vector<std::vector<double>> coordinates(2);
  for (const double t : {known.t - before, known.t, known.t + after}) {
    const auto [x, y] = known.point(t);
    coordinates[0].push_back(x);
    coordinates[1].push_back(y);
  }
  const VertexGeometry at = vertex_geometry(make_polyline(std::move(coordinates), false)).front();
  return std::abs(std::abs(circle ? at.circle_curvature : at.parabola_curvature) - known.curvature);
}

/// Errors below the rounding of the differences say nothing and are left out.
std::string cell(double error) {
  constexpr double least = 1e-13;
  constexpr int shown = 6;
  return error < least ? "" : fmt::format("{:.{}g}", error, shown);
}

void add_curvature_figure(Results& results) {
  const std::string name = "polyloop-curvature";
  Series table_of{name, {"step"}, {}};
  Figure figure{
      name,
      "Errors of curvatures, by the circle (points) and by the parabola (lines) through three points",
      "step h of the parameter",
      "error (1 / unit)",
      {},
      style::log_x + style::log_y + "set ytics 100",
      {"figure.polyloops.curvature", "polyloops.radius.circle.order", "polyloops.radius.parabola.order",
       "polyloops.radius.circle.uneven", "polyloops.radius.parabola.uneven"}};
  const std::vector<Known> curves = known_curves();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string& curve = curves[i].name;
    for (const char* way : {"circle", "parabola", "circle, uneven", "parabola, uneven"}) {
      const std::string column = curve + ": " + way;
      table_of.columns.push_back(column);
      const bool by_circle = std::string(way).starts_with("circle");
      const bool even = std::string(way).find("uneven") == std::string::npos;
      const bool exactly = even && curve == way;  // the error is 0
      const bool shown = even || curve == "ellipse";
      if (!shown || exactly || (curve == "circle" && by_circle)) continue;
      // One name a curve: how its curvature is found is told by points and lines.
      const bool named = by_circle ? curve == "parabola" : even;
      const std::string label = named ? curve : (even || by_circle ? "" : curve + ", uneven");
      figure.curves.push_back(
          {name, "step", column, label,
           by_circle ? style::points(even ? i : 5, 0.5) : style::curve(even ? i : 5, 1.5)});
    }
  }
  constexpr int steps = 10;
  for (int k = 0; k <= steps; ++k) {
    const double h = std::ldexp(0.5, -k);
    std::vector<std::string> row{fmt::format("{:.{}g}", h, digits)};
    for (const Known& known : curves) {
      for (const double after : {h, 2 * h}) {
        for (const bool circle : {true, false}) row.push_back(cell(error_at(known, h, after, circle)));
      }
    }
    table_of.rows.push_back(std::move(row));
  }
  const auto error = [](const Rational& h) {  // of the squared curvature of (t, t^3) at 1/2, 9/(25/16)^3
    const Rational t(1, 2);
    const auto point = [](const Rational& at) { return pair_of(at, at * at * at); };
    const Rational known = Rational(9) / pow(Rational(25, 16), 3);
    return squared_circle_curvature(point(t - h), point(t), point(t + h)) - known;
  };
  constexpr int halves = 64;
  results.claims.push_back(
      settle(head_of("figure.polyloops.curvature"),
             exact(error(Rational(1, halves)) / error(Rational(1, 2 * halves)), "rational arithmetic"),
             "Close to 4: order two. Where the step doubles at the vertex (uneven), the circle has order one "
             "and the parabola an error of a ninth."));
  results.series.push_back(std::move(table_of));
  results.figures.push_back(std::move(figure));
}

void add_acute_figure(Results& results) {
  const std::string name = "polyloop-acute";
  Series table_of{name, {"angle", "circle", "parabola"}, {}};
  constexpr int straight = 180;
  constexpr int between = 3;
  for (int degrees = between; degrees < straight; degrees += between) {
    const double half_angle = degrees * std::numbers::pi / (2 * straight);
    const double x = std::sin(half_angle);
    const double y = std::cos(half_angle);
    const VertexGeometry at = vertex_geometry(make_polyline({{-x, 0, x}, {-y, 0, -y}}, false)).front();
    table_of.rows.push_back({std::to_string(degrees), fmt::format("{:.{}g}", at.circle_radius(), digits),
                             fmt::format("{:.{}g}", at.parabola_radius(), digits)});
  }
  const Vector<Rational> a = pair_of(Rational(-3), Rational(-4));
  const Vector<Rational> b = pair_of(Rational(0), Rational(0));
  const Vector<Rational> c = pair_of(Rational(3), Rational(-4));
  const Rational circle = squared_circle_curvature(a, b, c);
  const Rational parabola = squared_parabola_curvature(a, b, c);
  const Rational ratio(25, 9);
  if (parabola != ratio * ratio * circle) throw std::logic_error("radii at a vertex disagree");
  results.claims.push_back(settle(head_of("figure.polyloops.acute"), exact(ratio, "rational arithmetic"),
                                  "1/sin^2 of half the angle, whose sine is 3/5."));
  results.figures.push_back(
      {name,
       "Radii of curvature at a vertex between two edges of length 1",
       "angle between the edges (degrees)",
       "radius (edge lengths)",
       {{name, "angle", "circle", "circle"}, {name, "angle", "parabola", "parabola"}},
       style::log_y + "set xrange [0:180]; set xtics 30",
       {"figure.polyloops.acute", "polyloops.radius.circle.acute", "polyloops.radius.ratio"}});
  results.series.push_back(std::move(table_of));
}

}  // namespace

Results run_polyloop_radii() {
  Results results;
  add_better(results);
  add_curvature_figure(results);
  add_acute_figure(results);
  return results;
}

}  // namespace subdiv
