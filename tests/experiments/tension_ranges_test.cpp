#include "experiments/tension_ranges.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

class TensionRanges : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_tension_ranges();
    return all;
  }
  static const std::vector<Claim>& claims() { return results().claims; }
  static const Series& series(const std::string& name) { return test::find_series(results(), name); }
};

TEST_F(TensionRanges, EveryClaimIsSettled) {
  EXPECT_EQ(claims().size(), tension_range_heads().size());
  for (const Claim& claim : claims()) {
    EXPECT_EQ(claim.verdict, claim.head.printed ? Verdict::reproduced : Verdict::established)
        << claim.head.id;
  }
}

TEST_F(TensionRanges, EndsAreTheRootsOfTheLiterature) {
  // Hechler, Moessner & Reif 2009: 32w^3 + 4w - 1 = 0.
  const double four = test::value_of(claims(), "smooth.four-point.c1.upper");
  EXPECT_NEAR(32 * std::pow(four, 3) + 4 * four - 1, 0, 1e-14);
  EXPECT_NEAR(four, 0.19272924926481203, 1e-15);
  EXPECT_EQ(test::find_claim(claims(), "smooth.four-point.c1.lower").exact, "0");
  EXPECT_EQ(test::find_claim(claims(), "smooth.four-point.c0.upper").exact, "1/2");
  // Above the published 1/48.
  const double dual = test::value_of(claims(), "smooth.dfh.c2.upper");
  EXPECT_GT(dual, 1.0 / 48);
  EXPECT_NEAR(((327680 * dual + 25600) * dual + 352) * dual * dual + 24 * dual - 1, 0, 1e-13);
  EXPECT_EQ(test::find_claim(claims(), "smooth.dfh.c2.single").exact, "-1/28");
  EXPECT_NEAR(test::value_of(claims(), "smooth.dfh.c2.single.exponent"), 2 + std::log2(1.4), 1e-14);
}

TEST_F(TensionRanges, CurvesPassThroughKnownExponents) {
  const auto exponent_at = [](const Series& s, double w) {
    for (const auto& row : s.rows) {
      if (std::abs(std::stod(row.at(0)) - w) < 1e-9) return std::stod(row.at(1));
    }
    throw std::out_of_range("no row");
  };
  const Series& four = series("four-point-exponent");
  EXPECT_NEAR(exponent_at(four, 0), 1, 1e-11);         // linear B-splines
  EXPECT_NEAR(exponent_at(four, 1.0 / 16), 2, 1e-11);  // Dubuc
  EXPECT_NEAR(exponent_at(four, 0.375), 1 - std::log2(1.5), 1e-11);
  // rho = (1 + sqrt(1 - 16w))/2 for w <= 1/16.
  EXPECT_NEAR(exponent_at(four, -0.25), 1 - std::log2((1 + std::sqrt(5.0)) / 2), 1e-11);
  const Series& dual = series("dfh-exponent");
  EXPECT_NEAR(exponent_at(dual, 0), 2, 1e-11);  // Chaikin
  EXPECT_NEAR(exponent_at(dual, 1.0 / 128), 6 - std::log2(9), 1e-11);
  EXPECT_NEAR(exponent_at(dual, -1.0 / 28), 2 - std::log2(8.0 / 7), 1e-11);
}

}  // namespace
}  // namespace subdiv
