#include "schemes/algebra/polynomial.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/interval.h"
#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_rational;
using testing::Samples;

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);
const Polynomial w = Polynomial::variable(2);

Polynomial draw(Generator& generator) { return Samples<Polynomial>::draw(generator); }

std::vector<Rational> random_point(Generator& generator) {
  return {random_rational(generator), random_rational(generator), random_rational(generator)};
}

TEST(Polynomial, EvaluationIsAHomomorphism) {
  Generator generator(31);
  for (int i = 0; i < 100; ++i) {
    const Polynomial a = draw(generator);
    const Polynomial b = draw(generator);
    const std::vector<Rational> point = random_point(generator);
    const auto at = [&](const Polynomial& p) { return p.evaluate<Rational>(point); };
    EXPECT_EQ(at(a * b), at(a) * at(b));
    EXPECT_EQ(at(a - b), at(a) - at(b));
    EXPECT_EQ(at(pow(a, 3)), pow(at(a), 3));
  }
}

TEST(Polynomial, EvaluatesOverOtherRings) {
  const Polynomial p = x * x * y - Polynomial(Rational(1, 3));
  const std::vector<Polynomial> inner{y + Polynomial(1), x};
  EXPECT_EQ(p.evaluate<Polynomial>(inner),
            (y + Polynomial(1)) * (y + Polynomial(1)) * x - Polynomial(Rational(1, 3)));
  const std::vector<Interval> box{Interval::hull(Rational(1), Rational(2)), Interval(3)};
  EXPECT_TRUE(p.evaluate<Interval>(box).contains(Rational(9 * 3, 4) - Rational(1, 3)));
  const std::vector<double> point{2.0, 0.5};
  EXPECT_DOUBLE_EQ(p.evaluate<double>(point), 2.0 - 1.0 / 3.0);
  const std::vector<Rational> short_point{Rational(1)};
  EXPECT_THROW(static_cast<void>(p.evaluate<Rational>(short_point)), std::domain_error);
}

TEST(Polynomial, CoefficientsInAVariableRebuildIt) {
  Generator generator(32);
  for (int i = 0; i < 100; ++i) {
    const Polynomial p = draw(generator);
    for (int variable = 0; variable < 3; ++variable) {
      Polynomial rebuilt;
      Polynomial power(1);
      for (const Polynomial& c : p.coefficients_in(variable)) {
        EXPECT_FALSE(c.uses(variable));
        rebuilt += c * power;
        power *= Polynomial::variable(variable);
      }
      EXPECT_EQ(rebuilt, p);
    }
  }
}

TEST(Polynomial, SubstitutionIsEvaluationAtAPolynomial) {
  Generator generator(33);
  for (int i = 0; i < 50; ++i) {
    const Polynomial p = draw(generator);
    const Polynomial by = draw(generator);
    const std::vector<Polynomial> arguments{x, by, w};
    EXPECT_EQ(p.substitute(1, by), p.evaluate<Polynomial>(arguments));
  }
}

TEST(Polynomial, DerivativeObeysTheProductRule) {
  Generator generator(34);
  for (int i = 0; i < 50; ++i) {
    const Polynomial a = draw(generator);
    const Polynomial b = draw(generator);
    EXPECT_EQ((a * b).derivative(1), a.derivative(1) * b + a * b.derivative(1));
  }
  EXPECT_EQ((x * x * y).derivative(0), Polynomial(2) * x * y);
  EXPECT_TRUE(Polynomial(5).derivative(0).is_zero());
}

TEST(Polynomial, KnowsConstantsAndDegrees) {
  EXPECT_EQ((x - x + Polynomial(Rational(2, 3))).constant(), Rational(2, 3));
  EXPECT_THROW(static_cast<void>(x.constant()), std::domain_error);
  EXPECT_EQ((x * x * y).degree(0), 2);
  EXPECT_EQ((x * x * y).degree(2), 0);
  EXPECT_THROW(Polynomial::variable(max_parameters), std::domain_error);
  EXPECT_THROW(Polynomial::variable(-1), std::domain_error);
}

TEST(Polynomial, DivisionIsExactOrRefused) {
  Generator generator(35);
  for (int i = 0; i < 100; ++i) {
    const Polynomial a = draw(generator);
    const Polynomial b = draw(generator);
    Polynomial quotient;
    if (b.is_zero()) {
      EXPECT_FALSE(divides(b, a, quotient));
      continue;
    }
    ASSERT_TRUE(divides(b, a * b, quotient));
    EXPECT_EQ(quotient, a);
  }
  Polynomial quotient;
  EXPECT_FALSE(divides(x + Polynomial(1), x * x + Polynomial(1), quotient));
}

TEST(Polynomial, GreatestCommonDivisor) {
  const Polynomial common = x * y - Polynomial(2);
  const Polynomial g = gcd(common * (x + Polynomial(1)), Polynomial(Rational(3, 7)) * common * (x - y));
  Polynomial quotient;
  EXPECT_TRUE(divides(common, g, quotient));
  EXPECT_TRUE(quotient.is_constant());
  EXPECT_EQ(gcd(x, y), Polynomial(1));
}

// The resultant of two products of linear factors is the product of the differences of their roots.
TEST(Polynomial, ResultantIsTheProductOfRootDifferences) {
  const auto linear = [](const Polynomial& root) { return w - root; };
  const std::vector<Polynomial> left{x, y, Polynomial(3)};
  const std::vector<Polynomial> right{x + y, Polynomial(-2)};
  Polynomial p(1);
  Polynomial q(1);
  Polynomial expected(1);
  for (const Polynomial& a : left) p *= linear(a);
  for (const Polynomial& b : right) q *= linear(b);
  for (const Polynomial& a : left) {
    for (const Polynomial& b : right) expected *= a - b;
  }
  EXPECT_EQ(resultant(p, q, 2), expected);
}

TEST(Polynomial, FactorsMultiplyBack) {
  const Polynomial p = Polynomial(Rational(-5, 8)) * pow(x - Polynomial(2), 2) *
                       (Polynomial(3) * x * y + Polynomial(1)) * (x * x + y * y);
  const Factorization f = factor(p);
  EXPECT_EQ(f.factors.size(), 3U);
  Polynomial product(f.constant);
  int squared = 0;
  for (const auto& [base, multiplicity] : f.factors) {
    product *= pow(base, static_cast<unsigned>(multiplicity));
    if (multiplicity == 2) ++squared;
  }
  EXPECT_EQ(product, p);
  EXPECT_EQ(squared, 1);
  EXPECT_THROW(factor(Polynomial()), std::domain_error);
}

TEST(Polynomial, PrintsWithNames) {
  const std::vector<std::string> names{"s", "t"};
  EXPECT_EQ((x * x - Polynomial(3) * y + Polynomial(Rational(1, 2))).to_string(names), "s^2 - 3*t + 1/2");
  EXPECT_EQ(Polynomial::variable(symbol_variable).to_string(), "z");
  EXPECT_EQ(Polynomial::variable(eigenvalue_variable).to_string(), "lambda");
  EXPECT_EQ(Polynomial::variable(3).to_string(names), "x3");
  EXPECT_EQ(Polynomial().to_string(), "0");
}

TEST(Polynomial, PrintsFactoredWithIntegerCoefficients) {
  const std::vector<std::string> names{"s"};
  const Polynomial one(1);
  EXPECT_EQ(to_factored_string(Polynomial(Rational(1, 8)) * (x - Polynomial(2)) * pow(x + one, 2), names),
            "(1/8)*(s - 2)*(s + 1)^2");
  EXPECT_EQ(to_factored_string(Polynomial(-1) * x * x, names), "-s^2");
  EXPECT_EQ(to_factored_string(Polynomial(Rational(7, 2)), names), "7/2");
}

}  // namespace
}  // namespace subdiv
