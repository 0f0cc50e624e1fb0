#include "analysis/jsr/number_field.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

TEST(NumberField, HasTheArithmeticOfItsGenerator) {
  const auto field = std::make_shared<const NumberField>(sqrt(Algebraic(2)));
  const FieldElement root = FieldElement::generator(field);
  EXPECT_EQ(root * root, FieldElement(2));
  EXPECT_EQ(FieldElement(1) / (FieldElement(1) + root), root - FieldElement(1));
  EXPECT_EQ((root - FieldElement(1)).sign(), 1);
  EXPECT_EQ((root - FieldElement(Rational(3, 2))).sign(), -1);
  EXPECT_EQ((root * root - FieldElement(2)).sign(), 0);
  EXPECT_TRUE((root * root - FieldElement(2)).is_zero());
  EXPECT_EQ(abs(FieldElement(1) - root), root - FieldElement(1));
  EXPECT_THROW((void)(root / FieldElement(0)), std::domain_error);
}

TEST(NumberField, DecidesSignsOfTinyDifferences) {
  const auto field = std::make_shared<const NumberField>(sqrt(Algebraic(2)));
  const FieldElement root = FieldElement::generator(field);
  // p^2 - 2 q^2 = 1: (root - p/q) is about -1 / (2 sqrt(2) q^2).
  Rational p(1);
  Rational q(0);
  for (int i = 0; i < 200; ++i) {
    const Rational next = Rational(3) * p + Rational(4) * q;
    q = Rational(2) * p + Rational(3) * q;
    p = next;
  }
  EXPECT_EQ((FieldElement(q) * root - FieldElement(p)).sign(), -1);
}

TEST(NumberField, OfARationalNumber) {
  const auto field = std::make_shared<const NumberField>(Algebraic(Rational(9, 2)));
  EXPECT_EQ(FieldElement::generator(field), FieldElement(Rational(9, 2)));
  EXPECT_EQ(FieldElement::generator(field).sign(), 1);
}

TEST(NumberField, SolvesLinearSystems) {
  const auto field =
      std::make_shared<const NumberField>(real_roots(UnivariatePolynomial({-2, 0, 0, Rational(1)}))[0].value);
  const FieldElement x = FieldElement::generator(field);
  Matrix<FieldElement> a(2, 2);
  a << x, FieldElement(1), FieldElement(2), x * x;
  // det = x^3 - 2 = 0.
  EXPECT_EQ(null_space(a).size(), 1u);
  a(1, 1) = x;
  Vector<FieldElement> b(2);
  b << FieldElement(1), x;
  const auto solution = solve(a, b);
  ASSERT_TRUE(solution);
  EXPECT_TRUE(Vector<FieldElement>(a * *solution) == b);
}

}  // namespace
}  // namespace subdiv
