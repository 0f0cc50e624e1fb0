#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "schemes/index_window.h"
#include "schemes/mask.h"

namespace subdiv {

/// The rule of one residue class r of a step: the refined point m q + r is the sum of weights[k]
/// P_{q + first + k}; at least one weight, which may be 0.
template <class R>
struct RefinementRule {
  int first = 0;           ///< the offset of the first control point
  std::vector<R> weights;  ///< at least one

  [[nodiscard]] int last() const { return first + static_cast<int>(weights.size()) - 1; }
};

/// The rules of a step, r = 0 .. m - 1: two for J_s, of three and of four points (js-report 1).
template <class R>
std::vector<RefinementRule<R>> refinement_rules(const Mask<R>& mask) {
  std::vector<RefinementRule<R>> rules;
  for (int r = 0; r < mask.arity; ++r) {
    const Laurent<R> part = reverse(residue_class(mask.symbol, r, mask.arity));
    rules.push_back(part.is_zero() ? RefinementRule<R>{0, {R(0)}}
                                   : RefinementRule<R>{part.first(), part.coefficients()});
  }
  return rules;
}

namespace detail {

/// The offsets from a vertex on which the offsets of a window depend, seen from the vertex one level below.
template <class R>
IndexWindow parents(const Mask<R>& mask, const IndexWindow& window) {
  return {-floor_divide(mask.symbol.last() - window.first, mask.arity),
          floor_divide(window.last - mask.symbol.first(), mask.arity)};
}

inline IndexWindow joined(const IndexWindow& a, const IndexWindow& b) {
  return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

/// The least window that contains the given one and its parents by every step of the scheme.
template <class R>
IndexWindow closed_window(const Scheme<R>& scheme, IndexWindow window) {
  for (IndexWindow before{1, 0}; !(before == window);) {
    before = window;
    for (const Mask<R>& step : scheme.steps) window = joined(window, parents(step, window));
  }
  return window;
}

}  // namespace detail

/// The offsets, seen from a vertex, of the points of one level on which its descendants at this place depend,
/// however deep: an open polygon has that many added points. [-2, 2] for J_{a,b}.
template <class R>
IndexWindow vertex_reach(const Scheme<R>& scheme) {
  return detail::closed_window(scheme, {0, 0});
}

/// The same for `depth` steps and no more, of control points.
template <class R>
IndexWindow vertex_reach(const Scheme<R>& scheme, int depth) {
  IndexWindow window{0, 0};
  for (int k = depth; k-- > 0;)
    window = detail::joined({0, 0}, detail::parents(scheme.step(static_cast<std::size_t>(k)), window));
  return window;
}

/// The offsets of the points that a ring keeps: vertex_reach, and all that the rules read while the child
/// moves from behind its parent up to it. [-2, 2] for J_{a,b}, the 5 points a level of js-report 12.
template <class R>
IndexWindow ring_window(const Scheme<R>& scheme) {
  const int m = scheme.arity();
  IndexWindow window = vertex_reach(scheme);
  for (IndexWindow before{1, 0}; !(before == window);) {
    before = window;
    for (const Mask<R>& step : scheme.steps) {
      const auto rules = refinement_rules(step);
      for (int index = window.last - m + 1; index <= window.last; ++index) {
        const auto& rule = rules[static_cast<std::size_t>(residue(index, m))];
        window.first = std::min(window.first, floor_divide(index, m) + rule.first);
      }
    }
    window = detail::closed_window(scheme, window);
  }
  return window;
}

}  // namespace subdiv
