#include "optimize/unbounded_bound.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);
const Polynomial s = Polynomial::variable(2);
constexpr long precision = 128;

/// A circle, a hyperbola and a line that miss each other.
UnboundedProblem no_common_point() {
  return {{x * x + y * y - Polynomial(4), x * y - Polynomial(1), x - y - Polynomial(3) - s}, 2, 2};
}

TEST(UnboundedBound, IsBelowTheMaximumAtEveryPoint) {
  const UnboundedProblem problem = no_common_point();
  const UnboundedBound bound(problem, precision);
  const Rational low(-1, 100);
  const Rational high(1, 100);
  const Rational least = bound.least_maximum(low, high);
  ASSERT_GT(least, Rational(0));
  for (int i = -40; i <= 40; ++i) {
    for (int j = -40; j <= 40; ++j) {
      for (const Rational& at : {low, Rational(0), high}) {
        const std::vector<Rational> point{Rational(i, 10), Rational(j, 10), at};
        Rational largest;
        for (const Polynomial& f : problem.functions)
          largest = std::max(largest, abs(f.evaluate<Rational>(point)));
        ASSERT_GE(largest, least);
      }
    }
  }
}

TEST(UnboundedBound, KnowsAClosedForm) {
  // max(|x^2 - s|, |x^2 + s|) >= |s|, and it is attained at x = 0 (one unknown, the parameter is the next
  // variable).
  const Polynomial t = Polynomial::variable(1);
  const UnboundedBound bound({{x * x - t, x * x + t}, 1, 2}, precision);
  const Rational least = bound.least_maximum(Rational(2), Rational(2) + Rational::power_of_two(-40));
  EXPECT_LE(least, Rational(2));
  EXPECT_GT(least, Rational(1, 10));
}

TEST(UnboundedBound, ProvesNothingWhereThereIsACommonZero) {
  const UnboundedBound bound({{x * x + y * y - Polynomial(2), x - y - s, x * y - Polynomial(1)}, 2, 2},
                             precision);
  EXPECT_EQ(bound.least_maximum(Rational(-1, 100), Rational(1, 100)), Rational(0));  // (1, 1) at s = 0
  EXPECT_GT(bound.least_maximum(Rational(1), Rational(101, 100)), Rational(0));
  const UnboundedAnswer there =
      exceeds(bound, Polynomial(1), 2, Rational(1, 1000000), Rational(-1), Rational(1), 200);
  EXPECT_FALSE(there.proved);
  EXPECT_EQ(there.intervals, 200);
  EXPECT_TRUE(exceeds(bound, Polynomial(1), 2, Rational(1, 1000000), Rational(1), Rational(2), 2000).proved);
}

TEST(UnboundedBound, WeighsByTheDenominator) {
  const UnboundedBound bound(no_common_point(), precision);
  const Rational level = bound.least_maximum(Rational(0), Rational(0)) * Rational(9, 10);
  EXPECT_TRUE(exceeds(bound, Polynomial(1), 2, level, Rational(0), Rational(1, 1000), 100).proved);
  EXPECT_FALSE(exceeds(bound, Polynomial(2), 2, level, Rational(0), Rational(1, 1000), 100).proved);
}

TEST(UnboundedBound, RadiiHoldThePointsBelowALevel) {
  // Almost a common zero at the origin, and no other point that comes near to one.
  const UnboundedProblem problem{{x + y * y, y - x * x, x * y + Polynomial(Rational(1, 1000))}, 2, 2};
  const UnboundedBound bound(problem, precision);
  const Rational level(2, 1000);
  const auto radii = bound.radii(Rational(0), Rational(0), level);
  ASSERT_TRUE(radii);
  ASSERT_EQ(radii->size(), 2U);
  for (const Rational& radius : *radii) EXPECT_LT(radius, Rational(1, 10));
  int inside = 0;
  for (int i = -50; i <= 50; ++i) {
    for (int j = -50; j <= 50; ++j) {
      const std::vector<Rational> point{Rational(i, 10000), Rational(j, 10000), Rational(0)};
      Rational largest;
      for (const Polynomial& f : problem.functions)
        largest = std::max(largest, abs(f.evaluate<Rational>(point)));
      if (largest > level) continue;
      ++inside;
      EXPECT_LE(abs(point[0]), (*radii)[0]);
      EXPECT_LE(abs(point[1]), (*radii)[1]);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_FALSE(bound.radii(Rational(0), Rational(0), Rational(1000)));
}

}  // namespace
}  // namespace subdiv
