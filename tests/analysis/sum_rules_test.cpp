#include "analysis/sum_rules.h"

#include <gtest/gtest.h>

#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

/// Order n by another route: the moments of the residue classes agree for exponents below n, and differ at n.
template <class R>
int order_by_moments(const Mask<R>& mask) {
  for (int e = 0;; ++e) {
    for (int r = 1; r < mask.arity; ++r) {
      if (!(residue_moment(mask, r, e) == residue_moment(mask, 0, e))) return e;
    }
  }
}

template <class R>
void expect_order(const Mask<R>& mask, int order) {
  const SumRules<R> rules = sum_rules(mask);
  EXPECT_EQ(rules.order, order);
  EXPECT_EQ(order_by_moments(mask), order);
  EXPECT_EQ(pow(smoothing_factor<R>(mask.arity), rules.order) * rules.cofactor, mask.symbol);
}

Mask<Rational> ternary_bspline(int degree) {
  return {3, Laurent<Rational>(3) * pow(Rational(1, 3) * smoothing_factor<Rational>(3), degree + 1)};
}

TEST(SumRules, JsplineFamilyHasFourAndTheQuinticSix) {
  const RationalFunction s = RationalFunction::variable(0);
  expect_order(jspline(s), 4);
  // 16 S = (1+z)^4 ((s-1) + (4-2s) z + (s-1) z^2) z^-3.
  const RationalFunction sixteenth(Rational(1, 16));
  EXPECT_EQ(sum_rules(jspline(s)).cofactor,
            Laurent<RationalFunction>(
                -3, {sixteenth * (s - 1), sixteenth * (RationalFunction(4) - s - s), sixteenth * (s - 1)}));
  expect_order(jspline(Rational(3, 2)), 6);
  expect_order(jspline(Rational(2)), 4);
  expect_order(jspline(s, RationalFunction::variable(1)), 2);
}

TEST(SumRules, CatalogueSchemes) {
  for (int degree = 0; degree <= 6; ++degree) expect_order(bspline<Rational>(degree), degree + 1);
  for (int degree = 0; degree <= 4; ++degree) expect_order(ternary_bspline(degree), degree + 1);
  expect_order(four_point(RationalFunction::variable(0)), 2);
  expect_order(four_point(Rational(1, 16)), 4);
  expect_order(deslauriers_dubuc<Rational>(6), 6);
  expect_order(dyn_floater_hormann(Rational(1, 128)), 5);
}

TEST(SumRules, MixedSchemesCountTheWorstStep) {
  EXPECT_EQ(sum_rule_order(mixed(stationary("a", jspline(Rational(1), Rational(2))),
                                 stationary("b", jspline(Rational(3, 2))))),
            2);
}

TEST(SumRules, NamesTheRuleThatFails) {
  const Mask<Rational> binary{2, Laurent<Rational>(-1, {Rational(1, 4), Rational(1), Rational(1, 2)})};
  EXPECT_EQ(residue_sums(binary), (std::vector<Rational>{Rational(1), Rational(3, 4)}));
  EXPECT_EQ(violated_affine_invariance(binary),
            "the coefficients with index = 1 mod 2 add up to 3/4 instead of 1");
  EXPECT_EQ(violated_affine_invariance(jspline(Rational(7, 5))), std::nullopt);
  EXPECT_EQ(violated_affine_invariance(ternary_bspline(2)), std::nullopt);
  EXPECT_THROW(sum_rules(Mask<Rational>{}), std::domain_error);
}

}  // namespace
}  // namespace subdiv
