#include "optimize/exclusion.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);
const std::vector<Range> box{{Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}};

CommonForm form(std::vector<Polynomial> numerators, Polynomial denominator = Polynomial(1)) {
  CommonForm result;
  result.numerators = std::move(numerators);
  result.weights.assign(result.numerators.size(), 1);
  result.denominator = std::move(denominator);
  return result;
}

Exclusion run(Norm norm, const CommonForm& f, const Rational& level,
              const std::vector<Box>& neighbourhoods = {}, int boxes = 5000) {
  return exclude(norm, f, Interval(level), box, neighbourhoods, 64, boxes);
}

// max(|x - 1| , |x + 1|) >= 1 and |x - 1| + |x + 1| >= 2, both with equality on x = 0 and [-1, 1].
TEST(Exclusion, LevelsBelowTheMinimumAreExceeded) {
  const CommonForm f = form({x - Polynomial(1), x + Polynomial(1) + Polynomial(0) * y});
  EXPECT_EQ(run(Norm::linf, f, Rational(99, 100)).outcome, Exclusion::Outcome::proved);
  EXPECT_EQ(run(Norm::l1, f, Rational(199, 100)).outcome, Exclusion::Outcome::proved);
  EXPECT_EQ(run(Norm::l2, form({x * x + y * y + Polynomial(1)}), Rational(99, 100)).outcome,
            Exclusion::Outcome::proved);
}

TEST(Exclusion, LevelsAboveTheMinimumAreNot) {
  const CommonForm f = form({x - Polynomial(1), x + Polynomial(1)});
  for (const auto& [norm, level] : {std::pair{Norm::linf, Rational(11, 10)}, {Norm::l1, Rational(21, 10)}}) {
    const Exclusion result = run(norm, f, level);
    ASSERT_EQ(result.outcome, Exclusion::Outcome::better_point);
    const Rational a = abs(result.point[0] - Rational(1));
    const Rational b = abs(result.point[0] + Rational(1));
    EXPECT_LT(norm == Norm::linf ? std::max(a, b) : a + b, level);
  }
}

TEST(Exclusion, TheMinimumItselfNeedsANeighbourhood) {
  const CommonForm f = form({x * x + y * y + Polynomial(1)});
  EXPECT_EQ(run(Norm::linf, f, Rational(1)).outcome, Exclusion::Outcome::out_of_boxes);
  const Box around{{{Rational(-1, 10), Rational(1, 10)}, {Rational(-1, 10), Rational(1, 10)}}};
  EXPECT_EQ(run(Norm::linf, f, Rational(1), {around}).outcome, Exclusion::Outcome::proved);
  const Box beside{{{Rational(1, 10), Rational(2, 10)}, {Rational(-1, 10), Rational(1, 10)}}};
  EXPECT_NE(run(Norm::linf, f, Rational(1), {beside}).outcome, Exclusion::Outcome::proved);
}

TEST(Exclusion, DividesByTheDenominator) {
  // (2 + x^2) / (1 + x^2): between 6/5 and 2.
  const CommonForm f = form({Polynomial(2) + x * x}, Polynomial(1) + x * x);
  EXPECT_EQ(run(Norm::linf, f, Rational(119, 100)).outcome, Exclusion::Outcome::proved);
  EXPECT_EQ(run(Norm::linf, f, Rational(13, 10)).outcome, Exclusion::Outcome::better_point);
}

}  // namespace
}  // namespace subdiv
