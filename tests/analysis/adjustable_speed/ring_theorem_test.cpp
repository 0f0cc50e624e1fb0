#include "analysis/adjustable_speed/ring_theorem.h"

#include <gtest/gtest.h>

#include "analysis/adjustable_speed/characteristic_ring_joins.h"
#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/ring_conditions.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

RingShape<Function> shape_in_box() {
  const Function x0 = Function::variable(0);
  return {Function(1) - x0 * Function::variable(1), Function(2) - x0};
}

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
  const auto functions = ring_conditions(characteristic_ring(shape_in_box()).sector);
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

TEST(RingTheorem, WrongDomainsAndWrongRingsAreNotProved) {
  const auto proved = [](const PlaneDomain& domain, const RingSector<RingPoint<Function>>& sector) {
    DomainSigns signs(domain, 200);
    int count = 0;
    for (const auto& condition : ring_conditions(sector)) {
      const auto wanted = condition.sign > 0 ? DomainSign::Kind::positive : DomainSign::Kind::negative;
      count += !condition.value.is_zero() && signs.sign(condition.value).kind == wanted ? 1 : 0;
    }
    return count;
  };
  const RingShape<Function> shape = shape_in_box();
  const CharacteristicRing<Function> ring = characteristic_ring(shape);
  const PlaneDomain right = ring_shapes();
  EXPECT_EQ(proved(right, ring.sector), 97);
  // Beyond c = 1 the sector is turned over.
  PlaneDomain wider = right;
  wider.positive.erase(wider.positive.begin() + 1);
  EXPECT_LT(proved(wider, ring.sector), 97);
  // An inner border elsewhere: lambda^2 times the border's mirror image.
  const Function wrong = shape.eigenvalue() * shape.eigenvalue();
  BezierPatch<RingPoint<Function>> inner = ring.border;
  for (auto& point : inner) point = {wrong * point[0], Function(0) - wrong * point[1]};
  EXPECT_LT(proved(right, ring_sector(ring.border, inner, shape.sigma)), 97);
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
