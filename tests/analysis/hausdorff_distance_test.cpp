#include "analysis/hausdorff_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr double tolerance = 1e-9;

Polyline closed(std::vector<std::vector<double>> coordinates) {
  return make_polyline(std::move(coordinates), true);
}
Polyline open(std::vector<std::vector<double>> coordinates) {
  return make_polyline(std::move(coordinates), false);
}

void expect_encloses(const DistanceBounds& bounds, double value) {
  EXPECT_LE(bounds.lower, value + 1e-14);
  EXPECT_GE(bounds.upper, value - 1e-14);
  EXPECT_LE(bounds.width(), tolerance);
}

TEST(HausdorffDistance, ClosedForms) {
  const Polyline small = closed({{-1, 1, 1, -1}, {-1, -1, 1, 1}});
  const Polyline large = closed({{-2, 2, 2, -2}, {-2, -2, 2, 2}});
  expect_encloses(directed_hausdorff_distance(small, large, tolerance), 1);
  expect_encloses(directed_hausdorff_distance(large, small, tolerance), std::sqrt(2.0));
  expect_encloses(hausdorff_distance(small, large, tolerance), std::sqrt(2.0));
  expect_encloses(hausdorff_distance(small, small, tolerance), 0);
  // The farthest point lies inside an edge: between the arms of a U, 3 away from both.
  const Polyline edge = open({{-3, 3}, {0, 0}});
  const Polyline arms = open({{-3, -3, 3, 3}, {0, -9, -9, 0}});
  expect_encloses(directed_hausdorff_distance(edge, arms, tolerance), 3);
  expect_encloses(directed_hausdorff_distance(arms, edge, tolerance), 9);
  // An L: (t, 0) is min(t, 1) away.
  const Polyline corner = open({{0, 0, 10}, {4, -1, -1}});
  expect_encloses(directed_hausdorff_distance(open({{0, 6}, {0, 0}}), corner, tolerance), 1);
}

TEST(HausdorffDistance, AnyDimension) {
  expect_encloses(hausdorff_distance(open({{0, 1}}), open({{0, 3.5}}), tolerance), 2.5);
  const std::vector<std::vector<double>> a(5, {0, 1});
  std::vector<std::vector<double>> b = a;
  b[3] = {0, 4};  // the R-tree sees the first three coordinates alone
  b[4] = {0, 5};
  expect_encloses(hausdorff_distance(open(a), open(b), tolerance), 5);
  // The end (1, 1, 1, 4, 5) is nearest to (1, 1, 1, 1, 1); the way back is along b: sqrt(5 - 12^2/44).
  expect_encloses(directed_hausdorff_distance(open(a), open(b), tolerance), std::sqrt(5 - 144.0 / 44));
}

TEST(HausdorffDistance, BeyondTheThirdCoordinate) {
  // The nearest edge in the first three coordinates is far in the fourth: (0,0,0,0) to (1,0,0,0), not to
  // (0,0,0,9).
  const std::vector<std::vector<double>> a{{0}, {0}, {0}, {0}};
  const std::vector<std::vector<double>> b{{0, 1}, {0, 0}, {0, 0}, {9, 0}};
  // The edge from (0,0,0,9) to (1,0,0,0) is 9/sqrt(82) away from the origin.
  expect_encloses(directed_hausdorff_distance(open(a), open(b), tolerance), 9 / std::sqrt(82.0));
  const std::vector<std::vector<double>> c{{0, 0, 1, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {9, 8, 8, 0}};
  expect_encloses(directed_hausdorff_distance(open(a), open(c), tolerance), 1);
}

TEST(HausdorffDistance, AnySize) {
  for (const double size : {1e-300, 1e-150, 1e150, 1e300}) {
    const Polyline small = closed({{-size, size, size, -size}, {-size, -size, size, size}});
    const Polyline large =
        closed({{-2 * size, 2 * size, 2 * size, -2 * size}, {-2 * size, -2 * size, 2 * size, 2 * size}});
    const DistanceBounds bounds = hausdorff_distance(small, large, 1e-9 * size);
    EXPECT_NEAR(bounds.lower / size, std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(bounds.upper / size, std::sqrt(2.0), 1e-9);
  }
}

TEST(HausdorffDistance, Points) {
  const Polyline point = closed({{1}, {1}});
  expect_encloses(hausdorff_distance(point, closed({{4}, {5}}), tolerance), 5);
  expect_encloses(directed_hausdorff_distance(point, open({{0, 2}, {0, 0}}), tolerance), 1);
  expect_encloses(hausdorff_distance(closed({{1, 1, 1}, {1, 1, 1}}), point, tolerance), 0);
  // Points that carry the ends of an open curve do not count.
  const Polyline added{{4, false, 1, 1}, {{-9, 0, 1, 9}}};
  expect_encloses(hausdorff_distance(added, open({{0, 1}}), tolerance), 0);
}

TEST(HausdorffDistance, Refuses) {
  const Polyline fine = open({{0, 1}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(hausdorff_distance(open({{0, nan}}), fine, tolerance)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(hausdorff_distance(fine, open({{}}), tolerance)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(hausdorff_distance(fine, open({}), tolerance)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(hausdorff_distance(fine, open({{0, 1}, {0, 1}}), tolerance)),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(hausdorff_distance(fine, fine, 0)), std::invalid_argument);
}

double distance_from_edge(double x, double y, double ax, double ay, double bx, double by) {
  const double t = std::clamp(
      ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)), 0.0,
      1.0);
  return std::hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay));
}

/// By dense samples of a against all edges of b: at most half a sample's length too small.
double sampled(const Polyline& a, const Polyline& b, int samples, double& gap) {
  const auto at = [](const Polyline& p, std::size_t c, std::size_t i) {
    return p.coordinates[c][i % p.topology.points];
  };
  double largest = 0;
  for (std::size_t i = 0; i < a.topology.points; ++i) {
    const double dx = at(a, 0, i + 1) - at(a, 0, i);
    const double dy = at(a, 1, i + 1) - at(a, 1, i);
    gap = std::max(gap, std::hypot(dx, dy) / samples / 2);
    for (int k = 0; k <= samples; ++k) {
      const double x = at(a, 0, i) + dx * k / samples;
      const double y = at(a, 1, i) + dy * k / samples;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < b.topology.points; ++j) {
        least = std::min(
            least, distance_from_edge(x, y, at(b, 0, j), at(b, 1, j), at(b, 0, j + 1), at(b, 1, j + 1)));
      }
      largest = std::max(largest, least);
    }
  }
  return largest;
}

TEST(HausdorffDistance, AgreesWithDenseSamples) {
  std::mt19937 random(20261122);
  const auto number = [&] { return static_cast<double>(random() % 1000); };
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::vector<double>> a(2);
    std::vector<std::vector<double>> b(2);
    for (int i = 0; i < 5 + trial; ++i) {
      for (int c = 0; c < 2; ++c) {
        a[static_cast<std::size_t>(c)].push_back(number());
        b[static_cast<std::size_t>(c)].push_back(number());
      }
    }
    const Polyline p = closed(a);
    const Polyline q = closed(b);
    double gap = 0;
    const double expected = sampled(p, q, 2000, gap);
    const DistanceBounds bounds = directed_hausdorff_distance(p, q, 1e-6);
    EXPECT_LE(expected, bounds.upper + 1e-9);
    EXPECT_GE(expected + gap, bounds.lower);
    EXPECT_LE(bounds.width(), 1e-6);
  }
}

TEST(HausdorffDistance, FinePolygonsAreQuick) {
  constexpr int n = 100000;
  std::vector<std::vector<double>> coarse(2);
  std::vector<std::vector<double>> fine(2);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    fine[0].push_back(std::cos(angle));
    fine[1].push_back(std::sin(angle));
    if (i % 2 != 0) continue;
    coarse[0].push_back(std::cos(angle));
    coarse[1].push_back(std::sin(angle));
  }
  constexpr double small = 1e-12;
  const DistanceBounds bounds = hausdorff_distance(closed(coarse), closed(fine), small);
  EXPECT_NEAR(bounds.lower, 1 - std::cos(2 * std::numbers::pi / n), small);
  EXPECT_LE(bounds.width(), small);
}

TEST(HausdorffDistance, DisparityOfConsecutiveLevels) {
  const Polyline square = closed({{0, 8, 8, 0}, {0, 0, 8, 8}});
  const auto levels = disparities(stationary<double>("J", jspline(0.0)), square, 3, tolerance);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].displacement, 1);
  expect_encloses(levels[0].hausdorff, 1);  // the mid-edge points bulge by 1
  EXPECT_LT(levels[2].displacement, levels[1].displacement);
  const auto cubic = disparities(stationary<double>("J", jspline(1.0)), square, 1, tolerance);
  EXPECT_EQ(cubic[0].displacement, std::sqrt(2.0));
  // From the corner (0, 0) to the edges between (1, 1) and (0, 4), (4, 0): the nearest is (1, 1).
  expect_encloses(cubic[0].hausdorff, std::sqrt(2.0));
}

}  // namespace
}  // namespace subdiv
