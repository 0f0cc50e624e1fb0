#include "analysis/limit_points.h"

#include <cmath>

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

Rational q(long p, long denominator = 1) { return {p, denominator}; }
Scheme<Rational> j(const Rational& s) { return stationary("J", jspline(s)); }

const std::vector<Rational> some_values{q(3), q(-1), q(4), q(1), q(-5), q(9), q(2)};

TEST(LimitPoints, CubicBSpline) {
  // (1, 4, 1)/6 and (-1, 0, 1)/2; half-way (1, 23, 23, 1)/48 and (-1, -5, 5, 1)/8.
  const auto limit = limit_points(stationary("B3", bspline<Rational>(3)), closed_polygon(some_values), 1);
  ASSERT_EQ(limit.positions.size(), 14U);
  EXPECT_EQ(limit.positions[0], (q(2) + q(4) * q(3) + q(-1)) / q(6));
  EXPECT_EQ(limit.tangents[0], (q(-1) - q(2)) / q(2));
  EXPECT_EQ(limit.positions[13], (q(9) + q(23) * q(2) + q(23) * q(3) + q(-1)) / q(48));
  EXPECT_EQ(limit.tangents[13], (q(-9) - q(5) * q(2) + q(5) * q(3) + q(-1)) / q(8));
}

TEST(LimitPoints, AgreeWithFineLevels) {
  constexpr int depth = 12;
  constexpr int density = 1 << depth;
  for (const Scheme<Rational>& scheme :
       {j(q(1, 2)), j(q(3, 2)), mixed(stationary("J", jspline(q(-7, 4), q(59, 52))), j(q(3, 2))),
        mixed(mixed(j(q(1, 5)), j(q(2, 5))), j(q(1, 2)))}) {
    for (const auto& polygon : {closed_polygon(some_values), open_polygon(some_values, 2, 2)}) {
      const auto fine = curve_points(refine_level_by_level(scheme, polygon, depth));
      for (const int level : {0, 1, 2}) {
        const auto limit = limit_points(scheme, polygon, level);
        ASSERT_EQ(limit.positions.size(), refined_points(polygon.topology, 2, level));
        const std::size_t spacing = std::size_t{1} << (depth - level);
        for (std::size_t i = 0; i < limit.positions.size(); ++i) {
          EXPECT_NEAR(limit.positions[i].to_double(), fine[i * spacing].to_double(), 1e-5);
          if ((i + 1) * spacing >= fine.size()) continue;
          const Rational slope = q(density) * (fine[i * spacing + 1] - fine[i * spacing]);
          EXPECT_NEAR(limit.tangents[i].to_double(), slope.to_double(), 0.05);
        }
      }
    }
  }
}

TEST(LimitPoints, AnyRingAndAnyKindOfPoint) {
  using Point = Eigen::Vector2d;
  const std::vector<Point> square{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  const auto limit = limit_points(stationary<double>("B3", bspline<double>(3)), closed_polygon(square));
  EXPECT_NEAR((limit.positions[0] - Point(1, 1)).norm(), 0, 1e-14);
  EXPECT_NEAR((limit.tangents[0] - Point(3, -3)).norm(), 0, 1e-14);
  // Over the rational functions of s the drift from the vertices is exact for all s (jsplines 5).
  using F = RationalFunction;
  const F s = F::variable(0);
  const auto family = limit_points(stationary<F>("J", jspline(s)), closed_polygon<F>({F(1), F(0), F(0)}));
  const auto mask = vertex_limit_mask(stationary<F>("J", jspline(s)));
  EXPECT_EQ(family.positions[0], mask[0]);
  EXPECT_EQ(family.positions[1], mask[1] + mask[2]);
}

TEST(LimitPoints, EndsAndEmptyPolygons) {
  EXPECT_THROW(limit_points(j(q(1, 2)), open_polygon(some_values, 1, 1)), std::out_of_range);
  EXPECT_TRUE(limit_points(j(q(1, 2)), closed_polygon<Rational>({})).positions.empty());
  EXPECT_EQ(limit_points(j(q(1, 2)), closed_polygon<Rational>({q(7)})).positions, std::vector{q(7)});
  // The only vertices of an open polygon that bear a curve.
  EXPECT_EQ(limit_points(j(q(1, 2)), open_polygon(some_values, 2, 2)).positions.size(), 3U);
  // Differences of quadratic B-splines jump: there is no second derivative at the vertices' parameters.
  EXPECT_THROW(limit_derivatives(stationary("B2", bspline<Rational>(2)), closed_polygon(some_values), 0, 2),
               std::domain_error);
}

}  // namespace
}  // namespace subdiv
