#pragma once

#include <algorithm>
#include <vector>

#include "schemes/index_window.h"
#include "schemes/mask.h"

namespace subdiv {

/// The rule of one residue class r of a step: the refined point m q + r is the sum of weights[k]
/// P_{q + first + k}.
template <class R>
struct RefinementRule {
  int first = 0;
  std::vector<R> weights;

  [[nodiscard]] int last() const { return first + static_cast<int>(weights.size()) - 1; }
};

/// The rules of a step, r = 0 .. m - 1: two for J_s, of three and of four points (js-report 1).
template <class R>
std::vector<RefinementRule<R>> refinement_rules(const Mask<R>& mask) {
  std::vector<RefinementRule<R>> rules;
  for (int r = 0; r < mask.arity; ++r) {
    const Laurent<R> part = reverse(residue_class(mask.symbol, r, mask.arity));
    rules.push_back({part.first(), part.coefficients()});
  }
  return rules;
}

/// A window of coarse points around q = floor(i / m) from which all refined points with indices i + window
/// follow, whatever the residue of i: that of the parent level, for rules applied from any place.
template <class R>
IndexWindow parent_window(const Mask<R>& mask, const IndexWindow& window) {
  const int m = mask.arity;
  return {-floor_divide(mask.symbol.last() - window.first, m),
          floor_divide(m - 1 + window.last - mask.symbol.first(), m)};
}

/// The offsets, seen from a vertex, of the points of one level that its descendants at this place need: the
/// least window around 0 that every step of the scheme maps into itself, with at least m points. [-2, 2], the
/// 5 points a level of js-report 12, for J_{a,b}.
template <class R>
IndexWindow ring_window(const Scheme<R>& scheme) {
  const int m = scheme.arity();
  IndexWindow window{0, 0};
  for (IndexWindow before{1, 0}; !(before == window);) {
    before = window;
    for (const Mask<R>& step : scheme.steps) {
      window.first = std::min(window.first, -floor_divide(step.symbol.last() - window.first, m));
      window.last = std::max(window.last, floor_divide(window.last - step.symbol.first(), m));
      window.first = std::min(window.first, -floor_divide(step.symbol.last() - window.last + m - 1, m));
    }
  }
  return window;
}

}  // namespace subdiv
