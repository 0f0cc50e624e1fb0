#pragma once

#include "analysis/curve_measures.h"

namespace subdiv {

/// lower <= distance <= upper in exact arithmetic; rounding adds some 1e-15 of the polylines' extent.
struct DistanceBounds {
  double lower = 0;  ///< proved, for the polylines as sets of points
  double upper = 0;  ///< at most the tolerance more

  [[nodiscard]] double width() const { return upper - lower; }
};

/// The largest distance of a point of polyline a, anywhere on its edges, from polyline b: upper - lower <=
/// tolerance, or as close as doubles allow. Branch and bound over a's edges: the distance to b is 1-Lipschitz
/// along an edge pq, hence at most (d(p) + d(q) + |pq|) / 2 there; and the distance to one edge of b is
/// convex along pq, hence at most the larger of those of p and q. The lower bound is a distance attained.
/// Works in any dimension; nearest edges come from an R-tree over the first three coordinates.
///
/// Throws std::invalid_argument for polylines without points, of different dimensions or with coordinates
/// that are not finite, and for a tolerance that is not positive.
[[nodiscard]] DistanceBounds directed_hausdorff_distance(const Polyline& a, const Polyline& b,
                                                         double tolerance);

/// The Hausdorff distance: the larger of both directions.
[[nodiscard]] DistanceBounds hausdorff_distance(const Polyline& a, const Polyline& b, double tolerance);

/// Disparity of consecutive levels, what switching from a polygon to its refinement moves (jsplines 11).
struct Disparity {
  double displacement = 0;   ///< the largest distance of a new point from its place on the parent's edges
  DistanceBounds hausdorff;  ///< between the two polygons
};

/// Between `controls` and its first refinement, and so on: one a level, `levels` of them. For primal schemes:
/// index i of a level stands at i / m^level.
[[nodiscard]] std::vector<Disparity> disparities(const Scheme<double>& scheme, Polyline controls, int levels,
                                                 double tolerance);

}  // namespace subdiv
