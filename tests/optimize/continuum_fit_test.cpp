#include "optimize/continuum_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "analysis/basis_function.h"
#include "schemes/bspline.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const RationalFunction s = RationalFunction::variable(0);

Scheme<RationalFunction> family() { return stationary<RationalFunction>("jspline", jspline(s)); }

Rational at(const RationalFunction& f, const Rational& x) {
  const std::vector<Rational> point{x};
  return f.evaluate<Rational>(point);
}

/// Norms of phi_x - B_d from values at multiples of 2^-level, in double: refinement of the values at
/// integers, which are the limit mask printed in js-report 5.
struct Norms {
  double l1 = 0;
  double l2_squared = 0;
  double linf = 0;
};

Norms sampled_norms(double x, int degree, int level) {
  const double below = 12 * (6 + x);
  const double one = 2 * x * (8 - x) / below;
  const double two = x * (x - 1) / below;
  std::vector<double> phi{0, two, one, (72 + 2 * (x - 9) * x) / below, one, two, 0};
  const std::vector<double> a{(x - 1) / 16, x / 8, (9 - x) / 16, 1 - x / 4,
                              (9 - x) / 16, x / 8, (x - 1) / 16};
  int unit = 1;
  for (int k = 0; k < level; ++k, unit *= 2) {
    // phi(i / 2u) = sum of a_j phi(i / u - j); index 0 is t = -3.
    std::vector<double> fine(static_cast<std::size_t>(12 * unit + 1));
    for (int i = -6 * unit; i <= 6 * unit; ++i) {
      double sum = 0;
      for (int j = -3; j <= 3; ++j) {
        const int place = i - j * unit;
        if (std::abs(place) <= 3 * unit) {
          sum += a[static_cast<std::size_t>(j + 3)] * phi[static_cast<std::size_t>(place + 3 * unit)];
        }
      }
      fine[static_cast<std::size_t>(i + 6 * unit)] = sum;
    }
    phi = std::move(fine);
  }
  const auto b = [&](double t) {
    double sum = 0;
    double binomial = 1;
    double factorial = 1;
    for (int j = 2; j <= degree; ++j) factorial *= j;
    for (int j = 0; j <= degree + 1; ++j) {
      sum += (j % 2 == 0 ? 1 : -1) * binomial * std::pow(std::max(0.0, t + (degree + 1) / 2.0 - j), degree);
      binomial *= static_cast<double>(degree + 1 - j) / (j + 1);
    }
    return sum / factorial;
  };
  Norms norms;
  for (std::size_t i = 0; i < phi.size(); ++i) {
    const double e = phi[i] - b(static_cast<double>(i) / unit - 3);
    norms.l1 += std::abs(e) / unit;
    norms.l2_squared += e * e / unit;
    norms.linf = std::max(norms.linf, std::abs(e));
  }
  return norms;
}

TEST(SquaredDistance, IsTheSumOfSquaredSamples) {
  for (const int degree : {1, 2, 3, 4, 5, 6}) {
    const RationalFunction e = squared_distance(family(), degree, 0);
    for (const double x : {0.25, 0.6875, 1.25, 2.5}) {
      // The support of B_6 is wider than the samples': the rest is far below the tolerance.
      EXPECT_NEAR(at(e, Rational::from_double(x)).to_double(), sampled_norms(x, degree, 9).l2_squared, 2e-6)
          << degree << " " << x;
    }
  }
}

TEST(SquaredDistance, ClosedFormForQuadraticBsplines) {
  // Derived by hand from the linear systems of the inner products.
  const auto power = [&](int n) {
    RationalFunction result(1);
    for (int i = 0; i < n; ++i) result *= s;
    return result;
  };
  const auto polynomial = [&](const std::vector<long>& coefficients) {
    RationalFunction sum(0);
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      sum += fraction<RationalFunction>(coefficients[i], 1) * power(static_cast<int>(i));
    }
    return sum;
  };
  const RationalFunction denominator = polynomial({-16056, -276, 82, -7, 1});
  EXPECT_EQ(squared_distance(family(), 2, 0) * denominator * RationalFunction(2903040),
            polynomial({-2087974584, 6821224236, -6722160918, 1889858061, -265791377, 20331619, -775719,
                        11312, -70}));
}

TEST(SquaredDistance, OfDualAndMixedSchemes) {
  const auto scheme = [](int degree) {
    return stationary<RationalFunction>("", bspline<RationalFunction>(degree));
  };
  EXPECT_TRUE(squared_distance(scheme(2), 2, Rational(1, 2)).is_zero());
  EXPECT_TRUE(squared_distance(scheme(3), 3, Rational(0)).is_zero());
  EXPECT_TRUE(squared_distance(bspline_at(2, Rational(0)), 2, Rational(0)).is_zero());
  EXPECT_TRUE(squared_distance(bspline_at(3, Rational(5, 2)), 3, Rational(5, 2)).is_zero());
  EXPECT_FALSE(squared_distance(scheme(2), 2, Rational(0)).is_zero());
  // One step J_1, then J_2 for ever, is the quartic B-spline.
  const auto j = [](int n) { return stationary<RationalFunction>("", jspline(RationalFunction(n))); };
  EXPECT_TRUE(squared_distance(mixed(j(1), j(2)), 4, Rational(0)).is_zero());
  EXPECT_THROW((void)bspline_at(2, Rational(1, 3)), std::domain_error);
}

/// Is x the minimum, judged by samples of the norm beside it?
void expect_least(double x, const std::function<double(double)>& norm, double tolerance) {
  const double here = norm(x);
  for (const double step : {0.02, 0.1, 0.3, 1.0}) {
    EXPECT_LT(here, norm(x + step) + tolerance);
    EXPECT_LT(here, norm(x - step) + tolerance);
  }
}

struct Case {
  int degree;
  Norm norm;
};

class ContinuumFit : public ::testing::TestWithParam<Case> {};

TEST_P(ContinuumFit, IsTheLeastOfTheSampledNorms) {
  const auto [degree, norm] = GetParam();
  Options options;
  options.width = Rational(1, 10000000000);
  const Summary found = minimise_continuum_fit(degree, norm, jspline_fit_range(), options);
  ASSERT_EQ(found.termination, Termination::proved) << found.message;
  EXPECT_LE(found.minimiser[0].width(), options.width);
  EXPECT_EQ(found.minimiser[0].rigour, Rigour::certified);
  EXPECT_GT(found.boxes, 0);
  constexpr int level = 9;
  const auto sampled = [&](double x) {
    const Norms norms = sampled_norms(x, degree, level);
    return norm == Norm::l1 ? norms.l1 : norms.linf;
  };
  const double x = found.minimiser[0].midpoint().to_double();
  EXPECT_NEAR(found.minimum.midpoint().to_double(), sampled(x), 1e-5);
  EXPECT_LE(found.minimum.width().to_double(), 1e-9);
  expect_least(x, sampled, 0);
}

INSTANTIATE_TEST_SUITE_P(OfTheDocuments, ContinuumFit,
                         ::testing::Values(Case{2, Norm::l1}, Case{4, Norm::l1}, Case{1, Norm::l1},
                                           Case{2, Norm::linf}, Case{4, Norm::linf}, Case{1, Norm::linf}));

TEST(ContinuumFitEnds, MembersThatAreBsplinesAreFoundExactly) {
  for (const Norm norm : {Norm::l1, Norm::linf}) {
    const Summary cubic = minimise_continuum_fit(3, norm, jspline_fit_range());
    EXPECT_EQ(cubic.termination, Termination::proved);
    EXPECT_EQ(cubic.minimiser[0].exact, "1");
    EXPECT_EQ(cubic.minimum.exact, "0");
    EXPECT_EQ(minimise_continuum_fit(5, norm, jspline_fit_range()).minimiser[0].exact, "3/2");
  }
}

TEST(ContinuumFitEnds, ARangeWithoutTheMinimumIsNotProved) {
  const Summary found = minimise_continuum_fit(2, Norm::l1, {Rational(1), Rational(2)});
  EXPECT_EQ(found.termination, Termination::not_isolated);
}

TEST(ContinuumFitEnds, BadInputIsNamed) {
  const Range range = jspline_fit_range();
  EXPECT_THROW((void)minimise_continuum_fit(6, Norm::l1, range), InputError);
  EXPECT_THROW((void)minimise_continuum_fit(0, Norm::linf, range), InputError);
  EXPECT_THROW((void)minimise_continuum_fit(2, Norm::l2, range), InputError);
  EXPECT_THROW((void)minimise_continuum_fit(2, Norm::l1, {Rational(-3), Rational(1)}), InputError);
  EXPECT_THROW((void)minimise_continuum_fit(2, Norm::l1, {Rational(2), Rational(1)}), InputError);
}

TEST(OnlyZero, FindsAZeroThatIsAlone) {
  const RationalFunction square = (s - RationalFunction(1)) * (s - RationalFunction(1));
  const auto found = only_zero(square, {Rational(-2), Rational(2)});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->minimiser[0].exact, "1");
  EXPECT_EQ(found->minimum.exact, "0");
  EXPECT_FALSE(only_zero(square, {Rational(-2), Rational(0)}));
  EXPECT_FALSE(only_zero(square * s * s, {Rational(-2), Rational(2)}));  // two
  EXPECT_FALSE(only_zero(square + RationalFunction(1), {Rational(-2), Rational(2)}));
  EXPECT_FALSE(only_zero(RationalFunction(0), {Rational(-2), Rational(2)}));
}

}  // namespace
}  // namespace subdiv
