#include "schemes/algebra/laurent.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_int;
using testing::Samples;
using P = Laurent<Rational>;

P draw(Generator& generator) { return Samples<P>::draw(generator); }

TEST(Laurent, DropsZerosAtBothEnds) {
  const P p(-3, {0, 0, 5, 0, 7, 0});
  EXPECT_EQ(p.first(), -1);
  EXPECT_EQ(p.last(), 1);
  EXPECT_EQ(p.size(), 3);
  EXPECT_EQ(p[-1], Rational(5));
  EXPECT_EQ(p[0], Rational(0));
  EXPECT_EQ(p[100], Rational(0));
  EXPECT_EQ(p, P(-1, {5, 0, 7}));
}

TEST(Laurent, ZeroIsOneValue) {
  const P zero(5, {0, 0});
  EXPECT_TRUE(zero.is_zero());
  EXPECT_EQ(zero, P());
  EXPECT_EQ(zero, P(0));
  EXPECT_EQ(zero.first(), 0);
  EXPECT_EQ(zero.last(), -1);
  EXPECT_EQ(shift(zero, 4), zero);
  EXPECT_EQ(upsample(zero, 3), zero);
  EXPECT_EQ(reverse(zero), zero);
  EXPECT_EQ(residue_class(zero, 1, 2), zero);
  EXPECT_EQ(euler_derivative(zero), zero);
  EXPECT_EQ(sum(zero), Rational(0));
}

TEST(Laurent, ProductsConvolveCoefficients) {
  const P a(-1, {1, 2, 3});
  const P b(2, {1, -1});
  EXPECT_EQ(a * b, P(1, {1, 1, 1, -3}));
}

// Evaluation at points is a homomorphism: a second route to sums and products, shifts, upsampling and powers.
TEST(Laurent, EvaluationIsAHomomorphism) {
  Generator generator(21);
  for (int i = 0; i < 200; ++i) {
    const P a = draw(generator);
    const P b = draw(generator);
    Rational x = testing::random_rational(generator);
    if (x.sign() == 0) x = Rational(1, 2);
    const int k = random_int(generator, -4, 4);
    const int m = random_int(generator, 1, 4);
    EXPECT_EQ(evaluate(a + b, x), evaluate(a, x) + evaluate(b, x));
    EXPECT_EQ(evaluate(a * b, x), evaluate(a, x) * evaluate(b, x));
    EXPECT_EQ(evaluate(shift(a, k), x), evaluate(a, x) * pow(x, k));
    EXPECT_EQ(evaluate(upsample(a, m), x), evaluate(a, pow(x, m)));
    EXPECT_EQ(evaluate(reverse(a), x), evaluate(a, Rational(1) / x));
    EXPECT_EQ(evaluate(pow(a, 3), x), pow(evaluate(a, x), 3));
    EXPECT_EQ(sum(a), evaluate(a, Rational(1)));
  }
}

TEST(Laurent, IsTheSumOfItsResidueClasses) {
  Generator generator(22);
  for (int i = 0; i < 200; ++i) {
    const P p = draw(generator);
    for (int m = 1; m <= 4; ++m) {
      P total;
      for (int r = 0; r < m; ++r) total += shift(upsample(residue_class(p, r, m), m), r);
      EXPECT_EQ(total, p) << "m = " << m;
    }
  }
}

TEST(Laurent, ResidueClassesOfAMask) {
  const P mask(-3, {-1, 0, 9, 16, 9, 0, -1});
  EXPECT_EQ(residue_class(mask, 0, 2), P(0, {16}));
  EXPECT_EQ(residue_class(mask, 1, 2), P(-2, {-1, 9, 9, -1}));
  EXPECT_EQ(residue_class(mask, 2, 3), P(-1, {9, 0}));
}

TEST(Laurent, ResidueAndFloorAgreeForAllSigns) {
  for (int i = -20; i <= 20; ++i) {
    for (int m = 1; m <= 5; ++m) {
      EXPECT_EQ(floor_divide(i, m) * m + residue(i, m), i);
      EXPECT_GE(residue(i, m), 0);
      EXPECT_LT(residue(i, m), m);
    }
  }
}

TEST(Laurent, EulerDerivativeObeysTheProductRule) {
  Generator generator(23);
  for (int i = 0; i < 100; ++i) {
    const P a = draw(generator);
    const P b = draw(generator);
    EXPECT_EQ(euler_derivative(a * b), euler_derivative(a) * b + a * euler_derivative(b));
  }
  EXPECT_EQ(euler_derivative(P::monomial(-3, Rational(2))), P::monomial(-3, Rational(-6)));
}

TEST(Laurent, ExactDivisionInvertsMultiplication) {
  Generator generator(24);
  for (int i = 0; i < 300; ++i) {
    const P a = draw(generator);
    const P b = draw(generator);
    if (b.is_zero()) continue;
    const auto quotient = divide_exactly(a * b, b);
    ASSERT_TRUE(quotient.has_value());
    EXPECT_EQ(*quotient, a);
  }
}

TEST(Laurent, DivisionLeavesARemainderOfTheHighestPowers) {
  Generator generator(25);
  for (int i = 0; i < 300; ++i) {
    const P a = draw(generator);
    const P b = draw(generator);
    if (b.is_zero()) {
      EXPECT_THROW(divide_from_below(a, b), std::domain_error);
      continue;
    }
    const auto [quotient, remainder] = divide_from_below(a, b);
    EXPECT_EQ(quotient * b + remainder, a);
    if (!remainder.is_zero()) {
      EXPECT_GT(remainder.first(), a.last() - b.size() + 1);
      EXPECT_LE(remainder.last(), a.last());
    }
  }
  EXPECT_FALSE(divide_exactly(P(0, {1, 1, 1}), P(0, {1, 1})).has_value());
  EXPECT_FALSE(divide_exactly(P(0, {1}), P(0, {1, 1})).has_value());
}

TEST(Laurent, DividesOverRingsWithoutDivisionByMonicDivisors) {
  using Q = Laurent<Polynomial>;
  const Polynomial s = Polynomial::variable(0);
  const Q factor(0, {Polynomial(1), s});
  const Q cofactor(-2, {s * s, Polynomial(3), s - Polynomial(1)});
  EXPECT_EQ(divide_exactly(factor * cofactor, Q(0, {Polynomial(1), s})), cofactor);
}

TEST(Laurent, MultiplicityOfSmoothingFactors) {
  Generator generator(26);
  for (int arity = 2; arity <= 3; ++arity) {
    const P factor = smoothing_factor<Rational>(arity);
    EXPECT_EQ(sum(factor), Rational(arity));
    for (int i = 0; i < 100; ++i) {
      P cofactor = draw(generator);
      if (cofactor.is_zero() || divide_exactly(cofactor, factor)) continue;
      const int n = random_int(generator, 0, 6);
      const auto [multiplicity, rest] = divide_out(cofactor * pow(factor, n), factor);
      EXPECT_EQ(multiplicity, n);
      EXPECT_EQ(rest, cofactor);
    }
  }
  EXPECT_THROW(divide_out(P(), smoothing_factor<Rational>(2)), std::domain_error);
}

// (1 + z + z^2) divides z^9 - 1 over z^3 - 1 twice nowhere: a case where the multiplicity is known by other
// means.
TEST(Laurent, MultiplicityInCyclotomicProducts) {
  const P one_minus_z(0, {1, -1});
  const P one_minus_z9 = P(1) - P::monomial(9);
  EXPECT_EQ(divide_out(one_minus_z9, smoothing_factor<Rational>(3)).first, 1);
  EXPECT_EQ(divide_out(one_minus_z9 * one_minus_z9, smoothing_factor<Rational>(3)).first, 2);
  EXPECT_EQ(divide_out(one_minus_z9, smoothing_factor<Rational>(2)).first, 0);
  EXPECT_EQ(*divide_exactly(one_minus_z9, one_minus_z), P(0, std::vector<Rational>(9, Rational(1))));
}

TEST(Laurent, MapsIntoOtherRings) {
  const P p(-1, {Rational(1, 3), 2});
  const auto doubled = map_coefficients(p, [](const Rational& c) { return (c + c).to_double(); });
  EXPECT_EQ(doubled.first(), -1);
  EXPECT_DOUBLE_EQ(doubled[-1], 2.0 / 3.0);
  // Coefficients that vanish in the other ring are dropped.
  const auto truncated = map_coefficients(p, [](const Rational& c) { return floor(c); });
  EXPECT_EQ(truncated, P(0, {2}));
}

TEST(Laurent, IntervalsEncloseExactProducts) {
  Generator generator(27);
  for (int i = 0; i < 100; ++i) {
    const P a = draw(generator);
    const P b = draw(generator);
    const auto coarse = [](const Rational& q) { return Interval(q, 10); };
    const auto product = map_coefficients(a, coarse) * map_coefficients(b, coarse);
    for (int k = -10; k <= 16; ++k) EXPECT_TRUE(product[k].contains((a * b)[k]));
  }
}

}  // namespace
}  // namespace subdiv
