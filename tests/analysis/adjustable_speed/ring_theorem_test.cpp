#include "analysis/adjustable_speed/ring_theorem.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "analysis/adjustable_speed/characteristic_ring_joins.h"
#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/ring_conditions.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

TEST(RingTheorem, HoldsForAllSpeedsAndValences) {
  const RingTheorem theorem = prove_ring_theorem();
  EXPECT_EQ(theorem.holds, Decision::yes);
  EXPECT_EQ(theorem.conditions, 97);
  EXPECT_TRUE(theorem.open.empty());
}

TEST(RingTheorem, ABudgetLeavesItOpen) {
  const RingTheorem theorem = prove_ring_theorem(1);
  EXPECT_EQ(theorem.holds, Decision::undecided);
  EXPECT_FALSE(theorem.open.empty());
}

TEST(RingTheorem, ShapesOfAllValencesLieInItsDomain) {
  const PlaneDomain domain = ring_shapes();
  for (const int n : {3, 4, 5, 6, 10, 100, 10000}) {
    for (const double sigma : {1e-9, 0.01, 0.3, 0.5, 0.9, 0.999, 0.999999}) {
      const RingShape<double> shape = ring_shape(sigma, n);
      const double x0 = 2 - shape.v;
      EXPECT_TRUE(domain.contains(Rational::from_double(x0), Rational::from_double((1 - sigma) / x0)))
          << n << ' ' << sigma;
    }
  }
}

TEST(RingTheorem, ItsConditionsAreTheRingsOwn) {
  // The functions that are proved, evaluated, against the ring computed in double.
  const auto functions = ring_conditions(characteristic_ring(ring_coordinates()).sector);
  for (const int n : {3, 7, 50}) {
    for (const double sigma : {0.2, 0.8}) {
      const RingShape<double> shape = ring_shape(sigma, n);
      const std::array<double, 2> at{2 - shape.v, (1 - sigma) / (2 - shape.v)};
      const auto values = ring_conditions(characteristic_ring(shape).sector);
      ASSERT_EQ(values.size(), functions.size());
      for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_NEAR(functions[k].value.evaluate<double>(at), values[k].value, 1e-8) << values[k].name;
    }
  }
}

struct Case {
  RingShape<Function> shape = ring_coordinates();
  CharacteristicRing<Function> ring = characteristic_ring(shape);
  PlaneDomain domain = ring_shapes();

  [[nodiscard]] RingTheorem proved() const { return prove_ring(ring, shape, domain, 1000); }
};
bool is_open(const RingTheorem& theorem, const std::string& name) {
  return std::ranges::find(theorem.open, name) != theorem.open.end();
}

TEST(RingTheorem, TheRightRingIsProved) {
  const RingTheorem theorem = Case().proved();
  EXPECT_EQ(theorem.holds, Decision::yes);
  EXPECT_EQ(theorem.identities, 70);
}

TEST(RingTheorem, EveryConditionIsAsked) {
  // A coefficient elsewhere: conditions that read it fail by name, and beside the joins none but those.
  const Case right;
  const auto conditions = ring_conditions(right.ring.sector);
  std::set<std::string> seen;
  for (const std::size_t slot : {0U, 5U, 10U, 15U}) {
    Case wrong = right;
    RingPoint<Function>& point = wrong.ring.sector.corner[slot];
    point = {Function(-3) * point[0], Function(-3) * point[1] - Function(3)};
    const RingTheorem theorem = wrong.proved();
    EXPECT_EQ(theorem.holds, Decision::no);
    const std::string label = "b(" + std::to_string(slot / 4) + "," + std::to_string(slot % 4) + ")";
    for (const std::string& name : theorem.open) {
      if (!name.starts_with("corner x b") && !name.starts_with("corner y b")) continue;
      EXPECT_NE(name.find(label), std::string::npos) << name;
      seen.insert(name);
    }
  }
  EXPECT_GE(seen.size(), 8U);
}

TEST(RingTheorem, AMirroredPatchIsRefused) {
  Case mirrored;
  for (auto& point : mirrored.ring.sector.corner) point[1] = Function(0) - point[1];
  const RingTheorem theorem = mirrored.proved();
  EXPECT_EQ(theorem.holds, Decision::no);
  for (const auto& condition : ring_conditions(mirrored.ring.sector)) {
    const bool turned = condition.name.starts_with("corner y");
    EXPECT_EQ(is_open(theorem, condition.name), turned) << condition.name;
  }
}

TEST(RingTheorem, AConditionThatVanishesIsRefused) {
  Case folded;
  folded.ring.sector.corner[4] = folded.ring.sector.corner[0];
  const RingTheorem theorem = folded.proved();
  EXPECT_EQ(theorem.holds, Decision::no);
  EXPECT_TRUE(is_open(theorem, "corner x b(1,0)-b(0,0)"));
  EXPECT_TRUE(is_open(theorem, "corner y b(1,0)-b(0,0)"));
}

TEST(RingTheorem, AWrongEigenvalueIsRefused) {
  Case wrong;
  const Function square = wrong.shape.eigenvalue() * wrong.shape.eigenvalue();
  BezierPatch<RingPoint<Function>> inner = wrong.ring.border;
  for (auto& point : inner) point = {square * point[0], square * point[1]};
  wrong.ring.sector = ring_sector(wrong.ring.border, inner, wrong.shape.sigma);
  const RingTheorem theorem = wrong.proved();
  EXPECT_EQ(theorem.holds, Decision::no);
  EXPECT_TRUE(is_open(theorem, "side and next ring 0 order 0"));
}

TEST(RingTheorem, EachCoordinateOfAJoinCounts) {
  for (const std::size_t k : {0U, 1U}) {
    Case kinked;  // one coefficient of the side, next to the corner patch
    kinked.ring.sector.first_side[4][k] *= Function(2);
    const RingTheorem theorem = kinked.proved();
    EXPECT_EQ(theorem.holds, Decision::no) << k;
    EXPECT_TRUE(is_open(theorem, "corner and side 1 order 0")) << k;
  }
}

TEST(RingTheorem, EndsOfTheBorderAreOnTheirLines) {
  const std::string begins = "the border begins on the bisectrix";
  const std::string ends = "the border ends on the spoke";
  Case begun;
  begun.ring.border[0][1] += Function(1);
  const RingTheorem not_begun = begun.proved();
  EXPECT_EQ(not_begun.holds, Decision::no);
  EXPECT_TRUE(is_open(not_begun, begins));
  EXPECT_FALSE(is_open(not_begun, ends));
  Case ended;
  ended.ring.border[3][0] += Function(1);
  const RingTheorem not_ended = ended.proved();
  EXPECT_EQ(not_ended.holds, Decision::no);
  EXPECT_TRUE(is_open(not_ended, ends));
  EXPECT_FALSE(is_open(not_ended, begins));
}

TEST(RingTheorem, BeyondItsDomainSignsFailByName) {
  // Beyond c = 1 the sector is turned over; the joins are identities there too.
  Case wider;
  wider.domain.positive.erase(wider.domain.positive.begin() + 1);
  const RingTheorem theorem = wider.proved();
  EXPECT_EQ(theorem.holds, Decision::no);
  EXPECT_FALSE(theorem.open.empty());
  std::set<std::string> conditions;
  for (const auto& condition : ring_conditions(wider.ring.sector)) conditions.insert(condition.name);
  for (const std::string& name : theorem.open) EXPECT_TRUE(conditions.contains(name)) << name;
}

TEST(RingJoins, SeeWrongEigenvaluesAndWrongNets) {
  const auto broken = [](const CharacteristicRing<Function>& ring, const RingShape<Function>& shape) {
    int count = 0;
    for (const auto& join : ring_joins(ring, shape))
      count += join.difference[0].is_zero() && join.difference[1].is_zero() ? 0 : 1;
    return count;
  };
  const RingShape<Function> shape{Function::variable(0), Function::variable(1)};
  const CharacteristicRing<Function> ring = characteristic_ring(shape);
  EXPECT_EQ(ring_joins(ring, shape).size(), 68U);
  EXPECT_EQ(broken(ring, shape), 0);
  CharacteristicRing<Function> moved = ring;
  for (std::size_t k = 0; k < 4; ++k) moved.border[k][0] += Function(1);
  EXPECT_GT(broken(moved, shape), 0);
  CharacteristicRing<Function> kinked = ring;
  kinked.sector.first_side[7][1] += Function(1);
  EXPECT_GT(broken(kinked, shape), 0);
  // The same ring read with other sizes of its patches.
  const RingShape<Function> other{shape.sigma * shape.sigma, shape.v};
  EXPECT_GT(broken(ring, other), 0);
}

}  // namespace
}  // namespace subdiv
