#include "analysis/limit_mask.h"

#include <gtest/gtest.h>

#include "analysis/reproduction.h"
#include "schemes/algebra/jet.h"
#include "schemes/algebra/real.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/analysis/refine_locally.h"

namespace subdiv {
namespace {

using F = RationalFunction;
using Mask0 = Laurent<Rational>;

const F s = F::variable(0);

Mask<Rational> ternary_bspline(int degree, int first) {
  return {3, shift(Laurent<Rational>(3) * pow(Rational(1, 3) * smoothing_factor<Rational>(3), degree + 1),
                   first)};
}

/// Irregular control points, the same for every test.
Rational control(int j) { return {((j * j + 3 * j + 7) * (j + 20)) % 23 - 9, 5}; }

Rational apply(const Laurent<Rational>& mask, int offset = 0) {
  Rational value(0);
  for (int j = mask.first(); j <= mask.last(); ++j) value += mask[j] * control(j + offset);
  return value;
}

/// Points around the parameter 0 after `levels` steps, in 400-bit intervals.
std::map<int, Interval> iterate(const Scheme<Rational>& scheme, int levels) {
  constexpr long precision = 400;
  const auto interval = [](const Rational& q) { return Interval(q, precision); };
  return testing::refine_locally(map_coefficients(scheme, interval), levels, 3,
                                 [&](int j) { return interval(control(j)); });
}

/// Limit, tangent and (optionally) second-derivative masks against differences of the points after 60 steps.
void expect_limits(const Scheme<Rational>& scheme, int derivatives) {
  constexpr int levels = 60;
  std::map<int, Interval> points = iterate(scheme, levels);
  const Rational density = pow(Rational(scheme.arity()), levels);
  constexpr double tolerance = 1e-6;
  EXPECT_NEAR(apply(vertex_limit_mask(scheme)).to_double(), points.at(0).to_double(), tolerance);
  if (derivatives >= 1) {
    const Rational difference = density * (points.at(1).midpoint() - points.at(0).midpoint());
    EXPECT_NEAR(apply(vertex_tangent_mask(scheme)).to_double(), difference.to_double(), tolerance);
  }
  if (derivatives >= 2) {
    const Rational second =
        points.at(1).midpoint() - Rational(2) * points.at(0).midpoint() + points.at(-1).midpoint();
    EXPECT_NEAR(apply(point_mask(scheme, 0, 0, 2)).to_double(), (density * density * second).to_double(),
                tolerance);
  }
}

TEST(LimitMask, OfJsplines) {
  // js-report 5 and 11.
  const F below = F(12) * (F(6) + s);
  const F outer = (s - 1) * s / below;
  const F inner = F(2) * s * (F(8) - s) / below;
  EXPECT_EQ(limit_mask(jspline(s)),
            Laurent<F>(-2, {outer, inner, (F(72) + F(2) * (s - 9) * s) / below, inner, outer}));
  const F twelfth(Rational(1, 12));
  EXPECT_EQ(tangent_mask(jspline(s)), Laurent<F>(-2, {twelfth * (F(1) - s), twelfth * F(2) * (s - 4), F(0),
                                                      -twelfth * F(2) * (s - 4), twelfth * (s - 1)}));
  EXPECT_EQ(
      limit_mask(jspline(Rational(3, 2))),
      Mask0(-2, {Rational(1, 120), Rational(13, 60), Rational(11, 20), Rational(13, 60), Rational(1, 120)}));
}

TEST(LimitMask, AgreesWithSixtyRefinements) {
  for (const Rational& value :
       {Rational(-1, 2), Rational(1, 2), Rational(1), Rational(3, 2), Rational(11, 4)}) {
    expect_limits(stationary("", jspline(value)), value.sign() < 0 ? 1 : 2);
  }
  expect_limits(stationary("", four_point(Rational(1, 16))), 1);
  expect_limits(stationary("", deslauriers_dubuc<Rational>(6)), 2);
  expect_limits(stationary("", bspline<Rational>(2)), 1);
  expect_limits(stationary("", bspline<Rational>(4)), 2);
  expect_limits(stationary("", dyn_floater_hormann(Rational(1, 128))), 2);
  expect_limits(stationary("", ternary_bspline(2, -2)), 1);
  expect_limits(stationary("", ternary_bspline(3, -4)), 2);
  // An asymmetric mask: quadratic B-spline times an uneven average.
  const Mask<Rational> skew{2, bspline<Rational>(2).symbol * Mask0(0, {Rational(2, 3), Rational(1, 3)})};
  expect_limits(stationary("", skew), 1);
}

TEST(LimitMask, OfMixedSchemesAgreesWithSixtyRefinements) {
  const Scheme<Rational> anticipation = stationary("", jspline(Rational(-7, 4), Rational(59, 52)));
  expect_limits(mixed(anticipation, stationary("", jspline(Rational(3, 2)))), 2);
  expect_limits({"", {bspline<Rational>(2), jspline(Rational(1, 3), Rational(2)), bspline<Rational>(4)}}, 2);
  expect_limits({"", {ternary_bspline(1, -1), ternary_bspline(3, -4)}}, 2);
}

TEST(LimitMask, DyadicPointsAreLimitsOfRefinedPoints) {
  // The limit at i / 2^k is the limit mask of the remaining scheme, applied to the points after k steps.
  const Scheme<Rational> scheme{
      "", {jspline(Rational(-1), Rational(2)), bspline<Rational>(3), jspline(Rational(1, 2))}};
  Laurent<Rational> points(-40, [] {
    std::vector<Rational> values;
    for (int j = -40; j <= 40; ++j) values.push_back(control(j));
    return values;
  }());
  for (int level = 0; level <= 4; ++level) {
    const auto skipped = std::min<std::ptrdiff_t>(level, 2);
    const Scheme<Rational> rest{"", {scheme.steps.begin() + skipped, scheme.steps.end()}};
    for (int derivative = 0; derivative <= 2; ++derivative) {
      const Laurent<Rational> mask = vertex_limit_mask(rest);
      const Laurent<Rational> tail = point_mask(rest, 0, 0, derivative);
      for (int i = -3; i <= 5; ++i) {
        Rational value(0);
        for (int j = tail.first(); j <= tail.last(); ++j) value += tail[j] * points[i + j];
        EXPECT_EQ(apply(point_mask(scheme, level, i, derivative)),
                  value * pow(Rational(2), static_cast<long>(level) * derivative));
      }
    }
    points = refine_sequence(scheme.step(static_cast<std::size_t>(level)), points);
  }
}

TEST(LimitMask, PrintedVertexAndEdgeInterpolation) {
  // js-report 6 and 7.
  const Scheme<Rational> quintic = stationary("", jspline(Rational(3, 2)));
  EXPECT_EQ(vertex_limit_mask(mixed(stationary("", jspline(Rational(-7, 4), Rational(59, 52))), quintic)),
            Mask0(1));
  const Mask0 midpoint(0, {Rational(1, 2), Rational(1, 2)});
  EXPECT_EQ(
      edge_limit_mask(mixed(stationary("", jspline(Rational(2, 3))), stationary("", jspline(Rational(1))))),
      midpoint);
  // A quadratic B-spline's vertices, at integers, are the mid-edge points.
  EXPECT_EQ(vertex_limit_mask(stationary("", bspline<Rational>(2))), shift(midpoint, -1));
}

TEST(LimitMask, NormalisedByPolynomialData) {
  for (const Mask<Rational>& mask : {jspline(Rational(1, 2)), bspline<Rational>(4), ternary_bspline(3, -4)}) {
    const Scheme<Rational> scheme = stationary("", mask);
    EXPECT_EQ(sum(limit_mask(mask)), Rational(1));
    EXPECT_EQ(sum(euler_derivative(limit_mask(mask))), -parametric_shift(scheme));
    EXPECT_EQ(sum(tangent_mask(mask)), Rational(0));
    EXPECT_EQ(sum(euler_derivative(tangent_mask(mask))), Rational(1));
    EXPECT_EQ(sum(euler_derivative(euler_derivative(derivative_mask(mask, 2)))), Rational(2));
  }
}

template <class R>
class LimitMaskOver : public ::testing::Test {};
using Fields = ::testing::Types<double, Interval, Real, Algebraic, ceres::Jet<double, 1>>;
TYPED_TEST_SUITE(LimitMaskOver, Fields);

template <class R>
double as_double(const R& x) {
  if constexpr (requires { x.a; }) return x.a;
  if constexpr (requires { x.to_double(); }) return x.to_double();
  if constexpr (requires { x.to_interval(); }) return x.to_interval().to_double();
  if constexpr (std::is_convertible_v<R, double> || std::is_same_v<R, Real>) return static_cast<double>(x);
}

TYPED_TEST(LimitMaskOver, EveryField) {
  using R = TypeParam;
  const Rational value(-13, 20);
  for (int derivative = 0; derivative <= 1; ++derivative) {
    const Laurent<Rational> exact = derivative_mask(jspline(value), derivative);
    const Laurent<R> mask = derivative_mask(jspline(from_rational<R>(value)), derivative);
    for (int j = -3; j <= 3; ++j) EXPECT_NEAR(as_double(mask[j]), exact[j].to_double(), 1e-14);
  }
}

TEST(LimitMask, IntervalsEncloseAndJetsDifferentiate) {
  const Rational value(2, 7);
  const Laurent<Rational> exact = limit_mask(jspline(value));
  const Interval box = Interval::hull(value - Rational(1, 100), value + Rational(1, 100));
  const Laurent<Interval> enclosed = limit_mask(jspline(box));
  using Jet = ceres::Jet<double, 1>;
  const Laurent<Jet> differentiated = limit_mask(jspline(Jet(value.to_double(), 0)));
  const Laurent<F> symbolic = limit_mask(jspline(s));
  for (int j = -2; j <= 2; ++j) {
    EXPECT_TRUE(enclosed[j].contains(exact[j]));
    EXPECT_LT(enclosed[j].radius(), 0.3);
    const std::vector<Rational> point{value};
    EXPECT_NEAR(differentiated[j].v[0],
                symbolic[j].derivative(0).evaluate(std::span<const Rational>(point)).to_double(), 1e-13);
  }
}

std::string reason(const Mask<Rational>& mask, int derivative) {
  try {
    derivative_mask(mask, derivative);
  } catch (const std::domain_error& e) {
    return e.what();
  }
  return "none";
}

TEST(LimitMask, SaysWhyThereIsNone) {
  EXPECT_EQ(reason(jspline(Rational(-6)), 0),
            "limit mask: 1 is not a simple eigenvalue of the subdivision matrix (multiplicity 2)");
  EXPECT_EQ(reason(jspline(Rational(-2)), 1),
            "tangent mask: 1/2 is not a simple eigenvalue of the subdivision matrix (multiplicity 2)");
  EXPECT_EQ(
      reason(four_point(Rational(1, 16)), 2),
      "mask of derivative 2: 1/4 is not a simple eigenvalue of the subdivision matrix (multiplicity 2)");
  EXPECT_EQ(reason(jspline(Rational(1, 2)), 5),
            "mask of derivative 5: 1/32 is no eigenvalue of the subdivision matrix");
  EXPECT_EQ(reason(bspline<Rational>(0), 0),
            "limit mask: 1 is not a simple eigenvalue of the subdivision matrix (multiplicity 2)");
  EXPECT_EQ(reason(Mask<Rational>{2, Mask0(-1, {Rational(1, 4), Rational(1), Rational(1, 4)})}, 1),
            "tangent mask: 1/2 is no eigenvalue of the subdivision matrix");
  // (2-s)/8 = 1/16 at s = 3/2 belongs to a polynomial; at s = 2 the eigenvalue (s-1)/16 does not.
  EXPECT_EQ(reason(jspline(Rational(3, 2)), 4), "none");
  EXPECT_NE(reason(jspline(Rational(2)), 4), "none");
  EXPECT_THROW(limit_mask(jspline(-6.0)), std::domain_error);
  EXPECT_THROW(limit_mask(jspline(Interval(-6))), std::domain_error);
}

TEST(LimitMask, TooFewSumRulesForADerivative) {
  // One sum rule: 1/4 is a simple eigenvalue, but not that of quadratic data.
  const Mask<Rational> mask{2,
                            Mask0(-1, {Rational(13, 20), Rational(3, 4), Rational(7, 20), Rational(1, 4)})};
  EXPECT_EQ(reason(mask, 0), "none");
  EXPECT_EQ(reason(mask, 2), "mask of derivative 2: too few sum rules hold for a derivative of this order");
}

}  // namespace
}  // namespace subdiv
