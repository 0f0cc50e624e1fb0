#include "analysis/iterate_norm.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

/// The definition, word for word: the whole product D_k, its absolute coefficients summed by residue.
Rational norm_by_definition(const Laurent<Rational>& d, int arity, int k) {
  Laurent<Rational> product(1);
  int step = 1;
  for (int i = 0; i < k; ++i, step *= arity) product *= upsample(d, step);
  std::vector<Rational> sums(static_cast<std::size_t>(step));
  for (int i = product.first(); i <= product.last(); ++i) {
    sums[static_cast<std::size_t>(residue(i, step))] += abs(product[i]);
  }
  return *std::max_element(sums.begin(), sums.end());
}

Laurent<Rational> random_symbol(std::mt19937& random, int taps, bool symmetric) {
  std::uniform_int_distribution<int> numerator(-20, 20);
  std::vector<Rational> c;
  for (int i = 0; i < taps; ++i) {
    const bool mirrored = symmetric && i > taps - 1 - i;
    c.push_back(mirrored ? c[static_cast<std::size_t>(taps - 1 - i)] : Rational(numerator(random), 30));
  }
  c.front() = c.back() = Rational(1, 7);
  return {-2, c};
}

Laurent<Rational> difference_of_jspline(const Rational& s, int continuity) {
  return difference_symbol(jspline(s), continuity).value();
}

TEST(IterateNorm, DifferenceSymbolsOfTheJSplines) {
  const RationalFunction s = RationalFunction::variable(0);
  const Laurent<RationalFunction> p(0, {(s - 1) / 2, 2 - s, (s - 1) / 2});
  const Laurent<RationalFunction> average(
      0, {fraction<RationalFunction>(1, 2), fraction<RationalFunction>(1, 2)});
  // J_s has the symbol 2 ((1+z)/2)^4 ((s-1)/2 + (2-s) z + (s-1)/2 z^2), up to a power of z.
  for (int c = 0; c <= 3; ++c) {
    const auto d = difference_symbol(jspline(s), c);
    ASSERT_TRUE(d.has_value());
    EXPECT_EQ(shift(*d, -d->first()), pow(average, 3 - c) * p);
  }
  EXPECT_FALSE(difference_symbol(jspline(s), 4).has_value());
  EXPECT_EQ(difference_of_jspline(Rational(3, 2), 4),
            Laurent<Rational>(-3, {Rational(1, 2), Rational(1, 2)}));
  EXPECT_FALSE(difference_symbol(jspline(Rational(1)), 4).has_value());
  EXPECT_THROW((void)difference_symbol(jspline(s), -1), std::domain_error);
}

TEST(IterateNorm, ExactNormsMeetTheDefinition) {
  std::mt19937 random(20070601);
  for (const int arity : {2, 3}) {
    for (int taps = 1; taps <= 8; ++taps) {
      const Laurent<Rational> d = random_symbol(random, taps, taps % 2 == 0);
      const std::vector<Rational> norms = iterate_norms(d, arity, 5);
      ASSERT_EQ(norms.size(), 6U);
      for (int k = 0; k <= 5; ++k) {
        EXPECT_EQ(norms[static_cast<std::size_t>(k)], norm_by_definition(d, arity, k))
            << arity << " " << taps << " " << k;
      }
    }
  }
}

TEST(IterateNorm, EnclosuresMeetTheDefinition) {
  std::mt19937 random(20090101);
  for (const int arity : {2, 3}) {
    for (int taps = 1; taps <= 9; ++taps) {
      for (const bool symmetric : {false, true}) {
        const Laurent<Rational> d = random_symbol(random, taps, symmetric);
        for (int k = 0; k <= (arity == 2 ? 8 : 5); ++k) {
          const Rational truth = norm_by_definition(d, arity, k);
          const Enclosure norm = iterate_norm_enclosure(d, arity, k);
          EXPECT_TRUE(norm.contains(truth)) << arity << " " << taps << " " << k << " " << symmetric;
          EXPECT_LT(norm.width(), Rational(1, 10'000'000'000) * (Rational(1) + truth));
        }
      }
    }
  }
}

// The inner and the outer table both take part, and so does the padding of tables of 3^k classes.
TEST(IterateNorm, TilesOfDeepIteratesMeetTheExactTree) {
  const Laurent<Rational> d2 = difference_of_jspline(Rational(-17, 10), 1);
  const std::vector<Rational> norms = iterate_norms(d2, 2, 13);
  for (const int k : {9, 11, 13}) {
    EXPECT_TRUE(iterate_norm_enclosure(d2, 2, k).contains(norms[static_cast<std::size_t>(k)]));
  }
  const Laurent<Rational> d3(
      0, {Rational(-1, 9), Rational(4, 9), Rational(1, 3), Rational(7, 9), Rational(-2, 9)});
  const std::vector<Rational> ternary = iterate_norms(d3, 3, 8);
  EXPECT_TRUE(iterate_norm_enclosure(d3, 3, 8).contains(ternary[8]));
}

// B-splines of degree c + 1: every class of D_k has the one coefficient m^-k.
TEST(IterateNorm, BSplines) {
  for (int c = 0; c <= 4; ++c) {
    const Laurent<Rational> d = difference_symbol(bspline<Rational>(c + 1), c).value();
    EXPECT_EQ(iterate_norms(d, 2, 10).back(), Rational(1, 1024));
    EXPECT_TRUE(iterate_norm_enclosure(d, 2, 18).contains(Rational::power_of_two(-18)));
  }
  EXPECT_EQ(iterate_norms(difference_of_jspline(Rational(1), 2), 2, 3).back(), Rational(1, 8));
}

// The four-point scheme is C^1 by k = 2 and never C^2: the norms for C^2 are exactly 1 (Dyn, Gregory & Levin
// 1987).
TEST(IterateNorm, FourPoint) {
  const Mask<Rational> mask = four_point(Rational(1, 16));
  const std::vector<Rational> first = iterate_norms(difference_symbol(mask, 1).value(), 2, 2);
  EXPECT_EQ(first[1], Rational(1));
  EXPECT_EQ(first[2], Rational(3, 4));
  for (const Rational& norm : iterate_norms(difference_symbol(mask, 2).value(), 2, 8))
    EXPECT_EQ(norm, Rational(1));
}

TEST(IterateNorm, IrrationalParameters) {
  const Algebraic s = sqrt(Algebraic(2));
  const auto d = difference_symbol(jspline(s), 2);
  ASSERT_TRUE(d.has_value());
  // p = (s-1)/2 = 0.207: the classes of the first step are |p/2| + |(1-p)/2| = 1/2.
  EXPECT_EQ(iterate_norms(*d, 2, 2)[1], Algebraic(Rational(1, 2)));
}

TEST(IterateNorm, NormsAreSubmultiplicative) {
  const std::vector<Rational> norms = iterate_norms(difference_of_jspline(Rational(29, 5), 1), 2, 10);
  for (std::size_t i = 1; i < norms.size(); ++i) {
    for (std::size_t j = 1; i + j < norms.size(); ++j) EXPECT_LE(norms[i + j], norms[i] * norms[j]);
  }
}

TEST(IterateNorm, ScalesBeyondTheRangeOfDouble) {
  const Laurent<Rational> d = difference_of_jspline(Rational(1, 3), 1);
  for (const long exponent : {-3000L, 3000L}) {
    const Rational scale = Rational(3) * Rational::power_of_two(exponent);
    const Rational norm = iterate_norms(d, 2, 6).back() * pow(scale, 6);
    const Enclosure enclosure = iterate_norm_enclosure(Laurent<Rational>::constant(scale) * d, 2, 6);
    EXPECT_TRUE(enclosure.contains(norm));
    EXPECT_LT(enclosure.width(), norm * Rational(1, 1'000'000'000'000));
  }
  EXPECT_EQ(iterate_norm_enclosure({}, 2, 3).upper, Rational(0));
  EXPECT_THROW((void)iterate_norm_enclosure(d, 2, 37), std::domain_error);
  EXPECT_THROW((void)iterate_norm_enclosure(d, 2, -1), std::domain_error);
}

/// |computed - true| / (half the width) for d = c, one coefficient: norm_k = c^k, and the middle of the
/// enclosure is the computed norm.
double share_of_bound_used(const Rational& c, int k) {
  const Enclosure norm = iterate_norm_enclosure(Laurent<Rational>::constant(c), 2, k);
  EXPECT_TRUE(norm.contains(pow(c, k)));
  return (abs(norm.midpoint() - pow(c, k)) / (norm.width() / Rational(2))).to_double();
}

// The bound is no ornament. Where only the input is rounded (c just below a power of two's half unit, each
// product nearly exact) and where only products are rounded (c a double), errors come near enough to the
// bound that leaving out either part would lose the true norm.
TEST(IterateNorm, BoundsOfRoundingAreNeeded) {
  const Rational just_above_one = Rational(1) + Rational::power_of_two(-52) - Rational::power_of_two(-80);
  EXPECT_GT(share_of_bound_used(just_above_one / Rational(2), 24), 0.5);
  double most = 0;
  for (int i = 1; i < 200; ++i) {
    most = std::max(most, share_of_bound_used(Rational::from_double(0.5 + i * 0x1.23456789abcdp-9), 24));
  }
  EXPECT_GT(most, 0.25);
}

}  // namespace
}  // namespace subdiv
