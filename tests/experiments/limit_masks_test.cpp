#include "experiments/limit_masks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

constexpr double pi_double = 3.14159265358979323846;

/// 1 - L(e^{iw}) from the limit mask that the papers print.
double error_factor(double s, double w) {
  const double scale = 1 / (12 * (6 + s));
  const double symbol =
      (72 + 2 * (s - 9) * s) + 2 * 2 * s * (8 - s) * std::cos(w) + 2 * (s - 1) * s * std::cos(2 * w);
  return std::abs(1 - symbol * scale);
}

bool loop_converges(double s, int n) {
  for (int k = 0; k < n; ++k) {
    if (error_factor(s, 2 * pi_double * k / n) >= 1) return false;
  }
  return true;
}

class LimitMasks : public ::testing::Test {
 protected:
  static const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = run_limit_masks().claims;
    return all;
  }
};

TEST_F(LimitMasks, RetrofitEndsByFrequencies) {
  const double lower = test::value_of(claims(), "retrofit.range.lower.exact");
  EXPECT_NEAR(lower, (19 - std::sqrt(505.0)) / 4, 1e-12);
  for (const int n : {4, 6, 8, 10, 64}) {
    EXPECT_TRUE(loop_converges(lower + 1e-6, n)) << n;
    EXPECT_FALSE(loop_converges(lower - 1e-6, n)) << n;
    EXPECT_TRUE(loop_converges(2 - 1e-6, n)) << n;
    EXPECT_FALSE(loop_converges(2 + 1e-6, n)) << n;
    for (double s = 2.01; s < 12; s += 0.01) EXPECT_FALSE(loop_converges(s, n)) << s << ' ' << n;
  }
  EXPECT_EQ(test::find_claim(claims(), "retrofit.range.lower").verdict, Verdict::refuted);
  EXPECT_EQ(test::find_claim(claims(), "retrofit.range.upper").verdict, Verdict::reproduced);
}

TEST_F(LimitMasks, OddLoopsByFrequencies) {
  EXPECT_EQ(test::find_claim(claims(), "retrofit.finite.n3").exact,
            "((19-sqrt(457))/2, 3) u (8, (19+sqrt(457))/2)");
  const double low = (19 - std::sqrt(457.0)) / 2;
  const double high = (19 + std::sqrt(457.0)) / 2;
  for (double s = -3.005; s < 22; s += 0.01) {
    EXPECT_EQ(loop_converges(s, 3), (low < s && s < 3) || (8 < s && s < high)) << s;
  }
  EXPECT_EQ(test::find_claim(claims(), "retrofit.singular.n3").exact, "3, 8");
  EXPECT_NEAR(error_factor(3, 2 * pi_double / 3), 1, 1e-12);
}

TEST_F(LimitMasks, EndsAreMirrored) {
  EXPECT_EQ(test::find_claim(claims(), "open.opposite.js-report").verdict, Verdict::refuted);
  EXPECT_EQ(test::find_claim(claims(), "open.opposite.jsplines").verdict, Verdict::reproduced);
}

TEST_F(LimitMasks, EveryClaimIsSettled) {
  EXPECT_EQ(claims().size(), limit_mask_heads().size());
  for (const Claim& claim : claims()) EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
}

}  // namespace
}  // namespace subdiv
