#include "analysis/uniform_bspline.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

/// B_d by the Cox-de Boor recursion, from the box.
Rational by_recursion(int degree, const Rational& t) {
  const Rational half(degree + 1, 2);
  if (degree == 0) return Rational(-1, 2) <= t && t < Rational(1, 2) ? 1 : 0;
  const Rational shift(1, 2);
  return ((half + t) * by_recursion(degree - 1, t + shift) +
          (half - t) * by_recursion(degree - 1, t - shift)) /
         Rational(degree);
}

TEST(UniformBspline, KnownValues) {
  EXPECT_EQ(UniformBspline(1).value(Rational(1, 4)), Rational(3, 4));
  EXPECT_EQ(UniformBspline(2).value(0), Rational(3, 4));
  EXPECT_EQ(UniformBspline(2).value(1), Rational(1, 8));
  EXPECT_EQ(UniformBspline(3).value(1), Rational(1, 6));
  EXPECT_EQ(UniformBspline(4).value(0), Rational(115, 192));
  EXPECT_EQ(UniformBspline(5).value(2), Rational(1, 120));
}

TEST(UniformBspline, AgreesWithTheRecursionInAndOutsideTheSupport) {
  for (int degree = 0; degree <= 6; ++degree) {
    const UniformBspline b(degree);
    for (int i = -45; i <= 45; ++i) {
      const Rational t(i, 11);
      EXPECT_EQ(b.value(t), by_recursion(degree, t)) << degree << " at " << t.to_string();
    }
    // At knots too: values from the right.
    for (int j = 0; j <= degree + 1; ++j) {
      const Rational knot = Rational(j) - b.half_width();
      EXPECT_EQ(b.value(knot), by_recursion(degree, knot));
    }
  }
}

TEST(UniformBspline, IntegralIsASumOfTheNextDegree) {
  // The derivative of B_{d+1} is B_d(t+1/2) - B_d(t-1/2); summed up, the integral of B_d to t is the sum over
  // j >= 0 of B_{d+1}(t - 1/2 - j).
  for (int degree = 0; degree <= 5; ++degree) {
    const UniformBspline b(degree);
    const UniformBspline next(degree + 1);
    for (int i = -30; i <= 30; ++i) {
      const Rational t(i, 7);
      Rational sum(0);
      for (int j = 0; j <= 10; ++j) sum += next.value(t - Rational(1, 2) - Rational(j));
      EXPECT_EQ(b.integral(t), sum) << degree << " to " << t.to_string();
    }
  }
}

TEST(UniformBspline, PiecesHoldBetweenKnotsOnly) {
  const UniformBspline b(2);
  EXPECT_EQ(b.piece(Rational(-1, 2), Rational(1, 2)),
            UnivariatePolynomial({Rational(3, 4), Rational(0), Rational(-1)}));
  EXPECT_TRUE(b.piece(Rational(3, 2), Rational(7)).is_zero());
  EXPECT_TRUE(b.piece(Rational(-9), Rational(-3, 2)).is_zero());
  EXPECT_THROW((void)b.piece(Rational(0), Rational(1)), std::domain_error);
  EXPECT_THROW((void)b.piece(Rational(-2), Rational(-1)), std::domain_error);
  EXPECT_THROW(UniformBspline(-1), std::domain_error);
}

}  // namespace
}  // namespace subdiv
