#include "experiments/two_parameter_smoothness.h"

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using test::find_claim;

const std::vector<Claim>& claims() {
  static const Results all = run_two_parameter_smoothness();
  return all.claims;
}

TEST(TwoParameterSmoothness, EveryClaimIsSettled) {
  EXPECT_EQ(claims().size(), two_parameter_smoothness_heads().size());
  for (const Claim& claim : claims()) EXPECT_EQ(claim.verdict, Verdict::established) << claim.head.id;
}

TEST(TwoParameterSmoothness, ExactSets) {
  // Reduced schemes: p = (b-1)/4 with |p - 1/2| < 1 for C1 and < 1/2 for C2 on a = 2; p = (b-1)/8 in (0, 1)
  // on the other lines, where the scheme needs |1 - 3p| < 1 too.
  EXPECT_EQ(find_claim(claims(), "smooth.ab.c2").exact, "a = b in (0, 4), or a = 2 and b in (1, 5)");
  EXPECT_EQ(find_claim(claims(), "smooth.ab.c2.scheme").exact, "a = b in (0, 4)");
  EXPECT_EQ(find_claim(claims(), "smooth.ab.line.quadratic").exact, "(-1, 7)");
  EXPECT_EQ(find_claim(claims(), "smooth.ab.line.even").exact, "(1, 9)");
  EXPECT_EQ(find_claim(claims(), "smooth.ab.line.cycle").exact, "(1, 9)");
  EXPECT_EQ(find_claim(claims(), "smooth.ab.line.cycle.scheme").exact, "(1, 19/3)");
  EXPECT_EQ(find_claim(claims(), "smooth.ab.unstable").exact,
            "a = 2; a = b-1 but for (0, 1); 2a+b = 9; (4, 9)");
}

}  // namespace
}  // namespace subdiv
