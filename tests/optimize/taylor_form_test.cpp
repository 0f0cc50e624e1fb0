#include "optimize/taylor_form.h"

#include <random>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using F = RationalFunction;

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);

Polynomial sample() {
  return x * x * x * y - Polynomial(Rational(7, 3)) * x * y * y + Polynomial(2) * y - Polynomial(5);
}

std::vector<Interval> box(const Rational& cx, const Rational& rx, const Rational& cy, const Rational& ry) {
  return {Interval::hull(cx - rx, cx + rx, 128), Interval::hull(cy - ry, cy + ry, 128)};
}

TEST(TaylorForm, ShiftIsTheExactExpansion) {
  const std::vector<Interval> centre{Interval(Rational(2)), Interval(Rational(-3))};
  const TaylorForm t = TaylorForm(sample(), 2, 128).shifted(centre);
  const std::vector<Rational> c{Rational(2), Rational(-3)};
  EXPECT_TRUE(t.constant().contains(sample().evaluate<Rational>(c)));
  EXPECT_TRUE(t.slope(0).contains(sample().derivative(0).evaluate<Rational>(c)));
  EXPECT_TRUE(t.slope(1).contains(sample().derivative(1).evaluate<Rational>(c)));
  const Interval mixed = t.derivative(0).derivative(1).constant();
  EXPECT_TRUE(mixed.contains(sample().derivative(0).derivative(1).evaluate<Rational>(c)));
  EXPECT_LT(mixed.radius(), 1e-30);
}

TEST(TaylorForm, RangesContainTheValuesAtRandomPoints) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> digit(-100, 100);
  for (int trial = 0; trial < 200; ++trial) {
    const Rational cx(digit(random), 50);
    const Rational cy(digit(random), 50);
    const Rational rx(std::abs(digit(random)), 100);
    const Rational ry(std::abs(digit(random)), 100);
    const std::vector<Interval> b = box(cx, rx, cy, ry);
    const Interval range = TaylorForm(sample(), 2, 128).shifted(centre_of(b)).range(radius_of(b));
    const Interval least =
        TaylorForm(sample(), 2, 128).shifted(centre_of(b)).scaled(radius_of(b)).least_on_cube();
    for (int k = 0; k < 5; ++k) {
      const std::vector<Rational> at{cx + rx * Rational(digit(random), 100),
                                     cy + ry * Rational(digit(random), 100)};
      const Rational value = sample().evaluate<Rational>(at);
      EXPECT_TRUE(range.contains(value));
      EXPECT_LE(least.lower(), value);
    }
  }
}

TEST(TaylorForm, LowerBoundKnowsThatEvenPowersDoNotFall) {
  // 1 + x^2 on [-1, 1]: the bound is 1, where absolute values would give 0.
  const std::vector<Interval> b = box(Rational(0), Rational(1), Rational(0), Rational(1));
  const TaylorForm t = TaylorForm(Polynomial(1) + x * x, 2, 128).shifted(centre_of(b)).scaled(radius_of(b));
  EXPECT_EQ(t.least_on_cube().lower(), Rational(1));
}

TEST(TaylorForm, PaddingKeepsTheFunction) {
  const TaylorForm t(x * y + Polynomial(1), 2, 128);
  TaylorForm sum = TaylorForm(sample(), 2, 128);
  const TaylorForm padded = t.padded(sum.extents());
  sum += padded;
  const std::vector<Interval> at{Interval(Rational(3)), Interval(Rational(1, 2))};
  const std::vector<Rational> exact{Rational(3), Rational(1, 2)};
  EXPECT_TRUE(
      sum.shifted(at).constant().contains((sample() + x * y + Polynomial(1)).evaluate<Rational>(exact)));
}

TEST(TaylorForm, RefusesAVariableWithoutARange) {
  EXPECT_THROW(TaylorForm(sample(), 1, 64), std::domain_error);
}

TEST(TaylorFunction, EnclosesValueGradientAndHessianOfAQuotient) {
  const F f = F(sample()) / F(x * x + y * y + Polynomial(3));
  const TaylorFunction compiled(f, 2, 128);
  std::mt19937 random(6);
  std::uniform_int_distribution<int> digit(-100, 100);
  for (int trial = 0; trial < 50; ++trial) {
    const Rational cx(digit(random), 50);
    const Rational cy(digit(random), 50);
    const Rational r(std::abs(digit(random)), 1000);
    const SecondOrder local = compiled.over(box(cx, r, cy, r));
    const std::vector<Rational> at{cx + r * Rational(digit(random), 100),
                                   cy + r * Rational(digit(random), 100)};
    EXPECT_TRUE(local.value.contains(f.evaluate<Rational>(at)));
    for (int j = 0; j < 2; ++j) {
      EXPECT_TRUE(local.gradient(j).contains(f.derivative(j).evaluate<Rational>(at)));
      for (int k = 0; k < 2; ++k) {
        EXPECT_TRUE(local.hessian(j, k).contains(f.derivative(j).derivative(k).evaluate<Rational>(at)));
      }
    }
  }
}

TEST(TaylorFunction, IsNotFiniteOverAPole) {
  const TaylorFunction f(F(1) / F(x - y), 2, 128);
  EXPECT_FALSE(f.over(box(Rational(0), Rational(1), Rational(0), Rational(1))).value.is_finite());
}

}  // namespace
}  // namespace subdiv
