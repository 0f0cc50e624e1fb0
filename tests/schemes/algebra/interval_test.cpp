#include "schemes/algebra/interval.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_int;
using testing::random_rational;

/// A value computed twice: exactly, and in intervals of a few bits, where rounding is never invisible.
struct Twin {
  Rational exact;
  Interval interval;
};

Twin random_leaf(Generator& generator) {
  const Rational q = random_rational(generator);
  const long precision = random_int(generator, 2, 64);
  // Every other leaf is an interval that holds the number somewhere inside, not only at its centre.
  if (random_int(generator, 0, 1) == 0) return {q, Interval(q, precision)};
  const Rational below(random_int(generator, 0, 5), 7);
  const Rational above(random_int(generator, 0, 5), 9);
  return {q, Interval::hull(q - below, q + above, precision)};
}

Twin random_expression(Generator& generator, int depth) {
  if (depth == 0) return random_leaf(generator);
  const Twin a = random_expression(generator, depth - 1);
  const Twin b = random_expression(generator, random_int(generator, 0, depth - 1));
  switch (random_int(generator, 0, 9)) {
    case 0:
      return {abs(a.exact), abs(a.interval)};
    case 1:
      return {std::max(a.exact, b.exact), max(a.interval, b.interval)};
    case 2:
      return {std::min(a.exact, b.exact), min(a.interval, b.interval)};
    case 3:
      return {-a.exact, -a.interval};
    case 4:
      return {a.exact - b.exact, a.interval - b.interval};
    case 5: {
      const int n = random_int(generator, a.exact.sign() == 0 ? 0 : -3, 3);
      return {pow(a.exact, n), pow(a.interval, n)};
    }
    case 6:
      if (b.exact.sign() == 0) return {a.exact + b.exact, a.interval + b.interval};
      return {a.exact / b.exact, a.interval / b.interval};
    case 7:
      return {a.exact + b.exact, a.interval + b.interval};
    default:
      return {a.exact * b.exact, a.interval * b.interval};
  }
}

TEST(Interval, ContainsTheExactValueOfRandomExpressions) {
  Generator generator(11);
  int bounded = 0;
  for (int i = 0; i < 5000; ++i) {
    const Twin twin = random_expression(generator, 4);
    ASSERT_TRUE(twin.interval.contains(twin.exact)) << "expression " << i << ": " << twin.exact.to_string();
    if (!twin.interval.is_finite()) continue;
    ++bounded;
    ASSERT_LE(twin.interval.lower(), twin.exact);
    ASSERT_GE(twin.interval.upper(), twin.exact);
  }
  EXPECT_GT(bounded, 3000);  // else the test would say little
}

TEST(Interval, PrecisionIsTheLargestOfTheOperands) {
  const Interval coarse(Rational(1, 3), 20);
  const Interval fine(Rational(1, 3), 300);
  EXPECT_EQ((coarse + fine).precision(), 300);
  EXPECT_EQ((fine * Interval(3)).precision(), 300);
  EXPECT_LT((fine * Interval(3)).radius(), 1e-80);
  EXPECT_GT((coarse + Interval(0)).radius(), 1e-10);
  EXPECT_EQ(Interval(5).precision(), 0);
}

TEST(Interval, EndPointsAreExact) {
  const Interval x = Interval::hull(Rational(-1, 4), Rational(3, 8));
  EXPECT_LE(x.lower(), Rational(-1, 4));
  EXPECT_GE(x.upper(), Rational(3, 8));
  EXPECT_LT(x.upper() - x.lower(), Rational(5, 8) + Rational::power_of_two(-25));
  EXPECT_EQ(x.midpoint(), (x.lower() + x.upper()) / Rational(2));
  EXPECT_EQ(Interval(Rational(3, 8)).lower(), Rational(3, 8));
  EXPECT_EQ(Interval(0.1).midpoint(), Rational::from_double(0.1));
  const Interval unbounded = Interval(1) / Interval(0);
  EXPECT_THROW(static_cast<void>(unbounded.lower()), std::domain_error);
  EXPECT_THROW(static_cast<void>(unbounded.upper()), std::domain_error);
  EXPECT_THROW(static_cast<void>(unbounded.midpoint()), std::domain_error);
}

TEST(Interval, HullHoldsBoth) {
  const Interval a = Interval::hull(Rational(-2), Rational(-1));
  const Interval b = Interval::hull(Rational(1, 3), Rational(1, 2));
  const Interval hull = Interval::hull(a, b);
  EXPECT_TRUE(hull.contains(a));
  EXPECT_TRUE(hull.contains(b));
  EXPECT_TRUE(hull.contains(Rational(0)));
}

TEST(Interval, OrderIsClaimedOnlyWhenCertain) {
  const Interval third(Rational(1, 3));
  const Interval around = Interval::hull(Rational(1, 4), Rational(1, 2));
  EXPECT_FALSE(certainly_less(third, around));
  EXPECT_FALSE(certainly_less(around, third));
  EXPECT_FALSE(certainly_less(third, third));
  EXPECT_TRUE(certainly_less(Interval(Rational(1, 5)), around));
  EXPECT_TRUE(certainly_at_most(Interval(1), Interval(1)));
  EXPECT_FALSE(certainly_at_most(Interval(1), around));
  EXPECT_TRUE(certainly_positive(around));
  EXPECT_TRUE(certainly_negative(-around));
  EXPECT_FALSE(certainly_positive(around - around));
  EXPECT_FALSE(certainly_negative(around - around));
  EXPECT_TRUE((around - around).contains_zero());
  EXPECT_FALSE((around - around).is_exactly_zero());
}

TEST(Interval, StrictInclusionExcludesTheBoundary) {
  const Interval box = Interval::hull(Rational(0), Rational(1));
  EXPECT_TRUE(box.contains_strictly(Interval::hull(Rational(1, 4), Rational(3, 4))));
  EXPECT_FALSE(box.contains_strictly(box));
  EXPECT_TRUE(box.contains(box));
}

TEST(Interval, AbsoluteValueOfAnIntervalAcrossZeroStartsAtZero) {
  const Interval x = abs(Interval::hull(Rational(-1), Rational(2)));
  EXPECT_TRUE(x.contains(Rational(0)));
  EXPECT_TRUE(x.contains(Rational(2)));
  EXPECT_GE(x.lower(), Rational(-1, 1'000'000));
}

TEST(Interval, RootsAndTranscendentalFunctionsHoldTheirDefiningIdentities) {
  Generator generator(12);
  for (int i = 0; i < 200; ++i) {
    const Interval x(Rational(random_int(generator, 1, 1000), random_int(generator, 1, 50)), 100);
    const Interval root = sqrt(x);
    EXPECT_TRUE((root * root).contains(x));
    EXPECT_TRUE(certainly_positive(root));
    EXPECT_TRUE(exp(log(x)).overlaps(x));
    const Interval one = sin(x) * sin(x) + cos(x) * cos(x);
    EXPECT_TRUE(one.contains(Rational(1)));
    EXPECT_LT(one.radius(), 1e-20);
  }
  EXPECT_FALSE(sqrt(Interval(-1)).is_finite());
}

// The digits of pi, e and sqrt(2) as they stand in any table.
TEST(Interval, KnownConstants) {
  const auto digits = [](const std::string& text) {
    const Rational value = Rational::parse(text);
    return std::pair(value, value + Rational::parse("1e-30"));
  };
  const std::vector<std::pair<Interval, std::string>> constants{
      {pi(128), "3.141592653589793238462643383279"},
      {exp(Interval(Rational(1))), "2.718281828459045235360287471352"},
      {sqrt(Interval(Rational(2))), "1.414213562373095048801688724209"},
      {log(Interval(Rational(2))), "0.693147180559945309417232121458"}};
  for (const auto& [value, text] : constants) {
    const auto [below, above] = digits(text);
    EXPECT_GT(value.lower(), below) << text;
    EXPECT_LT(value.upper(), above) << text;
  }
}

}  // namespace
}  // namespace subdiv
