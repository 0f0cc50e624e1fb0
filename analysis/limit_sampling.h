#pragma once

#include <stdexcept>

#include "analysis/limit_mask.h"

namespace subdiv {

/// A scheme of `level` >= 1 steps whose points after them are the limit points f(i / m^level) instead of the
/// refined ones: the limit mask is part of the last step. Every evaluator takes it. Throws
/// std::invalid_argument for a level below 1, and as derivative_mask does.
template <class R>
Scheme<R> limit_sampling(const Scheme<R>& scheme, int level) {
  if (level < 1) throw std::invalid_argument("limit points of level 0 are those of the vertices");
  Scheme<R> sampling{scheme.name, {}};
  for (int k = 0; k < level; ++k) sampling.steps.push_back(scheme.step(static_cast<std::size_t>(k)));
  // Point i is the sum of L_j P_{i+j}, so that L's powers count backwards.
  Mask<R>& last = sampling.steps.back();
  last.symbol =
      last.symbol * reverse(vertex_limit_mask(after_steps(scheme, static_cast<std::size_t>(level))));
  return sampling;
}

}  // namespace subdiv
