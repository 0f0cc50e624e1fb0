#include "analysis/polyloop/limit_shape.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "schemes/polyloop/apply_operator.h"

namespace subdiv {
namespace {

Laurent<Rational> tuck(const Rational& t) { return polyloop::tuck(t).rows.front(); }

TEST(LimitShape, ModesOfTheSquare) {  // x_k = 0, 1, 2
  const std::vector<Algebraic> gains = mode_gains(tuck(Rational(2, 3)), 4);
  EXPECT_EQ(gains, (std::vector<Algebraic>{1, Rational(1, 3), Rational(-1, 3)}));
  EXPECT_EQ(slowest_modes(tuck(Rational(2, 3)), 4), (std::vector<int>{1, 2}));
  EXPECT_EQ(slowest_modes(tuck(Rational(1, 2)), 4), std::vector<int>{1});
  EXPECT_EQ(slowest_modes(tuck(Rational(3, 4)), 4), std::vector<int>{2});
  EXPECT_EQ(ellipse_end(4), Algebraic(Rational(2, 3)));
}

TEST(LimitShape, ModeOneIsSlowestUpToItsEnd) {
  for (int n = 4; n <= 9; ++n) {
    const Algebraic end = ellipse_end(n);
    EXPECT_TRUE(Algebraic(Rational(2, 3)) <= end && end < Algebraic(Rational(6, 5))) << n;
    const Rational step(1, 1000000);
    const Rational near = end.to_interval().midpoint();
    EXPECT_EQ(slowest_modes(tuck(near - step), n), std::vector<int>{1}) << n;
    EXPECT_EQ(slowest_modes(tuck(near + step), n), std::vector<int>{n / 2}) << n;
  }
  EXPECT_THROW((void)ellipse_end(3), std::domain_error);
}

/// Repeated tucks of a loop, scaled about its centroid: they come to lie on its limit ellipse.
TEST(LimitShape, RepeatedTucksComeToLieOnTheEllipse) {
  std::mt19937 random(7);
  std::vector<VertexChain<double>> loop(2, VertexChain<double>{{}, true, 0});
  for (auto& c : loop) {
    for (int i = 0; i < 7; ++i) c.vertices.push_back(static_cast<double>(random() % 100));
    double mean = 0;
    for (const double x : c.vertices) mean += x / 7;
    for (double& x : c.vertices) x -= mean;
  }
  const HalfAxes axes = limit_ellipse(make_polyline({loop[0].vertices, loop[1].vertices}, true));
  const auto gain = mode_gains(tuck(Rational(1, 2)), 7)[1].to_interval().to_double();
  const PolyloopOperator<double> op = polyloop::tuck(0.5);
  constexpr int steps = 45;  // more would show the rounding of the centroid
  for (int k = 0; k < steps; ++k) {
    for (auto& c : loop) {
      c = apply(op, c);
      for (double& x : c.vertices) x /= gain;
    }
  }
  // The half axes of points on an ellipse in equal steps of its parameter, from their second moments.
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    const double x = loop[0].vertices[i];
    const double y = loop[1].vertices[i];
    xx += 2 * x * x / 7;
    xy += 2 * x * y / 7;
    yy += 2 * y * y / 7;
  }
  EXPECT_NEAR(xx + yy, axes.major * axes.major + axes.minor * axes.minor, 1e-9);
  EXPECT_NEAR(xx * yy - xy * xy, std::pow(axes.major * axes.minor, 2), 1e-6);
}

TEST(LimitShape, RegularPolygonsAndRefusals) {
  const HalfAxes square = limit_ellipse(make_polyline({{1, 0, -1, 0}, {0, 1, 0, -1}}, true));
  EXPECT_NEAR(square.major, 1, 1e-15);
  EXPECT_NEAR(square.minor, 1, 1e-15);
  const HalfAxes rectangle = limit_ellipse(make_polyline({{0, 4, 4, 0}, {0, 0, 2, 2}}, true));
  EXPECT_NEAR(rectangle.major / rectangle.minor, 2, 1e-14);
  EXPECT_THROW((void)limit_ellipse(make_polyline({{0, 1}, {0, 1}}, false)), std::invalid_argument);
  EXPECT_THROW((void)mode_gains(tuck(Rational(1)), 0), std::domain_error);
}

TEST(LimitShape, TurnedRoundTheEllipseIsTheSame) {
  const HalfAxes clockwise = limit_ellipse(make_polyline({{0, 0, 4, 4}, {0, 2, 2, 0}}, true));
  EXPECT_NEAR(clockwise.major / clockwise.minor, 2, 1e-14);
  EXPECT_GT(clockwise.minor, 0);
}

TEST(LimitShape, FewerThanThreeVerticesHaveNoEllipse) {
  for (const auto& polygon : {make_polyline({{0, 1}, {0, 2}}, true), make_polyline({{3}, {4}}, true)}) {
    EXPECT_EQ(limit_ellipse(polygon).major, 0);
    EXPECT_EQ(limit_ellipse(polygon).minor, 0);
  }
}

}  // namespace
}  // namespace subdiv
