#include "analysis/basis_function.h"

#include <map>

#include <gtest/gtest.h>

#include "analysis/uniform_bspline.h"
#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

/// Coefficient i of the iterate of a level, from the definition P'_i = sum of a_{i - 2j} P_j alone.
double iterate(const Scheme<double>& scheme, int level, int i, std::map<std::pair<int, int>, double>& known) {
  if (level == 0) return i == 0 ? 1 : 0;
  const auto found = known.find({level, i});
  if (found != known.end()) return found->second;
  const Laurent<double>& a = scheme.step(static_cast<std::size_t>(level - 1)).symbol;
  double sum = 0;
  for (int k = a.first(); k <= a.last(); ++k) {
    if (residue(i - k, 2) == 0) sum += a[k] * iterate(scheme, level - 1, (i - k) / 2, known);
  }
  return known[{level, i}] = sum;
}

void expect_limit_of_iterates(const Scheme<Rational>& scheme) {
  constexpr int level = 4;
  constexpr int deep = 20;
  const Scheme<double> rounded = map_coefficients(scheme, [](const Rational& q) { return q.to_double(); });
  std::map<std::pair<int, int>, double> known;
  const Laurent<Rational> values = basis_values(scheme, level);
  for (int i = -60; i <= 60; ++i) {
    EXPECT_NEAR(values[i].to_double(), iterate(rounded, deep, i << (deep - level), known), 1e-9) << i;
  }
}

TEST(BasisFunction, ValuesAreLimitsOfTheIterates) {
  const auto scheme = [](const Mask<Rational>& mask) { return stationary<Rational>("", mask); };
  expect_limit_of_iterates(scheme(jspline(Rational(689, 1000))));
  expect_limit_of_iterates(scheme(jspline(Rational(2))));
  expect_limit_of_iterates(mixed(scheme(jspline(Rational(-33, 26))), scheme(jspline(Rational(3, 2)))));
  expect_limit_of_iterates(mixed(mixed(scheme(jspline(Rational(1, 5))), scheme(jspline(Rational(37, 101)))),
                                 scheme(jspline(Rational(1, 2)))));
}

TEST(BasisFunction, OfBsplineSchemesAreBsplines) {
  for (int degree = 1; degree <= 6; ++degree) {
    const Scheme<Rational> scheme = stationary<Rational>("", bspline<Rational>(degree));
    const UniformBspline b(degree);
    const UniformBspline slope(degree - 1);
    const Rational centre((degree + 1) % 2, 2);
    const Laurent<Rational> values = basis_values(scheme, 3);
    const BasisIntegral<Rational> integral = basis_integral(scheme.last(), 3);
    for (int i = -40; i <= 40; ++i) {
      const Rational t = Rational(i, 8) - centre;
      EXPECT_EQ(values[i], b.value(t)) << degree << " at " << i;
      EXPECT_EQ(integral.at(i), b.integral(t)) << degree << " to " << i;
    }
    if (degree < 2) continue;
    const Laurent<Rational> slopes = basis_values(scheme, 3, 1);
    for (int i = -40; i <= 40; ++i) {
      const Rational t = Rational(i, 8) - centre;
      EXPECT_EQ(slopes[i], slope.value(t + Rational(1, 2)) - slope.value(t - Rational(1, 2))) << degree << i;
    }
  }
}

TEST(BasisFunction, HigherDerivatives) {
  // B_5'' by differences of B_3.
  const Laurent<Rational> second = basis_values(stationary<Rational>("", jspline(Rational(3, 2))), 2, 2);
  const UniformBspline b(3);
  for (int i = -12; i <= 12; ++i) {
    const Rational t(i, 4);
    EXPECT_EQ(second[i], b.value(t + Rational(1)) - Rational(2) * b.value(t) + b.value(t - Rational(1)));
  }
}

TEST(BasisFunction, IntegralIsTheSumOfTheValues) {
  // The trapezoid rule over each cell, for a scheme that is no B-spline.
  constexpr int level = 6;
  const Mask<Rational> mask = dyn_floater_hormann(Rational(1, 100));
  const Laurent<Rational> values = basis_values(stationary<Rational>("", mask), level);
  const BasisIntegral<Rational> integral = basis_integral(mask, level);
  double sum = 0;
  for (int i = values.first() - 1; i <= values.last(); ++i) {
    EXPECT_NEAR(integral.at(i).to_double(), sum, 1e-4) << i;
    sum += (values[i].to_double() + values[i + 1].to_double()) / 2 / (1 << level);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(BasisFunction, OverTheWholeFamily) {
  const RationalFunction s = RationalFunction::variable(0);
  const Laurent<RationalFunction> values = integer_values(jspline(s));
  const RationalFunction below = RationalFunction(12) * (RationalFunction(6) + s);
  // The limit mask that js-report 5 prints.
  EXPECT_EQ(values[0] * below, RationalFunction(72) + RationalFunction(2) * (s - RationalFunction(9)) * s);
  EXPECT_EQ(values[1] * below, RationalFunction(2) * s * (RationalFunction(8) - s));
  EXPECT_EQ(values[-2] * below, s * (s - RationalFunction(1)));
}

TEST(BasisFunction, RejectsWhatIsNotDetermined) {
  // At s = -6 the eigenvalue 1 is double.
  EXPECT_THROW(integer_values(jspline(Rational(-6))), std::domain_error);
}

}  // namespace
}  // namespace subdiv
