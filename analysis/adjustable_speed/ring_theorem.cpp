#include "analysis/adjustable_speed/ring_theorem.h"

#include <stdexcept>

#include "analysis/adjustable_speed/characteristic_ring_joins.h"
#include "analysis/adjustable_speed/ring_conditions.h"

namespace subdiv {
namespace {

template <class R>
RingShape<R> shape_in_box() {
  const R x0 = R::variable(0);
  const R x1 = R::variable(1);
  return {R(1) - x0 * x1, R(2) - x0};
}

void note(RingTheorem& theorem, bool holds, const std::string& name) {
  if (!holds) theorem.open.push_back(name);
}

}  // namespace

PlaneDomain ring_shapes() {
  const RingShape<Polynomial> shape = shape_in_box<Polynomial>();
  const Polynomial square = shape.v * shape.v;
  Polynomial below;  // (2 W - v^2)/x_0, which is positive where 2 W - v^2 is
  if (!divides(Polynomial::variable(0), Polynomial(2) * shape.width() - square, below))
    throw std::logic_error("2 W - v^2 vanishes at sigma = 1, v = 2");
  return {{{Rational(0), Rational(0)}, {Rational(8, 5), Rational(2)}},
          {shape.sigma, below, Polynomial(5) * square - Polynomial(2) * shape.width()}};
}

RingShape<RationalFunction> ring_coordinates() { return shape_in_box<RationalFunction>(); }

RingTheorem prove_ring_theorem(long cells) {
  const RingShape<RationalFunction> shape = ring_coordinates();
  return prove_ring(characteristic_ring(shape), shape, ring_shapes(), cells);
}

RingTheorem prove_ring(const CharacteristicRing<RationalFunction>& ring,
                       const RingShape<RationalFunction>& shape, const PlaneDomain& domain, long cells) {
  RingTheorem theorem;
  for (const auto& [name, difference] : ring_joins(ring, shape)) {
    ++theorem.identities;
    note(theorem, difference[0].is_zero() && difference[1].is_zero(), name);
  }
  const RingPoint<RationalFunction>& end = ring.border[3];
  note(theorem, ring.border[0][1].is_zero(), "the border begins on the bisectrix");
  note(theorem, (end[0] + end[1]).is_zero(), "the border ends on the spoke");
  theorem.identities += 2;
  bool fails = !theorem.open.empty();  // identities are decided

  DomainSigns signs(domain, cells);
  for (const auto& [name, sign, value] : ring_conditions(ring.sector)) {
    ++theorem.conditions;
    if (value.is_zero()) {
      fails = true;
      theorem.open.push_back(name);
      continue;
    }
    const DomainSign found = signs.sign(value);
    const bool known = found.kind != DomainSign::Kind::undecided;
    const bool right = found.kind == (sign > 0 ? DomainSign::Kind::positive : DomainSign::Kind::negative);
    theorem.cells += found.cells;
    fails = fails || (known && !right);
    note(theorem, right, name);
  }
  if (fails) {
    theorem.holds = Decision::no;
  } else if (theorem.open.empty()) {
    theorem.holds = Decision::yes;
  }
  return theorem;
}

}  // namespace subdiv
