#include "experiments/mesh_smoothness.h"

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

TEST(MeshSmoothness, ClaimsAreSettledAsTheTheorySays) {
  const Results results = run_mesh_smoothness();
  EXPECT_EQ(results.claims.size(), mesh_smoothness_heads().size());
  for (const Claim& claim : results.claims) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
  }
  const auto& claims = results.claims;
  EXPECT_EQ(test::find_claim(claims, "mesh.blend.directional").verdict, Verdict::reproduced);
  EXPECT_EQ(test::find_claim(claims, "mesh.blend.literal").verdict, Verdict::refuted);
  // s and 1 - s change places in the formula as printed.
  EXPECT_NEAR(test::value_of(claims, "mesh.blend.as-printed"),
              1 - test::value_of(claims, "mesh.range.literal.n3.lower"), 1e-12);
}

}  // namespace
}  // namespace subdiv
