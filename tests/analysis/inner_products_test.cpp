#include "analysis/inner_products.h"

#include <gtest/gtest.h>

#include "analysis/basis_function.h"
#include "analysis/uniform_bspline.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

Rational at(const RationalFunction& f, const Rational& s) {
  const std::vector<Rational> point{s};
  return f.evaluate<Rational>(point);
}

/// A B-spline's scheme of arity 3: 3 ((1+z+z^2)/3)^(d+1), centred, d odd.
Mask<Rational> ternary_bspline(int degree) {
  const Laurent<Rational> average =
      Laurent<Rational>::constant(Rational(1, 3)) * smoothing_factor<Rational>(3);
  return {3, shift(Laurent<Rational>(3) * pow(average, degree + 1), -(degree + 1))};
}

TEST(InnerProducts, OfBsplinesAreValuesOfAHigherBspline) {
  // <B_d, B_e(. - k)> = B_{d+e+1}(k): convolution adds the orders. Even degrees of this scheme are centred at
  // 1/2.
  for (int d = 1; d <= 5; ++d) {
    for (int e = 1; e <= 4; ++e) {
      const Laurent<Rational> g = inner_products(bspline<Rational>(d), bspline<Rational>(e));
      const UniformBspline expected(d + e + 1);
      const Rational centres = Rational((d + 1) % 2, 2) - Rational((e + 1) % 2, 2);
      for (int k = -6; k <= 6; ++k) EXPECT_EQ(g[k], expected.value(Rational(k) - centres)) << d << e << k;
    }
  }
}

TEST(InnerProducts, WithADerivativeAreDifferencesOfBsplines) {
  // The integral of B_d(t) B_e'(t - k) is -B_{d+e+1}'(k) = B_{d+e}(k - 1/2) - B_{d+e}(k + 1/2).
  for (int d = 1; d <= 5; d += 2) {
    for (int e = 1; e <= 5; e += 2) {
      const Laurent<Rational> g = inner_products(bspline<Rational>(d), bspline<Rational>(e), 1);
      const UniformBspline lower(d + e);
      for (int k = -6; k <= 6; ++k) {
        EXPECT_EQ(g[k], lower.value(Rational(2 * k - 1, 2)) - lower.value(Rational(2 * k + 1, 2)))
            << d << e << k;
      }
    }
  }
}

TEST(InnerProducts, OfArityThreeAgreeWithArityTwo) {
  for (int degree = 1; degree <= 5; degree += 2) {
    for (int derivative = 0; derivative <= 1; ++derivative) {
      EXPECT_EQ(inner_products(ternary_bspline(degree), ternary_bspline(3), derivative),
                inner_products(bspline<Rational>(degree), bspline<Rational>(3), derivative));
    }
  }
}

TEST(InnerProducts, OfTheJsplineFamily) {
  const Laurent<RationalFunction> g =
      inner_products(jspline(RationalFunction::variable(0)), jspline(RationalFunction::variable(0)));
  EXPECT_EQ(at(g[0], 1), Rational(151, 315));                      // B_7(0)
  EXPECT_EQ(at(g[0], Rational(3, 2)), Rational(655177, 1663200));  // B_11(0)
  EXPECT_EQ(g[2], g[-2]);
  RationalFunction total;
  for (const RationalFunction& c : g.coefficients()) total += c;
  EXPECT_EQ(total, RationalFunction(1));
}

TEST(InnerProducts, AgreeWithSumsOfBasisValues) {
  // A second route that knows nothing of the refinement of inner products: the trapezoid rule.
  constexpr int level = 7;
  const Scheme<Rational> scheme = stationary<Rational>("", jspline(Rational(1, 3)));
  const Scheme<Rational> other =
      mixed(stationary<Rational>("", jspline(Rational(-1, 2), Rational(2, 3))), scheme);
  const Laurent<Rational> u = basis_values(scheme, level);
  const Laurent<Rational> v = basis_values(other, level);
  const Laurent<Rational> dv = basis_values(other, level, 1);
  const Laurent<Rational> g = inner_products(scheme, other);
  const Laurent<Rational> h = inner_products(scheme, other, 1);
  for (int k = -4; k <= 4; ++k) {
    double sum = 0;
    double derivative = 0;
    for (int i = u.first(); i <= u.last(); ++i) {
      const double here = u[i].to_double() / (1 << level);
      sum += here * v[i - (k << level)].to_double();
      derivative += here * dv[i - (k << level)].to_double();
    }
    EXPECT_NEAR(g[k].to_double(), sum, 1e-6) << k;
    EXPECT_NEAR(h[k].to_double(), derivative, 1e-5) << k;
  }
}

TEST(InnerProducts, RejectWhatTheEquationsDoNotDetermine) {
  EXPECT_THROW(inner_products(bspline<Rational>(2), ternary_bspline(3)), std::domain_error);
  EXPECT_THROW(inner_products(bspline<Rational>(2), bspline<Rational>(2), 2), std::domain_error);
  // 2 (1 + z^2) / 2: the limit splits in two that are not linked.
  EXPECT_THROW(inner_products(Mask<Rational>{2, Laurent<Rational>(0, {1, 0, 0, 1})},
                              Mask<Rational>{2, Laurent<Rational>(0, {1, 0, 0, 1})}, 1),
               std::domain_error);
}

}  // namespace
}  // namespace subdiv
