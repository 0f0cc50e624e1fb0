#include "analysis/mesh/interval_polynomial.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

// (x - 10^-20)(x - 10^-60): isolating the roots of a polynomial in absolute terms loses the small one.
TEST(EnclosedRoots, OfAQuadraticKeepTheDigitsOfTheSmallerOne) {
  const Rational large = Rational::parse("1e-20");
  const Rational small = Rational::parse("1e-60");
  const auto roots = enclosed_roots({Interval(large * small), Interval(-(large + small)), Interval(1)});
  ASSERT_TRUE(roots);
  ASSERT_EQ(roots->size(), 2);
  for (const Rational& expected : {large, small}) {
    EXPECT_TRUE(std::ranges::any_of(*roots, [&](const ComplexRoot& root) {
      return root.real.contains(expected) && root.imaginary.is_exactly_zero() &&
             Rational::parse("1e30") * (root.real.upper() - root.real.lower()) < expected;
    }));
  }
}

// 2 x^2 + 3 x - 5 = (2 x + 5)(x - 1); 2 x^2 - 2 x + 5 has (1 +- 3 i)/2; x^2 - 2 is its own mirror image.
TEST(EnclosedRoots, OfQuadraticsWithAnySigns) {
  const auto real = enclosed_roots({Interval(-5), Interval(3), Interval(2)});
  ASSERT_TRUE(real);
  for (const Rational& expected : {Rational(1), Rational(-5, 2)}) {
    EXPECT_TRUE(
        std::ranges::any_of(*real, [&](const ComplexRoot& root) { return root.real.contains(expected); }));
  }
  const auto complex = enclosed_roots({Interval(5), Interval(-2), Interval(2)});
  ASSERT_TRUE(complex);
  for (const Rational& expected : {Rational(3, 2), Rational(-3, 2)}) {
    EXPECT_TRUE(std::ranges::any_of(*complex, [&](const ComplexRoot& root) {
      return root.real.contains(Rational(1, 2)) && root.imaginary.contains(expected);
    }));
  }
  const auto opposite = enclosed_roots({Interval(-2), Interval(0), Interval(1)});
  ASSERT_TRUE(opposite);
  EXPECT_TRUE(((*opposite)[0].real + (*opposite)[1].real).contains_zero());
  EXPECT_TRUE(((*opposite)[0].real * (*opposite)[1].real).contains(Rational(-2)));
}

// A root counted twice is left to Arb, which does not isolate it.
TEST(EnclosedRoots, AreNotGuessedWhereTheDiscriminantVanishes) {
  EXPECT_FALSE(enclosed_roots({Interval(1), Interval(-2), Interval(1)}));
}

}  // namespace
}  // namespace subdiv
