#include "analysis/expanding_condition.h"

#include <random>
#include <stdexcept>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "analysis/transition_matrices.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

TEST(ExpandingCondition, HoldOnlyWhereTheWordExpands) {
  const std::vector<Matrix<Function>> family =
      transition_matrices(normal_form(jspline(Function::variable(0), Function::variable(1))));
  const auto conditions = expanding_conditions(family, 3);
  EXPECT_GT(conditions.size(), 10U);
  int holding = 0;
  for (int i = -7; i <= 7; ++i) {
    for (int j = -7; j <= 7; ++j) {
      const std::vector<Rational> x{Rational(i) + Rational(1, 7), Rational(j) + Rational(1, 9)};
      std::vector<Eigen::MatrixXd> here;
      for (const auto& t : family) {
        here.push_back(t.unaryExpr([&](const Function& f) { return f.evaluate<Rational>(x).to_double(); }));
      }
      double largest = 0;
      for (const ExpandingCondition& c : conditions) {
        const double radius = product(here, c.word).eigenvalues().cwiseAbs().maxCoeff();
        largest = std::max(largest, radius);
        if (c.g.evaluate<Rational>(x).sign() > 0) continue;
        ++holding;
        EXPECT_GE(radius, 1 - 1e-12) << word_text(c.word) << " " << x[0].to_string() << " "
                                     << x[1].to_string();
      }
    }
  }
  EXPECT_GT(holding, 300);
}

TEST(ExpandingCondition, LinearFactorsGiveTheirRoots) {
  const Function x = Function::variable(0);
  const auto conditions = expanding_conditions({Matrix<Function>::Constant(1, 1, x)}, 1);
  // 1 - x <= 0 and 1 + x <= 0.
  ASSERT_EQ(conditions.size(), 2U);
  EXPECT_TRUE(conditions[0].g == Polynomial(1) - Polynomial::variable(0) ||
              conditions[0].g == Polynomial(1) + Polynomial::variable(0));
}

TEST(ExpandingCondition, DenominatorsAreCleared) {
  // |1/x| >= 1 for -1 <= x <= 1; 0 is a pole.
  const Function x = Function::variable(0);
  const auto conditions = expanding_conditions({Matrix<Function>::Constant(1, 1, Function(1) / x)}, 1);
  for (int i = -30; i <= 30; ++i) {
    if (i == 0) continue;
    const std::vector<Rational> at{Rational(i, 10)};
    bool expands = false;
    for (const ExpandingCondition& c : conditions)
      expands = expands || c.g.evaluate<Rational>(at).sign() <= 0;
    EXPECT_EQ(expands, -10 <= i && i <= 10) << i;
  }
}

TEST(RangedPolynomial, EnclosesValuesAndIsSharpToTheSecondOrder) {
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial p = x * x * x - Polynomial(Rational(2, 3)) * x * y + y * y - Polynomial(1);
  const RangedPolynomial ranged(p, 2);
  std::mt19937 random(9);
  std::uniform_int_distribution<int> grid(-40, 40);
  for (int trial = 0; trial < 100; ++trial) {
    const Rational low_x(grid(random), 13);
    const Rational low_y(grid(random), 11);
    const Rational width(1, 10);
    const Interval range =
        ranged.range({Interval::hull(low_x, low_x + width), Interval::hull(low_y, low_y + width)});
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; j <= 3; ++j) {
        const std::vector<Rational> at{low_x + width * Rational(i, 3), low_y + width * Rational(j, 3)};
        EXPECT_TRUE(range.contains(p.evaluate<Rational>(at)));
        EXPECT_NEAR(ranged.value({at[0].to_double(), at[1].to_double()}),
                    p.evaluate<Rational>(at).to_double(), 1e-11);
      }
    }
  }
  // (x - y)^2 near its zero set: the width shrinks like the square of the box.
  const RangedPolynomial square((x - y) * (x - y), 2);
  const Rational h(1, 1000);
  EXPECT_LT(square.range({Interval::hull(1, Rational(1) + h), Interval::hull(1, Rational(1) + h)}).radius(),
            1e-5);
  EXPECT_THROW(RangedPolynomial(p, 1), std::domain_error);
}

}  // namespace
}  // namespace subdiv
