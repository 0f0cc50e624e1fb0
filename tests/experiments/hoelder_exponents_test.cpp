#include "experiments/hoelder_exponents.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"
#include "tests/experiments/refine_polygon.h"

namespace subdiv {
namespace {

using test::find_claim;

class HoelderExponents : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_hoelder_exponents();
    return all;
  }
  static const std::vector<Claim>& claims() { return results().claims; }
};

/// 3 - log2 of the growth of 8^k times the fourth differences per level, over an even number of levels.
double measured_exponent(double s) {
  std::vector<double> p{1};
  double at_eight = 0;
  for (int k = 1; k <= 18; ++k) {
    p = test::refine(p, s);
    if (k == 8) at_eight = std::pow(8.0, k) * test::largest_difference(p, 4);
  }
  const double at_eighteen = std::pow(8.0, 18) * test::largest_difference(p, 4);
  return 3 - std::log2(at_eighteen / at_eight) / 10;
}

TEST_F(HoelderExponents, EveryClaimIsSettled) {
  EXPECT_EQ(claims().size(), hoelder_exponent_heads().size());
  for (const Claim& claim : claims()) EXPECT_EQ(claim.verdict, Verdict::established) << claim.head.id;
}

TEST_F(HoelderExponents, MinimumBetweenTheSplines) {
  // The radius p(1+u)/2 with p = 4/(7+u^2) is largest at u = 2 sqrt(2) - 1.
  EXPECT_NEAR(test::value_of(claims(), "smooth.exponent.minimum.s"), (11 + std::sqrt(2.0)) / 7, 1e-14);
  EXPECT_NEAR(test::value_of(claims(), "smooth.exponent.minimum"),
              3 - std::log2((1 + 2 * std::sqrt(2.0)) / 7), 1e-14);
  EXPECT_EQ(find_claim(claims(), "smooth.exponent.maximum").exact, "5");
}

TEST_F(HoelderExponents, CurveIsTheGrowthOfDifferences) {
  for (const Series& series : results().series) {
    if (series.name != "smooth-exponent") continue;
    int compared = 0;
    for (const auto& row : series.rows) {
      const double s = std::stod(row.at(0));
      // Where one product is alone in its size the growth of differences shows after few levels.
      const bool clear = std::abs(s - std::round(4 * s) / 4) < 1e-9 && (s <= 0.5 || s >= 4);
      if (!clear || s < -5 || s > 9) continue;
      EXPECT_NEAR(std::stod(row.at(1)), measured_exponent(s), 0.06) << s;
      ++compared;
    }
    EXPECT_GT(compared, 20);
  }
}

TEST_F(HoelderExponents, BarsEndOnTheCurve) {
  // At the exact ends of C^m the exponent is m: 3 - log2(2-s) and 3 - log2(s-2), 4 - log2(s-1) at s = 3.
  const auto exponent = [](double s) {
    if (s < 1.5) return 3 - std::log2(2 - s);
    return s < 3 ? 4 - std::log2(s - 1) : 3 - std::log2(s - 2);
  };
  int bars = 0;
  for (const Series& series : results().series) {
    if (series.name != "smooth-ranges") continue;
    for (const auto& row : series.rows) {
      if (row.at(1).empty()) continue;
      EXPECT_NEAR(exponent(std::stod(row[0])), std::stod(row[1]), 1e-12) << row[0];
      ++bars;
    }
  }
  EXPECT_EQ(bars, 8);
}

}  // namespace
}  // namespace subdiv
