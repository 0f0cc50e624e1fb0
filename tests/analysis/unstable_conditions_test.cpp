#include "analysis/unstable_conditions.h"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/transition_matrices.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);

/// The conditions as "order: equation equation", equations up to a constant.
std::set<std::string> conditions(const Laurent<Function>& b) {
  std::set<std::string> result;
  for (const UnstableCondition& c : unstable_conditions(b)) {
    std::string text = std::to_string(c.order) + ":";
    for (const Polynomial& e : c.equations) {
      text += " " + (e * Polynomial(Rational(1) / e.terms().front().coefficient)).to_string();
    }
    result.insert(text);
  }
  return result;
}

std::set<std::string> text(std::initializer_list<std::pair<int, Polynomial>> expected) {
  std::set<std::string> result;
  for (const auto& [order, equation] : expected) {
    result.insert(std::to_string(order) + ": " +
                  (equation * Polynomial(Rational(1) / equation.terms().front().coefficient)).to_string());
  }
  return result;
}

TEST(UnstableConditions, JSplines) {
  // b = p + q z + p z^2: opposite roots for q = 0 (s = 2), the cycle of order 3 for q = -p (s = 3).
  const Laurent<Function> one = normal_form(jspline(Function::variable(0))).b;
  EXPECT_EQ(conditions(one), text({{0, x - Polynomial(2)}, {3, x - Polynomial(3)}}));
}

TEST(UnstableConditions, TwoParameterJSplines) {
  const auto found =
      unstable_conditions(normal_form(jspline(Function::variable(0), Function::variable(1))).b);
  ASSERT_EQ(found.size(), 4U);
  std::set<std::string> lines;
  for (const UnstableCondition& c : found) {
    if (c.order != 5) lines.insert(std::to_string(c.order) + ": " + c.equations.at(0).to_string());
  }
  const Polynomial sum = Polynomial(2) * x + y - Polynomial(9);
  EXPECT_EQ(lines, (std::set<std::string>{"0: " + (x - Polynomial(2)).to_string(),
                                          "0: " + (x - y + Polynomial(1)).to_string(),
                                          "3: " + (sum * Polynomial(Rational(1, 2))).to_string()}));
  // The cycle of order 5 fills b: one point, (4, 9).
  const std::vector<Rational> point{4, 9};
  for (const UnstableCondition& c : found) {
    if (c.order != 5) continue;
    ASSERT_EQ(c.equations.size(), 2U);
    for (const Polynomial& e : c.equations) EXPECT_EQ(e.evaluate<Rational>(point), Rational(0));
  }
}

TEST(UnstableConditions, DynFloaterHormann) {
  const Laurent<Function> b = normal_form(dyn_floater_hormann(Function::variable(0))).b;
  EXPECT_EQ(conditions(b),
            text({{0, x}, {0, x + Polynomial(Rational(1, 16))}, {3, x + Polynomial(Rational(1, 28))}}));
}

TEST(UnstableConditions, AlwaysAndNever) {
  // (1 + z^2)/2 has the roots i and -i for all parameters: a condition without equations.
  const Laurent<Function> even(0, {fraction<Function>(1, 2), Function(0), fraction<Function>(1, 2)});
  const auto always = unstable_conditions(even);
  ASSERT_EQ(always.size(), 1U);
  EXPECT_TRUE(always[0].equations.empty());
  // 1 - z + z^2: the cycle of order 3, whatever the parameters.
  const auto cycle = unstable_conditions(Laurent<Function>(-1, {1, -1, 1}));
  ASSERT_EQ(cycle.size(), 1U);
  EXPECT_EQ(cycle[0].order, 3);
  EXPECT_TRUE(cycle[0].equations.empty());
  EXPECT_TRUE(unstable_conditions(Laurent<Function>(1)).empty());
  EXPECT_TRUE(unstable_conditions(Laurent<Function>(0, {3, 1})).empty());
  EXPECT_THROW((void)unstable_conditions(Laurent<Function>()), std::domain_error);
  EXPECT_THROW((void)unstable_conditions(Laurent<Function>(0, {1, 1, 1, 1, 1, 1})), std::domain_error);
}

}  // namespace
}  // namespace subdiv
