#include "schemes/mask.h"

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using P = Laurent<Rational>;

const Scheme<Rational> anticipated =
    mixed(stationary("first", jspline(Rational(-33, 26))), stationary("rest", jspline(Rational(3, 2))));

TEST(Scheme, LastStepRepeatsForEver) {
  EXPECT_FALSE(anticipated.is_stationary());
  EXPECT_EQ(anticipated.name, "first+rest");
  EXPECT_EQ(anticipated.step(0), jspline(Rational(-33, 26)));
  EXPECT_EQ(anticipated.step(1), jspline(Rational(3, 2)));
  EXPECT_EQ(anticipated.step(100), anticipated.last());
  EXPECT_TRUE(stationary("x", bspline<Rational>(3)).is_stationary());
}

TEST(Scheme, StepsOfAMixedSchemeHaveOneArity) {
  const Mask<Rational> ternary{3, P(0, {1, 1, 1})};
  EXPECT_THROW(mixed(anticipated, stationary("ternary", ternary)), std::domain_error);
}

TEST(Scheme, IteratedSymbolIsLevelByLevelRefinement) {
  for (int k = 0; k <= 5; ++k) {
    P sequence(1);
    for (int level = 0; level < k; ++level) {
      sequence = refine_sequence(anticipated.step(static_cast<std::size_t>(level)), sequence);
    }
    EXPECT_EQ(iterated_symbol(anticipated, k), sequence);
  }
}

TEST(Scheme, IteratedBsplinesAreBsplinesOfHigherArity) {
  // Two doublings with (1+z)^(d+1) are one step of arity 4 with (1+z+z^2+z^3)^(d+1), scaled.
  const int degree = 3;
  const P twice = iterated_symbol(stationary("cubic", bspline<Rational>(degree)), 2);
  const P expected = Rational(1, 64) * pow(P(0, {1, 1, 1, 1}), degree + 1);
  EXPECT_EQ(shift(twice, -twice.first()), expected);
}

TEST(Scheme, RefinesATernarySequence) {
  // Insert two points on every edge at thirds: the ternary linear scheme.
  const Mask<Rational> linear{3, P(-2, {Rational(1, 3), Rational(2, 3), 1, Rational(2, 3), Rational(1, 3)})};
  const P refined = refine_sequence(linear, P(0, {0, 3, 9}));
  EXPECT_EQ(refined[3], Rational(3));
  EXPECT_EQ(refined[4], Rational(5));
  EXPECT_EQ(refined[5], Rational(7));
  EXPECT_EQ(refined[6], Rational(9));
}

TEST(Scheme, CoefficientsMapIntoOtherRings) {
  const Scheme<double> doubles =
      map_coefficients(anticipated, [](const Rational& q) { return q.to_double(); });
  EXPECT_EQ(doubles.steps.size(), 2U);
  EXPECT_DOUBLE_EQ(doubles.step(1).symbol[0], 0.625);
}

TEST(Scheme, GoesOnAfterSomeSteps) {
  const auto step = [](int i) { return Mask<Rational>{2, Laurent<Rational>(i)}; };
  const Scheme<Rational> scheme{"three", {step(1), step(2), step(3)}};
  for (std::size_t k = 0; k < 5; ++k) {
    const Scheme<Rational> rest = after_steps(scheme, k);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(rest.step(i), scheme.step(k + i));
  }
}

}  // namespace
}  // namespace subdiv
