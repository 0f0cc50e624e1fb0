#include "analysis/curve_measures.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "schemes/jspline.h"

namespace subdiv {
namespace {

Polyline closed(std::vector<std::vector<double>> coordinates) {
  return make_polyline(std::move(coordinates), true);
}
Polyline open(std::vector<std::vector<double>> coordinates) {
  return make_polyline(std::move(coordinates), false);
}

Polyline regular_polygon(int n, double radius) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < n; ++i) {
    x.push_back(radius * std::cos(2 * std::numbers::pi * i / n));
    y.push_back(radius * std::sin(2 * std::numbers::pi * i / n));
  }
  return closed({x, y});
}

TEST(CurveMeasures, Lengths) {
  EXPECT_EQ(length(closed({{0, 3, 3}, {0, 0, 4}})), 12);
  EXPECT_EQ(length(open({{0, 3, 3}, {0, 0, 4}})), 7);
  EXPECT_EQ(length(open({{0, 1, 1, 1}, {0, 0, 2, 2}, {0, 0, 0, 2}})), 5);
  EXPECT_EQ(length(open({{5, 2, 4}})), 5);
  EXPECT_EQ(length(closed({{1}, {1}})), 0);
  EXPECT_EQ(length(closed({})), 0);
  EXPECT_EQ(length(open({{1}, {1}})), 0);
  const double huge = 1e300;
  EXPECT_EQ(length(open({{0, 3 * huge}, {0, 4 * huge}})), 5 * huge);
  constexpr int many = 1000000;
  EXPECT_NEAR(length(regular_polygon(many, 1)), 2 * many * std::sin(std::numbers::pi / many), 1e-13);
  EXPECT_TRUE(std::isnan(length(open({{0, std::numeric_limits<double>::quiet_NaN()}}))));
  EXPECT_TRUE(std::isinf(length(open({{0, std::numeric_limits<double>::infinity(), 1}}))));
}

TEST(CurveMeasures, PointsThatCarryTheEndsDoNotCount) {
  const Polyline polyline{{6, false, 2, 1}, {{9, 8, 0, 3, 5, 7}}};
  EXPECT_EQ(curve_size(polyline.topology), 3U);
  EXPECT_EQ(edge_count(polyline.topology), 2U);
  EXPECT_EQ(length(polyline), 5);
}

TEST(CurveMeasures, Areas) {
  EXPECT_EQ(signed_area(closed({{0, 4, 4, 0}, {0, 0, 3, 3}})), 12);
  EXPECT_EQ(signed_area(closed({{0, 0, 4, 4}, {0, 3, 3, 0}})), -12);
  EXPECT_EQ(signed_area(closed({{0, 1, 0, 1}, {0, 1, 1, 0}})), 0);  // an eight
  EXPECT_EQ(signed_area(closed({{1, 2}, {1, 5}})), 0);
  const double far = std::ldexp(1.0, 50);  // no digits are lost far from the origin
  EXPECT_EQ(signed_area(closed({{far, far + 1, far + 1, far}, {-far, -far, -far + 1, -far + 1}})), 1);
  EXPECT_NEAR(signed_area(regular_polygon(12, 2)), 12, 1e-13);  // the dodecagon has area 3 r^2
  EXPECT_THROW(static_cast<void>(signed_area(open({{0, 1, 1}, {0, 0, 1}}))), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(signed_area(closed({{0, 1, 1}}))), std::invalid_argument);
}

TEST(CurveMeasures, VectorAreas) {
  using Vector = std::array<double, 3>;
  EXPECT_EQ(vector_area(closed({{0, 4, 4, 0}, {0, 0, 3, 3}, {7, 7, 7, 7}})), (Vector{0, 0, 12}));
  // The triangle of the three unit points: (1, 1, 1)/2.
  EXPECT_EQ(vector_area(closed({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})), (Vector{0.5, 0.5, 0.5}));
  EXPECT_THROW(static_cast<void>(vector_area(closed({{1, 0, 0}, {0, 1, 0}}))), std::invalid_argument);
}

TEST(CurveMeasures, NormalJerk) {
  // polyloops 1: -A + 3B - 3C + D = (0, 6) over the edge from (0, 0) to (1, 0), and (1, 5) with D moved.
  EXPECT_EQ(normal_jerks(open({{-1, 0, 1, 2}, {-3, 0, 0, 3}})), std::vector<double>{6});
  EXPECT_EQ(normal_jerks(open({{-1, 0, 1, 3}, {-3, 0, 0, 2}})), std::vector<double>{5});
  EXPECT_EQ(normal_jerks(open({{-1, 0, 1, 2}, {3, 0, 0, -3}})), std::vector<double>{-6});
  // In space its length, without the part along the edge: (1, 5, -12).
  EXPECT_EQ(normal_jerks(open({{-1, 0, 1, 3}, {-3, 0, 0, 2}, {6, 0, 0, -6}})), std::vector<double>{13});
  // An edge without a direction.
  EXPECT_EQ(normal_jerks(open({{-1, 0, 0, 2}, {-2, 0, 0, 2}})), std::vector<double>{5});
  EXPECT_TRUE(normal_jerks(open({{-1, 0, 1}, {-3, 0, 0}})).empty());
  EXPECT_EQ(normal_jerk(open({{-1, 0, 1}, {-3, 0, 0}})).largest, 0);
  // A regular polygon's jerk is tangential alone.
  EXPECT_LT(normal_jerk(regular_polygon(7, 1)).largest, 1e-15);
  // Edge i of a closed polygon starts at point i. A square with one point moved out by (1, 1):
  const Polyline kite = closed({{0, 1, 2, 0}, {0, 0, 2, 1}});
  const std::vector<double> jerks = normal_jerks(kite);
  ASSERT_EQ(jerks.size(), 4U);
  EXPECT_EQ(jerks[0], 1);   // A = (0,1), B = (0,0), C = (1,0), D = (2,2): (-1, 1)
  EXPECT_EQ(jerks[3], -1);  // the mirror image, run through the other way
  const NormalJerk both = normal_jerk(kite);
  EXPECT_EQ(both.largest, std::max(std::abs(jerks[1]), 1.0));
  EXPECT_DOUBLE_EQ(both.mean, (2 + std::abs(jerks[1]) + std::abs(jerks[2])) / 4);
}

TEST(CurveMeasures, JerkOfTheSmallestLoops) {
  // Two points: A = D = neighbours on the line, -A + 3B - 3C + D is along BC. One point: all are equal.
  EXPECT_NEAR(normal_jerk(make_polyline({{0, 4}, {0, 3}}, true)).largest, 0, 1e-14);
  EXPECT_EQ(normal_jerk(make_polyline({{2}, {7}}, true)).largest, 0);
}

TEST(CurveMeasures, DisplacementFromLinearRefinement) {
  const Polyline square = closed({{0, 8, 8, 0}, {0, 0, 8, 8}});
  // J_0 keeps vertices and moves mid-edge points out by 1/8 of (0, 8): the third neighbours' bulge.
  const Scheme<double> four_point = stationary<double>("J", jspline(0.0));
  EXPECT_EQ(largest_displacement(square, refine(four_point, square, 1), 2), 1);
  // J_1 moves vertices by 1/8 of (8, 8) and keeps mid-edge points.
  const Scheme<double> cubic = stationary<double>("J", jspline(1.0));
  EXPECT_EQ(largest_displacement(square, refine(cubic, square, 1), 2), std::sqrt(2.0));
  const Scheme<double> linear = stationary<double>("J", jspline(0.0, 1.0));
  EXPECT_EQ(largest_displacement(square, refine(linear, square, 1), 2), 0);
  EXPECT_THROW(static_cast<void>(largest_displacement(square, refine(linear, square, 2), 2)),
               std::invalid_argument);
  // Thirds of an edge, open.
  EXPECT_EQ(largest_displacement(open({{0, 3, 9}}), open({{0, 1, 2.5, 3, 5, 7, 9}}), 3), 0.5);
}

}  // namespace
}  // namespace subdiv
