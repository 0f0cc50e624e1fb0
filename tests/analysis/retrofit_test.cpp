#include "analysis/retrofit.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "analysis/limit_mask.h"
#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);

Laurent<double> rounded(const Laurent<Rational>& mask) {
  return map_coefficients(mask, [](const Rational& q) { return q.to_double(); });
}

/// |1 - L(e^{iw})| from the definition.
double modulus(const Laurent<double>& mask, double w) {
  std::complex<double> value = 1;
  for (int j = mask.first(); j <= mask.last(); ++j) value -= mask[j] * std::polar(1.0, w * j);
  return std::abs(value);
}

double radius_of_loops(const Laurent<double>& mask, int n) {
  double result = 0;
  for (int k = 0; k < n; ++k) result = std::max(result, modulus(mask, 2 * std::numbers::pi * k / n));
  return result;
}

double radius(const Laurent<double>& mask) {
  constexpr int samples = 2000;
  double result = 0;
  for (int k = 0; k < samples; ++k)
    result = std::max(result, modulus(mask, 2 * std::numbers::pi * k / samples));
  return result;
}

Laurent<F> jspline_limit() { return limit_mask(jspline(s)); }

TEST(Retrofit, RangeOfJsplines) {
  // js-report 5 prints -0.86 and 2; the lower end is a root of 2 s^2 - 19 s - 18.
  const RealSet range = retrofit_range(jspline_limit());
  EXPECT_EQ(range.to_string(), "((19-sqrt(505))/4, 2)");
  EXPECT_NEAR(range.parts[0].lower->to_interval().to_double(), -0.8680512, 1e-7);
}

TEST(Retrofit, RangesAgreeWithSampledFrequencies) {
  const RealSet infinite = retrofit_range(jspline_limit());
  const RealSet three = retrofit_range_of_loops(jspline_limit(), 3);
  const RealSet five = retrofit_range_of_loops(jspline_limit(), 5);
  const RealSet seven = retrofit_range_of_loops(jspline_limit(), 7);
  for (int i = -60; i <= 180; ++i) {
    const Rational value(2 * i + 1, 14);  // from -8.5 to 25.8, clear of the ends
    const Laurent<double> mask = rounded(limit_mask(jspline(value)));
    const Algebraic x(value);
    EXPECT_EQ(infinite.contains(x), radius(mask) < 1) << value.to_string();
    EXPECT_EQ(three.contains(x), radius_of_loops(mask, 3) < 1) << value.to_string();
    EXPECT_EQ(five.contains(x), radius_of_loops(mask, 5) < 1) << value.to_string();
    EXPECT_EQ(seven.contains(x), radius_of_loops(mask, 7) < 1) << value.to_string();
  }
}

TEST(Retrofit, ClosedLoopsOfJsplines) {
  // One frequency, cos w = -1/2: 1 - L = s (15 - s) / (4 (6 + s)).
  EXPECT_EQ(retrofit_range_of_loops(jspline_limit(), 3).to_string(),
            "((19-sqrt(457))/2, 3) u (8, (19+sqrt(457))/2)");
  EXPECT_EQ(RationalFunction(1) - symbol_at_cosine(jspline_limit(), F(Rational(-1, 2))),
            s * (F(15) - s) / (F(4) * (F(6) + s)));
  for (int n = 4; n <= 8; n += 2) {  // even loops see cos w = -1
    EXPECT_EQ(retrofit_range_of_loops(jspline_limit(), n).to_string(), "((19-sqrt(505))/4, 2)");
  }
  EXPECT_EQ(retrofit_range_of_loops(jspline_limit(), 1).to_string(), "(-inf, -6) u (-6, inf)");
  const RealSet five = retrofit_range_of_loops(jspline_limit(), 5);
  ASSERT_EQ(five.parts.size(), 2U);
  EXPECT_NEAR(five.parts[0].lower->to_interval().to_double(), -0.970507033406, 1e-12);
  EXPECT_NEAR(five.parts[0].upper->to_interval().to_double(), 2.33471006401, 1e-11);
  EXPECT_THROW(retrofit_range_of_loops(jspline_limit(), 0), std::domain_error);
}

std::vector<Rational> target(int n) {
  std::vector<Rational> result;
  for (int i = 0; i < n; ++i) result.emplace_back(((i * i * 7 + 3 * i) % 11) - 5, 2);
  return result;
}

/// The distance to the direct solution after 60 steps over that at the start.
double shrinkage(const Rational& value, int n) {
  const Laurent<Rational> mask = limit_mask(jspline(value));
  const std::vector<Rational> goal = target(n);
  const std::vector<Rational> solution = retrofit_directly(mask, goal);
  EXPECT_EQ(apply_to_loop(mask, solution), goal);
  const Laurent<double> fast = rounded(mask);
  std::vector<double> wanted;
  for (const Rational& q : goal) wanted.push_back(q.to_double());
  std::vector<double> current = wanted;
  const auto distance = [&] {
    double result = 0;
    for (std::size_t i = 0; i < current.size(); ++i) {
      result = std::max(result, std::abs(current[i] - solution[i].to_double()));
    }
    return result;
  };
  const double start = distance();
  for (int step = 0; step < 60; ++step) current = retrofit_step(fast, current, wanted);
  return distance() / start;
}

TEST(Retrofit, TheIterationConvergesInsideAndDivergesOutside) {
  for (const int n : {3, 4, 5, 7}) {
    const RealSet range = retrofit_range_of_loops(jspline_limit(), n);
    for (const Rational& value :
         {Rational(-3, 2), Rational(-11, 10), Rational(-9, 10), Rational(-1, 2), Rational(3, 2),
          Rational(11, 5), Rational(5, 2), Rational(11, 2), Rational(10)}) {
      const double ratio = shrinkage(value, n);
      EXPECT_EQ(ratio < 1, range.contains(Algebraic(value))) << n << " " << value.to_string() << " " << ratio;
    }
  }
  EXPECT_LT(shrinkage(Rational(3, 4), 6), 1e-15);
}

TEST(Retrofit, WhereTheDirectSolveIsSingular) {
  EXPECT_EQ(singular_for_loops(jspline_limit(), 3), (std::vector<Algebraic>{Algebraic(3), Algebraic(8)}));
  EXPECT_EQ(singular_for_loops(jspline_limit(), 4),
            (std::vector<Algebraic>{Algebraic(2), Algebraic(Rational(9, 2))}));
  for (const auto& [n, value] : std::vector<std::pair<int, int>>{{3, 3}, {3, 8}, {4, 2}, {6, -9}, {6, 3}}) {
    EXPECT_THROW(retrofit_directly(limit_mask(jspline(Rational(value))), target(n)), std::domain_error) << n;
  }
  for (const Algebraic& x : singular_for_loops(jspline_limit(), 5)) {
    double least = 1;
    const Laurent<double> mask = limit_mask(jspline(x.to_interval().to_double()));
    for (int k = 0; k < 5; ++k) {
      const double w = 2 * std::numbers::pi * k / 5;
      least = std::min(least, std::abs(mask[0] + 2 * mask[1] * std::cos(w) + 2 * mask[2] * std::cos(2 * w)));
    }
    EXPECT_LT(least, 1e-12);
  }
  EXPECT_EQ(solvable_range(jspline_limit()).to_string(), "(-6, 2)");
}

TEST(Retrofit, ContractionRates) {
  // At cos w = -1: 2 s (8 - s) / (3 (6 + s)).
  const F alternating = F(1) - symbol_at_cosine(jspline_limit(), F(-1));
  EXPECT_EQ(alternating, F(2) * s * (F(8) - s) / (F(3) * (F(6) + s)));
  const RealSet dominated = alternation_dominates(jspline_limit());
  for (const Rational& value :
       {Rational(-4, 5), Rational(1, 2), Rational(3, 2), Rational(2), Rational(4), Rational(12)}) {
    const Laurent<Rational> mask = limit_mask(jspline(value));
    const Algebraic rate = contraction_rate(mask);
    EXPECT_NEAR(rate.to_interval().to_double(), radius(rounded(mask)), 1e-5);
    for (int n = 2; n <= 7; ++n) {
      EXPECT_NEAR(contraction_rate_of_loops(mask, n).to_interval().to_double(),
                  radius_of_loops(rounded(mask), n), 1e-12);
    }
    const std::vector<Rational> point{value};
    const Rational closed_form = abs(alternating.evaluate(std::span<const Rational>(point)));
    EXPECT_EQ(dominated.contains(Algebraic(value)), rate == Algebraic(closed_form)) << value.to_string();
  }
  EXPECT_EQ(contraction_rate(limit_mask(jspline(Rational(3, 2)))), Algebraic(Rational(13, 15)));
  EXPECT_EQ(contraction_rate(Laurent<Rational>(1)), Algebraic(0));
}

TEST(Retrofit, AsymmetricMasks) {
  // The quadratic B-spline's vertices: L = (1 + z^-1) / 2, |1 - L| = |sin(w/2)|, 1 at w = pi.
  const Laurent<Rational> mask = limit_mask(bspline<Rational>(2));
  EXPECT_EQ(contraction_rate(mask), Algebraic(1));
  EXPECT_EQ(contraction_rate_of_loops(mask, 3), sqrt(Algebraic(3)) / Algebraic(2));
  EXPECT_THROW(symbol_at_cosine(mask, Rational(0)), std::domain_error);
  // A family: (1 - s) P_0 + s P_1 has |1 - L| = |s| |1 - e^{iw}|.
  const Laurent<F> moving(0, {F(1) - s, s});
  EXPECT_EQ(retrofit_range(moving).to_string(), "(-1/2, 1/2)");
  EXPECT_EQ(retrofit_range_of_loops(moving, 3).to_string(), "(-sqrt(3)/3, sqrt(3)/3)");
  EXPECT_EQ(solvable_range(moving).to_string(), "(-inf, 1/2) u (1/2, inf)");
}

}  // namespace
}  // namespace subdiv
