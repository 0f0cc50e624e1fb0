#include "analysis/mesh/condition_end.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "schemes/algebra/univariate.h"
#include "schemes/mesh/jspline_mesh.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);

/// The second route: single parameters next to the end, decided by counting roots.
TEST(ConditionEnd, SeparatesParametersThatAreDecidedOneByOne) {
  for (const bool literal : {false, true}) {
    const MeshScheme<F> scheme = literal ? jspline_mesh_literal<F>(s) : jspline_mesh<F>(s);
    const ModeEquation turning = turning_modes(scheme);
    for (const int n : {3, 5, 6, 8, 30}) {
      const SpectralCondition condition(turning, invariant_mode(scheme, n), n);
      const auto cells = condition.cells(Rational(-2), Rational(6), Rational(1, 1L << 14));
      for (std::size_t i = 1; i + 1 < cells.size(); ++i) {
        if (cells[i].holds != Decision::undecided) continue;
        const auto end = condition_end(condition, cells[i].lower, cells[i].upper);
        ASSERT_TRUE(end.has_value()) << literal << " " << n << " " << cells[i].lower.to_string();
        EXPECT_LT(end->at.radius(), 1e-35);
        const Rational step = Rational(1) / pow(Rational(10), 10);
        const Decision inside =
            condition.decide(end->holds_below ? end->at.lower() - step : end->at.upper() + step);
        const Decision outside =
            condition.decide(end->holds_below ? end->at.upper() + step : end->at.lower() - step);
        EXPECT_EQ(inside, Decision::yes) << n;
        EXPECT_EQ(outside, Decision::no) << n;
      }
    }
  }
}

/// A third route at valence 3, cos(2 pi/3) = -1/2: a common root of modes 1 and 0, x there and +-x here, is a
/// zero of their resultant.
TEST(ConditionEnd, IsAZeroOfAResultantAtValenceThree) {
  const auto largest = [](const ModeEquation& equation) {
    return std::ranges::max_element(equation.factors, {},
                                    [](const auto& f) { return f.first.degree(eigenvalue_variable); })
        ->first;
  };
  for (const bool literal : {false, true}) {
    const MeshScheme<F> scheme = literal ? jspline_mesh_literal<F>(s) : jspline_mesh<F>(s);
    const ModeEquation turning = turning_modes(scheme);
    const ModeEquation invariant = invariant_mode(scheme, 3);
    const SpectralCondition condition(turning, invariant, 3);
    const auto cells = condition.cells(Rational(-2), Rational(6), Rational(1, 1L << 14));
    ASSERT_EQ(cells.size(), 5U);
    for (const bool lower : {true, false}) {
      const ConditionCell& cell = cells[lower ? 1 : 3];
      const auto end = condition_end(condition, cell.lower, cell.upper);
      ASSERT_TRUE(end.has_value());
      EXPECT_EQ(end->rival.mode, 0);
      const Polynomial x = Polynomial(lower ? 1 : -1) * Polynomial::variable(eigenvalue_variable);
      const Polynomial tie =
          resultant(largest(turning).substitute(turn_variable, Polynomial(Rational(-1, 2))),
                    largest(invariant).substitute(eigenvalue_variable, x), eigenvalue_variable);
      const UnivariatePolynomial in_s(tie, 0);
      EXPECT_LT((in_s.evaluate(end->at.lower()) * in_s.evaluate(end->at.upper())).sign(), 0);
    }
  }
}

/// Where the condition holds throughout, there is no end.
TEST(ConditionEnd, NothingWhereNothingEnds) {
  const MeshScheme<F> scheme = jspline_mesh<F>(s);
  const SpectralCondition condition(turning_modes(scheme), invariant_mode(scheme, 5), 5);
  EXPECT_FALSE(condition_end(condition, Rational(1, 2), Rational(33, 64)).has_value());
}

}  // namespace
}  // namespace subdiv
