#include "optimize/fit_functionals.h"

#include <gtest/gtest.h>

#include "analysis/bspline_distance.h"

namespace subdiv {
namespace {

constexpr long precision = 192;
constexpr int depth = 40;

Interval ball(const Rational& q) { return Interval(q, precision); }

double value(const FitFamily& family, const FitFunctional& g, double s) {
  return evaluate<3>(family, g, ball(Rational::from_double(s))).c[0].to_double();
}

struct Case {
  int degree;
  double s;
};

class FitFunctionals : public ::testing::TestWithParam<Case> {};

TEST_P(FitFunctionals, TouchTheNormWhereTheyAreMadeAndNeverPassIt) {
  const auto [degree, s] = GetParam();
  const FitFamily family = fit_family(degree, precision);
  const Rational exact_s = Rational::from_double(s);
  for (const Norm norm : {Norm::l1, Norm::linf}) {
    const auto distance = [&](const Rational& at) {
      return norm == Norm::l1 ? bspline_distance_l1(at, degree) : bspline_distance_linf(at, degree);
    };
    const std::vector<FitFunctional> g = touching_functionals(family, norm, exact_s, depth);
    ASSERT_FALSE(g.empty());
    const Interval here = evaluate<3>(family, g.front(), ball(exact_s)).c[0];
    const Enclosure there = distance(exact_s);
    EXPECT_LE(here.lower(), there.upper);
    EXPECT_LT(abs(here.midpoint() - there.lower), Rational::power_of_two(-70)) << to_string(norm);
    for (const double other : {0.1, 1.0, 2.9}) {
      const Rational upper = distance(Rational::from_double(other)).upper;
      for (const FitFunctional& each : g) {
        EXPECT_LE(evaluate<3>(family, each, ball(Rational::from_double(other))).c[0].lower(), upper) << other;
      }
    }
  }
}

TEST_P(FitFunctionals, TaylorCoefficientsAreDifferenceQuotients) {
  const auto [degree, s] = GetParam();
  const FitFamily family = fit_family(degree, precision);
  constexpr double h = 1e-4;
  for (const Norm norm : {Norm::l1, Norm::linf}) {
    for (const FitFunctional& g : touching_functionals(family, norm, Rational::from_double(s), depth)) {
      const Taylor<Interval, 3> jet = evaluate<3>(family, g, ball(Rational::from_double(s)));
      const double up = value(family, g, s + h);
      const double middle = value(family, g, s);
      const double down = value(family, g, s - h);
      EXPECT_NEAR(jet.c[1].to_double(), (up - down) / (2 * h), 1e-7);
      EXPECT_NEAR(jet.c[2].to_double(), (up - 2 * middle + down) / (2 * h * h), 1e-6);
      // Over a ball the last coefficient holds the remainder.
      const Rational a = Rational::from_double(s);
      const Rational b = Rational::from_double(s + 0.01);
      const Taylor<Interval, 3> whole = evaluate<3>(family, g, Interval::hull(a, b, precision));
      const Interval u = ball(b) - ball(a);
      const Interval predicted = jet.c[0] + jet.c[1] * u + whole.c[2] * u * u;
      EXPECT_TRUE(predicted.contains(evaluate<3>(family, g, ball(b)).c[0]));
      EXPECT_EQ(evaluate<2>(family, g, ball(a)).c[1].to_double(), jet.c[1].to_double());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AtSeveralFits, FitFunctionals,
                         ::testing::Values(Case{2, 0.6875}, Case{4, 1.265625}, Case{1, 0.3125},
                                           Case{3, 2.0}));

TEST(FitFunctionalsByHand, WithTheRepeatingEnd) {
  // sigma = 1 on [0, 2], -1 on [2, 5/2], repeated with the sign of c_3 < 0: against the same by many pieces.
  const FitFamily family = fit_family(2, precision);
  const FitFunctional repeated{Norm::l1, {0, 2, Rational(5, 2)}, {1, -1}, -1};
  FitFunctional written{Norm::l1, {0, 2}, {1}, 0};
  int sign = -1;
  for (int k = 0; k < 30; ++k) {
    written.points.push_back(Rational(3) - Rational::power_of_two(-k - 1));
    written.signs.push_back(sign);
    sign = -sign;
  }
  written.points.emplace_back(3);
  written.signs.push_back(sign);
  for (const double s : {0.3, 0.689, 0.95}) {
    const Interval at = ball(Rational::from_double(s));
    const Taylor<Interval, 3> a = evaluate<3>(family, repeated, at);
    const Taylor<Interval, 3> b = evaluate<3>(family, written, at);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((a.c[k] - b.c[k]).to_double(), 0, 1e-25) << s << " " << k;
  }
}

TEST(FitFunctionalsByHand, DegreesBeyondTheSupport) {
  EXPECT_THROW((void)fit_family(0, precision), std::domain_error);
  EXPECT_THROW((void)fit_family(6, precision), std::domain_error);
}

}  // namespace
}  // namespace subdiv
