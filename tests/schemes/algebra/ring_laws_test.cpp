// The laws of a commutative ring with 1, for every coefficient ring and for Laurent polynomials over several
// of them.

#include <gtest/gtest.h>

#include "tests/schemes/algebra/random_elements.h"

namespace subdiv::testing {
namespace {

template <class R>
class RingLaws : public ::testing::Test {
 protected:
  static constexpr int rounds = 40;

  /// Calls check(a, b, c) for random elements.
  template <class Check>
  void for_random_elements(Check check) {
    Generator generator(20'240'229);
    for (int round = 0; round < rounds; ++round) {
      const R a = Samples<R>::draw(generator);
      const R b = Samples<R>::draw(generator);
      const R c = Samples<R>::draw(generator);
      check(a, b, c);
    }
  }
  static bool agree(const R& a, const R& b) { return Samples<R>::agree(a, b); }
};

using Rings =
    ::testing::Types<Rational, double, Real, Interval, ceres::Jet<double, 3>, UnivariatePolynomial,
                     Polynomial, RationalFunction, Algebraic, Laurent<Rational>, Laurent<double>,
                     Laurent<Real>, Laurent<Interval>, Laurent<ceres::Jet<double, 3>>, Laurent<Polynomial>,
                     Laurent<RationalFunction>, Laurent<Algebraic>, Laurent<Laurent<Rational>>>;
TYPED_TEST_SUITE(RingLaws, Rings);

TYPED_TEST(RingLaws, AdditionIsAnAbelianGroup) {
  using R = TypeParam;
  this->for_random_elements([this](const R& a, const R& b, const R& c) {
    EXPECT_TRUE(this->agree((a + b) + c, a + (b + c)));
    EXPECT_TRUE(this->agree(a + b, b + a));
    EXPECT_TRUE(this->agree(a + R(0), a));
    EXPECT_TRUE(this->agree(a - a, R(0)));
    EXPECT_TRUE(this->agree(a - b, a + (-b)));
    EXPECT_TRUE(this->agree(-(-a), a));
  });
}

TYPED_TEST(RingLaws, MultiplicationIsACommutativeMonoid) {
  using R = TypeParam;
  this->for_random_elements([this](const R& a, const R& b, const R& c) {
    EXPECT_TRUE(this->agree((a * b) * c, a * (b * c)));
    EXPECT_TRUE(this->agree(a * b, b * a));
    EXPECT_TRUE(this->agree(a * R(1), a));
    EXPECT_TRUE(this->agree(a * R(0), R(0)));
    EXPECT_TRUE(this->agree(a * R(-1), -a));
  });
}

TYPED_TEST(RingLaws, MultiplicationDistributes) {
  using R = TypeParam;
  this->for_random_elements([this](const R& a, const R& b, const R& c) {
    EXPECT_TRUE(this->agree(a * (b + c), a * b + a * c));
    EXPECT_TRUE(this->agree((a + b) * (a - b), a * a - b * b));
    EXPECT_TRUE(this->agree(a + a + a, R(3) * a));
  });
}

TYPED_TEST(RingLaws, CompoundAssignmentIsTheSameOperation) {
  using R = TypeParam;
  this->for_random_elements([this](const R& a, const R& b, const R& /*c*/) {
    R sum = a;
    sum += b;
    EXPECT_TRUE(this->agree(sum, a + b));
    R difference = a;
    difference -= b;
    EXPECT_TRUE(this->agree(difference, a - b));
    R product = a;
    product *= b;
    EXPECT_TRUE(this->agree(product, a * b));
    R square = a;
    square *= square;  // an operand that is its own target
    EXPECT_TRUE(this->agree(square, a * a));
    R nothing = a;
    nothing -= nothing;
    EXPECT_TRUE(this->agree(nothing, R(0)));
  });
}

TYPED_TEST(RingLaws, RationalsMapHomomorphically) {
  using R = TypeParam;
  Generator generator(7);
  for (int round = 0; round < 100; ++round) {
    const Rational p = random_dyadic(generator);
    const Rational q = random_dyadic(generator);
    EXPECT_TRUE(this->agree(from_rational<R>(p + q), from_rational<R>(p) + from_rational<R>(q)));
    EXPECT_TRUE(this->agree(from_rational<R>(p * q), from_rational<R>(p) * from_rational<R>(q)));
  }
  EXPECT_TRUE(this->agree(from_rational<R>(Rational(1)), R(1)));
  EXPECT_TRUE(this->agree(R(8) * fraction<R>(-3, 8), R(-3)));
}

TYPED_TEST(RingLaws, ZeroIsRecognised) {
  using R = TypeParam;
  EXPECT_TRUE(is_zero(R(0)));
  EXPECT_FALSE(is_zero(R(1)));
  EXPECT_FALSE(is_zero(fraction<R>(1, 1024)));
  if constexpr (ExactRing<R>) {
    this->for_random_elements([](const R& a, const R& b, const R& c) {
      EXPECT_TRUE(is_zero((a + b) * c - c * b - a * c));
      if (!is_zero(a) && !is_zero(b)) {
        EXPECT_FALSE(is_zero(a * b));
      }
    });
  }
}

TYPED_TEST(RingLaws, CopiesAreIndependentAndMovesKeepTheValue) {
  using R = TypeParam;
  this->for_random_elements([this](const R& a, const R& b, const R& /*c*/) {
    R copy = a;
    copy += b;
    copy = a;
    EXPECT_TRUE(this->agree(copy, a));
    R moved = std::move(copy);
    EXPECT_TRUE(this->agree(moved, a));
    copy = b;
    EXPECT_TRUE(this->agree(copy, b));
    const R& same = moved;
    moved = same;  // assignment to itself
    EXPECT_TRUE(this->agree(moved, a));
  });
}

template <class R>
class FieldLaws : public RingLaws<R> {};
using Fields = ::testing::Types<Rational, Interval, RationalFunction, Algebraic>;
TYPED_TEST_SUITE(FieldLaws, Fields);

TYPED_TEST(FieldLaws, DivisionInvertsMultiplication) {
  using R = TypeParam;
  this->for_random_elements([this](const R& a, const R& b, const R& c) {
    if (is_zero(b)) return;
    EXPECT_TRUE(this->agree(b / b, R(1)));
    EXPECT_TRUE(this->agree((a / b) * b, a));
    EXPECT_TRUE(this->agree((a + c) / b, a / b + c / b));
    R quotient = b;
    quotient /= quotient;
    EXPECT_TRUE(this->agree(quotient, R(1)));
  });
}

TYPED_TEST(FieldLaws, ExactFieldsRefuseDivisionByZero) {
  using R = TypeParam;
  if constexpr (ExactRing<R>) {
    EXPECT_THROW(static_cast<void>(R(1) / R(0)), std::domain_error);
    EXPECT_THROW(static_cast<void>(R(0) / (fraction<R>(1, 3) - fraction<R>(2, 6))), std::domain_error);
  } else {
    EXPECT_FALSE((R(1) / R(0)).is_finite());
  }
}

}  // namespace
}  // namespace subdiv::testing
