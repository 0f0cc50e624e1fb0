#include "schemes/algebra/rational_function.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/interval.h"
#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::Samples;

const RationalFunction s = RationalFunction::variable(0);
const RationalFunction t = RationalFunction::variable(1);

TEST(RationalFunction, IsInLowestTerms) {
  const RationalFunction f = (s * s - t * t) / (RationalFunction(2) * s - RationalFunction(2) * t);
  EXPECT_EQ(f, (s + t) / RationalFunction(2));
  EXPECT_EQ(f.denominator(), Polynomial(2));
  EXPECT_EQ(f.numerator(), Polynomial::variable(0) + Polynomial::variable(1));
  EXPECT_TRUE(((s - t) / (t - s)).is_constant());
  EXPECT_EQ(((s - t) / (t - s)).constant(), Rational(-1));
}

TEST(RationalFunction, EvaluationIsAHomomorphismWhereDefined) {
  Generator generator(41);
  int defined = 0;
  for (int i = 0; i < 60; ++i) {
    const auto a = Samples<RationalFunction>::draw(generator);
    const auto b = Samples<RationalFunction>::draw(generator);
    const std::vector<Rational> point{Rational(2, 3), Rational(-7, 5), Rational(9, 4)};
    const auto at = [&](const RationalFunction& f) { return f.evaluate<Rational>(point); };
    try {
      EXPECT_EQ(at(a * b), at(a) * at(b));
      EXPECT_EQ(at(a - b), at(a) - at(b));
      ++defined;
    } catch (const std::domain_error&) {  // a pole
    }
  }
  EXPECT_GT(defined, 50);
}

TEST(RationalFunction, PolesAreErrorsInExactFieldsOnly) {
  const RationalFunction f = RationalFunction(1) / (s + RationalFunction(6));
  const std::vector<Rational> pole{Rational(-6)};
  EXPECT_THROW(static_cast<void>(f.evaluate<Rational>(pole)), std::domain_error);
  const std::vector<Interval> around{Interval::hull(Rational(-7), Rational(-5))};
  EXPECT_FALSE(f.evaluate<Interval>(around).is_finite());
}

TEST(RationalFunction, DerivativeOfAQuotient) {
  // d/ds of s/(s+6) is 6/(s+6)^2.
  const RationalFunction below = s + RationalFunction(6);
  EXPECT_EQ((s / below).derivative(0), RationalFunction(6) / (below * below));
  EXPECT_TRUE((s / below).derivative(1).is_zero());
}

TEST(RationalFunction, Prints) {
  const std::vector<std::string> names{"s", "t"};
  const RationalFunction f = (s * s - s) / (RationalFunction(12) * s + RationalFunction(72));
  EXPECT_EQ(f.to_string(names), "(s^2 - s)/(12*s + 72)");
  EXPECT_EQ(f.to_factored_string(names), "s*(s - 1)/(12*(s + 6))");
  EXPECT_EQ((s / RationalFunction(8)).to_string(names), "s/8");
  EXPECT_EQ(((s - RationalFunction(1)) / RationalFunction(16)).to_string(names), "(s - 1)/16");
  EXPECT_EQ(RationalFunction(Rational(-3, 4)).to_string(names), "-3/4");
  EXPECT_EQ(RationalFunction().to_string(names), "0");
}

TEST(RationalFunction, ComesFromPolynomialsWithFractions) {
  const Polynomial p = Polynomial(Rational(1, 6)) * Polynomial::variable(0) - Polynomial(Rational(3, 4));
  EXPECT_EQ(RationalFunction(p), s / RationalFunction(6) - RationalFunction(Rational(3, 4)));
}

}  // namespace
}  // namespace subdiv
