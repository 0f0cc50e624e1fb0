#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "analysis/limit_mask.h"
#include "schemes/evaluate/control_polygon.h"

namespace subdiv {

/// Where the vertices of a polygon go, and the limit's tangents there: element i at parameter t = i (of the
/// level at hand: i / m^level). Tangents are d/dt at unit spacing of the control points of level 0.
template <class Point>
struct LimitPoints {
  std::vector<Point> positions;  ///< one for each vertex
  std::vector<Point> tangents;   ///< in the same order
};

/// A mask applied at vertex i of a polygon: the sum of mask_j P_{i+j}; indices of a closed polygon go round.
/// Throws std::out_of_range when an open polygon has too few added points, std::domain_error for a mask that
/// is 0.
template <class R, class Point>
Point apply_mask(const Laurent<R>& mask, const ControlPolygon<Point>& polygon, long long i) {
  if (mask.is_zero()) throw std::domain_error("a mask without coefficients gives no point");
  Point sum = mask.coefficients().front() * polygon.at(i + mask.first());
  for (int j = mask.first() + 1; j <= mask.last(); ++j) sum = sum + mask[j] * polygon.at(i + j);
  return sum;
}

/// f^(d) at the points i / m^level, i = 0, 1, .., of the limit f of any scheme: one for each point of that
/// level that belongs to the curve (refined_points). Over any field whose masks exist (derivative_mask);
/// throws as that does, and std::out_of_range for an open polygon with too few added points.
template <class R, class Point>
std::vector<Point> limit_derivatives(const Scheme<R>& scheme, const ControlPolygon<Point>& controls,
                                     int level, int derivative) {
  const std::size_t count = refined_points(controls.topology, scheme.arity(), level);
  const std::size_t spacing = refined_spacing(scheme.arity(), level);
  std::vector<Laurent<R>> masks;  // of the points between two vertices: index spacing q + r, r < spacing
  for (std::size_t r = 0; r < std::min(spacing, count); ++r)
    masks.push_back(point_mask(scheme, level, static_cast<int>(r), derivative));
  std::vector<Point> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(apply_mask(masks[i % spacing], controls, static_cast<long long>(i / spacing)));
  return result;
}

/// Limit points and tangents of the vertices of a level (js-report 5, 11).
template <class R, class Point>
LimitPoints<Point> limit_points(const Scheme<R>& scheme, const ControlPolygon<Point>& controls,
                                int level = 0) {
  return {limit_derivatives(scheme, controls, level, 0), limit_derivatives(scheme, controls, level, 1)};
}

}  // namespace subdiv
