#pragma once

#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "schemes/algebra/laurent.h"
#include "schemes/mask.h"

namespace subdiv {

/// A linear operator on sequences of vertices (Rossignac: Smoothing and subdivision of polyloops, 2006): with
/// m = rows.size(), vertex m k + r of the result is the sum over j of rows[r][j] P_{period k + j}, 0 <= r <
/// m, for all k. It commutes with the shift by `period` vertices: 1 for refine, dual and tuck, 2 for
/// operators that tell old and new vertices apart. A closed polyloop's number of vertices is a multiple of
/// the period.
template <class R>
struct PolyloopOperator {
  int period = 1;                ///< of the vertices that are treated alike
  std::vector<Laurent<R>> rows;  ///< one for each vertex made from a period
  /// Whether vertex i of the result is vertex i of the polyloop, moved: then rules that reach beyond the ends
  /// of an open one can leave it in its place.
  bool moves_vertices = false;

  [[nodiscard]] int outputs() const { return static_cast<int>(rows.size()); }
};

namespace polyloop {

/// Every vertex stays.
template <class R>
PolyloopOperator<R> identity() {
  return {1, {Laurent<R>(1)}, true};
}

/// A new vertex in the middle of each edge (polyloops 3): vertex 2 i is P_i. Also split, of Split & Tweak.
template <class R>
PolyloopOperator<R> refine() {
  const R half = fraction<R>(1, 2);
  return {1, {Laurent<R>(1), Laurent<R>(0, {half, half})}, false};
}

/// The middles of the edges instead of the vertices (polyloops 2): vertex i is (P_i + P_{i+1})/2.
template <class R>
PolyloopOperator<R> dual() {
  const R half = fraction<R>(1, 2);
  return {1, {Laurent<R>(0, {half, half})}, false};
}

/// Vertex B between A and C moves by t M(B), M(B) = (A + C)/2 - B (polyloops 2).
template <class R>
PolyloopOperator<R> tuck(const R& t) {
  const R side = t * fraction<R>(1, 2);
  return {1, {Laurent<R>(-1, {side, R(1) - t, side})}, true};
}

/// tuck(-1) (polyloops 3.1, "u").
template <class R>
PolyloopOperator<R> untuck() {
  return tuck(R(-1));
}

/// After refine: old vertices (2 i) move by `old_share` towards the middle of their new neighbours; new ones
/// (2 i + 1) by `new_share` away from the middle of the vertices three places off, both measured before any
/// moves (polyloops 3.1, Split & Tweak). (1/2, 0): cubic B-splines; (0, 1/8): the four-point scheme.
template <class R>
PolyloopOperator<R> tweak(const R& old_share, const R& new_share) {
  const R pull = old_share * fraction<R>(1, 2);
  const R push = R(0) - new_share * fraction<R>(1, 2);
  const Laurent<R> old_rule(-1, {pull, R(1) - old_share, pull});
  const Laurent<R> new_rule(-2, {push, R(0), R(0), R(1) + new_share, R(0), R(0), push});
  return {2, {old_rule, new_rule}, true};
}

}  // namespace polyloop

/// First `first`, then `second`.
template <class R>
PolyloopOperator<R> composed(const PolyloopOperator<R>& first, const PolyloopOperator<R>& second) {
  const int middle = std::lcm(first.outputs(), second.period);  // vertices between the two that repeat
  PolyloopOperator<R> result;
  result.period = first.period * (middle / first.outputs());
  result.moves_vertices = first.moves_vertices && second.moves_vertices;
  for (int block = 0; block < middle / second.period; ++block) {
    for (const Laurent<R>& row : second.rows) {
      Laurent<R> sum;
      for (int j = row.first(); j <= row.last(); ++j) {
        if (is_zero(row[j])) continue;
        const int between = block * second.period + j;
        const int residue_of = residue(between, first.outputs());
        const int shifted = floor_divide(between, first.outputs()) * first.period;
        sum += row[j] * shift(first.rows[static_cast<std::size_t>(residue_of)], shifted);
      }
      result.rows.push_back(std::move(sum));
    }
  }
  return result;
}

/// The same operator with the least period.
template <class R>
PolyloopOperator<R> reduced(const PolyloopOperator<R>& op) {
  for (int parts = op.period; parts > 1; --parts) {
    if (op.period % parts != 0 || op.outputs() % parts != 0) continue;
    const int period = op.period / parts;
    const auto outputs = static_cast<std::size_t>(op.outputs() / parts);
    bool repeats = true;
    for (std::size_t r = outputs; r < op.rows.size(); ++r)
      repeats = repeats && op.rows[r] == shift(op.rows[r - outputs], period);
    if (repeats)
      return {period,
              {op.rows.begin(), op.rows.begin() + static_cast<std::ptrdiff_t>(outputs)},
              op.moves_vertices};
  }
  return op;
}

/// All of them in their order; the identity for none.
template <class R>
PolyloopOperator<R> sequence(const std::vector<PolyloopOperator<R>>& steps) {
  PolyloopOperator<R> result = polyloop::identity<R>();
  for (const PolyloopOperator<R>& step : steps) result = reduced(composed(result, step));
  return result;
}

/// The operator as a step of subdivision, its arity the number of new vertices for an old one; nothing unless
/// it commutes with every shift.
template <class R>
std::optional<Mask<R>> mask_of(const PolyloopOperator<R>& op) {
  const PolyloopOperator<R> least = reduced(op);
  if (least.period != 1) return std::nullopt;
  const int arity = least.outputs();
  Mask<R> mask{arity, {}};
  for (int r = 0; r < arity; ++r)
    mask.symbol += shift(upsample(reverse(least.rows[static_cast<std::size_t>(r)]), arity), r);
  return mask;
}

/// Whether two masks are the same step but for the numbering of the new vertices.
template <ExactRing R>
bool same_but_for_numbers(const Mask<R>& a, const Mask<R>& b) {
  return a.arity == b.arity && shift(a.symbol, b.symbol.first() - a.symbol.first()) == b.symbol;
}

}  // namespace subdiv
