#include "optimize/common_form.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using F = RationalFunction;

const F x = F::variable(0);
const F y = F::variable(1);

Problem problem(std::vector<F> residuals, Norm norm = Norm::linf) {
  return {std::move(residuals), norm, {{Rational(0), Rational(1)}, {Rational(0), Rational(1)}}, {}};
}

TEST(CommonForm, ResidualsComeBackUpToSign) {
  const std::vector<F> residuals{x / (F(2) + y), F(0), -x / (F(2) + y), y / (F(6) - F(3) * x * y), x + y};
  const CommonForm form = common_form(problem(residuals));
  EXPECT_EQ(form.numerators.size(), 3U);
  EXPECT_EQ(form.representative, (std::vector<int>{0, -1, 0, 1, 2}));
  EXPECT_EQ(form.weights, (std::vector<int>{2, 1, 1}));
  EXPECT_EQ(form.members(0), (std::vector<int>{0, 2}));
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (form.representative[i] < 0) continue;
    const F back = form.residual(form.representative[i]);
    EXPECT_TRUE(back == residuals[i] || back == -residuals[i]);
  }
  const std::vector<Rational> centre{Rational(1, 2), Rational(1, 2)};
  EXPECT_GT(form.denominator.evaluate<Rational>(centre).sign(), 0);
}

TEST(CommonForm, ObjectiveOfSquaresAndOfAbsoluteValues) {
  const std::vector<F> residuals{x / (F(2) + y), -x / (F(2) + y), F(1) - x * y};
  const CommonForm squares = objective_form(problem(residuals, Norm::l2), common_form(problem(residuals)));
  ASSERT_EQ(squares.numerators.size(), 1U);
  EXPECT_TRUE(squares.residual(0) ==
              F(2) * x * x / ((F(2) + y) * (F(2) + y)) + (F(1) - x * y) * (F(1) - x * y));
  const CommonForm sum = objective_form(problem(residuals, Norm::l1), common_form(problem(residuals)));
  EXPECT_TRUE(sum.residual(0) == F(2) * x / (F(2) + y));
}

TEST(CommonForm, PositivityIsProvedOrLeftOpen) {
  const Polynomial px = Polynomial::variable(0);
  const Polynomial py = Polynomial::variable(1);
  const std::vector<Range> box{{Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}};
  const Polynomial narrow = (px - py) * (px - py) + Polynomial(Rational(1, 50));
  EXPECT_TRUE(is_positive_on(narrow, box, 64, 20000));
  EXPECT_FALSE(is_positive_on(narrow, box, 64, 10));
  EXPECT_FALSE(is_positive_on((px - py) * (px - py), box, 64, 20000));
  EXPECT_FALSE(is_positive_on(px - Polynomial(Rational(19, 10)), box, 64, 20000));
}

}  // namespace
}  // namespace subdiv
