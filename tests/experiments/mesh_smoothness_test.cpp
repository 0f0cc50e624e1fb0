#include "experiments/mesh_smoothness.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

TEST(MeshSmoothness, ClaimsAreSettledAsTheTheorySays) {
  const Results results = run_mesh_smoothness();
  const auto& claims = results.claims;
  EXPECT_EQ(claims.size(), mesh_smoothness_heads().size());
  for (const Claim& claim : claims) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
  }
  EXPECT_EQ(test::find_claim(claims, "mesh.blend.directional").verdict, Verdict::reproduced);
  EXPECT_EQ(test::find_claim(claims, "mesh.blend.literal").verdict, Verdict::refuted);
  // s and 1 - s change places in the formula as printed.
  EXPECT_NEAR(test::value_of(claims, "mesh.blend.as-printed"),
              1 - test::value_of(claims, "mesh.range.literal.n3.lower"), 1e-12);
  for (const std::string name : {"directional", "literal"}) {
    // The limit 1 is approached from above, by O(1/n) because the slopes in s of the two modes differ.
    const Series& series = test::find_series(results, "mesh-range-" + name + "-upper");
    const auto above = [&](std::size_t row) { return std::stod(series.rows.at(row).at(1)) - 1; };
    const std::size_t last = series.rows.size() - 1;
    EXPECT_GT(above(last), 0);
    EXPECT_NEAR(above(last - 1) / above(last), 2, 0.1);
    const Claim& end = test::find_claim(claims, "mesh.range." + name + ".n3.upper");
    EXPECT_LT(*end.upper - *end.lower, Rational(1) / pow(Rational(10), 30));
  }
}

}  // namespace
}  // namespace subdiv
