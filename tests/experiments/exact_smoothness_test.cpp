#include "experiments/exact_smoothness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "experiments/popping.h"
#include "tests/experiments/find_claim.h"
#include "tests/experiments/refine_polygon.h"

namespace subdiv {
namespace {

using test::find_claim;

class ExactSmoothness : public ::testing::Test {
 protected:
  static const std::vector<Claim>& claims() {
    static const Results all = run_exact_smoothness();
    return all.claims;
  }
};

TEST_F(ExactSmoothness, EveryClaimIsSettled) {
  EXPECT_EQ(claims().size(), exact_smoothness_heads().size());
  for (const Claim& claim : claims()) {
    EXPECT_EQ(claim.verdict, claim.head.printed ? Verdict::reproduced : Verdict::established)
        << claim.head.id;
  }
}

TEST_F(ExactSmoothness, RangesAreTheNecessaryOnesOfThePapers) {
  // js-report 3: -2 < s < 6, 0 < s < 4, 1 < s < 3, s = 3/2.
  EXPECT_EQ(find_claim(claims(), "smooth.conjecture").exact, "C1 (-2, 6), C2 (0, 4), C3 (1, 3), C4 {3/2}");
  EXPECT_NE(find_claim(claims(), "smooth.conjecture").note.find("The conjecture is true"), std::string::npos);
  EXPECT_EQ(find_claim(claims(), "smooth.exact.c0.lower").exact, "-6");
  EXPECT_EQ(find_claim(claims(), "smooth.exact.c0.upper").exact, "10");
  EXPECT_EQ(find_claim(claims(), "smooth.exact.c4").exact, "3/2");
  EXPECT_EQ(find_claim(claims(), "smooth.mixed.c2").exact, "(0, 4)");
}

TEST_F(ExactSmoothness, DifferencesFallInsideAndGrowOutside) {
  // 2^(m k) times differences of order m+1 tend to zero exactly inside; after 16 levels of an impulse.
  const auto scaled = [](double s, int m) {
    std::vector<double> p{1};
    constexpr int levels = 16;
    for (int k = 0; k < levels; ++k) p = test::refine(p, s);
    return std::pow(2.0, m * levels) * test::largest_difference(p, m + 1);
  };
  EXPECT_LT(scaled(-5.5, 0), 1);
  EXPECT_GT(scaled(-6.5, 0), 1);
  EXPECT_LT(scaled(5.5, 1), 1);
  EXPECT_GT(scaled(6.5, 1), 1);
  EXPECT_LT(scaled(0.3, 2), 1);
  EXPECT_GT(scaled(-0.3, 2), 1);
  EXPECT_LT(scaled(3.7, 2), 1);
  EXPECT_GT(scaled(4.3, 2), 1);
}

TEST_F(ExactSmoothness, ScheduleContractsSecondDividedDifferences) {
  EXPECT_EQ(find_claim(claims(), "popping.schedule.c2").exact, "9/5");
  // 3 - log2(3/2) = 2 + log2(4/3).
  EXPECT_NEAR(test::value_of(claims(), "popping.schedule.exponent"), 2 + std::log2(4.0 / 3), 1e-12);
  // The schedule itself: differences of second divided differences fall like (3/4)^k.
  std::vector<double> p{1};
  double x = 1.5;
  double before = 0;
  for (int k = 1; k <= 16; ++k) {
    p = test::refine(p, (2 - x) / (4 - x));
    x *= (6 - x) / 8;
    const double now = std::pow(4.0, k) * test::largest_difference(p, 3);
    if (k > 8) {
      EXPECT_NEAR(now / before, 0.75, 0.01) << k;
    }
    before = now;
  }
}

TEST_F(ExactSmoothness, TheTwoUnstableParameters) {
  EXPECT_EQ(find_claim(claims(), "smooth.unstable").exact, "s = 2, s = 3");
  // Alternating data vanish in the limit at s = 2: sum of (-1)^j phi(x - j) = 0.
  std::vector<double> p;
  for (int j = 0; j < 40; ++j) p.push_back(j % 2 == 0 ? 1 : -1);
  p = test::refine(p, 2);
  for (std::size_t i = 10; i + 10 < p.size(); ++i) EXPECT_NEAR(p[i], 0, 1e-14);
}

}  // namespace
}  // namespace subdiv
