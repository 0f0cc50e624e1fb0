#include "analysis/iterate_norm_range.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/critical_root.h"
#include "analysis/iterate_norm.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const RationalFunction s = RationalFunction::variable(0);

std::vector<NormRange> ranges_of(const Mask<RationalFunction>& mask, int continuity, const Rational& interior,
                                 int max_power) {
  NormRangeOptions options;
  options.interior = interior;
  options.max_power = max_power;
  return iterate_norm_ranges(difference_family(mask, continuity), options);
}

/// The ends by the tables of all residue classes, in place of the tree: closely inside the norm is below 1,
/// closely outside above.
void expect_ends_at_one(const std::vector<NormRange>& ranges, int continuity) {
  const auto norm = [&](int k, const Rational& at) {
    return iterate_norm_enclosure(difference_symbol(jspline(at), continuity).value(), 2, k);
  };
  const Rational step(1, 10'000'000);
  for (const NormRange& range : ranges) {
    EXPECT_TRUE(range.lower.sharp && range.upper.sharp) << range.power;
    EXPECT_LT(range.lower.value.width() + range.upper.value.width(), Rational(1, 1'000'000'000));
    EXPECT_LT(norm(range.power, range.lower.value.upper + step).upper, Rational(1)) << range.power;
    EXPECT_GT(norm(range.power, range.lower.value.lower - step).lower, Rational(1)) << range.power;
    EXPECT_LT(norm(range.power, range.upper.value.lower - step).upper, Rational(1)) << range.power;
    EXPECT_GT(norm(range.power, range.upper.value.upper + step).lower, Rational(1)) << range.power;
  }
}

TEST(IterateNormRange, FirstContinuityOfJSplines) {
  const std::vector<NormRange> ranges = ranges_of(jspline(s), 1, Rational(3, 2), 20);
  ASSERT_EQ(ranges.size(), 20U);
  expect_ends_at_one(ranges, 1);
  EXPECT_EQ(ranges[0].lower.value.exact, "0");
  EXPECT_EQ(ranges[0].upper.value.exact, "4");
  EXPECT_EQ(ranges[1].lower.value.exact, "(5-sqrt(33))/2");
  EXPECT_EQ(ranges[1].upper.value.exact, "(5+sqrt(33))/2");
  EXPECT_EQ(first_power_containing(ranges, Rational(29, 5)), 10);
  EXPECT_EQ(first_power_containing(ranges, Rational(-17, 10)), 15);
  EXPECT_EQ(first_power_containing(ranges, Rational(-2)), std::nullopt);
  EXPECT_EQ(first_power_containing(ranges, Rational(6)), std::nullopt);
}

TEST(IterateNormRange, SecondContinuityOfJSplines) {
  const std::vector<NormRange> ranges = ranges_of(jspline(s), 2, Rational(3, 2), 20);
  ASSERT_EQ(ranges.size(), 20U);
  expect_ends_at_one(ranges, 2);
  for (const NormRange& range : ranges) {
    EXPECT_EQ(range.lower.value.exact, "0");
    EXPECT_EQ(range.upper.value.exact, "4");
    EXPECT_TRUE(range.contains(Rational(1, 1'000'000)));
    EXPECT_FALSE(range.contains(Rational(0)));
    EXPECT_FALSE(range.contains(Rational(4)));
  }
}

TEST(IterateNormRange, ThirdContinuityOfJSplines) {
  const std::vector<NormRange> ranges = ranges_of(jspline(s), 3, Rational(3, 2), 17);
  ASSERT_EQ(ranges.size(), 17U);
  expect_ends_at_one(ranges, 3);
  for (const NormRange& range : ranges) EXPECT_EQ(range.lower.value.exact, "1");
  EXPECT_EQ(ranges[0].upper.value.exact, "2");
  EXPECT_EQ(ranges[1].upper.value.exact, "(3+sqrt(5))/2");
  EXPECT_EQ(first_power_containing(ranges, Rational(14, 5)), 6);
  EXPECT_EQ(first_power_containing(ranges, Rational(29, 10)), 12);
}

// The interior point decides which powers appear: J_{29/5} is contracted from k = 10 on.
TEST(IterateNormRange, PowersThatDoNotContractAreLeftOut) {
  const std::vector<NormRange> ranges = ranges_of(jspline(s), 1, Rational(29, 5), 12);
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_EQ(ranges[0].power, 10);
  EXPECT_TRUE(ranges[0].lower.value.contains(ranges_of(jspline(s), 1, Rational(1), 10)[9].lower.value.lower));
}

// Dyn, Gregory & Levin (Analysis of uniform binary subdivision schemes for curve design, 1991) find C^1 for
// 0 < w < (sqrt(5)-1)/8 by k = 2. At w = 0 coefficients vanish.
TEST(IterateNormRange, FourPoint) {
  const std::vector<NormRange> ranges = ranges_of(four_point(s), 1, Rational(1, 16), 6);
  ASSERT_EQ(ranges.size(), 5U);
  EXPECT_EQ(ranges[0].power, 2);
  EXPECT_EQ(ranges[0].upper.value.exact, "(-1+sqrt(5))/8");
  for (const NormRange& range : ranges) {
    EXPECT_TRUE(range.lower.sharp);
    EXPECT_EQ(range.lower.value.exact, "0");
  }
}

// The ternary four-point scheme of Hassan, Ivrissimtzis, Dodgson & Sabin (2002) is C^2 for 1/15 < mu < 1/9.
TEST(IterateNormRange, TernaryFourPoint) {
  const auto q = [](int p, int r) { return RationalFunction(Rational(p, r)); };
  const RationalFunction a0 = q(-1, 18) - s / 6;
  const RationalFunction a1 = q(13, 18) + s / 2;
  const RationalFunction a2 = q(7, 18) - s / 2;
  const RationalFunction a3 = q(-1, 18) + s / 6;
  const Mask<RationalFunction> mask{3,
                                    Laurent<RationalFunction>(-5, {a3, a0, 0, a2, a1, 1, a1, a2, 0, a0, a3})};
  const std::vector<NormRange> ranges = ranges_of(mask, 2, Rational(1, 11), 8);
  ASSERT_EQ(ranges.size(), 8U);
  for (const NormRange& range : ranges) {
    EXPECT_EQ(range.lower.value.exact, "1/15");
    EXPECT_EQ(range.upper.value.exact, "1/9");
  }
}

// Not linear in the parameter: J_{s^2} touches the norm 1 at s = 0 for k = 1 and is below it on both sides.
TEST(IterateNormRange, TouchingEnds) {
  const std::vector<NormRange> ranges = ranges_of(jspline(s * s), 1, Rational(1), 2);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].lower.value.exact, "0");
  EXPECT_EQ(ranges[0].upper.value.exact, "2");
  EXPECT_LT(ranges[1].lower.value.upper, Rational(-2));
}

// J_{p(s)} with p = 4 + 10^-4 - (s-1)^2 leaves (0, 4) on [0.99, 1.01] only: the interval around 0 must not
// jump over it.
TEST(IterateNormRange, NarrowGapsAreSeen) {
  const RationalFunction p = RationalFunction(Rational(40001, 10000)) - (s - 1) * (s - 1);
  const std::vector<NormRange> ranges = ranges_of(jspline(p), 1, Rational(0), 1);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_EQ(ranges[0].upper.value.exact, "99/100");
}

TEST(IterateNormRange, SearchEnds) {
  const std::vector<NormRange> ranges = ranges_of(jspline(RationalFunction(1)), 2, Rational(0), 2);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].upper.value.status, Status::out_of_depth);
  EXPECT_FALSE(ranges[0].upper.sharp);
  EXPECT_EQ(ranges[0].upper.value.upper, Rational(64));
  EXPECT_TRUE(ranges[0].contains(Rational(64)));
  EXPECT_THROW((void)ranges_of(jspline(s), 1, Rational(64), 2), std::domain_error);
}

// For C^1 and k = 1 the even class has the norm (s-1)/4 + |3-s|/4, the odd one 1/2.
TEST(CriticalRoot, FirstContinuityByHand) {
  const DifferenceFamily family = difference_family(jspline(s), 1);
  const Rational inside(31, 8);
  const Rational outside(33, 8);
  EXPECT_FALSE(first_critical_root(family, {{1}}, inside, outside).has_value());
  EXPECT_FALSE(first_critical_root(family, {{0}}, outside, Rational(5)).has_value());
  EXPECT_FALSE(first_critical_root(family, {{0}}, Rational(5, 2), outside).has_value())
      << "a coefficient changes sign at 3";
  const auto root = first_critical_root(family, {{0}, {1}}, inside, outside);
  ASSERT_TRUE(root.has_value());
  EXPECT_EQ(root->exact, Algebraic(4));
  EXPECT_TRUE(reaches_one_first_at(family, {{0}, {1}}, inside, Rational(4)));
  EXPECT_FALSE(reaches_one_first_at(family, {{0}, {1}}, inside, outside));
  EXPECT_FALSE(reaches_one_first_at(family, {{1}}, inside, Rational(4)));
}

/// The family d(z) = p(s): every norm_k is |p(s)|^k.
DifferenceFamily constant_symbol(const std::vector<Rational>& p) {
  return {2, Laurent<UnivariatePolynomial>(0, {UnivariatePolynomial(p)})};
}

TEST(CriticalRoot, NeedsSignsAndIncrease) {
  // p = 1 + (s-1)(s-2)(s-3)/1000 crosses 1 three times on [1/2, 4]; halving alone would find the last
  // crossing.
  const Rational milli(1, 1000);
  const DifferenceFamily wave =
      constant_symbol({Rational(1) - Rational(6) * milli, Rational(11) * milli, Rational(-6) * milli, milli});
  EXPECT_FALSE(first_critical_root(wave, {{0}}, Rational(1, 2), Rational(4)).has_value());
  EXPECT_EQ(first_critical_root(wave, {{0}}, Rational(3, 4), Rational(5, 4)).value().exact, Algebraic(1));
  EXPECT_FALSE(reaches_one_first_at(wave, {{0}}, Rational(1, 2), Rational(3)));
  // |2 s - 1| is 3 at -1, falls to 0 and is 1 at s = 1: not the first place.
  const DifferenceFamily line = constant_symbol({Rational(-1), Rational(2)});
  EXPECT_FALSE(reaches_one_first_at(line, {{0}}, Rational(-1), Rational(1)));
  EXPECT_TRUE(reaches_one_first_at(line, {{0}}, Rational(3, 4), Rational(1)));
}

}  // namespace
}  // namespace subdiv
