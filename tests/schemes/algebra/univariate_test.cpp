#include "schemes/algebra/univariate.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_int;
using testing::random_rational;
using testing::Samples;
using P = UnivariatePolynomial;

P linear(const Rational& root) { return P({-root, Rational(1)}); }

P with_roots(const std::vector<Rational>& roots) {
  P result(1);
  for (const Rational& root : roots) result *= linear(root);
  return result;
}

TEST(UnivariatePolynomial, ReadsAPolynomialInOneVariable) {
  const Polynomial s = Polynomial::variable(2);
  EXPECT_EQ(P(s * s - Polynomial(Rational(1, 2)), 2), P({Rational(-1, 2), 0, 1}));
  EXPECT_THROW(P(s * Polynomial::variable(0), 2), std::domain_error);
  EXPECT_TRUE(P(Polynomial(), 0).is_zero());
  EXPECT_EQ(P().degree(), -1);
  EXPECT_EQ(P({1, 0, 3}).coefficient(2), Rational(3));
  EXPECT_EQ(P({1, 0, 3}).coefficient(7), Rational(0));
  EXPECT_EQ(P({Rational(-1, 2), 0, 1}).to_string("s"), "s^2 - 1/2");
}

TEST(UnivariatePolynomial, EvaluatesAtRationalsAndIntervals) {
  Generator generator(61);
  for (int i = 0; i < 100; ++i) {
    const P a = Samples<P>::draw(generator);
    const P b = Samples<P>::draw(generator);
    const Rational x = random_rational(generator);
    EXPECT_EQ((a * b).evaluate(x), a.evaluate(x) * b.evaluate(x));
    EXPECT_EQ((a - b).evaluate(x), a.evaluate(x) - b.evaluate(x));
    EXPECT_TRUE(a.evaluate(Interval(x, 20)).contains(a.evaluate(x)));
    EXPECT_EQ((a * b).derivative(), a.derivative() * b + a * b.derivative());
  }
}

TEST(UnivariatePolynomial, DivisionWithRemainder) {
  Generator generator(62);
  for (int i = 0; i < 100; ++i) {
    const P a = Samples<P>::draw(generator);
    const P b = Samples<P>::draw(generator);
    if (b.is_zero()) {
      EXPECT_THROW(divide(a, b), std::domain_error);
      continue;
    }
    const auto [quotient, remainder] = divide(a, b);
    EXPECT_EQ(quotient * b + remainder, a);
    EXPECT_LT(remainder.degree(), std::max(b.degree(), 1L));
  }
  EXPECT_EQ(gcd(with_roots({1, 2, 2}), with_roots({2, 3})), linear(2));
}

TEST(UnivariatePolynomial, FactorsMultiplyBackUpToAConstant) {
  const P p =
      P(Rational(7, 3)) * pow(Rational(2), 3) * linear(2) * linear(2) * P({1, 1, 1}) * P({-2, 0, 0, 1});
  P product(1);
  int factors = 0;
  for (const auto& [base, multiplicity] : factor(p)) {
    for (int i = 0; i < multiplicity; ++i) product *= base;
    ++factors;
  }
  EXPECT_EQ(factors, 3);
  EXPECT_EQ(divide(p, product).second, P());
  EXPECT_EQ(divide(p, product).first.degree(), 0);
  EXPECT_THROW(factor(P()), std::domain_error);
}

TEST(RealRoots, OfKnownPolynomials) {
  // (x^2 - 2)(x - 1)^2 (x^2 + 1): roots -sqrt 2, 1 (double), sqrt 2.
  const auto roots = real_roots(P({-2, 0, 1}) * linear(1) * linear(1) * P({1, 0, 1}));
  ASSERT_EQ(roots.size(), 3U);
  EXPECT_EQ(roots[0].value, -sqrt(Algebraic(2)));
  EXPECT_EQ(roots[1].value, Algebraic(1));
  EXPECT_EQ(roots[1].multiplicity, 2);
  EXPECT_EQ(roots[2].value, sqrt(Algebraic(2)));
  EXPECT_EQ(roots[2].multiplicity, 1);
  EXPECT_TRUE(real_roots(P({1, 0, 1})).empty());
  EXPECT_TRUE(real_roots(P(5)).empty());
  EXPECT_THROW(real_roots(P()), std::domain_error);
}

// Chebyshev's polynomial T_8, by its recurrence, has the eight roots cos((2k-1) pi / 16).
TEST(RealRoots, OfAChebyshevPolynomial) {
  P previous(1);
  P current = P(std::vector<Rational>{0, 1});
  for (int n = 2; n <= 8; ++n) {
    const P next = P(std::vector<Rational>{0, 2}) * current - previous;
    previous = current;
    current = next;
  }
  const auto roots = real_roots(current);
  ASSERT_EQ(roots.size(), 8U);
  for (int k = 1; k <= 8; ++k) {
    const Interval expected = cos(pi() * Interval(Rational(2 * k - 1, 16)));
    EXPECT_TRUE(roots[static_cast<std::size_t>(8 - k)].value.to_interval().overlaps(expected));
  }
  EXPECT_EQ(count_roots(current, Rational(-1), Rational(1)), 8);
  EXPECT_EQ(count_roots(current, Rational(0), Rational(1)), 4);
}

// Wilkinson's polynomial (x-1)..(x-20), whose roots floating-point arithmetic loses.
TEST(RealRoots, OfWilkinsonsPolynomial) {
  std::vector<Rational> expected;
  for (int i = 1; i <= 20; ++i) expected.emplace_back(i);
  const P p = with_roots(expected);
  const auto roots = real_roots(p);
  ASSERT_EQ(roots.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(roots[i].value, Algebraic(expected[i]));
  EXPECT_EQ(count_roots(p, Rational(5), Rational(7)), 3);
}

TEST(CountRoots, IncludesBothEndsAndCountsEachRootOnce) {
  const P p = with_roots({-1, -1, 0, Rational(1, 2), 3, 3, 3});
  EXPECT_EQ(count_roots(p, Rational(-10), Rational(10)), 4);
  EXPECT_EQ(count_roots(p, Rational(-1), Rational(3)), 4);
  EXPECT_EQ(count_roots(p, Rational(-1), Rational(-1)), 1);
  EXPECT_EQ(count_roots(p, Rational(0), Rational(1, 2)), 2);
  EXPECT_EQ(count_roots(p, Rational(1, 100), Rational(49, 100)), 0);
  EXPECT_EQ(count_roots(p, Rational(2), Rational(1)), 0);
  EXPECT_EQ(count_roots(P(4), Rational(-1), Rational(1)), 0);
  EXPECT_THROW(static_cast<void>(count_roots(P(), Rational(0), Rational(1))), std::domain_error);
}

TEST(CountRoots, AgreesWithTheRootsThemselves) {
  Generator generator(63);
  for (int i = 0; i < 60; ++i) {
    P p = Samples<P>::draw(generator) * Samples<P>::draw(generator);
    if (p.is_zero()) continue;
    const Rational lower(random_int(generator, -12, 0), 4);
    const Rational upper(random_int(generator, 0, 12), 4);
    if (random_int(generator, 0, 1) == 1) p *= linear(lower) * linear(lower);
    const auto roots = real_roots(p);
    const auto inside = std::count_if(roots.begin(), roots.end(), [&](const RealRoot& root) {
      return Algebraic(lower) <= root.value && root.value <= Algebraic(upper);
    });
    EXPECT_EQ(count_roots(p, lower, upper), inside);
  }
}

TEST(ComplexRoots, EncloseEveryRootWithItsMultiplicity) {
  // (x^2 + 4)^2 (x - 3): +-2i twice, 3 once.
  const auto roots = complex_roots(P({4, 0, 1}) * P({4, 0, 1}) * linear(3));
  int total = 0;
  int real = 0;
  for (const ComplexRoot& root : roots) {
    total += root.multiplicity;
    if (root.imaginary.is_exactly_zero()) {
      ++real;
      EXPECT_TRUE(root.real.contains(Rational(3)));
      EXPECT_EQ(root.multiplicity, 1);
    } else {
      EXPECT_TRUE(root.real.contains(Rational(0)));
      EXPECT_TRUE(abs(root.imaginary).contains(Rational(2)));
      EXPECT_EQ(root.multiplicity, 2);
    }
  }
  EXPECT_EQ(total, 5);
  EXPECT_EQ(real, 1);
}

}  // namespace
}  // namespace subdiv
