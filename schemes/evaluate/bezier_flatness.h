#pragma once

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
/// tolerance > 0, and D is a double (else std::invalid_argument); the product may lie beyond them.
[[nodiscard]] int levels_needed(const BezierCurve& curve, double tolerance);

/// What so many halvings in doubles may have moved a control point of a curve, rounded upwards: each of n
/// averages of a halving adds half a unit in the last place, or half the smallest number; averaging does not
/// enlarge what is there.
[[nodiscard]] double rounding_of_halvings(const BezierCurve& curve, int halvings);

/// How much n (n-1)/8 D of a part, computed, may exceed that of the part without rounding whose control
/// points are within `error` of it, plus `error` itself.
[[nodiscard]] double rounding_of_bound(const BezierCurve& curve, double error);

}  // namespace subdiv
