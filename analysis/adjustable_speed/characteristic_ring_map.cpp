#include "analysis/adjustable_speed/characteristic_ring_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/adjustable_speed/ring_theorem.h"
#include "analysis/mesh/bernstein_patch.h"
#include "schemes/algebra/turn.h"

namespace subdiv {
namespace {

/// Bits that are worked with at least: what sigma is known to is then all that limits an answer.
constexpr long ring_precision = 256;

void require_valence(int valence) {
  if (valence < 3) throw std::invalid_argument("characteristic ring: the valence is at least 3");
}

template <class R>
RingShape<R> shape_at(const R& sigma, const R& one_plus_cosine, const R& root) {
  return {sigma, (one_plus_cosine * sigma + root) / R(2)};
}

/// What is below the root of (1 + c)^2 sigma^2 + 4 (1 + c) q.
template <class R>
R discriminant(const R& sigma, const R& d) {
  return d * (d * sigma * sigma + R(4) * (R(1) - sigma));
}

/// 1 + cos(2 pi/n) = 2 cos^2(pi/n).
Interval one_plus_cosine(int valence, long precision) {
  const Interval half_turn = cos(pi(precision) / Interval(valence));
  return Interval(2) * half_turn * half_turn;
}

template <std::size_t N>
using Series = Taylor<Interval, N>;

template <std::size_t N>
Series<N> sqrt(const Series<N>& x) {
  Series<N> root;
  root.c[0] = subdiv::sqrt(x.c[0]);
  const Interval twice = Interval(2) * root.c[0];
  for (std::size_t k = 1; k < N; ++k) {
    Interval rest = x.c[k];
    for (std::size_t j = 1; j < k; ++j) rest -= root.c[j] * root.c[k - j];
    root.c[k] = rest / twice;
  }
  return root;
}

/// Bernstein coefficients of the Jacobian; a unit of the parameters is that of the whole ring.
void add_jacobians(SignsFound& found, const BezierPatch<RingPoint<Interval>>& patch, const Interval& area) {
  SquarePatch x(3, 3);
  SquarePatch y(3, 3);
  for (std::size_t slot = 0; slot < patch.size(); ++slot) {
    const auto i = static_cast<int>(slot / 4);
    const auto j = static_cast<int>(slot % 4);
    x(i, j) = patch[slot][0];
    y(i, j) = patch[slot][1];
  }
  SquarePatch jacobian = derivative_u(x) * derivative_v(y) - derivative_u(y) * derivative_v(x);
  for (int i = 0; i <= jacobian.degree_u(); ++i) {
    for (int j = 0; j <= jacobian.degree_v(); ++j) jacobian(i, j) /= area;
  }
  int parts = 0;
  add_signs(found, jacobian, 0, parts);
}

/// All conditions hold for all speeds in the cell.
bool hold_on(const Interval& cell, const std::function<RingExpansion(const Interval&)>& expanded) {
  // Taylor's theorem: the coefficients at the middle, the remainder's on the whole interval. Plain interval
  // arithmetic would count sigma's width again wherever sigma occurs.
  const Interval middle = cell.center();
  const Interval off = cell - middle;
  const RingExpansion at_middle = expanded(middle);
  const RingExpansion on_cell = expanded(cell);
  for (std::size_t k = 0; k < at_middle.size(); ++k) {
    Interval value = on_cell[k].value.c[ring_order];
    for (std::size_t j = ring_order; j > 0; --j) value = value * off + at_middle[k].value.c[j - 1];
    if (at_middle[k].sign > 0 ? !certainly_positive(value) : !certainly_negative(value)) return false;
  }
  return true;
}

/// One proof, for all speeds and valences.
bool theorem_holds() {
  static const bool holds = prove_ring_theorem().holds == Decision::yes;
  return holds;
}

/// For sigma in (0, 1) if inside is true.
CharacteristicMap map_on(const Interval& cell, int valence, bool inside) {
  CharacteristicMap map;
  map.eigenvalue = ring_shape(cell, valence).eigenvalue();
  map.eigenvalue_of_mode_1 = map.eigenvalue.to_double();
  map.method = "signs of Bezier differences over intervals";
  if (ring_conditions_on(cell, valence).hold != Decision::yes) {
    if (!inside || !theorem_holds()) return map;
    map.method = "signs of Bezier differences for all speeds and valences, exact";
  }
  map.rigour = Rigour::certified;
  map.regular = map.injective = Decision::yes;
  map.winding = 1;
  const RingShape<Interval> middle = ring_shape(cell.center(), valence);
  const RingSector<RingPoint<Interval>> ring = characteristic_ring(middle).sector;
  SignsFound jacobians;
  add_jacobians(jacobians, ring.corner, middle.sigma * middle.sigma);
  add_jacobians(jacobians, ring.first_side, middle.sigma * middle.rest());
  const bool known = jacobians.positive && !jacobians.negative && !jacobians.open;
  if (known) map.jacobian_ratio = jacobians.smallest / jacobians.largest;
  return map;
}

}  // namespace

template <>
RingShape<double> ring_shape(const double& sigma, int valence) {
  require_valence(valence);
  const double d = 1 + cosine_of_turn<double>(1, valence);
  return shape_at(sigma, d, std::sqrt(discriminant(sigma, d)));
}

template <>
RingShape<Interval> ring_shape(const Interval& sigma, int valence) {
  require_valence(valence);
  const Interval d = one_plus_cosine(valence, sigma.working_precision());
  return shape_at(sigma, d, subdiv::sqrt(discriminant(sigma, d)));
}

RingExpansion ring_expansion(const Interval& sigma, int valence) {
  using Value = Series<ring_order + 1>;
  const Value s = Value::variable(sigma);
  const Value d = Value::constant(one_plus_cosine(valence, sigma.working_precision()));
  return ring_conditions(characteristic_ring(shape_at(s, d, sqrt(discriminant(s, d)))).sector);
}

RingRange conditions_on(const Interval& sigma, const std::function<RingExpansion(const Interval&)>& expanded,
                        int cells) {
  RingRange result;
  if (!sigma.is_finite() || !certainly_positive(sigma) || !certainly_less(sigma, Interval(1))) return result;
  const long precision = std::max(ring_precision, sigma.working_precision());
  std::vector<std::pair<Rational, Rational>> waiting{{sigma.lower(), sigma.upper()}};
  while (!waiting.empty()) {
    if (result.cells >= cells) return result;
    const auto [lower, upper] = waiting.back();
    waiting.pop_back();
    ++result.cells;
    if (hold_on(Interval::hull(lower, upper, precision), expanded)) continue;
    const Rational middle = (lower + upper) / Rational(2);
    waiting.emplace_back(lower, middle);
    waiting.emplace_back(middle, upper);
  }
  result.hold = Decision::yes;
  return result;
}

RingRange ring_conditions_on(const Interval& sigma, int valence, int cells) {
  require_valence(valence);
  return conditions_on(
      sigma, [valence](const Interval& part) { return ring_expansion(part, valence); }, cells);
}

CharacteristicMap speed_characteristic_map(const Interval& sigma, int valence) {
  return map_on(sigma.with_precision(std::max(ring_precision, sigma.working_precision())), valence,
                sigma.is_finite() && certainly_positive(sigma) && certainly_less(sigma, Interval(1)));
}

CharacteristicMap speed_characteristic_map(const Rational& sigma, int valence) {
  if (sigma.sign() <= 0 || !(sigma < Rational(1)))
    throw std::invalid_argument("characteristic ring: the speed lies strictly between 0 and 1");
  return map_on(Interval(sigma, ring_precision), valence, true);
}

}  // namespace subdiv
