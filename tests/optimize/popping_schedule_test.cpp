#include "optimize/popping_schedule.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optimize/problem.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function s = Function::variable(0);

TEST(PoppingSchedule, IsTheMinimaxOverAllCoefficients) {
  // The definition itself: the LP over every coefficient, level after level.
  const std::vector<PoppingLevel> schedule = popping_schedule(5);
  Laurent<Function> before(1);
  for (const PoppingLevel& level : schedule) {
    const Problem problem{
        popping_difference(jspline(s), before).coefficients(), Norm::linf, {{Rational(-2), Rational(6)}}, {}};
    const Summary best = minimise(problem);
    ASSERT_EQ(best.termination, Termination::proved);
    EXPECT_EQ(best.minimiser[0].exact, level.parameter.exact);
    EXPECT_EQ(best.minimum.exact, level.disparity.exact);
    before = jspline(Function(level.parameter.lower)).symbol * upsample(before, 2);
  }
}

TEST(PoppingSchedule, ByBruteForceInDouble) {
  // Levels 1 .. 10 by ternary search on the largest coefficient, from the stencils alone.
  std::vector<double> p{1};  // odd number of coefficients, centred
  int level = 0;
  for (const PoppingLevel& expected : popping_schedule(10)) {
    const auto difference = [&](double x, bool linear) {
      const std::vector<double> mask = linear
                                           ? std::vector<double>{0, 0, 0.5, 1, 0.5, 0, 0}
                                           : std::vector<double>{(x - 1) / 16, x / 8, (9 - x) / 16, 1 - x / 4,
                                                                 (9 - x) / 16, x / 8, (x - 1) / 16};
      std::vector<double> fine(2 * p.size() + 5, 0);
      for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t k = 0; k < 7; ++k) fine[2 * i + k] += mask[k] * p[i];
      }
      return fine;
    };
    const std::vector<double> linear = difference(0, true);
    const auto worst = [&](double x) {
      const std::vector<double> refined = difference(x, false);
      double largest = 0;
      for (std::size_t i = 0; i < refined.size(); ++i)
        largest = std::max(largest, std::abs(linear[i] - refined[i]));
      return largest;
    };
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
      const double a = low + (high - low) / 3;
      const double b = high - (high - low) / 3;
      (worst(a) < worst(b) ? high : low) = worst(a) < worst(b) ? b : a;
    }
    ++level;
    EXPECT_NEAR(low, expected.parameter.lower.to_double(), 1e-8) << level;
    EXPECT_NEAR(worst(low), expected.disparity.lower.to_double(), 1e-10) << level;
    p = difference(low, false);
  }
}

TEST(PoppingSchedule, GivesExactFractionsThenCertifiedDigits) {
  const std::vector<PoppingLevel> schedule = popping_schedule(25);
  ASSERT_EQ(schedule.size(), 25U);
  EXPECT_EQ(schedule[0].parameter.exact, "1/5");
  EXPECT_EQ(schedule[1].parameter.exact, "37/101");
  EXPECT_EQ(schedule[2].parameter.exact, "11929/28313");
  for (const PoppingLevel& level : schedule) {
    EXPECT_NE(level.parameter.rigour, Rigour::approximate);
    EXPECT_LT(level.parameter.width(), Rational::power_of_two(-200));
    EXPECT_LT(level.disparity.width(), Rational::power_of_two(-200));
  }
  EXPECT_TRUE(popping_schedule(0).empty());
}

TEST(PoppingSchedule, ExactAndCertifiedLevelsFollowOneRecursion) {
  // From s_k alone: x = (2 - 4s)/(1 - s), then x (6 - x)/8, through the change of arithmetic.
  const std::vector<PoppingLevel> schedule = popping_schedule(12);
  for (std::size_t k = 0; k + 1 < schedule.size(); ++k) {
    const Interval here = Interval::hull(schedule[k].parameter.lower, schedule[k].parameter.upper, 300);
    const Interval x = (Interval(2) - Interval(4) * here) / (Interval(1) - here);
    const Interval next = x * (Interval(6) - x) / Interval(8);
    const Interval predicted = (Interval(2) - next) / (Interval(4) - next);
    EXPECT_TRUE(predicted.overlaps(
        Interval::hull(schedule[k + 1].parameter.lower, schedule[k + 1].parameter.upper, 300)));
    EXPECT_LT(predicted.radius(), 1e-70);
  }
}

TEST(PoppingSchedule, RisesToItsLimitAtTheProvedRate) {
  const Enclosure limit = popping_limit();
  EXPECT_EQ(limit.exact, "1/2");
  EXPECT_EQ(limit.rigour, Rigour::exact);
  Rational previous(0);
  Rational bound(3, 10);
  for (const PoppingLevel& level : popping_schedule(25)) {
    EXPECT_GT(level.parameter.lower, previous);
    EXPECT_LT(level.parameter.upper, limit.lower);
    EXPECT_LE(limit.lower - level.parameter.lower, bound);
    previous = level.parameter.upper;
    bound *= Rational(3, 4);
  }
}

}  // namespace
}  // namespace subdiv
