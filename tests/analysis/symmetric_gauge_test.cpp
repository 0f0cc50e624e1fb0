#include "analysis/symmetric_gauge.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

Eigen::MatrixXd hexagon() {
  Eigen::MatrixXd v(2, 3);
  v << 1, 0, 1,  //
      0, 1, 1;
  return v;
}

Eigen::VectorXd at(double x, double y) { return Eigen::Vector2d(x, y); }

/// Rebuilds the point from the combination.
Eigen::VectorXd point(const SymmetricGauge& gauge, const Combination& c) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(gauge.dimension());
  for (std::size_t k = 0; k < c.basis.size(); ++k) {
    sum += c.coefficients(static_cast<Eigen::Index>(k)) * gauge.vertices().col(c.basis[k]);
  }
  return sum;
}

TEST(SymmetricGauge, HexagonHasItsClosedForm) {
  const SymmetricGauge gauge = SymmetricGauge::of(hexagon()).value();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  for (int i = 0; i < 200; ++i) {
    const double x = coordinate(random);
    const double y = coordinate(random);
    const double expected = x * y >= 0 ? std::max(std::abs(x), std::abs(y)) : std::abs(x) + std::abs(y);
    const Combination c = gauge.combine(at(x, y));
    EXPECT_NEAR(c.sum, expected, 1e-12);
    EXPECT_NEAR((point(gauge, c) - at(x, y)).norm(), 0, 1e-12);
    EXPECT_NEAR(c.coefficients.cwiseAbs().sum(), c.sum, 1e-12);
  }
}

TEST(SymmetricGauge, CubeAndCrossPolytopeInHigherDimensions) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  constexpr int n = 5;
  Eigen::MatrixXd corners(n, 16);
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < n; ++i) corners(i, j) = i > 0 && (j >> (i - 1) & 1) != 0 ? -1 : 1;
  }
  const SymmetricGauge cube = SymmetricGauge::of(corners).value();
  const SymmetricGauge cross = SymmetricGauge::of(Eigen::MatrixXd::Identity(n, n)).value();
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(n, [&] { return coordinate(random); });
    EXPECT_NEAR(cube.gauge(x), x.cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(cross.gauge(x), x.cwiseAbs().sum(), 1e-12);
  }
}

TEST(SymmetricGauge, StopsOnceTheSumIsEnough) {
  const SymmetricGauge gauge = SymmetricGauge::of(hexagon()).value();
  const Combination c = gauge.combine(at(1, 1), 5);
  EXPECT_LE(c.sum, 5);
  EXPECT_NEAR((point(gauge, c) - at(1, 1)).norm(), 0, 1e-12);
}

TEST(SymmetricGauge, AddedVerticesCount) {
  SymmetricGauge gauge = SymmetricGauge::of(hexagon()).value();
  EXPECT_NEAR(gauge.gauge(at(2, -2)), 4, 1e-12);
  gauge.add_vertex(at(2, -2));
  EXPECT_EQ(gauge.size(), 4);
  EXPECT_NEAR(gauge.gauge(at(2, -2)), 1, 1e-12);
}

TEST(SymmetricGauge, VerticesHaveToSpan) {
  Eigen::MatrixXd line(2, 2);
  line << 1, 2,  //
      1, 2;
  EXPECT_FALSE(SymmetricGauge::of(line).has_value());
}

}  // namespace
}  // namespace subdiv
