#pragma once

#include <map>

#include "schemes/mask.h"

namespace subdiv::testing {

/// The points with indices -radius .. radius after `levels` steps of a scheme, straight from the definition
/// P'_i = sum over j of a_{i - m j} P_j; `control` gives P_j for every j.
template <class R, class Control>
std::map<int, R> refine_locally(const Scheme<R>& scheme, int levels, int radius, Control control) {
  // Every step needs the points around 0 that its own masks reach: a radius that maps into itself.
  int reach = radius;
  for (const Mask<R>& step : scheme.steps) {
    reach = std::max({reach, step.symbol.last() + 1, -step.symbol.first() + 1});
  }
  std::map<int, R> points;
  for (int j = -reach; j <= reach; ++j) points[j] = control(j);
  for (int level = 0; level < levels; ++level) {
    const Mask<R>& mask = scheme.step(static_cast<std::size_t>(level));
    std::map<int, R> refined;
    for (int i = -reach; i <= reach; ++i) {
      R value(0);
      for (int j = -reach; j <= reach; ++j) value = value + mask.symbol[i - mask.arity * j] * points.at(j);
      refined[i] = value;
    }
    points = std::move(refined);
  }
  return points;
}

}  // namespace subdiv::testing
