#include "experiments/popping.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using test::find_claim;
using test::value_of;

/// One step of J_{a,b} on a unit impulse's values, indices from -first on, from the stencils of jsplines 1.
std::vector<double> refine(const std::vector<double>& p, double a, double b) {
  const std::vector<double> mask{(b - 1) / 16, a / 8, (9 - b) / 16, 1 - a / 4,
                                 (9 - b) / 16, a / 8, (b - 1) / 16};
  std::vector<double> fine(2 * p.size() + 5, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < mask.size(); ++k) fine[2 * i + k] += mask[k] * p[i];
  }
  return fine;
}

/// How far a step of J_s puts the points from linear subdivision J_{0,1}.
double disparity(const std::vector<double>& p, double s) {
  const std::vector<double> smooth = refine(p, s, s);
  const std::vector<double> linear = refine(p, 0, 1);
  double largest = 0;
  for (std::size_t i = 0; i < smooth.size(); ++i)
    largest = std::max(largest, std::abs(smooth[i] - linear[i]));
  return largest;
}

class Popping : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_popping();
    return all;
  }
  static const std::vector<Claim>& claims() { return results().claims; }
};

TEST_F(Popping, EveryPrintedValueIsReproduced) {
  const std::vector<std::string> printed{"0.2",   "0.366", "0.421", "0.449", "0.465",
                                         "0.475", "0.482", "0.487", "0.491"};
  for (std::size_t k = 1; k <= printed.size(); ++k) {
    const Claim& claim = find_claim(claims(), "popping.schedule." + std::to_string(k));
    EXPECT_EQ(claim.head.printed, printed[k - 1]);
    EXPECT_EQ(claim.head.document, "jsplines");
    EXPECT_EQ(claim.verdict, Verdict::reproduced);
  }
  for (int k = 10; k <= 25; ++k) {
    const Claim& claim = find_claim(claims(), "popping.schedule." + std::to_string(k));
    EXPECT_EQ(claim.verdict, Verdict::established);
    EXPECT_LT(claim.upper.value() - claim.lower.value(), pow(Rational(10), -18));
  }
}

TEST_F(Popping, EveryLevelIsTheBestAfterTheOnesBefore) {
  std::vector<double> p{1};
  for (int k = 1; k <= 12; ++k) {
    const double s = value_of(claims(), "popping.schedule." + std::to_string(k));
    const double least = disparity(p, s);
    for (const double step : {1e-7, 1e-4, 0.01, 0.1, 0.5}) {
      EXPECT_GT(disparity(p, s + step), least) << k;
      EXPECT_GT(disparity(p, s - step), least) << k;
    }
    p = refine(p, s, s);
  }
}

TEST_F(Popping, OneParameterForTwoLevelsWouldPrintAnotherValue) {
  const auto both = [](double s) { return disparity(refine({1}, s, s), s); };
  const double s = value_of(claims(), "popping.one-s");
  for (const double step : {1e-6, 1e-3, 0.1}) {
    EXPECT_GT(both(s + step), both(s));
    EXPECT_GT(both(s - step), both(s));
  }
  EXPECT_GT(std::abs(s - 0.366), 5e-4);
  EXPECT_LT(std::abs(s - 0.369), 5e-4);
  // A smoother first level makes the second pop less still.
  EXPECT_LT(both(2), both(s));
  for (const double step : {1e-6, 1e-3, 0.1, 1.0, 3.0}) {
    EXPECT_GT(both(2 + step), both(2));
    EXPECT_GT(both(2 - step), both(2));
  }
  EXPECT_NE(find_claim(claims(), "popping.order").note.find("2.0"), std::string::npos);
  EXPECT_EQ(find_claim(claims(), "popping.order").verdict, Verdict::reproduced);
}

TEST_F(Popping, LimitRangeAndRecursion) {
  EXPECT_EQ(find_claim(claims(), "popping.limit").exact, "1/2");
  EXPECT_EQ(find_claim(claims(), "popping.limit").verdict, Verdict::established);
  EXPECT_EQ(find_claim(claims(), "popping.range").verdict, Verdict::reproduced);
  EXPECT_EQ(find_claim(claims(), "popping.change").verdict, Verdict::reproduced);
  EXPECT_EQ(find_claim(claims(), "popping.recursion").verdict, Verdict::established);
  double x = 1.5;
  for (int k = 1; k <= 25; ++k) {
    EXPECT_NEAR(value_of(claims(), "popping.schedule." + std::to_string(k)), (2 - x) / (4 - x), 1e-14);
    x *= (6 - x) / 8;
  }
}

TEST_F(Popping, FigureDataAreTheDisparitiesOfTheSchedule) {
  std::vector<double> p{1};
  const Series& series = results().series.at(0);
  EXPECT_EQ(series.columns, (std::vector<std::string>{"level", "s", "disparity", "limit"}));
  ASSERT_EQ(series.rows.size(), 25U);
  for (std::size_t k = 0; k < 10; ++k) {
    const double s = std::stod(series.rows[k][1]);
    EXPECT_NEAR(std::stod(series.rows[k][2]), disparity(p, s), 1e-12);
    p = refine(p, s, s);
  }
}

}  // namespace
}  // namespace subdiv
