#include "optimize/polygon_objectives.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/area_mask.h"
#include "analysis/limit_mask.h"
#include "schemes/bspline.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"
#include "tests/plane_loop.h"

namespace subdiv {
namespace {

using F = RationalFunction;
using test::area;
using test::Points;
using test::refined;

const F x0 = F::variable(0);
const F x1 = F::variable(1);

Rational q(long p, long d = 1) { return {p, d}; }
F fixed(const Rational& x) { return F(x); }

Scheme<F> family_s() { return stationary<F>("*J_s", jspline(x0)); }
Scheme<F> family_r() {
  return mixed(stationary<F>("J_r", jspline(x0)), stationary<F>("*J", jspline(fixed(q(3, 2)))));
}
Scheme<F> family_ab() {
  return mixed(stationary<F>("J_ab", jspline(x0, x1)), stationary<F>("*J", jspline(fixed(q(3, 2)))));
}
Scheme<F> family_rs() { return mixed(stationary<F>("J_r", jspline(x0)), stationary<F>("*J", jspline(x1))); }

using Coordinates = std::vector<std::vector<Rational>>;

Coordinates coordinates(const std::vector<std::array<long, 2>>& points) {
  Coordinates result(2);
  for (const auto& [x, y] : points) {
    result[0].emplace_back(x);
    result[1].emplace_back(y);
  }
  return result;
}
const std::vector<std::array<long, 2>> heptagon{{10, 4}, {6, 3}, {1, 1}, {5, 4}, {-5, 3}, {-10, 5}, {2, -1}};
const std::vector<std::array<long, 2>> pentagon{{0, 0}, {8, 0}, {9, 6}, {4, 9}, {1, 5}};

Summary best(const Scheme<F>& scheme, const std::string& objective, Norm norm, const Coordinates& polygon,
             std::vector<Range> box) {
  std::vector<std::string> names{"s", "t"};
  names.resize(box.size());
  return minimise_on_polygon(scheme, parse_polygon_objective(objective), norm, polygon, std::move(box),
                             names);
}

Points doubles(const std::vector<std::array<long, 2>>& points) {
  Points result;
  for (const auto& [x, y] : points) result.push_back({static_cast<double>(x), static_cast<double>(y)});
  return result;
}

/// {J_{a,b}, *J_s} by many refinements.
Points curve(Points p, double a, double b, double s, int depth = 10) {
  for (int k = 0; k < depth; ++k) p = k == 0 ? refined(p, a, b) : refined(p, s, s);
  return p;
}

double value(const Enclosure& x) { return x.midpoint().to_double(); }

TEST(PolygonObjectives, AreaPreservingParametersAreAllListed) {
  const Coordinates polygon = coordinates(heptagon);
  const Summary s = best(family_s(), "area", Norm::linf, polygon, {{q(-17, 10), q(58, 10)}});
  ASSERT_FALSE(s.zeros.empty());
  EXPECT_EQ(s.minimum.exact, "0");
  EXPECT_EQ(s.termination, s.zeros.size() == 1 ? Termination::proved : Termination::not_unique);
  const Points p = doubles(heptagon);
  const auto error = [&](double at) { return area(curve(p, at, at, at)) - area(p); };
  for (const Enclosure& zero : s.zeros) {
    EXPECT_EQ(zero.rigour, Rigour::exact);
    EXPECT_NEAR(error(value(zero)), 0, 1e-3);
  }
  // A scan by refinement changes sign nowhere else.
  std::size_t changes = 0;
  for (int i = -33; i < 116; ++i) changes += (error(i / 20.0) > 0) != (error((i + 1) / 20.0) > 0) ? 1U : 0U;
  EXPECT_EQ(changes, s.zeros.size());
  // The other way that the papers name: r, while s = 3/2 (jsplines 8).
  const Summary r = best(family_r(), "area", Norm::linf, polygon, {{q(-2), q(2)}});
  ASSERT_EQ(r.zeros.size(), 1U);
  EXPECT_NEAR(area(curve(p, value(r.minimiser[0]), value(r.minimiser[0]), 1.5)), area(p), 1e-3);
}

TEST(PolygonObjectives, AreaOfSquaresByHand) {
  // A_2 = 0 and A_3 = -A_1 for quadrilaterals: the area mask alone decides.
  const Coordinates square = coordinates({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Summary s = best(family_s(), "area", Norm::l2, square, {{q(0), q(4)}});
  const Laurent<F> mask = area_mask(family_s());
  const F change = F(2) * (mask[1] - mask[3] + mask[5]) - F(1);
  ASSERT_EQ(s.zeros.size(), 1U);
  const std::vector<Interval> at{Interval::hull(s.zeros[0].lower, s.zeros[0].upper)};
  EXPECT_TRUE(change.evaluate(std::span<const Interval>(at)).contains_zero());
  // No s in [1, 4] keeps it: the end at s = 1 is best.
  const Summary none = best(family_s(), "area", Norm::linf, square, {{q(1), q(4)}});
  EXPECT_TRUE(none.zeros.empty());
  EXPECT_EQ(none.termination, Termination::proved);
  EXPECT_EQ(none.minimiser[0].exact, "1");
}

TEST(PolygonObjectives, AreaThatCannotBeKeptMissesByTheDifference) {
  // A square of side 2: the area of *J_s falls from s = 1, where it is that of the cubic B-spline.
  const Coordinates square = coordinates({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const Summary s = best(family_s(), "area", Norm::linf, square, {{q(1), q(4)}});
  const double limit = area(curve(doubles({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 1, 1, 1, 9));
  EXPECT_NEAR(value(s.minimum), 4 - limit, 1e-4);
}

TEST(PolygonObjectives, AreaOverTwoParametersIsACurve) {
  const Summary rs =
      best(family_rs(), "area", Norm::linf, coordinates(heptagon), {{q(-1), q(1)}, {q(0), q(2)}});
  EXPECT_EQ(rs.termination, Termination::not_unique);
  ASSERT_EQ(rs.minimiser.size(), 2U);
  const Points p = doubles(heptagon);
  const double r = value(rs.minimiser[0]);
  EXPECT_NEAR(area(curve(p, r, r, value(rs.minimiser[1]))), area(p), 1e-3);
}

/// The lengths from control vertices to limit points, by refinement.
std::vector<double> drifts(const Points& p, double a, double b, double s) {
  constexpr int depth = 12;
  const Points fine = curve(p, a, b, s, depth);
  std::vector<double> result;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& limit = fine[i << depth];
    result.push_back(std::hypot(limit[0] - p[i][0], limit[1] - p[i][1]));
  }
  return result;
}

double norm(const std::vector<double>& lengths, Norm norm) {
  double result = 0;
  for (const double x : lengths)
    result = norm == Norm::linf ? std::max(result, x) : result + (norm == Norm::l2 ? x * x : x);
  return result;
}

TEST(PolygonObjectives, DistancesFromVerticesAreLeast) {
  const Points p = doubles(pentagon);
  for (const Norm kind : {Norm::l2, Norm::linf, Norm::l1}) {
    const Summary r = best(family_r(), "vertex-distance", kind, coordinates(pentagon), {{q(-3), q(3)}});
    EXPECT_EQ(r.termination, kind == Norm::l1 ? Termination::local : Termination::proved);
    const double at = value(r.minimiser[0]);
    const double least = norm(drifts(p, at, at, 1.5), kind);
    EXPECT_NEAR(value(r.minimum), least, 1e-5 * least);
    for (double other = -3; other <= 3; other += 0.1)
      EXPECT_GE(norm(drifts(p, other, other, 1.5), kind), least * (1 - 1e-9)) << other;
  }
}

TEST(PolygonObjectives, InterpolationIsFoundExactly) {
  // js-report 6: {J_{-7/4,59/52}, *J_{3/2}} interpolates whatever the polygon.
  for (const Norm kind : {Norm::l2, Norm::linf}) {
    const Summary ab =
        best(family_ab(), "vertex-distance", kind, coordinates(pentagon), {{q(-3), q(3)}, {q(0), q(3)}});
    EXPECT_EQ(ab.minimum.exact, "0");
    EXPECT_EQ(ab.minimiser[0].exact, "-7/4");
    EXPECT_EQ(ab.minimiser[1].exact, "59/52");
  }
  // js-report 7: J_{2/3} before *J_1 interpolates the middles of the edges.
  const Scheme<F> scheme =
      mixed(stationary<F>("J_r", jspline(x0)), stationary<F>("*J_1", jspline(fixed(q(1)))));
  const Summary edges = best(scheme, "edge-distance", Norm::l1, coordinates(pentagon), {{q(-1), q(1)}});
  EXPECT_EQ(edges.termination, Termination::proved);
  EXPECT_EQ(edges.minimiser[0].exact, "2/3");
  EXPECT_EQ(edges.minimum.exact, "0");
  // The four-point scheme alone interpolates vertices among *J_s.
  const Summary s = best(family_s(), "vertex-distance", Norm::linf, coordinates(heptagon), {{q(-1), q(3)}});
  EXPECT_EQ(s.minimiser[0].exact, "0");
}

TEST(PolygonObjectives, PoppingOfOneLevel) {
  // A regular quadrilateral: vertices move by s/8 of the second difference, middles by (1-s)/16 of the sum of
  // two that make a right angle: s = (1-s) sqrt(2)/2 for the largest, s = (1-s)/2 for the squares.
  const Coordinates square = coordinates({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  const Summary largest = best(family_s(), "popping", Norm::linf, square, {{q(0), q(1)}});
  EXPECT_EQ(largest.termination, Termination::proved);
  EXPECT_NEAR(value(largest.minimiser[0]), std::sqrt(0.5) / (1 + std::sqrt(0.5)), 1e-12);
  EXPECT_NEAR(value(largest.minimum), std::sqrt(2.0) * value(largest.minimiser[0]), 1e-12);
  const Summary squares = best(family_s(), "popping", Norm::l2, square, {{q(0), q(1)}});
  EXPECT_EQ(squares.minimiser[0].exact, "1/3");
  EXPECT_EQ(squares.minimum.exact, "8/3");  // 4 (2/9 + (2/3)^2)
}

TEST(PolygonObjectives, PoppingOfSeveralLevels) {
  const Summary s = best(family_s(), "popping:level=3", Norm::l2, coordinates(pentagon), {{q(0), q(2)}});
  EXPECT_EQ(s.termination, Termination::proved);
  const auto sum = [&](double at) {
    double total = 0;
    Points p = doubles(pentagon);
    for (int k = 0; k < 3; ++k) {
      const Points fine = refined(p, at, at);
      const Points linear = refined(p, 0, 1);
      for (std::size_t i = 0; i < fine.size(); ++i) {
        for (const std::size_t c : {0U, 1U})
          total += (fine[i][c] - linear[i][c]) * (fine[i][c] - linear[i][c]);
      }
      p = fine;
    }
    return total;
  };
  const double at = value(s.minimiser[0]);
  EXPECT_NEAR(value(s.minimum), sum(at), 1e-9);
  for (double other = 0; other <= 2; other += 0.01) EXPECT_GE(sum(other), sum(at) - 1e-12);
}

TEST(PolygonObjectives, DistanceFromThePolygonIsLocal) {
  // A square of side 8 under {J_r, *J_{3/2}}.
  const Coordinates square = coordinates({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  const Summary r = best(family_r(), "polygon-distance", Norm::linf, square, {{q(-2), q(2)}});
  EXPECT_EQ(r.termination, Termination::local);
  EXPECT_EQ(r.minimum.rigour, Rigour::approximate);
  // Corners of the square to the limit points of its vertices, against the bulge in the middle of an edge.
  const auto distance = [&](double at) {
    const Points fine = curve(doubles({{0, 0}, {8, 0}, {8, 8}, {0, 8}}), at, at, 1.5, 9);
    double bulge = 0;
    for (const auto& [x, y] : fine) bulge = std::max({bulge, -x, -y, x - 8, y - 8});
    double corner = 100;
    for (const auto& [x, y] : fine) corner = std::min(corner, std::hypot(x, y));
    return std::max(bulge, corner);
  };
  const double at = value(r.minimiser[0]);
  EXPECT_NEAR(value(r.minimum), distance(at), 1e-3);
  for (double other = -2; other <= 2; other += 0.1) EXPECT_GE(distance(other), value(r.minimum) - 1e-3);
}

TEST(PolygonObjectives, Degenerate) {
  const Summary point = best(family_s(), "vertex-distance", Norm::l2, {{q(3)}, {q(4)}}, {{q(0), q(1)}});
  EXPECT_EQ(point.termination, Termination::not_unique);
  EXPECT_EQ(point.minimum.exact, "0");
  const Summary flat =
      best(family_s(), "area", Norm::l2, coordinates({{0, 0}, {1, 1}, {2, 2}}), {{q(0), q(1)}});
  EXPECT_EQ(flat.minimum.exact, "0");
  // Points on a line through the values: numbers are points, too.
  const Summary line =
      best(family_r(), "vertex-distance", Norm::l1, {{q(0), q(1), q(5), q(2)}}, {{q(-3), q(3)}});
  EXPECT_EQ(line.termination, Termination::proved);
}

TEST(PolygonObjectives, NamesAndRefusals) {
  for (const ObjectiveDescription& entry : polygon_objectives()) {
    EXPECT_TRUE(names_polygon_objective(entry.example));
    EXPECT_EQ(names_polygon_objective(to_string(parse_polygon_objective(entry.example))), true);
  }
  EXPECT_FALSE(names_polygon_objective("vertex"));
  EXPECT_EQ(to_string(parse_polygon_objective("popping: level=3")), "popping:level=3");
  for (const char* text :
       {"vertices", "popping:level=0", "popping:level=x", "popping:level=7", "area:level=1"})
    EXPECT_THROW(static_cast<void>(parse_polygon_objective(text)), InputError) << text;
  const Coordinates polygon = coordinates(pentagon);
  const std::vector<Range> unit{{q(0), q(1)}};
  EXPECT_THROW(best(family_s(), "polygon-distance", Norm::l2, polygon, unit), InputError);
  EXPECT_THROW(best(family_s(), "area", Norm::l2, {{q(0), q(1)}}, unit), InputError);
  EXPECT_THROW(best(family_s(), "vertex-distance", Norm::l2, {}, unit), InputError);
  EXPECT_THROW(best(family_s(), "vertex-distance", Norm::l2, {{}, {}}, unit), InputError);
  EXPECT_THROW(best(family_s(), "vertex-distance", Norm::l2, polygon, {}), InputError);
  EXPECT_THROW(best(family_s(), "polygon-distance", Norm::linf, polygon, {{q(1), q(1)}}), InputError);
  EXPECT_EQ(best(family_s(), "vertex-distance", Norm::l2, polygon, {{q(-7), q(1)}}).termination,
            Termination::pole_in_box);
  const Scheme<F> dual = stationary<F>("B2", bspline<F>(2));
  EXPECT_THROW(best(dual, "vertex-distance", Norm::l2, polygon, unit), InputError);
}

}  // namespace
}  // namespace subdiv
