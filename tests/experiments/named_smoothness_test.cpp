#include "experiments/named_smoothness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const std::vector<Claim>& claims() {
  static const Results all = run_named_smoothness();
  return all.claims;
}

TEST(NamedSmoothness, EveryPrintedOrderIsReproduced) {
  EXPECT_EQ(claims().size(), named_smoothness_heads().size());
  for (const Claim& claim : claims()) EXPECT_EQ(claim.verdict, Verdict::reproduced) << claim.head.id;
}

TEST(NamedSmoothness, ExponentsAreThoseOfTheClosedForm) {
  const auto below = [](double s) { return 3 - std::log2(2 - s); };
  EXPECT_NEAR(test::value_of(claims(), "smooth.named.b2"), below(0.689), 1e-13);
  EXPECT_NEAR(test::value_of(claims(), "smooth.named.b4"), below(1.27), 1e-13);
  EXPECT_NEAR(test::value_of(claims(), "smooth.named.edge.s"), below(0.751), 1e-13);
  EXPECT_NEAR(test::value_of(claims(), "smooth.named.area.model-s"), below(0.476), 1e-13);
  EXPECT_NEAR(test::value_of(claims(), "smooth.named.area.rs.js-report"), below(-0.531), 1e-13);
  EXPECT_NEAR(test::value_of(claims(), "smooth.named.area.exact.js-report"), below(0.4666), 1e-13);
  EXPECT_EQ(test::find_claim(claims(), "smooth.named.edge.j1").exact, "3");
  EXPECT_EQ(test::find_claim(claims(), "smooth.named.vertex.r").exact, "5");
  EXPECT_NE(test::find_claim(claims(), "smooth.named.four-point").note.find("C1 and not C2"),
            std::string::npos);
  EXPECT_NE(test::find_claim(claims(), "smooth.named.four-point").note.find("not attained"),
            std::string::npos);
}

}  // namespace
}  // namespace subdiv
