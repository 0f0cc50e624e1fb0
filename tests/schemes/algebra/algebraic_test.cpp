#include "schemes/algebra/algebraic.h"

#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/univariate.h"
#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::Samples;

Algebraic root_of(int n) { return sqrt(Algebraic(n)); }

TEST(Algebraic, DecidesEquality) {
  // sqrt(2) + sqrt(3) = sqrt(5 + 2 sqrt(6)).
  EXPECT_EQ(root_of(2) + root_of(3), sqrt(Algebraic(5) + Algebraic(2) * root_of(6)));
  EXPECT_TRUE((root_of(8) - Algebraic(2) * root_of(2)).is_zero());
  EXPECT_TRUE((root_of(12) / root_of(3)).is_rational());
  EXPECT_EQ((root_of(12) / root_of(3)).to_rational(), Rational(2));
  EXPECT_THROW(static_cast<void>(root_of(2).to_rational()), std::domain_error);
}

TEST(Algebraic, DecidesOrderOfCloseNumbers) {
  // The continued fraction convergents of sqrt(2) lie on alternating sides of it.
  EXPECT_LT(Algebraic(Rational(8119, 5741)), root_of(2));
  EXPECT_GT(Algebraic(Rational(19601, 13860)), root_of(2));
  EXPECT_EQ((root_of(2) - Algebraic(Rational(19601, 13860))).sign(), -1);
  EXPECT_EQ(abs(Algebraic(1) - root_of(2)), root_of(2) - Algebraic(1));
}

TEST(Algebraic, RefusesWhatIsNotReal) {
  EXPECT_THROW(sqrt(Algebraic(-1)), std::domain_error);
  EXPECT_EQ(sqrt(Algebraic(0)), Algebraic(0));
}

TEST(Algebraic, MinimalPolynomialVanishesAtIt) {
  const Algebraic x = root_of(2) + root_of(3);
  const std::vector<Rational> p = x.minimal_polynomial();
  EXPECT_EQ(p, (std::vector<Rational>{1, 0, -10, 0, 1}));
  Algebraic value(0);
  for (auto c = p.rbegin(); c != p.rend(); ++c) value = value * x + Algebraic(*c);
  EXPECT_TRUE(value.is_zero());
  EXPECT_EQ(x.degree(), 4);
}

TEST(Algebraic, EnclosureHoldsAtEveryPrecision) {
  const Algebraic golden = (Algebraic(1) + root_of(5)) / Algebraic(2);
  for (const long bits : {10L, 64L, 300L}) {
    const Interval x = golden.to_interval(bits);
    EXPECT_TRUE((x * x - x).contains(Rational(1)));
    EXPECT_LT(x.upper() - x.lower(), Rational::power_of_two(5 - bits));
  }
}

TEST(Algebraic, PrintsRationalsQuadraticsAndTheRest) {
  EXPECT_EQ(Algebraic(Rational(-5, 8)).to_string(), "-5/8");
  EXPECT_EQ(root_of(2).to_string(), "sqrt(2)");
  EXPECT_EQ((root_of(2) / Algebraic(8)).to_string(), "sqrt(2)/8");
  EXPECT_EQ(((Algebraic(1) - root_of(5)) / Algebraic(2)).to_string(), "(1-sqrt(5))/2");
  EXPECT_EQ((Algebraic(Rational(1, 3)) + root_of(50) / Algebraic(3)).to_string(), "(1+5*sqrt(2))/3");
  EXPECT_EQ((-root_of(3)).to_string(), "-sqrt(3)");
  EXPECT_EQ(sqrt(root_of(2)).to_string(), "root of x^4 - 2 near 1.18920711500");
}

TEST(Algebraic, IsTheLimitOfItsIntervalArithmetic) {
  Generator generator(51);
  for (int i = 0; i < 50; ++i) {
    const Algebraic a = Samples<Algebraic>::draw(generator);
    const Algebraic b = Samples<Algebraic>::draw(generator);
    EXPECT_TRUE((a * b).to_interval().overlaps(a.to_interval() * b.to_interval()));
    EXPECT_EQ((a - b).sign(), a < b ? -1 : (a == b ? 0 : 1));
  }
}

}  // namespace
}  // namespace subdiv
