#include "analysis/adjustable_speed/characteristic_ring_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/adjustable_speed/ring_conditions.h"
#include "analysis/mesh/bernstein_patch.h"

namespace subdiv {
namespace {

Interval number(const char* text) { return Interval(Rational::parse(text)); }
Interval range(const char* lower, const char* upper) {
  return Interval::hull(Rational::parse(lower), Rational::parse(upper));
}

TEST(SpeedCharacteristicMap, IsRegularAndInjectiveNearTheEndsToo) {
  for (const int n : {3, 4, 5, 20, 100, 100000}) {
    for (const char* sigma : {"1/1000000000000", "1/10", "1/2", "9/10", "999999999999/1000000000000"}) {
      const CharacteristicMap map = speed_characteristic_map(number(sigma), n);
      EXPECT_TRUE(map.exists());
      EXPECT_EQ(map.regular, Decision::yes) << n << ' ' << sigma;
      EXPECT_EQ(map.injective, Decision::yes) << n << ' ' << sigma;
      EXPECT_EQ(map.rigour, Rigour::certified);
      EXPECT_EQ(map.winding, 1);
      EXPECT_GT(map.jacobian_ratio, 0);
    }
  }
}

TEST(SpeedCharacteristicMap, HoldsForWholeIntervals) {
  const CharacteristicMap map = speed_characteristic_map(range("0.5", "0.51"), 5);
  EXPECT_EQ(map.injective, Decision::yes);
  for (const double sigma : {0.5, 0.507, 0.51})
    EXPECT_TRUE(map.eigenvalue.overlaps(Interval(ring_shape(sigma, 5).eigenvalue())));
}

TEST(SpeedCharacteristicMap, StaysOpenWhereSigmaIsNotKnownWellEnough) {
  for (const Interval& sigma : {range("0", "1/2"), range("1/2", "1"), number("0"), number("1"), number("-1"),
                                number("2"), range("-1/2", "3/2")}) {
    const CharacteristicMap map = speed_characteristic_map(sigma, 5);
    EXPECT_EQ(map.regular, Decision::undecided) << sigma.to_string();
    EXPECT_EQ(map.injective, Decision::undecided);
    EXPECT_EQ(map.rigour, Rigour::approximate);  // nothing is proved
    EXPECT_FALSE(map.winding);
  }
  EXPECT_THROW((void)speed_characteristic_map(number("1/2"), 2), std::invalid_argument);
}

TEST(SpeedCharacteristicMap, IsDecidedAtEverySpeed) {
  const std::string exact = "signs of Bezier differences for all speeds and valences, exact";
  for (const int zeros : {20, 40, 400}) {
    const Rational tiny = Rational(1) / pow(Rational(10), static_cast<long>(zeros));
    for (const Rational& sigma : {tiny, Rational(1) - tiny}) {
      for (const int n : {3, 100}) {
        const CharacteristicMap map = speed_characteristic_map(sigma, n);
        EXPECT_EQ(map.regular, Decision::yes) << zeros << ' ' << n;
        EXPECT_EQ(map.injective, Decision::yes) << zeros << ' ' << n;
        EXPECT_EQ(map.rigour, Rigour::certified);
        EXPECT_EQ(map.winding, 1);
        EXPECT_GE(map.jacobian_ratio, 0);  // 0 where its precision does not tell
      }
    }
  }
  EXPECT_EQ(speed_characteristic_map(Rational(1) - Rational(1) / pow(Rational(10), 400L), 5).method, exact);
  // A wide interval that is surely inside, and a small one that may contain 1.
  const Rational near_one = Rational(1) - Rational(1) / pow(Rational(10), 40L);
  const CharacteristicMap wide = speed_characteristic_map(range("0.0000001", "0.9999999"), 5);
  EXPECT_EQ(wide.injective, Decision::yes);
  EXPECT_EQ(wide.method, exact);
  EXPECT_EQ(wide.rigour, Rigour::certified);
  EXPECT_NE(speed_characteristic_map(number("1/2"), 5).method, exact);
  EXPECT_EQ(speed_characteristic_map(Interval(near_one, 64), 5).rigour, Rigour::approximate);
  EXPECT_THROW((void)speed_characteristic_map(Rational(0), 5), std::invalid_argument);
  EXPECT_THROW((void)speed_characteristic_map(Rational(1), 5), std::invalid_argument);
  EXPECT_THROW((void)speed_characteristic_map(Rational(1, 2), 2), std::invalid_argument);
}

TEST(RingConditions, EveryOneIsAskedOnIntervals) {
  // One value at a time with the other sign, then one that is 0.
  const Interval speeds = range("0.5", "0.501");
  const auto proved = [&](std::size_t k, int factor) {
    const auto expanded = [&](const Interval& part) {
      RingExpansion conditions = ring_expansion(part, 5);
      if (k < conditions.size()) {
        for (Interval& c : conditions[k].value.c) c *= Interval(factor);
      }
      return conditions;
    };
    return conditions_on(speeds, expanded, 1).hold == Decision::yes;
  };
  const RingExpansion conditions = ring_expansion(speeds, 5);
  ASSERT_EQ(conditions.size(), 97U);
  EXPECT_TRUE(proved(conditions.size(), 1));
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    EXPECT_TRUE(proved(k, 2)) << conditions[k].name;
    EXPECT_FALSE(proved(k, -1)) << conditions[k].name;
    EXPECT_FALSE(proved(k, 0)) << conditions[k].name;
  }
}

TEST(RingConditions, HoldOnThePapersRangeOfSpeeds) {
  for (const int n : {3, 5, 20, 100}) {
    const RingRange found = ring_conditions_on(range("1/10", "9/10"), n);
    EXPECT_EQ(found.hold, Decision::yes) << n;
    EXPECT_GT(found.cells, 1);
  }
  const RingRange ended = ring_conditions_on(range("1/10", "9/10"), 5, 10);
  EXPECT_EQ(ended.hold, Decision::undecided);
  EXPECT_EQ(ended.cells, 10);
  EXPECT_EQ(ring_conditions_on(range("0", "1/2"), 5).hold, Decision::undecided);
}

TEST(SpeedCharacteristicMap, OneHalfIsCatmullClark) {
  const MeshSchemeForms catmull_clark = mesh_scheme_forms(parse_mesh_scheme("catmull-clark"));
  for (const int n : {3, 5, 8}) {
    const CharacteristicMap own = speed_characteristic_map(number("1/2"), n);
    const CharacteristicMap other = characteristic_map(catmull_clark, n);
    EXPECT_TRUE(own.eigenvalue.overlaps(other.eigenvalue)) << n;
    EXPECT_EQ(own.injective, other.injective);
    // The Bernstein coefficients there are those of the same three patches.
    EXPECT_NEAR(own.jacobian_ratio, other.jacobian_ratio, 1e-12) << n;
  }
}

TEST(RingConditions, PatchesWithTheirConditionsHavePositiveJacobians) {
  for (const int n : {3, 7}) {
    const CharacteristicRing<Interval> ring = characteristic_ring(ring_shape(number("3/4"), n));
    for (const auto* patch : {&ring.sector.corner, &ring.sector.first_side, &ring.sector.next_side}) {
      SquarePatch x(3, 3);
      SquarePatch y(3, 3);
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          x(i, j) = (*patch)[static_cast<std::size_t>(4 * i + j)][0];
          y(i, j) = (*patch)[static_cast<std::size_t>(4 * i + j)][1];
        }
      }
      SignsFound found;
      int parts = 0;
      add_signs(found, derivative_u(x) * derivative_v(y) - derivative_u(y) * derivative_v(x), 0, parts);
      EXPECT_TRUE(found.positive && !found.negative && !found.open);
    }
  }
}

TEST(RingConditions, FailForOtherRings) {
  // Turned over, the ring violates them; so does one whose eigenvalue is too large.
  const RingShape<double> shape = ring_shape(0.5, 5);
  const CharacteristicRing<double> ring = characteristic_ring(shape);
  const auto violated = [](const RingSector<RingPoint<double>>& sector) {
    int count = 0;
    for (const auto& condition : ring_conditions(sector))
      count += condition.value * condition.sign > 0 ? 0 : 1;
    return count;
  };
  EXPECT_EQ(ring_conditions(ring.sector).size(), 97U);
  EXPECT_EQ(violated(ring.sector), 0);
  RingSector<RingPoint<double>> mirrored = ring.sector;
  for (auto& point : mirrored.corner) point[1] = -point[1];
  EXPECT_GT(violated(mirrored), 0);
  RingSector<RingPoint<double>> swapped = ring.sector;
  std::swap(swapped.first_side[5], swapped.first_side[6]);
  EXPECT_GT(violated(swapped), 0);
  BezierPatch<RingPoint<double>> inner = ring.border;
  for (auto& point : inner) point = {0.95 * point[0], 0.95 * point[1]};
  EXPECT_GT(violated(ring_sector(ring.border, inner, 0.5)), 0);
}

}  // namespace
}  // namespace subdiv
