#include "schemes/algebra/taylor.h"

#include <gtest/gtest.h>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational.h"

namespace subdiv {
namespace {

using Series = Taylor<Rational, 4>;

Series series(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  Series result;
  result.c = {a, b, c, d};
  return result;
}

TEST(Taylor, OfAPolynomialIsItsExpansion) {
  const Series x = Series::variable(2);
  // (2+u)^3 - (2+u) = 6 + 11 u + 6 u^2 + u^3.
  EXPECT_EQ(x * x * x - x, series(6, 11, 6, 1));
  EXPECT_EQ(x + Series(3), series(5, 1, 0, 0));
}

TEST(Taylor, DivisionInvertsMultiplication) {
  const Series a = series(Rational(2, 3), -1, 5, Rational(7, 2));
  const Series b = series(-3, Rational(1, 4), 2, -8);
  EXPECT_EQ(a * b / b, a);
  // 1/(1-u) is the geometric series.
  EXPECT_EQ(Series(1) / (Series(1) - Series::variable(0)), series(1, 1, 1, 1));
}

TEST(Taylor, AddProductIsSumPlusProduct) {
  const Series a = series(0, 2, 0, 1);
  const Series b = series(4, 0, -1, 3);
  Series sum = series(1, 1, 1, 1);
  add_product(sum, a, b);
  EXPECT_EQ(sum, series(1, 1, 1, 1) + a * b);
  Series square = a;
  square *= square;
  EXPECT_EQ(square, series(0, 0, 4, 0));
}

TEST(Taylor, OverABallEnclosesTheRemainder) {
  // f = 1/x on [1, 2]: f''/2 = 1/x^3 between 1/8 and 1.
  using Jet = Taylor<Interval, 3>;
  const Jet f = Jet(1) / Jet::variable(Interval::hull(Rational(1), Rational(2)));
  EXPECT_TRUE(f.c[2].contains(Rational(1, 8)));
  EXPECT_TRUE(f.c[2].contains(Rational(1)));
  EXPECT_TRUE(f.c[1].contains(Rational(-1, 4)));
}

}  // namespace
}  // namespace subdiv
