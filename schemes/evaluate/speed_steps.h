#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "schemes/adjustable_speed/speed_rules.h"
#include "schemes/evaluate/surface_ring.h"

namespace subdiv {

/// A step among others: the net goes over to the knots of the step's speed, then it is refined.
template <class R>
struct SpeedStep {
  std::vector<SectorStencil<R>> change;  ///< none where the net has these knots already
  RingRules<R> rules;                    ///< of the refinement that follows
};

/// Steps of these speeds, 0 < sigma < 1, one after the other, from a net over uniform knots.
template <class R>
std::vector<SpeedStep<R>> speed_steps(std::span<const R> speeds) {
  std::vector<SpeedStep<R>> result;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (k > 0 && speeds[k] == speeds[k - 1]) {
      result.push_back({{}, result.back().rules});
      continue;
    }
    const LineKnots<R> before = k == 0 ? uniform_knots<R>() : unit_speed_knots(speeds[k - 1]);
    result.push_back({changed_places(before, unit_speed_knots(speeds[k])), ring_rules(speeds[k])});
  }
  return result;
}

}  // namespace subdiv
