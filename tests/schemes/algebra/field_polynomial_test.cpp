#include "schemes/algebra/field_polynomial.h"

#include <gtest/gtest.h>

#include "schemes/algebra/univariate.h"
#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using P = FieldPolynomial<Rational>;
using Q = FieldPolynomial<Algebraic>;

const Algebraic sqrt2 = sqrt(Algebraic(2));

/// The product of (x - root) over the roots.
template <class F>
FieldPolynomial<F> with_roots(const std::vector<F>& roots) {
  std::vector<F> c{F(1)};
  for (const F& root : roots) {
    c.push_back(F(0));
    for (std::size_t i = c.size(); i-- > 0;) c[i] = (i > 0 ? c[i - 1] : F(0)) - root * c[i];
  }
  return FieldPolynomial<F>(std::move(c));
}

UnivariatePolynomial flint(const P& p) { return UnivariatePolynomial(p.coefficients()); }

P from_flint(const UnivariatePolynomial& p) {
  std::vector<Rational> c;
  for (long i = 0; i <= p.degree(); ++i) c.push_back(p.coefficient(i));
  return P(std::move(c));
}

P random_polynomial(testing::Generator& generator, int degree) {
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.push_back(testing::random_rational(generator));
  return P(std::move(c));
}

TEST(FieldPolynomial, DivisionAndGcdAgreeWithFlint) {
  testing::Generator generator(1);
  for (int trial = 0; trial < 100; ++trial) {
    const P common = random_polynomial(generator, trial % 4);
    const P a = from_flint(flint(common) * flint(random_polynomial(generator, 3)));
    if (common.is_zero()) continue;
    const auto [quotient, rest] = divide(a, common);
    EXPECT_TRUE(rest.is_zero());
    EXPECT_EQ(flint(quotient) * flint(common), flint(a));
    EXPECT_EQ(flint(gcd(a, common)), gcd(flint(a), flint(common)));
  }
  EXPECT_THROW(divide(P({Rational(1)}), P()), std::domain_error);
}

TEST(FieldPolynomial, EvaluationAndDerivative) {
  const P p = with_roots<Rational>({Rational(1), Rational(-2), Rational(1, 3)});
  EXPECT_EQ(p.degree(), 3);
  EXPECT_EQ(p.evaluate(Rational(1, 3)), Rational(0));
  EXPECT_EQ(p.evaluate(Rational(0)), Rational(2, 3));
  EXPECT_EQ(flint(p.derivative()), flint(p).derivative());
  EXPECT_EQ(P({Rational(1), Rational(0)}).degree(), 0);
  EXPECT_EQ(P().degree(), -1);
}

TEST(FieldPolynomial, SquareFreeFactors) {
  const Q p = with_roots<Algebraic>({sqrt2, sqrt2, sqrt2, Algebraic(1), Algebraic(1), -sqrt2, Algebraic(0)});
  const auto factors = square_free_factors(p);
  ASSERT_EQ(factors.size(), 3U);
  EXPECT_EQ(factors[0], (std::pair{with_roots<Algebraic>({-sqrt2, Algebraic(0)}), 1}));
  EXPECT_EQ(factors[1], (std::pair{with_roots<Algebraic>({Algebraic(1)}), 2}));
  EXPECT_EQ(factors[2], (std::pair{with_roots<Algebraic>({sqrt2}), 3}));
  EXPECT_TRUE(square_free_factors(Q({Algebraic(5)})).empty());
}

TEST(FieldPolynomial, CountsRootsInClosedIntervals) {
  const Q p = with_roots<Algebraic>({sqrt2, sqrt2, Algebraic(1), -sqrt2});
  EXPECT_EQ(count_roots(p, Algebraic(1), sqrt2), 2);
  EXPECT_EQ(count_roots(p, Algebraic(-1), Algebraic(1)), 1);
  EXPECT_EQ(count_roots(p, -sqrt2, sqrt2), 3);
  EXPECT_EQ(count_roots(p, Algebraic(2), Algebraic(3)), 0);
  EXPECT_EQ(count_roots(Q({Algebraic(5)}), Algebraic(0), Algebraic(1)), 0);
  EXPECT_THROW(count_roots(Q(), Algebraic(0), Algebraic(1)), std::domain_error);
}

TEST(FieldPolynomial, RootsInsideACircleAgreesWithComplexRoots) {
  testing::Generator generator(2);
  int inside = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const P p = random_polynomial(generator, 1 + trial % 5);
    if (p.degree() < 1) continue;
    const Rational radius(testing::random_int(generator, 1, 9), 2);
    bool expected = true;
    for (const ComplexRoot& root : complex_roots(flint(p))) {
      const Interval square = root.real * root.real + root.imaginary * root.imaginary;
      if (!certainly_less(square, Interval(radius * radius))) expected = false;
    }
    EXPECT_EQ(roots_inside(p, radius), expected);
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 50);
}

TEST(FieldPolynomial, RootsOnTheCircleAreNotInside) {
  EXPECT_FALSE(roots_inside(with_roots<Rational>({Rational(1, 2)}), Rational(1, 2)));
  EXPECT_FALSE(roots_inside(P({Rational(1, 4), Rational(0), Rational(1)}), Rational(1, 2)));  // +-i/2
  EXPECT_FALSE(roots_inside(with_roots<Algebraic>({Algebraic(0), -sqrt2}), sqrt2));
  EXPECT_TRUE(roots_inside(with_roots<Algebraic>({Algebraic(0), -sqrt2}), Algebraic(Rational(3, 2))));
  EXPECT_TRUE(roots_inside(with_roots<Rational>({Rational(0), Rational(0)}), Rational(1, 100)));
  EXPECT_TRUE(roots_inside(P({Rational(3)}), Rational(1)));
  EXPECT_THROW(roots_inside(P(), Rational(1)), std::domain_error);
}

}  // namespace
}  // namespace subdiv
