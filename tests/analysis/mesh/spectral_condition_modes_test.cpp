#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/mesh/spectral_condition.h"

namespace subdiv {
namespace {

const Polynomial s = Polynomial::variable(0);
const Polynomial c = Polynomial::variable(turn_variable);
const Polynomial x = Polynomial::variable(eigenvalue_variable);

Polynomial constant(long p, long q = 1) { return Polynomial(Rational(p, q)); }

/// Each mode k != 0 has the eigenvalue(s) of the factors at c = cos(2 pi k/n); mode 0 has 1 and 1/100.
SpectralCondition condition(const std::vector<std::pair<Polynomial, int>>& factors, int valence) {
  return {ModeEquation{factors}, ModeEquation{{{x - constant(1), 1}, {x - constant(1, 100), 1}}}, valence};
}

/// The eigenvalue s c^2 + (1 + c)/10. At valence 8, c = 1/sqrt(2), 0, -1/sqrt(2), -1 in the modes 1 .. 4: s/2
/// + (2 + sqrt(2))/20, 1/10, s/2 + (2 - sqrt(2))/20, s. So mode 1 is ahead for 0 <= s < (2 + sqrt(2))/10, and
/// beyond that mode 4.
SpectralCondition half_turn() {
  return condition({{x - s * c * c - (c + constant(1)) * constant(1, 10), 1}}, 8);
}

TEST(SpectralConditionModes, TheModeOfHalfATurnDecides) {
  const SpectralCondition eight = half_turn();
  EXPECT_EQ(eight.decide(Rational(0)), Decision::yes);
  EXPECT_EQ(eight.decide(Rational(34, 100)), Decision::yes);
  EXPECT_EQ(eight.decide(Rational(35, 100)), Decision::no);
  EXPECT_EQ(eight.decide(Rational(6, 10), Rational(61, 100)), Decision::no);
  EXPECT_EQ(eight.decide(Rational(3, 10), Rational(4, 10)), Decision::undecided);
  EXPECT_EQ(eight.rival(Rational(34, 100)).mode, 4);
  EXPECT_FALSE(eight.leading(Rational(35, 100)));

  const std::vector<ConditionCell> cells = eight.cells(Rational(0), Rational(9, 10), Rational(1, 1L << 20));
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[0].holds, Decision::yes);
  EXPECT_EQ(cells[2].holds, Decision::no);
  const double end = (2 + std::sqrt(2.0)) / 10;
  EXPECT_LE(cells[1].lower.to_double(), end);
  EXPECT_GE(cells[1].upper.to_double(), end);
  EXPECT_LT((cells[1].upper - cells[1].lower).to_double(), 1e-5);
}

TEST(SpectralConditionModes, TheModeOfHalfATurnIsNextToTheLeadingOne) {
  const Rational at(3, 10);
  const auto leading = half_turn().leading(at);
  ASSERT_TRUE(leading.has_value());
  EXPECT_TRUE(leading->next.contains(at));
  EXPECT_NEAR(leading->subdominant.to_double(), 0.15 + (2 + std::sqrt(2.0)) / 20, 1e-15);
  EXPECT_LT(leading->next.radius(), 1e-20);
}

// An eigenvalue of all modes is n - 1 fold, threefold at least from valence 4 on. At valence 3 these
// are mode 1 and its mirror image.
TEST(SpectralConditionModes, ALeadingEigenvalueOfAllModesIsNotSimple) {
  const std::vector<std::pair<Polynomial, int>> factors{{constant(2) * x - constant(1), 1},
                                                        {constant(10) * x - c, 1}};
  EXPECT_EQ(condition(factors, 3).decide(Rational(0)), Decision::yes);
  for (const int n : {4, 5, 6, 11}) {
    EXPECT_NE(condition(factors, n).decide(Rational(0)), Decision::yes) << n;
    EXPECT_NE(condition(factors, n).decide(Rational(-1), Rational(1)), Decision::yes) << n;
    EXPECT_FALSE(condition(factors, n).leading(Rational(0))) << n;
  }
  // Shared but smaller: it does no harm.
  for (const int n : {4, 5, 6, 11})
    EXPECT_EQ(condition({{constant(10) * x - constant(1), 1}, {constant(4) * x - c - constant(2), 1}}, n)
                  .decide(Rational(0)),
              Decision::yes)
        << n;
}

// (2 + c)/2: more than 1 in mode 1, less in mode 2 of valence 5, where cos(72 degrees) > 0 > cos(144
// degrees).
TEST(SpectralConditionModes, EigenvaluesAbove1AreRefuted) {
  const SpectralCondition five = condition({{constant(2) * x - c - constant(2) - s, 1}}, 5);
  EXPECT_EQ(five.decide(Rational(0)), Decision::no);
  EXPECT_EQ(five.decide(Rational(0), Rational(1, 10)), Decision::no);
  // 1 + s/2 + cos(72 degrees)/2 < 1 from s = -0.31 down.
  EXPECT_EQ(five.decide(Rational(-1, 3)), Decision::yes);
  EXPECT_EQ(five.decide(Rational(-1, 3), Rational(-3, 10)), Decision::undecided);
}

}  // namespace
}  // namespace subdiv
