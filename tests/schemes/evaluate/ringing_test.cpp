#include "schemes/evaluate/ringing.h"

#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/matrix.h"
#include "schemes/bspline.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/jspline.h"
#include "tests/schemes/evaluate/sample_schemes.h"

namespace subdiv {
namespace {

using testing::binary_and_ternary_schemes;
using testing::j;
using testing::powers;
using testing::q;
using testing::Rationals;

template <class R, class Point>
std::vector<Point> by_ringing(const Scheme<R>& scheme, const ControlPolygon<Point>& controls, int depth) {
  std::vector<Point> points;
  Ringing<R, Point> rings(scheme, controls, depth);
  for (const Point& p : rings) points.push_back(p);
  return points;
}

TEST(Ringing, GivesTheSamePointsAsLevelByLevelRefinement) {  // js-report 12, over the rationals
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    for (const int n : {1, 2, 3, 7}) {
      const ControlPolygon<Rational> controls = closed_polygon(powers(n));
      for (int depth = 0; depth <= 4; ++depth) {
        EXPECT_EQ(by_ringing(scheme, controls, depth),
                  curve_points(refine_level_by_level(scheme, controls, depth)))
            << scheme.name << ", " << n << " points, depth " << depth;
      }
    }
  }
}

TEST(Ringing, OpenCurvesEndAtTheLastVertexWithSpan) {
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    const IndexWindow window = vertex_reach(scheme);
    const auto before = static_cast<std::size_t>(-window.first);
    const auto after = static_cast<std::size_t>(window.last);
    for (const std::size_t spans : {0U, 1U, 4U}) {
      const auto count = static_cast<int>(before + after + spans + 1);
      const ControlPolygon<Rational> controls = open_polygon(powers(count), before, after);
      for (int depth = 0; depth <= 4; ++depth) {
        const Rationals points = by_ringing(scheme, controls, depth);
        EXPECT_EQ(points.size(), spans * refined_spacing(scheme.arity(), depth) + 1);
        EXPECT_EQ(points, curve_points(refine_level_by_level(scheme, controls, depth)))
            << scheme.name << ", " << spans << " spans, depth " << depth;
      }
    }
  }
}

TEST(Ringing, OpenCurvesOfFewStepsNeedFewerPoints) {  // one step of J_s reaches one point beyond a vertex
  const ControlPolygon<Rational> controls = open_polygon(powers(6), 1, 1);
  const Rationals points = by_ringing(j(q(1, 2)), controls, 1);
  EXPECT_EQ(points, curve_points(refine_level_by_level(j(q(1, 2)), controls, 1)));
  EXPECT_THROW((Ringing<Rational, Rational>(j(q(1, 2)), controls, 2)), std::out_of_range);
}

TEST(Ringing, BeginsAnywhere) {
  const ControlPolygon<Rational> controls = closed_polygon(powers(5));
  const Scheme<Rational> scheme = mixed(j(q(-33, 26)), j(q(3, 2)));
  const Rationals all = by_ringing(scheme, controls, 3);
  Ringing<Rational, Rational> rings(scheme, controls, 3, 2);
  for (std::size_t i = 16; i < all.size(); ++i) {
    ASSERT_FALSE(rings.done());
    EXPECT_EQ(rings.index(), static_cast<long long>(i));
    EXPECT_EQ(rings.point(), all[i]);
    rings.advance();
  }
  EXPECT_TRUE(rings.done());
}

TEST(Ringing, FootprintIsFivePointsALevel) {  // js-report 12
  const ControlPolygon<double> controls = closed_polygon(std::vector<double>(9, 1));
  Ringing<double, double> rings(stationary("J", jspline(0.7)), controls, 6);
  EXPECT_EQ(rings.points_per_level(), 5U);
  EXPECT_EQ(rings.levels(), 7U);
}

TEST(Ringing, ComputesEveryPointOnceBesidesTheRingsAtTheWrap) {
  const ControlPolygon<double> controls = closed_polygon(std::vector<double>(9, 1));
  Ringing<double, double> rings(stationary("J", jspline(0.7)), controls, 6);
  while (!rings.done()) rings.advance();
  for (std::size_t level = 0; level < rings.levels(); ++level) {
    const std::size_t points = refined_points(controls.topology, 2, static_cast<int>(level));
    EXPECT_GE(rings.computed(level), points);
    EXPECT_LE(rings.computed(level), points + 5);
  }
}

TEST(Ringing, WritesIntoBuffersOfAnySize) {
  const ControlPolygon<Rational> controls = closed_polygon(powers(3));
  const Rationals all = by_ringing(j(q(1, 2)), controls, 3);
  Ringing<Rational, Rational> rings(j(q(1, 2)), controls, 3);
  Rationals buffer(5);
  Rationals written;
  while (const std::size_t count = rings.write(buffer))
    written.insert(written.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
  EXPECT_EQ(written, all);
}

TEST(Ringing, EnclosesOverIntervals) {
  const Scheme<Rational> exact = j(q(1, 3));
  const auto enclosing = map_coefficients(exact, [](const Rational& x) { return Interval(x); });
  std::vector<Interval> points;
  for (const Rational& x : powers(4)) points.emplace_back(x);
  const std::vector<Interval> values = by_ringing(enclosing, closed_polygon(points), 3);
  const Rationals truth = by_ringing(exact, closed_polygon(powers(4)), 3);
  ASSERT_EQ(values.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_TRUE(values[i].contains(truth[i])) << i;
}

TEST(Ringing, VectorsOfFloats) {
  using Point = Eigen::Vector3f;
  const std::vector<Point> points{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}};
  const auto curve = by_ringing(stationary("J", jspline(1.0F)), closed_polygon(points), 5);
  EXPECT_EQ(curve.size(), 96U);
  // The cubic B-spline at a vertex: (P_2 + 4 P_0 + P_1) / 6.
  const Point limit = (points[2] + 4.0F * points[0] + points[1]) / 6.0F;
  EXPECT_NEAR((curve[0] - limit).norm(), 0, 1e-2);
}

TEST(Ringing, ResiduesWithoutCoefficientsGiveZero) {  // a(z) = 2: even points are doubled, odd ones are 0
  const Scheme<Rational> scheme = stationary("even", Mask<Rational>{2, Laurent<Rational>(2)});
  const ControlPolygon<Rational> controls = closed_polygon(powers(3));
  EXPECT_EQ(by_ringing(scheme, controls, 1), (Rationals{2, 0, 4, 0, 8, 0}));
  EXPECT_EQ(by_ringing(scheme, controls, 3), curve_points(refine_level_by_level(scheme, controls, 3)));
  EXPECT_EQ(ring_window(scheme), (IndexWindow{-1, 0})) << "the rule of odd points reads the vertex before";
}

TEST(Ringing, NothingOfAnEmptyPolygon) {
  const ControlPolygon<double> controls = closed_polygon(std::vector<double>{});
  Ringing<double, double> rings(stationary("J", jspline(0.5)), controls, 3);
  EXPECT_TRUE(rings.done());
  rings.advance();
  EXPECT_TRUE(rings.done());
}

TEST(Ringing, RefusesOpenPolygonsWithoutAddedPoints) {
  const ControlPolygon<double> controls = open_polygon(std::vector<double>(6, 1), 1, 1);
  EXPECT_THROW((Ringing<double, double>(stationary("J", jspline(0.5)), controls, 3)), std::out_of_range);
  EXPECT_THROW((Ringing<double, double>(stationary("J", jspline(0.5)), controls, -1)), std::invalid_argument);
}

TEST(Ringing, DetailsAreReplayedAtTheirLevels) {  // js-report 10
  const ControlPolygon<Rational> controls = closed_polygon(powers(3));
  const Details<Rational> details(
      {{2, 11, q(5)}, {0, 1, q(1, 3)}, {1, 0, q(-7)}, {2, 0, q(2)}, {2, 0, q(4)}, {4, 47, q(9)}});
  for (const Scheme<Rational>& scheme : {j(q(3, 2)), stationary("B2", bspline<Rational>(2))}) {
    Ringing<Rational, Rational> rings(scheme, controls, 4, details);
    Rationals points;
    for (const Rational& p : rings) points.push_back(p);
    EXPECT_EQ(points, curve_points(refine_level_by_level(scheme, controls, 4, details)));
    EXPECT_NE(points, by_ringing(scheme, controls, 4));
  }
}

TEST(Ringing, DetailsBeyondTheCurveAreRefused) {
  const ControlPolygon<Rational> controls = closed_polygon(powers(3));
  for (const Detail<Rational>& d :
       {Detail<Rational>{1, 6, q(1)}, {5, 0, q(1)}, {-1, 0, q(1)}, {0, -1, q(1)}}) {
    EXPECT_THROW((Ringing<Rational, Rational>(j(q(1)), controls, 4, Details<Rational>({d}))),
                 std::out_of_range);
  }
}

TEST(Ringing, LinearDataFollowTheAbscissae) {  // J_s reproduces t: closed form, independent of refinement
  Rationals line;
  for (int i = -2; i <= 8; ++i) line.push_back(q(i));
  const Rationals points = by_ringing(j(q(-3, 7)), open_polygon(line, 2, 2), 5);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], q(static_cast<long>(i), 32));
}

}  // namespace
}  // namespace subdiv
