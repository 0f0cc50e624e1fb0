#include "experiments/curve_figures.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/limit_points.h"
#include "analysis/open_polygon.h"
#include "analysis/retrofit.h"
#include "experiments/data.h"
#include "experiments/details_file.h"
#include "experiments/drawing.h"
#include "schemes/bspline.h"
#include "schemes/evaluate/geomorph.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::string shape = "On the stored octagon figure-shape.csv: ";
const std::string open_shape = "On the stored open polygon of 6 points, figure-open.csv: ";

const std::array table{
    ClaimHead{
        "figure.between", "js-report", "1, figure 1",
        "these points lie between the corresponding vertices produced by the four-point subdivision and "
        "by the uniform cubic B-spline subdivision",
        ClaimKind::exact,
        shape + "every point of J_{0.7} is 0.3 times that of J_0 plus 0.7 times that of J_1."},
    finding("figure.three-curves.j0", "js-report 1, figure 2 (jsplines figure 1)",
            shape + "area of six refinements by J_0 over the area of the polygon."),
    finding("figure.three-curves.average", "js-report 1, figure 2 (jsplines figure 1)",
            shape + "area of six refinements by J_{1/2} over the area of the polygon."),
    finding("figure.three-curves.j1", "js-report 1, figure 2 (jsplines figure 1)",
            shape + "area of six refinements by J_1 over the area of the polygon."),
    ClaimHead{
        "figure.family.order", "jsplines", "3, figure 2", "from outer to inner", ClaimKind::exact,
        "Triangle and square, five refinements by J_0, J_{2/8}, .., J_{12/8}: of two curves that follow "
        "each other every vertex of the second lies within the first, a convex polygon or not (by "
        "winding number, exactly)."},
    finding("figure.bsplines.quadratic", "jsplines 4, figure 3 (js-report figure 4)",
            shape + "the greatest squared distance of *J_{.689} from B_2 at the parameters i/32, i a whole "
                    "number, of the limit curves."),
    finding("figure.bsplines.quartic", "jsplines 4, figure 3 (js-report figure 4)",
            shape + "the greatest squared distance of *J_{1.27} from B_4 at the parameters i/32."),
    finding("figure.bsplines.odd", "jsplines 4, figure 3 (js-report figure 4)",
            shape + "*J_1 is B_3 and *J_{1.5} is B_5 at all parameters i/32."),
    ClaimHead{
        "figure.retrofit", "js-report", "5, figures 5, 6 (jsplines figures 4, 5)",
        "quickly converging to a new control polygon, which yields an interpolating curve", ClaimKind::exact,
        "*J_{3/2} on triangle, square and octagon: the directly retrofitted polygon has the control "
        "points as limit points, and the factor by which a step reduces the error on loops of 3, 4 and 8 "
        "points is below 1."},
    finding("figure.retrofit.iterations", "js-report 5, figure 5 (jsplines figure 4)",
            shape + "the largest squared distance of limit points of *J_{3/2} from the control points after "
                    "three iterations, over that before."),
    finding("figure.anticipation", "js-report 6, figure 7 (jsplines figure 6)",
            shape + "the largest squared distance of the limit of {J_{-33/26}, *J_{3/2}} from the control "
                    "points, over that of *J_{3/2}."),
    finding("figure.interpolation", "js-report 6, figure 8 (jsplines figure 7)",
            shape + "{J_{-7/4,59/52}, *J_{3/2}} passes through the control points."),
    finding("figure.mid-edges.exact", "js-report 7, figure 9 (jsplines figure 8)",
            shape + "B_2 and {J_{2/3}, *J_1} pass through the mid-edge points."),
    finding("figure.mid-edges.s", "js-report 7, figure 9 (jsplines figure 8)",
            shape + "the largest squared distance of *J_{0.751} from mid-edge points, over the largest "
                    "squared length of an edge."),
    finding("figure.mid-edges.r", "js-report 7, figure 9 (jsplines figure 8)",
            shape + "the same for {J_{29/59}, *J_{3/2}}."),
    finding("figure.area", "js-report 8, figure 10 (jsplines figure 9)",
            "On the stored heptagon area-witness.csv, six refinements: the area of {J_{-0.0053,1.0276}, "
            "*J_{0.4666}} over that of the polygon."),
    ClaimHead{"design.14", "js-report", "10, figure 12",
              "The final shape was completely specified by only 14 control vertices", ClaimKind::exact,
              "3 points of figure-omega.csv, retrofitted with J_{12/8}, and the details of "
              "figure-omega-details.csv (3 of a cavity, 2 of the ends, 6 spikes), counted; ringing and "
              "refinement level by level replay them to the same 192 points, exactly."},
    finding("figure.open.ends", "js-report 11, figure 13 (jsplines figure 10)",
            open_shape + "with clamped ends *J_0, *J_{0.5}, *J_1 and *J_{1.5} begin at P_0 with the tangent "
                         "P_1 - P_0 and end at P_5 with P_5 - P_4."),
    finding("figure.levels", "jsplines 11, figure 15",
            shape + "the largest squared distance of a point of level 2 from the linear refinement of level "
                    "1, for *J_{3/8} over that for *J_0."),
    finding("figure.levels.cubic", "jsplines 11, figure 15", shape + "the same for *J_{3/8} over *J_1."),
    finding("figure.notes.cubic", "notes 3, figure 3",
            open_shape +
                "without added points the cubic B-spline begins at (P_0 + 4 P_1 + P_2)/6 and ends at "
                "the like combination of the last three."),
    finding("figure.notes.four-point", "notes 3, figure 4",
            open_shape + "without added points the four-point curve runs from P_2 to P_{n-2} of the points "
                         "P_0 .. P_n."),
};

using Plane = Eigen::Matrix<Rational, 2, 1>;
using Points = std::vector<Plane>;

constexpr int fine = 5;  // refinements of a drawn curve

const ClaimHead& claim(const std::string& id) { return head(table, id); }
Rational q(const char* text) { return Rational::parse(text); }

Points stored(const std::string& file) {
  Points points;
  for (const auto& [x, y] : polygon_from_data(file)) points.emplace_back(x, y);
  return points;
}

PlanePoints drawn(const Points& points) {
  PlanePoints result;
  for (const Plane& p : points) result.emplace_back(p(0), p(1));
  return result;
}

Scheme<Rational> j(const Rational& s) { return stationary("J", jspline(s)); }
Scheme<Rational> j(const char* s) { return j(q(s)); }
Scheme<Rational> then(const char* a, const char* b, const char* s) {
  return mixed(stationary("J", jspline(q(a), q(b))), j(s));
}
Scheme<Rational> spline(int degree) { return stationary("B", bspline<Rational>(degree)); }

Points refined(const Scheme<Rational>& scheme, const ControlPolygon<Plane>& controls, int depth = fine) {
  Points points;
  Ringing<Rational, Plane> rings(scheme, controls, depth);
  for (const Plane& p : rings) points.push_back(p);
  return points;
}
Points refined(const Scheme<Rational>& scheme, const Points& points, int depth = fine) {
  return refined(scheme, closed_polygon(points), depth);
}

Rational doubled_area(const Points& p) {
  Rational sum(0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Plane& next = p[(i + 1) % p.size()];
    sum += p[i](0) * next(1) - p[i](1) * next(0);
  }
  return sum;
}

Rational squared(const Plane& v) { return v(0) * v(0) + v(1) * v(1); }

/// The largest squared distance between points of the same place.
Rational distance(const Points& p, const Points& other) {
  if (p.size() != other.size()) throw std::logic_error("point lists of different lengths");
  Rational largest(0);
  for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, squared(p[i] - other[i]));
  return largest;
}

Points limits(const Scheme<Rational>& scheme, const Points& points, int level = 0) {
  return limit_derivatives(scheme, closed_polygon(points), level, 0);
}

Claim number(const std::string& id, const Rational& value) {
  return settle(claim(id), exact(value, "rational arithmetic"));
}
Claim statement(const std::string& id, bool holds) {
  return settle_statement(claim(id), holds, holds ? "true" : "false");
}

Stroke polygon_stroke(const Points& points, bool closed = true, const std::string& label = "") {
  return {label, drawn(points), closed, style::polygon};
}

// ---- The family
// ------------------------------------------------------------------------------------------------

void add_between(Results& results, const Points& points) {
  const Points four = refined(j("0"), points, 1);
  const Points cubic = refined(j("1"), points, 1);
  const Points blend = refined(j("7/10"), points, 1);
  bool between = true;
  for (std::size_t i = 0; i < blend.size(); ++i)
    between = between && blend[i] == Plane(q("3/10") * four[i] + q("7/10") * cubic[i]);
  results.claims.push_back(statement("figure.between", between));
  add_drawing(results, {"figure-refinements",
                        "Three refinements by J_0.7; one, between those of J_0 and J_1",
                        {{"three refinements",
                          {polygon_stroke(points, true, "control polygon"),
                           {"1st", drawn(blend), true, style::curve(1, 1.2)},
                           {"2nd", drawn(refined(j("7/10"), points, 2)), true, style::curve(2, 1.2)},
                           {"3rd", drawn(refined(j("7/10"), points, 3)), true, style::curve(0)}}},
                         {"one refinement",
                          {polygon_stroke(points),
                           {"J_0", drawn(four), true, style::curve(3, 1.2)},
                           {"J_1", drawn(cubic), true, style::curve(4, 1.2)},
                           {"J_0.7", drawn(blend), true, style::points(5, 0.5)}}}},
                        {"figure.between"}});
}

void add_three_curves(Results& results, const Points& points) {
  const std::vector<std::pair<std::string, const char*>> curves{{"j0", "0"}, {"average", "1/2"}, {"j1", "1"}};
  constexpr int most = 6;
  Drawing drawing{
      "figure-three-curves", "1, 2 and 6 refinements by J_0, J_1/2 and J_1", {}, {"figure.three-curves."}};
  for (const int depth : {1, 2, most}) {
    Panel panel{fmt::format("{} refinement{}", depth, depth == 1 ? "" : "s"), {polygon_stroke(points)}};
    for (std::size_t i = 0; i < curves.size(); ++i) {
      panel.strokes.push_back({depth == 1 ? fmt::format("J_{}", curves[i].second) : "",
                               drawn(refined(j(curves[i].second), points, depth)), true,
                               style::curve(i, 1.5)});
    }
    drawing.panels.push_back(std::move(panel));
  }
  for (const auto& [name, s] : curves) {
    results.claims.push_back(number("figure.three-curves." + name,
                                    doubled_area(refined(j(s), points, most)) / doubled_area(points)));
  }
  add_drawing(results, drawing);
}

/// How often a closed polygon winds around a point that does not lie on it; edges count where they cross the
/// ray to the right, half-open in y.
int winding_number(const Points& polygon, const Plane& point) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Plane& from = polygon[i];
    const Plane& to = polygon[(i + 1) % polygon.size()];
    if ((from(1) <= point(1)) == (to(1) <= point(1))) continue;
    const Rational cross =
        (to(0) - from(0)) * (point(1) - from(1)) - (to(1) - from(1)) * (point(0) - from(0));
    if (cross.sign() > 0 && to(1) > from(1)) ++winding;
    if (cross.sign() < 0 && to(1) < from(1)) --winding;
  }
  return winding;
}

void add_family(Results& results) {
  Drawing drawing{"figure-family",
                  "Five refinements by J_0, J_2/8, .., J_12/8, from outer to inner",
                  {},
                  {"figure.family.order"}};
  bool nested = true;
  for (const char* name : {"triangle", "square"}) {
    const Points points = stored(fmt::format("figure-{}.csv", name));
    Panel panel{name, {polygon_stroke(points)}};
    Points outer;
    for (int eighths = 0; eighths <= 12; eighths += 2) {
      const Points curve = refined(j(Rational(eighths, 8)), points);
      for (const Plane& p : curve) nested = nested && (outer.empty() || winding_number(outer, p) == 1);
      outer = curve;
      panel.strokes.push_back({drawing.panels.empty() ? fmt::format("J_{}/8", eighths) : "", drawn(curve),
                               true, style::curve(static_cast<std::size_t>(eighths / 2), 1.5)});
    }
    drawing.panels.push_back(std::move(panel));
  }
  results.claims.push_back(statement("figure.family.order", nested));
  add_drawing(results, drawing);
}

void add_bsplines(Results& results, const Points& points) {
  Drawing drawing{
      "figure-bsplines", "*J_s along the uniform B-splines of degree 2 to 5", {}, {"figure.bsplines."}};
  Panel panel{"from outer to inner: degree 2, 3, 4, 5", {polygon_stroke(points)}};
  std::vector<Rational> distances;
  std::size_t i = 0;
  for (const auto& [s, degree] : {std::pair{"0.689", 2}, {"1", 3}, {"1.27", 4}, {"3/2", 5}}) {
    const Points curve = limits(j(s), points, fine);
    Points target = limits(spline(degree), points, fine);
    if (degree % 2 == 0) {  // the limit of an even degree is at t where that of an odd one is at t - 1/2
      const auto half = static_cast<std::ptrdiff_t>(std::size_t{1} << static_cast<unsigned>(fine - 1));
      std::rotate(target.begin(), target.begin() + half, target.end());
    }
    distances.push_back(distance(curve, target));
    panel.strokes.push_back({degree == 2 ? "B-splines" : "", drawn(target), true, style::target});
    panel.strokes.push_back({fmt::format("*J_{}", s), drawn(curve), true, style::curve(i++, 1.5)});
  }
  drawing.panels.push_back(std::move(panel));
  results.claims.push_back(number("figure.bsplines.quadratic", distances[0]));
  results.claims.push_back(number("figure.bsplines.quartic", distances[2]));
  results.claims.push_back(statement("figure.bsplines.odd", is_zero(distances[1]) && is_zero(distances[3])));
  add_drawing(results, drawing);
}

// ---- Retrofitting and interpolation
// ------------------------------------------------------------------------------

/// A function of one coordinate of a loop applied to both.
template <class Function>
Points by_coordinate(const Points& points, const Points& other, Function function) {
  Points result(points.size());
  for (int c = 0; c < 2; ++c) {
    std::vector<Rational> one;
    std::vector<Rational> two;
    for (const Plane& p : points) one.push_back(p(c));
    for (const Plane& p : other) two.push_back(p(c));
    const std::vector<Rational> values = function(one, two);
    for (std::size_t i = 0; i < points.size(); ++i) result[i](c) = values[i];
  }
  return result;
}

void add_retrofit(Results& results, const Points& points) {
  const Scheme<Rational> quintic = j("3/2");
  const Laurent<Rational> mask = limit_mask(quintic.last());
  const auto step = [&](const std::vector<Rational>& current, const std::vector<Rational>& target) {
    return retrofit_step(mask, current, target);
  };
  const auto direct = [&](const std::vector<Rational>& target, const std::vector<Rational>&) {
    return retrofit_directly(mask, target);
  };
  constexpr int iterations = 3;
  Drawing steps{"figure-retrofit",
                "Retrofitting for *J_3/2: the polygon moves until its curve meets the points",
                {},
                {"figure.retrofit.iterations"}};
  Drawing shapes{
      "figure-retrofit-shapes", "*J_3/2 of a polygon, and of the retrofitted one", {}, {"figure.retrofit"}};
  bool interpolates = true;
  for (const char* name : {"triangle", "square", "shape"}) {
    const Points target = stored(fmt::format("figure-{}.csv", name));
    const Points solved = by_coordinate(target, target, direct);
    Points iterated = target;
    for (int k = 0; k < iterations; ++k) iterated = by_coordinate(iterated, target, step);
    const Rational before = distance(limits(quintic, target), target);
    const Rational after = distance(limits(quintic, iterated), target);
    const Algebraic rate = contraction_rate_of_loops(mask, static_cast<int>(target.size()));
    interpolates = interpolates && limits(quintic, solved) == target && rate < Algebraic(Rational(1));
    const bool first = shapes.panels.empty();
    shapes.panels.push_back(
        {name,
         {polygon_stroke(target, true, first ? "control polygon" : ""),
          {first ? "its curve" : "", drawn(refined(quintic, target)), true, style::curve(1)},
          {first ? "retrofitted" : "", drawn(refined(quintic, solved)), true, style::curve(0)}}});
    if (!(target == points)) continue;
    results.claims.push_back(number("figure.retrofit.iterations", after / before));
    Points current = target;
    for (const int k : {0, 1, 2}) {
      steps.panels.push_back(
          {fmt::format("{} iteration{}", k, k == 1 ? "" : "s"),
           {polygon_stroke(target, true, k == 0 ? "given polygon" : ""),
            {k == 0 ? "moved polygon" : "", drawn(current), true, style::curve(1, 1.2)},
            {k == 0 ? "curve" : "", drawn(refined(quintic, current)), true, style::curve(0)}}});
      current = by_coordinate(current, target, step);
    }
  }
  results.claims.push_back(statement("figure.retrofit", interpolates));
  add_drawing(results, steps);
  add_drawing(results, shapes);
}

Panel stages(const char* caption, const Points& points, const Scheme<Rational>& scheme, int depth) {
  return {caption,
          {polygon_stroke(points), {"", drawn(refined(scheme, points, depth)), true, style::curve(0, 1.5)}}};
}

void add_vertex_interpolation(Results& results, const Points& points) {
  const Scheme<Rational> near = then("-33/26", "-33/26", "3/2");
  const Scheme<Rational> through = then("-7/4", "59/52", "3/2");
  results.claims.push_back(number("figure.anticipation", distance(limits(near, points), points) /
                                                             distance(limits(j("3/2"), points), points)));
  results.claims.push_back(statement("figure.interpolation", limits(through, points) == points));
  add_drawing(results, {"figure-anticipation",
                        "{J_r, *J_3/2}, r = -33/26, passes near the control points",
                        {stages("J_r", points, near, 1), stages("then J_3/2", points, near, 2),
                         stages("limit", points, near, fine)},
                        {"figure.anticipation", "vertex.r", "vertex.r.error"}});
  add_drawing(results, {"figure-interpolation",
                        "{J_-7/4,59/52, *J_3/2} passes through the control points",
                        {stages("*J_3/2", points, j("3/2"), fine), stages("J_a,b", points, through, 1),
                         stages("then J_3/2", points, through, 2), stages("limit", points, through, fine)},
                        {"figure.interpolation", "vertex.ab."}});
}

void add_mid_edges(Results& results, const Points& points) {
  Points middles;
  Rational longest(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Plane& next = points[(i + 1) % points.size()];
    middles.emplace_back(q("1/2") * (points[i] + next));
    longest = std::max(longest, squared(next - points[i]));
  }
  // Limit points of level 1 with odd indices; those of B_2 at its vertices, which stand half-way.
  const auto odd = [&](const Scheme<Rational>& scheme) {
    const Points all = limits(scheme, points, 1);
    Points result;
    for (std::size_t i = 1; i < all.size(); i += 2) result.push_back(all[i]);
    return result;
  };
  const Points quadratic = limits(spline(2), points);
  const auto near = [&](const Points& p) {
    return std::min(distance(p, middles), [&] {  // vertex i of B_2 belongs to the edge before or after it
      Points turned = p;
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      return distance(turned, middles);
    }());
  };
  const Scheme<Rational> with_r = then("29/59", "29/59", "3/2");
  results.claims.push_back(
      statement("figure.mid-edges.exact",
                is_zero(near(quadratic)) && is_zero(distance(odd(then("2/3", "2/3", "1")), middles))));
  results.claims.push_back(number("figure.mid-edges.s", distance(odd(j("0.751")), middles) / longest));
  results.claims.push_back(number("figure.mid-edges.r", distance(odd(with_r), middles) / longest));
  const auto panel = [&](const char* caption, const Scheme<Rational>& scheme) {
    Panel result = stages(caption, points, scheme, fine);
    result.strokes.push_back({"", drawn(middles), true, style::points(1, 0.4)});
    return result;
  };
  add_drawing(results, {"figure-mid-edges",
                        "Curves through or near the middles of edges (squares)",
                        {panel("B_2", spline(2)), panel("J_2/3, *J_1", then("2/3", "2/3", "1")),
                         panel("*J_0.751", j("0.751")), panel("J_29/59, *J_3/2", with_r)},
                        {"figure.mid-edges."}});
}

// ---- Area, design, open curves, levels
// ---------------------------------------------------------------------------

void add_area(Results& results) {
  const Points points = stored("area-witness.csv");
  const Scheme<Rational> exactly = then("-0.0053", "1.0276", "0.4666");
  constexpr int depth = 6;
  results.claims.push_back(
      number("figure.area", doubled_area(refined(exactly, points, depth)) / doubled_area(points)));
  add_drawing(results, {"figure-area",
                        "Schemes that keep the area, on the heptagon with the printed errors",
                        {stages("a: *J_0.476", points, j("0.476"), fine),
                         stages("b: J_0.05, *J_1.5", points, then("0.05", "0.05", "3/2"), fine),
                         stages("c: *J_0.46415", points, j("0.46415"), fine),
                         stages("d: J_-0.0299, *J_1.5", points, then("-0.0299", "-0.0299", "3/2"), fine),
                         stages("e: J_0.836, *J_-0.531", points, then("0.836", "0.836", "-0.531"), fine),
                         stages("f: J_-0.0053,1.0276, *J_0.4666", points, exactly, fine)},
                        {"figure.area", "area.errors."}});
}

void add_design(Results& results) {
  const Scheme<Rational> quintic = j("12/8");
  const Points given = stored("figure-omega.csv");
  const Laurent<Rational> mask = limit_mask(quintic.last());
  const Points controls = by_coordinate(
      given, given, [&](const auto& target, const auto&) { return retrofit_directly(mask, target); });
  const auto records = read_details<Rational>(data_folder() / "figure-omega-details.csv", 2);
  constexpr int depth = 6;
  std::vector<Detail<Plane>> details;
  Drawing drawing{"figure-design",
                  "A shape of 3 control points and 11 details (*J_12/8, retrofitted)",
                  {},
                  {"design.14"}};
  const ControlPolygon<Plane> loop = closed_polygon(controls);
  bool same = true;
  for (std::size_t i = 0; i <= records.size(); ++i) {
    if (i == 0 || i == records.size() || records[i].level != records[i - 1].level) {
      Ringing<Rational, Plane> rings(quintic, loop, depth, Details<Plane>(details));
      Points points;
      for (const Plane& p : rings) points.push_back(p);
      same = same &&
             points == curve_points(refine_level_by_level(quintic, loop, depth, Details<Plane>(details)));
      drawing.panels.push_back(
          {fmt::format("{} vertices", given.size() + i), {{"", drawn(points), true, style::curve(0)}}});
    }
    if (i < records.size()) {
      const auto& d = records[i];
      details.push_back({d.level, d.index, Plane(d.displacement[0], d.displacement[1])});
    }
  }
  const std::size_t vertices = given.size() + details.size();
  results.claims.push_back(settle_statement(claim("design.14"), same && vertices == 14,
                                            std::to_string(vertices),
                                            "3 + 3 + 2 + 6; the document's own shape is lost, this one is "
                                            "made after its description."));
  add_drawing(results, drawing);
}

void add_open_curves(Results& results) {
  const Points points = stored("figure-open.csv");
  const auto clamped = [&](const char* s) {
    return with_ends(points,
                     end_weights<Rational>(parse_scheme(fmt::format("jspline:s={}", s)), OpenEnd::clamped));
  };
  bool ends = true;
  Drawing drawing{"figure-open",
                  "Opening a curve: closed, reflected and clamped ends",
                  {},
                  {"figure.open.ends", "open.clamped.", "open.reflected"}};
  drawing.panels.push_back(
      {"*J_0.5, closed",
       {polygon_stroke(points), {"", drawn(refined(j("1/2"), points)), true, style::curve(0)}}});
  const ControlPolygon<Plane> reflected =
      with_ends(points, end_weights<Rational>(parse_scheme("jspline:s=1/2"), OpenEnd::reflected));
  drawing.panels.push_back({"reflected",
                            {polygon_stroke(reflected.points, false),
                             {"", drawn(refined(j("1/2"), reflected)), false, style::curve(0)}}});
  for (const char* s : {"0", "1/2", "1", "3/2"}) {
    const ControlPolygon<Plane> polygon = clamped(s);
    const LimitPoints<Plane> at = limit_points(j(s), polygon);
    const std::size_t last = points.size() - 1;
    ends = ends && at.positions.front() == points.front() && at.positions.back() == points.back() &&
           at.tangents.front() == Plane(points[1] - points[0]) &&
           at.tangents.back() == Plane(points[last] - points[last - 1]);
    drawing.panels.push_back(
        {fmt::format("clamped, *J_{}", s),
         {polygon_stroke(points, false), {"", drawn(refined(j(s), polygon)), false, style::curve(0)}}});
  }
  results.claims.push_back(statement("figure.open.ends", ends));
  add_drawing(results, drawing);
}

void add_levels(Results& results, const Points& points) {
  Drawing drawing{"figure-levels",
                  "Levels 1 (grey) and 2: what a change of levels moves",
                  {},
                  {"figure.levels", "figure.levels.cubic"}};
  const auto moved = [&](const char* s) {
    const Points coarse = refined(j(s), points, 1);
    return distance(refined(j(s), points, 2),
                    refined(stationary("linear", linear_step<Rational>(2)), coarse, 1));
  };
  for (const char* s : {"0", "3/8", "1"}) {
    drawing.panels.push_back({fmt::format("J_{}", s),
                              {polygon_stroke(refined(j(s), points, 1)),
                               {"", drawn(refined(j(s), points, 2)), true, style::curve(0, 1.5)}}});
  }
  results.claims.push_back(number("figure.levels", moved("3/8") / moved("0")));
  results.claims.push_back(number("figure.levels.cubic", moved("3/8") / moved("1")));
  add_drawing(results, drawing);
}

/// The open curves of the notes: as many points at both ends as the rings need carry the ends.
void add_notes(Results& results) {
  const Points points = stored("figure-open.csv");
  const std::size_t last = points.size() - 1;
  const auto bare = [&](std::size_t margin) { return open_polygon(points, margin, margin); };
  const Scheme<Rational> cubic = spline(3);
  const Scheme<Rational> four = stationary("four-point", four_point(q("1/16")));
  const Points cubic_limits = limit_derivatives(cubic, bare(1), 0, 0);
  const auto blend = [&](std::size_t i, std::size_t k, std::size_t l) {
    return Plane(q("1/6") * (points[i] + Rational(4) * points[k] + points[l]));
  };
  results.claims.push_back(statement(
      "figure.notes.cubic",
      cubic_limits.front() == blend(0, 1, 2) && cubic_limits.back() == blend(last - 2, last - 1, last)));
  const Points four_limits = limit_derivatives(four, bare(2), 0, 0);
  results.claims.push_back(statement(
      "figure.notes.four-point", four_limits.front() == points[2] && four_limits.back() == points[last - 2]));
  Drawing drawing{"figure-notes",
                  "Open curves without added points: degree 1, cubic, four-point",
                  {},
                  {"figure.notes.cubic", "figure.notes.four-point"}};
  const Scheme<Rational> linear = stationary("linear", linear_step<Rational>(2));
  for (const int depth : {1, 2}) {
    drawing.panels.push_back({fmt::format("degree 1, level {}", depth),
                              {polygon_stroke(points, false),
                               {"", drawn(refined(linear, bare(0), depth)), false, style::points(0, 0.4)}}});
  }
  const auto panel = [&](const char* caption, const Scheme<Rational>& scheme, std::size_t margin) {
    return Panel{
        caption,
        {polygon_stroke(points, false), {"", drawn(refined(scheme, bare(margin))), false, style::curve(0)}}};
  };
  drawing.panels.push_back(panel("cubic", cubic, 1));
  drawing.panels.push_back(panel("four-point", four, 2));
  add_drawing(results, drawing);
}

}  // namespace

std::span<const ClaimHead> curve_figure_heads() { return table; }

Results run_curve_figures() {
  Results results;
  const Points points = stored("figure-shape.csv");
  add_between(results, points);
  add_three_curves(results, points);
  add_family(results);
  add_bsplines(results, points);
  add_retrofit(results, points);
  add_vertex_interpolation(results, points);
  add_mid_edges(results, points);
  add_area(results);
  add_design(results);
  add_open_curves(results);
  add_levels(results, points);
  add_notes(results);
  return results;
}

}  // namespace subdiv
