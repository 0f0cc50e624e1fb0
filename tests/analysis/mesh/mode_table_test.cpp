#include "analysis/mesh/mode_table.h"

#include <array>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Polynomial s = Polynomial::variable(0);
const Polynomial c = Polynomial::variable(turn_variable);
const Polynomial x = Polynomial::variable(eigenvalue_variable);

Polynomial constant(long p, long q = 1) { return Polynomial(Rational(p, q)); }

/// The value at x = at of every polynomial of a family, coefficient by coefficient.
Interval value_of(const PolynomialFamily& family, const Interval& at) { return family.value(at); }

/// Exactly, by substitution.
Rational value_of(const Polynomial& p, const Rational& x_value, const Rational& c_value,
                  const Rational& s_value) {
  std::array<Rational, 8> point;
  point[0] = s_value;
  point[turn_variable] = c_value;
  point[eigenvalue_variable] = x_value;
  return p.evaluate<Rational>(point);
}

// Coefficients that bend on the cell: their slope at the middle says nothing about its ends.
TEST(ModeTable, WideCellsContainAllTheirParameters) {
  const Polynomial bent =
      x * x - s * s * s * s * x + c * (s * s - constant(1)) * (s + constant(2)) + constant(3, 7) * s * s * s;
  const Polynomial even = x - s * s;  // no slope at 0 at all
  const ModeTable table(ModeEquation{{{bent, 1}, {even, 2}}});
  for (const auto& [lower, upper] : {std::pair{Rational(-1), Rational(1)},
                                     {Rational(-2), Rational(3)},
                                     {Rational(1, 3), Rational(7, 2)},
                                     {Rational(0), Rational(1, 1000)}}) {
    const ModeTable::AtParameter cell = table.at(lower, upper);
    for (const Rational& turn : {Rational(1), Rational(-1), Rational(1, 3)}) {
      const ModeFactors found = cell.at_turn(Interval(turn, ModeTable::precision));
      ASSERT_EQ(found.size(), 2U);
      EXPECT_EQ(found[1].second, 2);
      for (int i = 0; i <= 24; ++i) {
        const Rational at = lower + (upper - lower) * Rational(i, 24);
        for (const Rational& e : {Rational(0), Rational(1), Rational(-2, 3)}) {
          const Interval where(e, ModeTable::precision);
          EXPECT_TRUE(value_of(found[0].first, where).contains(value_of(bent, e, turn, at)))
              << lower.to_string() << ' ' << at.to_string();
          EXPECT_TRUE(value_of(found[1].first, where).contains(value_of(even, e, turn, at)))
              << lower.to_string() << ' ' << at.to_string();
        }
      }
    }
  }
}

// The mean value theorem on a narrow cell: s^2 moves by 0.002001, a radius of about 0.001.
TEST(ModeTable, NarrowCellsAreNarrow) {
  const ModeTable table(ModeEquation{{{x - s * s, 1}}});
  const ModeFactors found = table.at(Rational(1), Rational(1001, 1000)).at_turn(Interval(0));
  EXPECT_LT(value_of(found[0].first, Interval(0)).radius(), 0.0011);
}

}  // namespace
}  // namespace subdiv
