#include "analysis/sign_on_interval.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

const RationalFunction x = RationalFunction::variable(0);

RealInterval between(const Algebraic& lower, bool lower_closed, const Algebraic& upper, bool upper_closed) {
  return {lower, upper, lower_closed, upper_closed};
}

TEST(SignOnInterval, RootsAtTheEndsCountWhereTheyBelong) {
  const RationalFunction f = x * (RationalFunction(1) - x);
  EXPECT_TRUE(is_positive(f, open_interval(0, 1)));
  EXPECT_FALSE(is_positive(f, closed_interval(0, 1)));
  EXPECT_TRUE(is_nonnegative(f, closed_interval(0, 1)));
  EXPECT_FALSE(is_nonnegative(f, closed_interval(0, Rational(1001, 1000))));
  EXPECT_FALSE(is_nonnegative(-f, closed_interval(0, 1)));
  EXPECT_FALSE(has_no_root(f.numerator(), between(0, true, 1, false)));
  EXPECT_FALSE(has_no_root(f.numerator(), between(0, false, 1, true)));
  EXPECT_TRUE(has_no_root(f.numerator(), between(0, false, 1, false)));
}

TEST(SignOnInterval, IrrationalEnds) {
  const Algebraic root = sqrt(Algebraic(2));
  const RationalFunction f = RationalFunction(2) - x * x;
  EXPECT_TRUE(is_positive(f, between(-root, false, root, false)));
  EXPECT_FALSE(is_positive(f, between(-root, false, root, true)));
  EXPECT_TRUE(is_nonnegative(f, between(-root, true, root, true)));
  // The other root of the same minimal polynomial lies inside.
  EXPECT_FALSE(is_nonnegative(f, between(-2, true, root, false)));
  // A root that is not an end but close to it: 1.4142135 < sqrt(2).
  const RationalFunction close = fraction<RationalFunction>(14142135, 10000000) - x;
  EXPECT_FALSE(is_positive(close, between(0, true, root, false)));
  EXPECT_TRUE(is_positive(close + fraction<RationalFunction>(1, 10000000), between(0, true, root, false)));
}

TEST(SignOnInterval, EvenRootsInsideDoNotChangeTheSign) {
  const RationalFunction f =
      (x * x - fraction<RationalFunction>(1, 2)) * (x * x - fraction<RationalFunction>(1, 2));
  EXPECT_TRUE(is_nonnegative(f, closed_interval(0, 1)));
  EXPECT_FALSE(is_positive(f, closed_interval(0, 1)));
  EXPECT_FALSE(is_nonnegative(f * (x - fraction<RationalFunction>(7, 10)), closed_interval(0, 1)));
  EXPECT_TRUE(is_nonnegative(f * (x - fraction<RationalFunction>(1, 2)), closed_interval(Rational(1, 2), 1)));
}

TEST(SignOnInterval, PolesAreNoValues) {
  const RationalFunction f = RationalFunction(1) / (x - 1);
  EXPECT_TRUE(is_positive(f, between(1, false, 2, true)));
  EXPECT_FALSE(is_positive(f, between(1, true, 2, true)));
  EXPECT_FALSE(is_nonnegative(f * f, closed_interval(0, 2)));
  EXPECT_TRUE(is_finite(f, open_interval(0, 1)));
  EXPECT_FALSE(is_finite(f, closed_interval(0, 1)));
}

TEST(SignOnInterval, UnboundedIntervalsAndPoints) {
  const RealInterval positive{Algebraic(0), std::nullopt, false, false};
  EXPECT_TRUE(is_positive(x * x * x + x, positive));
  EXPECT_FALSE(is_positive(x - 1000000, positive));
  EXPECT_TRUE(is_positive(x * x + 1, RealInterval{}));
  EXPECT_FALSE(is_positive(x * x - 1, RealInterval{}));
  const Algebraic root = sqrt(Algebraic(3));
  EXPECT_TRUE(is_nonnegative(x * x - 3, between(root, true, root, true)));
  EXPECT_FALSE(is_positive(x * x - 3, between(root, true, root, true)));
  EXPECT_TRUE(is_positive(x, between(root, true, root, true)));
  EXPECT_TRUE(is_nonnegative(RationalFunction(0), closed_interval(0, 1)));
  EXPECT_FALSE(is_positive(RationalFunction(0), closed_interval(0, 1)));
  EXPECT_THROW((void)is_positive(x, closed_interval(1, 0)), std::domain_error);
  EXPECT_THROW((void)is_positive(x, open_interval(1, 1)), std::domain_error);
}

TEST(SignOnInterval, AgreesWithSturmOnManyPolynomials) {
  for (int seed = 1; seed < 60; ++seed) {
    Polynomial f(1);
    for (int i = 1; i <= 5; ++i) {
      const Rational root((seed * i * 37) % 101 - 50, 7 + i);
      f *= Polynomial::variable(0) - Polynomial(root);
      f += Polynomial(Rational(seed % 3, 50));
    }
    const bool expected = count_roots(UnivariatePolynomial(f, 0), Rational(-1), Rational(2)) == 0;
    EXPECT_EQ(has_no_root(f, closed_interval(-1, 2)), expected) << seed;
  }
}

TEST(SignOnInterval, SamplesLieInside) {
  EXPECT_EQ(sample(closed_interval(3, 3)), Rational(3));
  EXPECT_TRUE(open_interval(1, 2).contains(sample(open_interval(1, 2))));
  EXPECT_GT(sample({Algebraic(5), std::nullopt, false, false}), Rational(5));
  EXPECT_LT(sample({std::nullopt, Algebraic(-5), false, false}), Rational(-5));
  EXPECT_EQ(sample(RealInterval{}), Rational(0));
}

}  // namespace
}  // namespace subdiv
