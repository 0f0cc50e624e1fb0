#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/polyloop/local_geometry.h"
#include "experiments/area_schemes.h"
#include "experiments/drawing.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_shapes.h"
#include "schemes/evaluate/ringing.h"

namespace subdiv {
namespace {

const std::string level_five = "Polygons of level 5, exact: ";

const std::array table{
    ClaimHead{"figure.polyloops.inwards-out.square", "polyloops", "3.1, figure",
              "inwards out, J0, J2, J4, J6, and J8 for a square control polyloop", ClaimKind::exact,
              level_five + "of two curves that follow each other every vertex of the first lies within the "
                           "second, by winding number."},
    ClaimHead{"figure.polyloops.inwards-out.non-convex", "polyloops", "3.1, figure",
              "inwards out, J0, J2, J4, J6, and J8 for a square control polyloop and for a non-convex one",
              ClaimKind::exact,
              level_five + "of two curves that follow each other every vertex of the first lies within the "
                           "second, by winding number. On the polyloop of polyloop-non-convex.csv."},
    finding("figure.polyloops.superposed", "polyloops 3.1, figure",
            "On the self-intersecting polyloop-crossing.csv: the signed area of level 5 of J8 over that of "
            "J0."),
    finding("figure.polyloops.j4-j5", "polyloops 3.1, figure",
            "On polyloop-non-convex.csv: the area of level 5 of J5 over that of J4."),
    finding("figure.polyloops.jerk", "polyloops 3.2, figure",
            "On polyloop-non-convex.csv, level 4: the largest squared normal jerk of J0 over that of J8."),
    finding("figure.polyloops.jerk.jm", "polyloops 3.2, figure", "The same of Jm over that of J8."),
    finding("figure.polyloops.row", "polyloops 3.2, figure",
            "On polyloop-star.csv: the area of level 5 of Jm over that of the polygon."),
};

using Plane = Eigen::Matrix<Rational, 2, 1>;
using Points = std::vector<Plane>;

const std::vector<std::string> inwards_out{"J0", "J2", "J4", "J6", "J8"};

Points points_of(const PlanePolygon& polygon) {
  Points points;
  for (const auto& [x, y] : polygon) points.emplace_back(x, y);
  return points;
}

Points curve(const std::string& name, const PlanePolygon& polygon, int level = measured_level) {
  const ControlPolygon<Plane> controls = closed_polygon(points_of(polygon));
  Ringing<Rational, Plane> rings(polyloop_curve(name), controls, level);
  Points points;
  for (const Plane& p : rings) points.push_back(p);
  return points;
}

PlanePolygon plane(const Points& points) {
  PlanePolygon result;
  for (const Plane& p : points) result.emplace_back(p(0), p(1));
  return result;
}

Rational cross(const Plane& u, const Plane& v) { return u(0) * v(1) - u(1) * v(0); }

Rational doubled_area(const Points& p) {
  Rational sum(0);
  for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i], p[(i + 1) % p.size()]);
  return sum;
}

/// How often a closed polygon winds around a point that does not lie on it; edges count where they cross the
/// ray to the right, half-open in y.
int winding_number(const Points& polygon, const Plane& point) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Plane& from = polygon[i];
    const Plane& to = polygon[(i + 1) % polygon.size()];
    if ((from(1) <= point(1)) == (to(1) <= point(1))) continue;
    const int side = cross(to - from, point - from).sign();
    if (side > 0 && to(1) > from(1)) ++winding;
    if (side < 0 && to(1) < from(1)) --winding;
  }
  return winding;
}

/// How many vertices of the inner curves lie outside the next.
int outside_next(const PlanePolygon& polygon) {
  int count = 0;
  Points inner = curve(inwards_out.front(), polygon);
  for (std::size_t i = 1; i < inwards_out.size(); ++i) {
    Points outer = curve(inwards_out[i], polygon);
    count += static_cast<int>(
        std::ranges::count_if(inner, [&](const Plane& p) { return winding_number(outer, p) == 0; }));
    inner = std::move(outer);
  }
  return count;
}

Claim number(const std::string& id, const Rational& value, const std::string& note = "") {
  return settle(head(table, id), exact(value, "rational arithmetic"), note);
}

Stroke polygon_stroke(const PlanePolygon& polygon) { return {"", polygon, true, style::polygon}; }

/// Moved and scaled so that its box has the width 1 about the origin: panels in one scale.
PlanePolygon in_unit_box(const PlanePolygon& points, const PlanePolygon& box) {
  const auto by_x = [](const auto& p, const auto& q) { return p.first < q.first; };
  const auto by_y = [](const auto& p, const auto& q) { return p.second < q.second; };
  const auto [left, right] = std::ranges::minmax_element(box, by_x);
  const auto [low, high] = std::ranges::minmax_element(box, by_y);
  const Rational half(1, 2);
  const Rational x = (left->first + right->first) * half;
  const Rational y = (low->second + high->second) * half;
  const Rational size = std::max(right->first - left->first, high->second - low->second);
  PlanePolygon result;
  for (const auto& [px, py] : points) result.emplace_back((px - x) / size, (py - y) / size);
  return result;
}

void add_family(Results& results) {
  Drawing drawing{"polyloop-family",
                  "J0, J2, J4, J6, J8 from the inside outwards",
                  {},
                  {"figure.polyloops.inwards-out."}};
  for (const char* name : {"square", "non-convex"}) {
    const PlanePolygon& polygon = stored_polyloop(name);
    Panel panel{name, {polygon_stroke(in_unit_box(polygon, polygon))}};
    for (std::size_t i = 0; i < inwards_out.size(); ++i) {
      panel.strokes.push_back({drawing.panels.empty() ? inwards_out[i] : "",
                               in_unit_box(plane(curve(inwards_out[i], polygon)), polygon), true,
                               style::curve(i, 1.5)});
    }
    drawing.panels.push_back(std::move(panel));
    const int outside = outside_next(polygon);
    results.claims.push_back(settle_statement(
        head(table, std::string("figure.polyloops.inwards-out.") + name), outside == 0,
        outside == 0 ? "true" : "false",
        outside == 0 ? ""
                     : fmt::format("The order is reversed at concave vertices: {} vertices of the curves lie "
                                   "outside the next one. Areas rise in this order.",
                                   outside)));
  }
  add_drawing(results, drawing);
}

void add_superposed(Results& results) {
  const PlanePolygon& polygon = stored_polyloop("crossing");
  Panel panel{"", {}};
  constexpr std::array shades{style::blue, style::vermilion, style::green, style::purple, style::orange};
  for (std::size_t i = inwards_out.size(); i-- > 0;) {
    panel.strokes.push_back(
        {inwards_out[i], plane(curve(inwards_out[i], polygon)), true, style::glass(shades.at(i))});
  }
  panel.strokes.push_back(polygon_stroke(polygon));
  add_drawing(results, {"polyloop-superposed",
                        "Regions of J8 .. J0 about a polyloop that crosses itself",
                        {panel},
                        {"figure.polyloops.superposed"}});
  results.claims.push_back(number(
      "figure.polyloops.superposed", doubled_area(curve("J8", polygon)) / doubled_area(curve("J0", polygon)),
      "Parts of the region count by their winding number, which is negative in the larger one."));
}

void add_j4_j5(Results& results) {
  const PlanePolygon& polygon = stored_polyloop("non-convex");
  const Points j4 = curve("J4", polygon);
  const Points j5 = curve("J5", polygon);
  add_drawing(results, {"polyloop-j4-j5",
                        "J4 and J5 of the polyloop L",
                        {{"",
                          {{"L", polygon, true, style::polygon},
                           {"J4", plane(j4), true, style::curve(0)},
                           {"J5", plane(j5), true, style::curve(1)}}}},
                        {"figure.polyloops.j4-j5"}});
  results.claims.push_back(number("figure.polyloops.j4-j5", doubled_area(j5) / doubled_area(j4)));
}

constexpr int jerk_level = 4;

Rational largest_squared_jerk(const Points& p) {
  const std::size_t n = p.size();
  Rational largest;
  const auto at = [&](std::size_t i) { return Vector<Rational>(p[i % n]); };
  for (std::size_t i = 0; i < n; ++i)
    largest = std::max(largest, squared_normal_jerk(at(i + n - 1), at(i), at(i + 1), at(i + 2)));
  return largest;
}

/// A comb: from the middle of every edge of the curve a tooth along its normal, as long as its normal jerk
/// times the scale, drawn as one line there and back.
PlanePolygon comb(const Polyline& curve, double scale) {
  const std::vector<double> jerks = normal_jerks(curve);
  const std::vector<double>& x = curve.coordinates[0];
  const std::vector<double>& y = curve.coordinates[1];
  PlanePolygon line;
  for (std::size_t i = 0; i < jerks.size(); ++i) {
    const std::size_t next = (i + 1) % jerks.size();
    const double edge = std::hypot(x[next] - x[i], y[next] - y[i]);
    const double foot_x = (x[i] + x[next]) / 2;
    const double foot_y = (y[i] + y[next]) / 2;
    const double tooth = edge > 0 ? scale * jerks[i] / edge : 0;
    const std::pair foot{Rational::from_double(foot_x), Rational::from_double(foot_y)};
    line.push_back(foot);
    line.emplace_back(Rational::from_double(foot_x - tooth * (y[next] - y[i])),
                      Rational::from_double(foot_y + tooth * (x[next] - x[i])));
    line.push_back(foot);
  }
  return line;
}

void add_jerk(Results& results) {
  const std::array<std::pair<std::string, std::string_view>, 3> shown{
      std::pair{"J0", style::green}, {"Jm", style::blue}, {"J8", style::vermilion}};
  Drawing drawing{"polyloop-jerk",
                  "Normal jerk of J0, Jm and J8 (level 4), all combs in one scale",
                  {},
                  {"figure.polyloops.jerk", "figure.polyloops.jerk.jm", "polyloops.jerk."}};
  constexpr double longest_tooth = 1.8;  // in the polygons' units
  for (const char* name : {"square", "non-convex"}) {
    const PlanePolygon& polygon = stored_polyloop(name);
    const double longest = normal_jerk(refined(polyloop_curve("J8"), polygon, jerk_level)).largest;
    for (const auto& [curve_name, colour] : shown) {
      const Polyline fine = refined(polyloop_curve(curve_name), polygon, jerk_level);
      drawing.panels.push_back({fmt::format("{}, {}", curve_name, name),
                                {polygon_stroke(in_unit_box(polygon, polygon)),
                                 {"", in_unit_box(plane(curve(curve_name, polygon, jerk_level)), polygon),
                                  true, style::in_colour(style::black, 1)},
                                 {"", in_unit_box(comb(fine, longest_tooth / longest), polygon), true,
                                  style::in_colour(colour, 1)}}});
    }
  }
  add_drawing(results, drawing);
  const PlanePolygon& polygon = stored_polyloop("non-convex");
  const Rational most = largest_squared_jerk(curve("J8", polygon, jerk_level));
  results.claims.push_back(number("figure.polyloops.jerk",
                                  largest_squared_jerk(curve("J0", polygon, jerk_level)) / most,
                                  "The jerk of J0 is the root of this times that of J8."));
  results.claims.push_back(
      number("figure.polyloops.jerk.jm", largest_squared_jerk(curve("Jm", polygon, jerk_level)) / most));
}

void add_row(Results& results) {
  const PlanePolygon& polygon = stored_polyloop("star");
  Drawing drawing{"polyloop-row", "A polyloop L and its curves J0 .. Jm", {}, {"figure.polyloops.row"}};
  drawing.panels.push_back({"L", {{"", polygon, true, style::in_colour(style::black, 1.5)}}});
  for (const PolyloopCurve& shown : polyloop_curves()) {
    drawing.panels.push_back(
        {shown.name,
         {polygon_stroke(polygon), {"", plane(curve(shown.name, polygon)), true, style::curve(0)}}});
  }
  add_drawing(results, drawing);
  results.claims.push_back(
      number("figure.polyloops.row", doubled_area(curve("Jm", polygon)) / doubled_area(points_of(polygon))));
}

}  // namespace

std::span<const ClaimHead> polyloop_figure_heads() { return table; }

Results run_polyloop_figures() {
  Results results;
  add_family(results);
  add_superposed(results);
  add_j4_j5(results);
  add_jerk(results);
  add_row(results);
  return results;
}

}  // namespace subdiv
