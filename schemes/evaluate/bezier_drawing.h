#pragma once

#include <cstddef>
#include <vector>

namespace subdiv {

/// The control points of a Bezier curve of any degree n >= 1 in any dimension: coordinate c of point i is
/// curve[c][i], 0 <= i <= n.
using BezierCurve = std::vector<std::vector<double>>;

/// Bounds for the Hausdorff distance between the curve of these points (as they are stored) and a polyline,
/// rounded upwards. D is the largest |b_{i-1} - 2 b_i + b_{i+1}|, h the largest distance of a b_i from the
/// segment of b_0 and b_n.
///
/// The chord: the smallest of three bounds. n (n-1)/8 D, as linear interpolation errs by |f''|/8 at most and
/// |f''| <= n (n-1) D (Filip, Magedson & Markot: Surface algorithms using bounds on derivatives, 1986). The
/// same with the parts of second differences across the chord alone, for the distance from its line, plus how
/// far control points reach beyond its ends. And h: the curve lies within h of the chord, as its control
/// points do. The way back, from chord to curve, is not longer: the curve runs from one end of the chord to
/// the other, so that some point of it projects to each point of the chord. All hold for chords of length 0.
[[nodiscard]] double chord_distance_bound(const BezierCurve& curve);

/// The control polygon: floor(n/2) ceil(n/2) / (2 n) D (Nairn, Peters & Lutterkort: Sharp, quantitative
/// bounds on the distance between a polynomial piece and its Bezier control polygon, 1999). Proof: the
/// polygon, with its corners at i/n, is a line plus the sum of n (second difference) (t - i/n)_+, and the
/// curve its Bernstein polynomial; that of a convex function is not below it, so that the distance is largest
/// when all second differences are D; then it is x (n-x)/(2 n) - (part of x) (1 - part of x)/2 for x = n t,
/// convex between whole x and largest at the middle one.
[[nodiscard]] double polygon_distance_bound(const BezierCurve& curve);

/// How often to halve all parts so that n (n-1)/8 D, which a step divides by four or more, is at most the
/// tolerance (Wang: The subdivision method for finding the intersection between two Bezier curves, 1984).
/// Throws as require_drawable.
[[nodiscard]] int levels_needed(const BezierCurve& curve, double tolerance);

/// Throws InputError for curves without points, of unequal dimensions or degrees, of degree 0, with
/// coordinates that are not finite or beyond 2^1000 (their differences must not overflow).
void require_drawable(const std::vector<BezierCurve>& curves);

/// A polyline near a chain of curves.
struct BezierPolyline {
  std::vector<std::vector<double>> coordinates;  // as in BezierCurve
  std::size_t segments = 0;
  int deepest = 0;   // the largest number of halvings that led to a segment
  double bound = 0;  // the Hausdorff distance from each curve to its part is at most this, rounding included
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
