#include "analysis/adjustable_speed/characteristic_ring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/speed_matrix.h"
#include "analysis/mesh/mode_matrix.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

RingShape<Function> general_shape() { return {Function::variable(0), Function::variable(1)}; }

TEST(CharacteristicRing, NetIsAnEigenvectorForAllSpeedsAndValences) {
  const RingShape<Function> shape = general_shape();
  const CharacteristicSpeedNet<Function> net(shape);
  const auto stencils = refined_places(shape.sigma);
  for (int place = 0; place < 6; ++place) {
    const RingPoint<Function> fine = apply(stencils[static_cast<std::size_t>(place)], net, 0);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(fine[k], shape.eigenvalue() * net.at(0, place)[k]) << place;
  }
}

TEST(CharacteristicRing, EigenvalueIsTheRootOfThePrintedEquation) {
  const RingShape<Function> shape = general_shape();
  const Function lambda = shape.eigenvalue();
  const Function& s = shape.sigma;
  const Function q = shape.rest();
  const Function linear = q * (s * s * shape.one_plus_cosine() + Function(2) * q);
  EXPECT_TRUE((lambda * lambda - linear * lambda + q * q * q * q).is_zero());
  for (const int n : {3, 4, 5, 8, 50}) {  // (8)
    const double c = std::cos(2 * std::numbers::pi / n);
    for (const double sigma : {0.1, 0.5, 0.9}) {
      const double r = 1 - sigma;
      const double d = (1 + c) * sigma * sigma;
      const double root = sigma * std::sqrt((1 + c) * (d + 4 * r));
      EXPECT_NEAR(ring_shape(sigma, n).eigenvalue(), r / 2 * (d + 2 * r + root), 1e-15);
    }
  }
}

TEST(CharacteristicRing, NetIsTheNumericalEigenvectorOfTheSubdivisionMatrix) {
  for (const int n : {3, 4, 5, 6, 7, 12, 30}) {
    for (const double sigma : {0.1, 0.4, 0.5, 0.8, 0.95}) {
      const Matrix<double> matrix = mode_matrix(speed_matrix(sigma, n), 1);
      const RealEigenpair<double> pair = dominant_eigenpair(matrix);
      ASSERT_EQ(pair.missing, "");
      EXPECT_NEAR(pair.value, ring_shape(sigma, n).eigenvalue(), 1e-12);
      const auto values = mode_values(4, n, 1, 2, pair.vector);
      const CharacteristicSpeedNet<double> net(ring_shape(sigma, n));
      // There the first spoke is the real axis, here (1, -1); there the largest component is 1.
      const double angle = std::numbers::pi / n;
      const PlaneNumber<double> turned{std::cos(angle), std::sin(angle)};
      const double unit = values[0].x;
      for (int place = 0; place < 6; ++place) {
        const RingPoint<double>& own = net.at(0, place);
        const PlaneNumber<double> expected =
            turned * PlaneNumber<double>{std::cos(angle) * own[0], std::sin(angle) * own[1]};
        const PlaneNumber<double>& found = values[static_cast<std::size_t>(place)];
        EXPECT_NEAR(found.x / unit, expected.x, 1e-8 * std::abs(net.at(0, 4)[0])) << n << ' ' << sigma;
        EXPECT_NEAR(found.y / unit, expected.y, 1e-8 * std::abs(net.at(0, 4)[0])) << n << ' ' << sigma;
      }
    }
  }
}

TEST(CharacteristicRing, SpeedOneHalfHasTheEigenvaluesOfCatmullClark) {
  // (c + 5 + sqrt((c + 9)(c + 1)))/16, Ball & Storry 1988.
  for (const int n : {3, 5, 9}) {
    const double c = std::cos(2 * std::numbers::pi / n);
    EXPECT_NEAR(ring_shape(0.5, n).eigenvalue(), (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16, 1e-14);
  }
}

TEST(CharacteristicRing, IntervalsEncloseAnExactRing) {
  // At n = 3, where 1 + c = 1/2, sigma = 7/10 has the rational v = 3/5: v^2 = (3/10 + 7/10 v)/2.
  const RingShape<Rational> exact{Rational(7, 10), Rational(3, 5)};
  ASSERT_EQ(exact.one_plus_cosine(), Rational(1, 2));
  const RingShape<Interval> enclosed = ring_shape(Interval(exact.sigma), 3);
  EXPECT_TRUE(enclosed.v.contains(exact.v));
  EXPECT_TRUE(enclosed.eigenvalue().contains(exact.eigenvalue()));
  const RingSector<RingPoint<Rational>> points = characteristic_ring(exact).sector;
  const RingSector<RingPoint<Interval>> balls = characteristic_ring(enclosed).sector;
  const auto check = [](const auto& ball, const auto& point) {
    for (std::size_t slot = 0; slot < 16; ++slot) {
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(ball[slot][k].contains(point[slot][k])) << slot;
        EXPECT_LT(ball[slot][k].radius(), 1e-30);
      }
    }
  };
  check(balls.corner, points.corner);
  check(balls.next_side, points.next_side);
  check(balls.first_side, points.first_side);
}

TEST(CharacteristicRing, RegularVertexHasTheRingOfTheIdentity) {
  // c = 0: 1 + c = 1 = v^2/W for v = 1. Bezier points of the identity lie on a lattice.
  const Function sigma = Function::variable(0);
  const CharacteristicRing<Function> ring = characteristic_ring(RingShape<Function>{sigma, Function(1)});
  EXPECT_EQ(ring.sector.corner[0][0] * (Function(1) - sigma), ring.sector.corner[15][0]);
  const Function step = ring.sector.corner[4][0] - ring.sector.corner[0][0];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& point = ring.sector.corner[4 * i + j];
      EXPECT_EQ(point[0] - ring.sector.corner[0][0], Function(static_cast<int>(i + j)) * step);
      EXPECT_EQ(point[1], Function(static_cast<int>(j) - static_cast<int>(i)) * step);
    }
  }
}

}  // namespace
}  // namespace subdiv
