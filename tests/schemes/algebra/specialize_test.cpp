#include "schemes/algebra/specialize.h"

#include <gtest/gtest.h>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"

namespace subdiv {
namespace {

TEST(Specialize, AtOneParameter) {
  const RationalFunction s = RationalFunction::variable(2);
  const RationalFunction f = (s * s - 1) / (s - 3);
  EXPECT_EQ(specialize(f, 2, Rational(2)), Rational(-3));
  EXPECT_EQ(specialize(f.numerator(), 2, sqrt(Algebraic(2))), Algebraic(1));
  EXPECT_TRUE(specialize(f, 2, Interval(2)).contains(Rational(-3)));
  EXPECT_THROW(specialize(f, 2, Rational(3)), std::domain_error);
  EXPECT_THROW(specialize(f, 1, Rational(2)), std::domain_error);
}

}  // namespace
}  // namespace subdiv
