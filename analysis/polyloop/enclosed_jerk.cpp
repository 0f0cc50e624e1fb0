#include "analysis/polyloop/enclosed_jerk.h"

#include <array>
#include <cstddef>
#include <stdexcept>

namespace subdiv {

EnclosedNormalJerk enclosed_normal_jerk(const Polyline& polyline) {
  const std::size_t n = polyline.topology.points;
  if (!polyline.topology.closed || polyline.coordinates.size() != 2 || n < 2)
    throw std::invalid_argument("enclosed normal jerk: of closed plane polylines");
  const auto at = [&](std::size_t c, std::size_t i) { return Interval(polyline.coordinates[c][i % n]); };
  EnclosedNormalJerk result{Interval(0), Interval(0)};
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Interval, 2> jerk;
    std::array<Interval, 2> edge;
    for (std::size_t c = 0; c < 2; ++c) {
      jerk.at(c) = Interval(3) * (at(c, i + 1) - at(c, i + 2)) + at(c, i + 3) - at(c, i);
      edge.at(c) = at(c, i + 2) - at(c, i + 1);
    }
    const Interval length = sqrt(edge[0] * edge[0] + edge[1] * edge[1]);
    if (!certainly_positive(length)) throw std::invalid_argument("enclosed normal jerk: an edge of length 0");
    const Interval normal = abs(edge[0] * jerk[1] - edge[1] * jerk[0]) / length;
    result.largest = max(result.largest, normal);
    result.mean += normal;
  }
  result.mean /= Interval(static_cast<long>(n));
  return result;
}

}  // namespace subdiv
