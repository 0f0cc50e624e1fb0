#pragma once

#include <cstddef>
#include <utility>

namespace subdiv {

/// The control points of the parts [0, t] and [t, 1] of a Bezier curve, each over [0, 1] again (de Casteljau;
/// notes 1 for t = 1/2). Points is an array or a vector; between(a, b) is (1 - t) a + t b. The points of the
/// first part are those that the algorithm leaves on one side of its triangle, of the second on the other.
template <class Points, class Between>
std::pair<Points, Points> split_bezier(Points points, const Between& between) {
  Points first = points;
  for (std::size_t level = 0; level < points.size(); ++level) {
    first[level] = points[0];
    for (std::size_t i = 0; i + level + 1 < points.size(); ++i) points[i] = between(points[i], points[i + 1]);
  }
  return {std::move(first), std::move(points)};
}

}  // namespace subdiv
