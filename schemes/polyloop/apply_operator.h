#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "schemes/input_error.h"
#include "schemes/polyloop/polyloop_operator.h"

namespace subdiv {

/// The vertices of a polyloop, or of an open polygon: numbers (a coordinate of points of any dimension), or
/// vectors with + and multiplication by a scalar from the left. vertices[i] is P_{first + i}; operators that
/// tell old and new vertices apart go by these numbers. A closed one begins at 0.
template <class Point>
struct VertexChain {
  std::vector<Point> vertices;  ///< in order
  bool closed = true;           ///< whether the last is followed by the first
  int first = 0;                ///< the number of the first vertex; 0 when closed

  [[nodiscard]] int size() const { return static_cast<int>(vertices.size()); }
};

/// What becomes of vertices of an open polygon whose rules reach beyond its ends (weights 0 reach nowhere).
/// drop: they are left out, with those farther out; refine makes n vertices to 2n - 1 and dual to n - 1 in
/// any case. keep: where an operator moves vertices (PolyloopOperator::moves_vertices) they stay in their
/// places, so that tuck makes n vertices to n; where it makes new ones they are left out.
enum class OpenRule { drop, keep };

namespace detail {

/// The sum of row[j] P_{start + j}; `at` finds a vertex by its number.
template <class R, class Point, class At>
Point combined(const Laurent<R>& row, int start, const Point& any, const At& at) {
  if (row.is_zero()) return R(0) * any;
  Point sum = row[row.first()] * at(start + row.first());
  for (int j = row.first() + 1; j <= row.last(); ++j) {
    if (!is_zero(row[j])) sum = sum + row[j] * at(start + j);
  }
  return sum;
}

template <class R, class Point>
VertexChain<Point> apply_to_closed(const PolyloopOperator<R>& op, const VertexChain<Point>& chain) {
  const int n = chain.size();
  if (n % op.period != 0) {
    throw InputError("a closed polyloop of " + std::to_string(n) + " vertices: this operator repeats after " +
                     std::to_string(op.period) +
                     " vertices, so that their number must be a multiple of it, as it is after refine");
  }
  const auto at = [&](int i) -> const Point& {
    return chain.vertices[static_cast<std::size_t>(residue(i, n))];
  };
  VertexChain<Point> result;
  for (int block = 0; block < n / op.period; ++block) {
    for (const Laurent<R>& row : op.rows)
      result.vertices.push_back(combined(row, block * op.period, chain.vertices.front(), at));
  }
  return result;
}

template <class R, class Point>
VertexChain<Point> apply_to_open(const PolyloopOperator<R>& op, const VertexChain<Point>& chain,
                                 OpenRule rule) {
  const int begin = chain.first;
  const int end = chain.first + chain.size();
  const auto at = [&](int i) -> const Point& { return chain.vertices[static_cast<std::size_t>(i - begin)]; };
  int reach = op.period;  // beyond it no vertex of the result needs one of the chain
  for (const Laurent<R>& row : op.rows)
    reach = std::max({reach, std::abs(row.first()) + op.period, std::abs(row.last()) + op.period});
  const int first_block = floor_divide(begin - reach, op.period);
  const int last_block = floor_divide(end + reach, op.period);
  VertexChain<Point> result{{}, false, first_block * op.outputs()};
  for (int block = first_block; block <= last_block; ++block) {
    for (int r = 0; r < op.outputs(); ++r) {
      const Laurent<R>& row = op.rows[static_cast<std::size_t>(r)];
      const int start = block * op.period;
      const int number = block * op.outputs() + r;
      const bool before = start + row.first() < begin;
      const bool behind = start + row.last() >= end;
      if (rule == OpenRule::keep && op.moves_vertices) {
        if (number < begin || number >= end) continue;
        if (result.vertices.empty()) result.first = number;
        result.vertices.push_back(before || behind ? at(number)
                                                   : combined(row, start, chain.vertices.front(), at));
      } else if (before) {
        result = {{}, false, number + 1};  // short rules outside of it would leave a gap
      } else if (behind) {
        return result;
      } else {
        result.vertices.push_back(combined(row, start, chain.vertices.front(), at));
      }
    }
  }
  return result;
}

}  // namespace detail

/// The operator's vertices for a closed or open polygon. A closed one keeps the numbering of the operator:
/// vertex 0 of dual is the middle of the edge from P_0. Nothing comes of nothing. Throws InputError for a
/// closed polyloop whose number of vertices is no multiple of the operator's period. For an open polygon of
/// which only some rules are known, dropping them step by step gives a part of what the composed operator
/// gives; keeping ends is defined step by step.
template <class R, class Point>
VertexChain<Point> apply(const PolyloopOperator<R>& op, const VertexChain<Point>& chain,
                         OpenRule rule = OpenRule::drop) {
  if (chain.vertices.empty()) return {{}, chain.closed, 0};
  return chain.closed ? detail::apply_to_closed(op, chain) : detail::apply_to_open(op, chain, rule);
}

}  // namespace subdiv
