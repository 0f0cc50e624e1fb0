#include "optimize/krawczyk.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using F = RationalFunction;

Vector<Interval> point(std::initializer_list<double> x, long precision) {
  Vector<Interval> result(static_cast<Eigen::Index>(x.size()));
  Eigen::Index i = 0;
  for (const double value : x) result(i++) = Interval(value).with_precision(precision);
  return result;
}

/// x^2 + y^2 = 4, x y = 1: x = (sqrt(6) + sqrt(2))/2, y = (sqrt(6) - sqrt(2))/2 among others.
std::vector<F> circle_and_hyperbola() {
  const F x = F::variable(0);
  const F y = F::variable(1);
  return {x * x + y * y - F(4), x * y - F(1)};
}

TEST(Krawczyk, EnclosesAKnownZeroToTheWorkingPrecision) {
  for (const long precision : {128L, 400L}) {
    const auto zero =
        isolate_zero(square_system(circle_and_hyperbola(), precision), point({2, 0.5}, precision));
    ASSERT_TRUE(zero);
    const Interval six = sqrt(Interval(Rational(6), 2 * precision));
    const Interval two = sqrt(Interval(Rational(2), 2 * precision));
    EXPECT_TRUE(zero->enclosure(0).contains((six + two) / Interval(2)));
    EXPECT_TRUE(zero->enclosure(1).contains((six - two) / Interval(2)));
    EXPECT_LT(largest_width(zero->enclosure), Rational::power_of_two(-precision + 12));
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(zero->region(i).contains_strictly(zero->enclosure(i)));
  }
}

TEST(Krawczyk, MapsABoxWithOneZeroIntoItsInterior) {
  const SquareSystem system = square_system(circle_and_hyperbola(), 128);
  Vector<Interval> box(2);
  box(0) = Interval::hull(Rational(19, 10), Rational(2));
  box(1) = Interval::hull(Rational(1, 2), Rational(11, 20));
  const auto image = krawczyk(system, box);
  ASSERT_TRUE(image);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(box(i).contains_strictly((*image)(i)));
}

TEST(Krawczyk, ProvesNothingWithoutAZero) {
  const SquareSystem system = square_system(circle_and_hyperbola(), 128);
  Vector<Interval> box(2);
  box(0) = Interval::hull(Rational(3), Rational(31, 10));
  box(1) = Interval::hull(Rational(1, 2), Rational(6, 10));
  const auto image = krawczyk(system, box);
  ASSERT_TRUE(image);
  EXPECT_FALSE(box(0).contains_strictly((*image)(0)) && box(1).contains_strictly((*image)(1)));
}

TEST(Krawczyk, RefusesADoubleZero) {
  // x^2 = y, y = 0: a double zero is never isolated by a test that holds for perturbed systems too.
  const F x = F::variable(0);
  const F y = F::variable(1);
  EXPECT_FALSE(isolate_zero(square_system(std::vector<F>{x * x - y, y}, 128), point({0.1, 0.1}, 128)));
}

TEST(Krawczyk, RefusesASystemWithoutRealZeros) {
  const F x = F::variable(0);
  const F y = F::variable(1);
  EXPECT_FALSE(
      isolate_zero(square_system(std::vector<F>{x * x + y * y + F(1), x - y}, 128), point({0.3, 0.2}, 128)));
}

TEST(Krawczyk, TakesRationalFunctions) {
  // 1/(1 + x) = y, x = 2 y: 2 y^2 + y - 1 = 0, y = 1/2.
  const F x = F::variable(0);
  const F y = F::variable(1);
  const auto zero = isolate_zero(square_system(std::vector<F>{F(1) / (F(1) + x) - y, x - F(2) * y}, 192),
                                 point({0.7, 0.4}, 192));
  ASSERT_TRUE(zero);
  EXPECT_TRUE(zero->enclosure(0).contains(Rational(1)));
  EXPECT_TRUE(zero->enclosure(1).contains(Rational(1, 2)));
}

TEST(Krawczyk, InverseBoundsHoldBetweenAnyTwoPoints) {
  const std::vector<F> f = circle_and_hyperbola();
  Vector<Interval> box(2);
  box(0) = Interval::hull(Rational(19, 10), Rational(2));
  box(1) = Interval::hull(Rational(1, 2), Rational(6, 10));
  const auto bounds = inverse_bounds(square_system(f, 128), box);
  ASSERT_TRUE(bounds);
  for (int i = 0; i < 100; ++i) {
    const std::vector<Rational> p{Rational(1900 + (i * 37) % 101, 1000),
                                  Rational(500 + (i * 53) % 101, 1000)};
    const std::vector<Rational> q{Rational(1900 + (i * 71) % 101, 1000),
                                  Rational(500 + (i * 29) % 101, 1000)};
    Rational difference;
    for (const F& c : f) {
      difference = std::max(difference, abs(c.evaluate<Rational>(p) - c.evaluate<Rational>(q)));
    }
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_LE(abs(p[j] - q[j]), (*bounds)(static_cast<Eigen::Index>(j)).upper() * difference);
    }
  }
  // On a box where the Jacobian can be singular there is no bound.
  box(1) = Interval::hull(Rational(1), Rational(3));
  EXPECT_FALSE(inverse_bounds(square_system(f, 128), box));
}

TEST(Krawczyk, ApproximateInverseRefusesSingularMatrices) {
  Matrix<Interval> a(2, 2);
  a(0, 0) = a(0, 1) = a(1, 0) = a(1, 1) = Interval(Rational(1));
  EXPECT_FALSE(approximate_inverse(a));
  a(1, 1) = Interval(Rational(2));
  const auto inverse = approximate_inverse(a);
  ASSERT_TRUE(inverse);
  EXPECT_NEAR((*inverse)(0, 0).to_double(), 2, 1e-15);
  EXPECT_NEAR((*inverse)(0, 1).to_double(), -1, 1e-15);
}

}  // namespace
}  // namespace subdiv
