#include "analysis/reproduction.h"

#include <gtest/gtest.h>

#include "analysis/limit_mask.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

/// Interpolatory, from the parabola through P_{-1}, P_0, P_1 at 1/2: not symmetric.
Mask<Rational> one_sided_parabola() {
  return {2,
          Laurent<Rational>(-1, {Rational(3, 8), Rational(1), Rational(3, 4), Rational(0), Rational(-1, 8)})};
}

Mask<Rational> ternary_bspline(int degree) {
  return {3, Laurent<Rational>(3) * pow(Rational(1, 3) * smoothing_factor<Rational>(3), degree + 1)};
}

/// The defining property for one step, on data: P_j = (j + tau)^e is refined to ((i + tau) / m)^e.
bool refines_power(const Mask<Rational>& mask, const Rational& tau, int e) {
  for (int i = 0; i < mask.arity; ++i) {
    Rational value(0);
    for (int n = mask.symbol.first(); n <= mask.symbol.last(); ++n) {
      if (residue(i - n, mask.arity) != 0) continue;
      value += mask.symbol[n] * pow(Rational((i - n) / mask.arity) + tau, e);
    }
    if (value != pow((Rational(i) + tau) / Rational(mask.arity), e)) return false;
  }
  return true;
}

void expect_step(const Mask<Rational>& mask, int generation, int reproduction, const Rational& shift) {
  const Scheme<Rational> scheme = stationary("", mask);
  EXPECT_EQ(generation_degree(scheme), generation);
  EXPECT_EQ(reproduction_degree(scheme), reproduction);
  const Rational tau = parametric_shift(scheme);
  EXPECT_EQ(tau, shift);
  EXPECT_TRUE(step_reproduces(mask, reproduction));
  EXPECT_FALSE(step_reproduces(mask, reproduction + 1));
  for (int e = 1; e <= reproduction; ++e) EXPECT_TRUE(refines_power(mask, tau, e));
  EXPECT_FALSE(refines_power(mask, tau, reproduction + 1));
}

TEST(Reproduction, PrimalSchemes) {
  expect_step(bspline<Rational>(3), 3, 1, Rational(0));
  expect_step(bspline<Rational>(5), 5, 1, Rational(0));
  expect_step(jspline(Rational(1, 2)), 3, 1, Rational(0));
  expect_step(jspline(Rational(0)), 3, 3, Rational(0));
  expect_step(four_point(Rational(1, 16)), 3, 3, Rational(0));
  expect_step(four_point(Rational(1, 20)), 1, 1, Rational(0));
  expect_step(deslauriers_dubuc<Rational>(6), 5, 5, Rational(0));
}

TEST(Reproduction, DualAsymmetricAndTernarySchemes) {
  expect_step(bspline<Rational>(2), 2, 1, Rational(1, 2));
  expect_step(dyn_floater_hormann(Rational(1, 128)), 4, 3, Rational(-1, 2));
  expect_step(one_sided_parabola(), 2, 2, Rational(0));
  expect_step(ternary_bspline(2), 2, 1, Rational(3, 2));
  expect_step(ternary_bspline(1), 1, 1, Rational(1));
  const Mask<Rational> moved{2, shift(one_sided_parabola().symbol, 3)};
  expect_step(moved, 2, 2, Rational(3));
  const Mask<Rational> ternary_moved{3, shift(ternary_bspline(1).symbol, 1)};
  expect_step(ternary_moved, 1, 1, Rational(3, 2));
}

TEST(Reproduction, ConstantsMayBeLost) {
  const Mask<Rational> mask{2, Laurent<Rational>(0, {Rational(1), Rational(1, 2)})};
  EXPECT_EQ(reproduction_degree(stationary("", mask)), -1);
  EXPECT_THROW(basis_moments(stationary("", mask), 1), std::domain_error);
  EXPECT_EQ(reproduction_degree(stationary("", bspline<Rational>(0))), 0);
}

TEST(Reproduction, MomentsOfBSplines) {
  // The B-spline of degree d is the density of a sum of d + 1 uniform variables: variance (d + 1) / 12.
  for (int degree = 1; degree <= 5; ++degree) {
    const std::vector<Rational> moments = basis_moments(stationary("", bspline<Rational>(degree)), 2);
    EXPECT_EQ(moments[2] - moments[1] * moments[1], Rational(degree + 1, 12));
  }
  // Fourth moment of the cubic: 3 sigma^4 + 4 kappa_4 with kappa_4 = -1/120 of a uniform variable.
  EXPECT_EQ(basis_moments(stationary("", bspline<Rational>(3)), 4)[4], Rational(1, 3) - Rational(4, 120));
}

TEST(Reproduction, MomentsOfMixedSchemesAgreeWithIterates) {
  const Scheme<Rational> scheme =
      mixed(stationary("", jspline(Rational(-7, 4), Rational(59, 52))), stationary("", one_sided_parabola()));
  const std::vector<Rational> moments = basis_moments(scheme, 3);
  constexpr int levels = 9;
  const Laurent<Rational> iterate = iterated_symbol(scheme, levels);
  const Rational step = Rational::power_of_two(-levels);
  for (int e = 0; e <= 3; ++e) {
    Rational sum(0);
    for (int i = iterate.first(); i <= iterate.last(); ++i)
      sum += step * iterate[i] * pow(step * Rational(i), e);
    EXPECT_NEAR(sum.to_double(), moments[static_cast<std::size_t>(e)].to_double(), 1e-4);
  }
}

TEST(Reproduction, AnAnticipationStepCanRaiseTheDegree) {
  // The second moment of {J_a,b, *J_s} is (a + b + 2 s / 3) / 8.
  using F = RationalFunction;
  const F a = F::variable(0), b = F::variable(1), s = F::variable(2);
  const Scheme<F> family = mixed(stationary("", jspline(a, b)), stationary("", jspline(s)));
  EXPECT_EQ(basis_moments(family, 2)[2], (a + b + F(Rational(2, 3)) * s) / F(8));
  const Scheme<Rational> scheme =
      mixed(stationary("", jspline(Rational(-1, 2))), stationary("", jspline(Rational(3, 2))));
  EXPECT_EQ(reproduction_degree(stationary("", scheme.steps[0])), 1);
  EXPECT_EQ(reproduction_degree(stationary("", scheme.steps[1])), 1);
  EXPECT_EQ(reproduction_degree(scheme), 3);
  for (int e = 0; e <= 4; ++e) {
    for (int i = -3; i <= 5; ++i) {
      const Laurent<Rational> mask = point_mask(scheme, 2, i);
      Rational value(0);
      for (int j = mask.first(); j <= mask.last(); ++j) value += mask[j] * pow(Rational(j), e);
      EXPECT_EQ(value == pow(Rational(i, 4), e), e <= 3);
    }
  }
}

TEST(Reproduction, ShiftsAddUpOverTheSteps) {
  // The limit of P_j = j at t = 0 is -tau.
  const Scheme<Rational> scheme{
      "", {bspline<Rational>(2), one_sided_parabola(), bspline<Rational>(3), bspline<Rational>(2)}};
  const Laurent<Rational> mask = vertex_limit_mask(scheme);
  EXPECT_EQ(sum(euler_derivative(mask)), -parametric_shift(scheme));
  EXPECT_EQ(parametric_shift(scheme), Rational(1, 4) + Rational(1, 16));
}

TEST(Reproduction, Supports) {
  const auto support = [](int first, int last) { return std::pair{Rational(first), Rational(last)}; };
  EXPECT_EQ(basis_support(stationary("", jspline(Rational(1, 2)))), support(-3, 3));
  EXPECT_EQ(basis_support(stationary("", bspline<Rational>(2))), support(-1, 2));
  EXPECT_EQ(basis_support(stationary("", ternary_bspline(2))), support(0, 3));
  const Scheme<Rational> scheme =
      mixed(stationary("", bspline<Rational>(1)), stationary("", jspline(Rational(1, 2))));
  EXPECT_EQ(basis_support(scheme), support(-2, 2));
}

}  // namespace
}  // namespace subdiv
