#pragma once

#include <cstddef>
#include <vector>

#include "schemes/evaluate/bezier_flatness.h"

namespace subdiv {

/// Throws InputError for curves without points, of unequal dimensions or degrees, of degree 0, with
/// coordinates that are not finite or beyond 2^1000 (their differences must not overflow).
void require_drawable(const std::vector<BezierCurve>& curves);

/// A polyline near a chain of curves.
struct BezierPolyline {
  std::vector<std::vector<double>> coordinates;  ///< as in BezierCurve
  std::size_t segments = 0;                      ///< of the polyline
  int deepest = 0;                               ///< the largest number of halvings that led to a segment
  double bound =
      0;  ///< the Hausdorff distance from each curve to its part is at most this, rounding included
};

/// Chords of parts, each halved until the bound is at most the tolerance: the polyline's corners lie on the
/// curve but for rounding. Each curve begins where the one before ends. Throws InputError besides when the
/// tolerance is not positive, below what rounding of these coordinates allows, or needs more than
/// `most_segments`.
[[nodiscard]] BezierPolyline draw_to_tolerance(const std::vector<BezierCurve>& curves, double tolerance,
                                               std::size_t most_segments);

/// The control polygons of 2^depth parts of each curve (notes 1, draw_Bezier); no bound is asked for, the one
/// reached is given. Throws InputError besides for a negative depth and for more than `most_segments`.
[[nodiscard]] BezierPolyline draw_to_depth(const std::vector<BezierCurve>& curves, int depth,
                                           std::size_t most_segments);

/// Control points 1 + n k of k curves of degree n, the last point of each the first of the next. Throws
/// InputError for another number, and for degrees below 1.
[[nodiscard]] std::vector<BezierCurve> consecutive_curves(const std::vector<std::vector<double>>& coordinates,
                                                          int degree);

}  // namespace subdiv
