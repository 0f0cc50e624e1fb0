#include "experiments/speed_spectrum.h"

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

TEST(SpeedSpectrumClaims, AreSettledAsTheTheorySays) {
  const Results results = run_speed_spectrum();
  const auto& claims = results.claims;
  ASSERT_EQ(claims.size(), speed_spectrum_heads().size());
  for (const Claim& claim : claims) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
    EXPECT_NE(claim.rigour, Rigour::approximate) << claim.head.id;
  }
  for (const char* id : {"speed.eq6", "speed.eq7", "speed.eq8", "speed.subdominant", "speed.c1"})
    EXPECT_EQ(test::find_claim(claims, id).verdict, Verdict::reproduced) << id;
  for (const char* id : {"speed.mu", "speed.mu.square", "speed.unbounded", "speed.hyperbolic"})
    EXPECT_EQ(test::find_claim(claims, id).verdict, Verdict::refuted) << id;
  // Zeros of the same functions found by bisection in multiprecision floating point.
  EXPECT_NEAR(test::value_of(claims, "speed.mu.5.end"), 0.981608267833502934, 1e-15);
  // Catmull-Clark at valence 3 has bounded curvature (Peters & Reif: Subdivision Surfaces, 2008).
  EXPECT_LT(test::value_of(claims, "speed.mu.square.3.lower"), 0.5);
  EXPECT_GT(test::value_of(claims, "speed.mu.square.3.upper"), 0.5);
}

TEST(SpeedSpectrumClaims, FigureShowsLambdaOfCatmullClark) {
  const Results results = run_speed_spectrum();
  const Series& series = test::find_series(results, "speed-lambda");
  const auto& half = series.rows.at(49);
  EXPECT_EQ(std::stod(half.at(0)), 0.5);
  // (5 + c + sqrt((9 + c)(1 + c)))/16, c = cos(2 pi/n), at n = 3 and 5 (Peters & Reif 2008, 6.1).
  EXPECT_NEAR(std::stod(half.at(1)), 0.4100970508005519, 1e-11);
  EXPECT_NEAR(std::stod(half.at(2)), 0.5499883545182972, 1e-11);
}

}  // namespace
}  // namespace subdiv
