#include "analysis/norm_box.h"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/iterate_norm.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

DifferenceFamily jspline_family(int continuity) {
  return difference_family(jspline(RationalFunction::variable(0)), continuity);
}

/// Coefficients of degree 0 .. 3 in s, the first and the last not zero.
DifferenceFamily random_family(std::mt19937& random, int arity, int taps) {
  std::uniform_int_distribution<int> numerator(-9, 9);
  std::uniform_int_distribution<int> degree(0, 3);
  std::vector<UnivariatePolynomial> d;
  for (int i = 0; i < taps; ++i) {
    std::vector<Rational> c{Rational(2 * numerator(random) + 1, 21)};
    for (int p = degree(random); p > 0; --p) c.emplace_back(numerator(random), 13);
    d.emplace_back(c);
  }
  return {arity, Laurent<UnivariatePolynomial>(-1, d)};
}

Laurent<Rational> at(const DifferenceFamily& family, const Rational& s) {
  return map_coefficients(family.symbol, [&](const UnivariatePolynomial& p) { return p.evaluate(s); });
}

TEST(NormBox, BoundsHoldOnTheWholeBox) {
  std::mt19937 random(1979);
  std::uniform_real_distribution<double> center(-1.5, 1.5);
  constexpr int k = 4;
  for (const int arity : {2, 3}) {
    for (int trial = 0; trial < 24; ++trial) {
      const DifferenceFamily family = random_family(random, arity, 2 + trial % 6);
      const double lower = center(random);
      const double upper = lower + (trial % 3 == 0 ? 0.5 : 0x1p-6);
      NormBox box = norm_box(family, lower, upper);
      bound_norms(box, k);
      for (int i = 0; i <= 4; ++i) {
        const Rational share(i, 4);
        const Rational s =
            Rational::from_double(lower) * (Rational(1) - share) + Rational::from_double(upper) * share;
        const std::vector<Rational> norms = iterate_norms(at(family, s), arity, k);
        for (std::size_t j = 0; j <= k; ++j) EXPECT_LE(norms[j], Rational::from_double(box.bounds[j]));
      }
    }
  }
}

TEST(NormBox, BoundsOfAPointAreTheNorms) {
  std::mt19937 random(2007);
  for (const int arity : {2, 3}) {
    for (int taps = 1; taps <= 7; ++taps) {
      const DifferenceFamily family = random_family(random, arity, taps);
      const double s = 0.625;
      NormBox box = norm_box(family, s, s);
      bound_norms(box, 5);
      const std::vector<Rational> norms = iterate_norms(at(family, Rational::from_double(s)), arity, 5);
      for (std::size_t j = 0; j <= 5; ++j) {
        const Rational excess = Rational::from_double(box.bounds[j]) - norms[j];
        EXPECT_GE(excess, Rational(0));
        EXPECT_LE(excess, norms[j] * Rational(1, 1'000'000'000));
      }
    }
  }
}

// The excess over the center's norm shrinks like the first derivative: at most linear in the width, not
// worse.
TEST(NormBox, BoundsAreOfFirstOrder) {
  const DifferenceFamily family = jspline_family(1);
  NormBox point = norm_box(family, -1.7, -1.7);
  bound_norms(point, 16);
  const ClassValue largest = largest_class(point, 16);
  const auto norm = [](const Rational& s) {
    return iterate_norm_enclosure(difference_symbol(jspline(s), 1).value(), 2, 16).midpoint();
  };
  const Rational step(1, 100'000);
  const Rational quotient =
      (norm(Rational(-17, 10) + step) - norm(Rational(-17, 10) - step)) / (step * Rational(2));
  EXPECT_NEAR(largest.norm, norm(Rational(-17, 10)).to_double(), 1e-11);
  EXPECT_NEAR(largest.slope, quotient.to_double(), 1e-4);
  for (const double h : {1e-3, 1e-5}) {
    NormBox box = norm_box(family, -1.7 - h, -1.7 + h);
    bound_norms(box, 16);
    EXPECT_NEAR((box.bounds[16] - point.bounds[16]) / h, std::abs(largest.slope),
                0.02 * std::abs(largest.slope));
  }
}

// By hand: one class entry, d = c + c z + c z^2 at arity 3 has n = 1 and A_e = c; c lies just below the next
// double, so that storing it (rounded to zero) loses nearly 2^-52.
TEST(NormBox, DefectsCoverStorageAndRounding) {
  const Rational c = Rational(1) + Rational::power_of_two(-52) - Rational::power_of_two(-80);
  const std::vector<UnivariatePolynomial> d(3, UnivariatePolynomial(c));
  const NormBox box = norm_box({3, Laurent<UnivariatePolynomial>(0, d)}, 0.0, 0.0);
  ASSERT_EQ(box.n, 1U);
  const Rational lost = c - Rational::from_double(box.value[0]);
  EXPECT_GT(lost, Rational::power_of_two(-53));
  EXPECT_GE(Rational::from_double(box.defect_value), lost + Rational::power_of_two(-53) * c);
  EXPECT_EQ(box.defect_slope, 0.0);
}

// d = s + s^2 (z^0 alone): on |t| <= h around 1, A0 = 2, A1 = 3, rest 1.
TEST(NormBox, DefectsCoverTheSecondOrder) {
  const UnivariatePolynomial p({Rational(0), Rational(1), Rational(1)});
  const NormBox box = norm_box({2, Laurent<UnivariatePolynomial>(0, {p})}, 0.75, 1.25);
  EXPECT_EQ(box.radius, 0.25);
  EXPECT_EQ(box.value[0], 2.0);
  EXPECT_EQ(box.slope[0], 3.0);
  EXPECT_NEAR(box.defect_value, 0.0625 * 1, 1e-13);
  EXPECT_GE(box.defect_value, 0.0625);
  EXPECT_NEAR(box.defect_slope, 0.0625 * 3 + 0.015625 * 1, 1e-13);
  EXPECT_GE(box.defect_slope, 0.0625 * 3 + 0.015625 * 1);
}

TEST(NormBox, CriticalClasses) {
  const DifferenceFamily family = jspline_family(1);
  NormBox box = norm_box(family, 0.0, 0.0);
  // (D_1) = (-1, 2, 6, 2, -1)/8: the even class has norm 1, the odd one 1/2.
  const auto classes = critical_classes(box, 1, 8);
  ASSERT_TRUE(classes.has_value());
  EXPECT_EQ(*classes, std::vector<ClassWord>{ClassWord{0}});
  EXPECT_FALSE(critical_classes(box, 1, 0).has_value());
  EXPECT_EQ(class_norm(family, {0}, Rational(0)), Rational(1));
  EXPECT_EQ(class_norm(family, {1}, Rational(0)), Rational(1, 2));
  EXPECT_FALSE(proves_contraction(box, 1));
  EXPECT_TRUE(proves_contraction(box, 2));
}

// Words name residues by their digits, the lowest first, also where the lowest coefficients vanish for a
// value of s.
TEST(NormBox, ClassNormsMeetTheProduct) {
  const DifferenceFamily family = jspline_family(3);
  for (const Rational& s : {Rational(1), Rational(5, 2)}) {
    const Laurent<Rational> d = at(family, s);
    const Laurent<Rational> product = d * upsample(d, 2) * upsample(d, 4);
    const int origin = family.symbol.first() * 7;
    for (int r = 0; r < 8; ++r) {
      Rational sum;
      for (int i = origin + r - 64; i < origin + 64; i += 8) sum += abs(product[i]);
      EXPECT_EQ(class_norm(family, {r & 1, r >> 1 & 1, r >> 2}, s), sum);
    }
  }
}

TEST(NormBox, ContractionPowers) {
  const auto power = [](const Mask<Rational>& mask, int continuity) {
    return contraction_power(difference_symbol(mask, continuity).value(), mask.arity, 16);
  };
  EXPECT_EQ(power(bspline<Rational>(3), 2), 1);
  EXPECT_EQ(power(four_point(Rational(1, 16)), 1), 2);
  EXPECT_EQ(power(four_point(Rational(1, 16)), 2), std::nullopt);  // norms are exactly 1
  EXPECT_EQ(power(jspline(Rational(3, 2)), 4), 1);
  EXPECT_EQ(power(jspline(Rational(29, 5)), 1), 10);
  EXPECT_EQ(power(jspline(Rational(-17, 10)), 1), 15);
  EXPECT_EQ(power(jspline(Rational(14, 5)), 3), 6);
}

TEST(NormBox, HugeMasksAreNotProved) {
  const UnivariatePolynomial huge(Rational::power_of_two(1000));
  NormBox box = norm_box({2, Laurent<UnivariatePolynomial>(0, {huge, -huge, huge, huge})}, 0.0, 1.0);
  EXPECT_FALSE(proves_contraction(box, 8));
  EXPECT_THROW(bound_norms(box, 65), std::domain_error);
}

TEST(DifferenceFamily, Errors) {
  const RationalFunction s = RationalFunction::variable(0);
  EXPECT_THROW((void)difference_family(jspline(s), 4), std::domain_error);
  EXPECT_THROW((void)difference_family(jspline(RationalFunction(1) / s), 1), std::domain_error);
  EXPECT_THROW((void)difference_family(jspline(RationalFunction::variable(1)), 1), std::domain_error);
}

TEST(DifferenceFamily, DivisibleParameters) {
  const RationalFunction s = RationalFunction::variable(0);
  EXPECT_EQ(divisible_parameters(jspline(s), 4), std::vector<Algebraic>{Algebraic(Rational(3, 2))});
  EXPECT_EQ(divisible_parameters(jspline(s), 5), std::vector<Algebraic>{Algebraic(Rational(3, 2))});
  EXPECT_TRUE(divisible_parameters(jspline(s), 6).empty());
  EXPECT_EQ(divisible_parameters(four_point(s), 3), std::vector<Algebraic>{Algebraic(Rational(1, 16))});
  EXPECT_THROW((void)divisible_parameters(jspline(s), 3), std::domain_error);
}

}  // namespace
}  // namespace subdiv
