#include "analysis/three_tap_smoothness.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/reif.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

/// The tap of J_s.
Algebraic tap(const Rational& s) { return Algebraic((s - Rational(1)) / Rational(2)); }

TEST(ThreeTapSmoothness, SetsOfTheJSplines) {
  // s = 1 + 2p: C^0 (-6, 10), C^1 (-2, 6), C^2 (0, 4), C^3 (1, 3), C^4 {3/2}.
  EXPECT_EQ(three_tap_continuity_set(4, 0).to_string(), "(-7/2, 9/2)");
  EXPECT_EQ(three_tap_continuity_set(4, 1).to_string(), "(-3/2, 5/2)");
  EXPECT_EQ(three_tap_continuity_set(4, 2).to_string(), "(-1/2, 3/2)");
  EXPECT_EQ(three_tap_continuity_set(4, 3).to_string(), "(0, 1)");
  EXPECT_EQ(three_tap_continuity_set(4, 4).to_string(), "{1/4}");
  EXPECT_TRUE(three_tap_continuity_set(4, 5).is_empty());
  EXPECT_THROW((void)three_tap_continuity_set(0, 0), std::domain_error);
  EXPECT_THROW((void)three_tap_continuity_set(4, -1), std::domain_error);
}

TEST(ThreeTapSmoothness, NecessaryConditionOfReifIsAlsoSufficient) {
  // An independent route: eigenvalues of the 9 x 9 subdivision matrix alone.
  const Mask<RationalFunction> mask = jspline(RationalFunction::variable(0));
  for (int order = 1; order <= 4; ++order) {
    const RealSet reif = reif_set(mask, order);
    const RealSet taps = three_tap_continuity_set(4, order);
    ASSERT_EQ(reif.parts.size(), taps.parts.size());
    for (int i = -40; i <= 80; ++i) {
      const Rational s(i, 10);
      EXPECT_EQ(reif.contains(Algebraic(s)), taps.contains(tap(s))) << order << " " << s.to_string();
    }
  }
}

TEST(ThreeTapSmoothness, ExponentsOfKnownSplines) {
  EXPECT_EQ(three_tap_exponent(4, tap(1)).exact, "3");               // cubic B-spline
  EXPECT_EQ(three_tap_exponent(4, tap(Rational(3, 2))).exact, "5");  // quintic
  EXPECT_EQ(three_tap_exponent(4, tap(2)).exact, "4");               // combination of quartic B-splines
  EXPECT_EQ(three_tap_exponent(4, tap(3)).exact, "3");
  EXPECT_EQ(three_tap_exponent(4, tap(0)).exact, "2");  // four-point
  // Deslauriers & Dubuc, 6 points: n = 6, p = -(..): see the dual four-point scheme at w = 1/128, 6 - log2 9.
  EXPECT_EQ(three_tap_exponent(5, Algebraic(Rational(-5, 8))).exact, "4-log2(9/4)");
}

TEST(ThreeTapSmoothness, ExponentsAreEnclosed) {
  const Enclosure e = three_tap_exponent(4, tap(Rational(689, 1000)));
  EXPECT_EQ(e.exact, "3-log2(1311/1000)");
  EXPECT_EQ(e.rigour, Rigour::certified);
  // 3 - log2(1.311) to 24 digits, computed independently.
  EXPECT_LT(abs(e.midpoint() - Rational::parse("2.609332314440332496069552")), Rational::parse("1e-23"));
  EXPECT_LT(e.width(), Rational::parse("1e-30"));
  EXPECT_THROW((void)three_tap_exponent(4, tap(10)), std::domain_error);
  EXPECT_THROW((void)three_tap_exponent(4, tap(-6)), std::domain_error);
}

TEST(ThreeTapSmoothness, ContinuityIsTheLastOrderThatHolds) {
  EXPECT_EQ(three_tap_continuity(4, tap(Rational(1, 2))), 2);
  EXPECT_EQ(three_tap_continuity(4, tap(0)), 1);
  EXPECT_EQ(three_tap_continuity(4, tap(1)), 2);
  EXPECT_EQ(three_tap_continuity(4, tap(Rational(3, 2))), 4);
  EXPECT_EQ(three_tap_continuity(4, tap(2)), 3);
  EXPECT_EQ(three_tap_continuity(4, tap(11)), -1);
}

}  // namespace
}  // namespace subdiv
