#include "analysis/retrofit_polygon.h"

#include <chrono>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "analysis/limit_mask.h"
#include "analysis/retrofit.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

Rational q(long p, long denominator = 1) { return {p, denominator}; }
Scheme<Rational> j(const Rational& s) { return stationary("J", jspline(s)); }

Laurent<Interval> limit_of(const Scheme<Rational>& scheme) {
  return map_coefficients(vertex_limit_mask(scheme), [](const Rational& x) { return Interval(x); });
}
Laurent<Interval> limit_of(const Rational& s) { return limit_of(j(s)); }

const std::vector<int> x_values{0, 7, 9, 3, -2, 5, 1};
const std::vector<int> y_values{0, 1, 6, 9, 4, 4, 2};

/// The first n of some points.
Polyline some_polygon(std::size_t n) {
  return make_polyline({{x_values.begin(), x_values.begin() + static_cast<std::ptrdiff_t>(n)},
                        {y_values.begin(), y_values.begin() + static_cast<std::ptrdiff_t>(n)}},
                       true);
}

std::vector<Rational> exactly(const std::vector<int>& values, std::size_t n) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < n; ++i) result.emplace_back(values[i]);
  return result;
}

TEST(RetrofitPolygon, TheSpectrumOfLoopsEnclosesTheExactRate) {
  for (const Rational& s : {q(-1, 2), q(1), q(3, 2), q(2), q(3)}) {
    for (const int n : {1, 2, 3, 4, 5, 7, 12}) {
      const Algebraic rate = contraction_rate_of_loops(limit_mask(jspline(s)), n);
      const LoopSpectrum spectrum = loop_spectrum(limit_of(s), static_cast<std::size_t>(n));
      EXPECT_TRUE(spectrum.rate.overlaps(rate.to_interval()));
      EXPECT_LT(spectrum.rate.radius(), 1e-15);  // the root of a square that may be 0 has half the digits
      EXPECT_EQ(spectrum.converges(), rate < Algebraic(1));
    }
  }
  // The cubic B-spline's limit mask (1, 4, 1)/6 has the frequencies' values (2 + cos w)/3.
  const LoopSpectrum cubic = loop_spectrum(limit_of(q(1)), 4);
  EXPECT_TRUE(cubic.smallest.contains(q(1, 3)));
  EXPECT_TRUE(cubic.largest.contains(q(1)));
  EXPECT_TRUE(cubic.rate.contains(q(2, 3)));
  EXPECT_THROW(static_cast<void>(loop_spectrum(limit_of(q(1)), 0)), std::domain_error);
}

TEST(RetrofitPolygon, BothWaysGiveTheExactSolution) {
  for (const Scheme<Rational>& scheme :
       {j(q(1, 2)), j(q(1)), j(q(3, 2)), j(q(-3, 4)), mixed(j(q(-33, 26)), j(q(3, 2)))}) {
    for (const std::size_t n : {1U, 2U, 3U, 4U, 7U}) {
      const Polyline target = some_polygon(n);
      const Laurent<Rational> mask = vertex_limit_mask(scheme);
      const std::vector<Rational> x = retrofit_directly(mask, exactly(x_values, n));
      const std::vector<Rational> y = retrofit_directly(mask, exactly(y_values, n));
      const Retrofit direct = retrofit_directly(limit_of(scheme), target);
      const Retrofit iterated = retrofit_by_iteration(limit_of(scheme), target, {1e-12, 100000});
      EXPECT_LT(direct.residual, 1e-13);
      EXPECT_LE(iterated.residual, 1e-12);
      for (std::size_t i = 0; i < n; ++i) {
        EXPECT_NEAR(direct.polygon.coordinates[0][i], x[i].to_double(), 1e-12);
        EXPECT_NEAR(direct.polygon.coordinates[1][i], y[i].to_double(), 1e-12);
        EXPECT_NEAR(iterated.polygon.coordinates[0][i], x[i].to_double(), 1e-10);
        EXPECT_NEAR(iterated.polygon.coordinates[1][i], y[i].to_double(), 1e-10);
      }
    }
  }
}

TEST(RetrofitPolygon, IterationsAreThoseOfTheExactIteration) {
  const Laurent<Rational> mask = limit_mask(jspline(q(3, 2)));
  const std::vector<Rational> target = exactly(x_values, 7);
  std::vector<Rational> current = target;
  long count = 0;
  const auto residual = [&] {
    Rational largest;
    const std::vector<Rational> limit = apply_to_loop(mask, current);
    for (std::size_t i = 0; i < limit.size(); ++i) largest = std::max(largest, abs(limit[i] - target[i]));
    return largest;
  };
  for (; residual() > q(1, 1000); ++count) current = retrofit_step(mask, current, target);
  const Polyline line = make_polyline({{x_values.begin(), x_values.end()}}, true);
  EXPECT_EQ(retrofit_by_iteration(limit_of(q(3, 2)), line, {1e-3, 1000}).iterations, count);
  EXPECT_GT(count, 3);
}

TEST(RetrofitPolygon, NothingToDo) {
  EXPECT_EQ(retrofit_by_iteration(limit_of(q(0)), some_polygon(5)).iterations, 0);
  EXPECT_EQ(retrofit_by_iteration(limit_of(q(0)), some_polygon(5)).residual, 0);
}

template <class Call>
std::string refusal(Call call) {
  try {
    static_cast<void>(call());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RetrofitPolygon, RefusesWithTheReason) {
  // s = 2 on even loops: alternating data never shrink.
  const std::string slow = refusal([] { return retrofit_by_iteration(limit_of(q(2)), some_polygon(6)); });
  EXPECT_NE(slow.find("does not converge on closed loops of 6 points"), std::string::npos) << slow;
  // Triangles see no alternating data: they converge there (jsplines 5, figure 5).
  EXPECT_GT(retrofit_by_iteration(limit_of(q(2)), some_polygon(3)).iterations, 0);
  const std::string fast = refusal([] { return retrofit_by_iteration(limit_of(q(5, 2)), some_polygon(6)); });
  EXPECT_NE(fast.find("solve directly"), std::string::npos) << fast;
  EXPECT_LT(retrofit_directly(limit_of(q(5, 2)), some_polygon(6)).residual, 1e-12);
  // (1/4, 1/2, 1/4) kills alternating data.
  const Laurent<Interval> hat(-1, {Interval(q(1, 4)), Interval(q(1, 2)), Interval(q(1, 4))});
  EXPECT_NE(refusal([&] { return retrofit_directly(hat, some_polygon(6)); }).find("singular"),
            std::string::npos);
  EXPECT_NE(refusal([&] { return retrofit_by_iteration(hat, some_polygon(6)); }).find("singular, too"),
            std::string::npos);
  EXPECT_LT(retrofit_directly(hat, some_polygon(7)).residual, 1e-12);
  EXPECT_NE(refusal([] {
              return retrofit_by_iteration(limit_of(q(3, 2)), some_polygon(6), {1e-300, 100000});
            }).find("larger tolerance"),
            std::string::npos);
  EXPECT_NE(refusal([] {
              return retrofit_by_iteration(limit_of(q(3, 2)), some_polygon(6), {1e-9, 3});
            }).find("3 iterations"),
            std::string::npos);
  Polyline polygon = some_polygon(4);
  polygon.coordinates[1][2] = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal([&] { return retrofit_directly(limit_of(q(1)), polygon); }).find("point 2"),
            std::string::npos);
  EXPECT_NE(
      refusal([&] { return retrofit_directly(limit_of(q(1)), make_polyline({{1, 2}}, false)); }).find("open"),
      std::string::npos);
  EXPECT_NE(
      refusal([&] { return retrofit_directly(limit_of(q(1)), make_polyline({{}}, true)); }).find("none"),
      std::string::npos);
}

TEST(RetrofitPolygon, LargePolygonsTakeTimeProportionalToTheirSize) {
  constexpr std::size_t n = 100000;
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = static_cast<double>((i * i) % 1009);
  const Polyline target = make_polyline({x}, true);
  const Retrofit direct = retrofit_directly(limit_of(q(3, 2)), target);
  EXPECT_LT(direct.residual, 1e-9);
  const Retrofit iterated = retrofit_by_iteration(limit_of(q(3, 2)), target, {1e-9, 1000});
  EXPECT_NEAR(iterated.polygon.coordinates[0][n / 2], direct.polygon.coordinates[0][n / 2], 1e-7);
}

}  // namespace
}  // namespace subdiv
