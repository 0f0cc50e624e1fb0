#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "schemes/evaluate/control_polygon.h"
#include "schemes/mask.h"

namespace subdiv {

/// Measures of polygons in any number of dimensions. A closed polygon includes the edge from its last point
/// to its first; of an open one the points that only carry its ends (Topology::before, after) do not count.
/// All results are doubles. Sums are compensated, so that their rounding error is that of their terms: a few
/// units of 1e-16 relative to the length, or to length times diameter for areas. Points at infinity or NaN
/// give NaN or infinity, except where a function refuses them.
using Polyline = CoordinateArrays<double>;

/// A polyline from coordinate arrays, all points on the curve. Throws std::invalid_argument when the arrays
/// differ in length.
[[nodiscard]] Polyline make_polyline(std::vector<std::vector<double>> coordinates, bool closed);

/// How many points and edges the curve has.
[[nodiscard]] std::size_t curve_size(const Topology& topology);
/// Likewise: one edge less than points where the curve is open.
[[nodiscard]] std::size_t edge_count(const Topology& topology);

/// The sum of the edges' lengths; 0 for fewer than two points.
[[nodiscard]] double length(const Polyline& polyline);

/// The area that a closed plane polygon encloses, positive when it runs counter-clockwise, parts counted by
/// their winding number: 1/2 sum of P_i x P_{i+1}. Throws std::invalid_argument for an open polygon or
/// another dimension than 2.
[[nodiscard]] double signed_area(const Polyline& polyline);

/// The same in space: the vector 1/2 sum of P_i x P_{i+1}, which any surface that the polygon bounds has as
/// its integral of normals. Throws std::invalid_argument for an open polygon or another dimension than 3.
[[nodiscard]] std::array<double, 3> vector_area(const Polyline& polyline);

/// The normal jerk of every edge BC between neighbours A and D (polyloops 1): the part of the jerk
/// -A + 3B - 3C + D across BC. In the plane signed, positive to the left of BC; in other dimensions its
/// length. Edges of length 0 have no direction: the whole jerk's length. One value for each of the n edges of
/// a closed polygon, edge i from point i; for the n - 3 inner edges of an open one.
[[nodiscard]] std::vector<double> normal_jerks(const Polyline& polyline);

/// The normal jerk of a polygon, absolute values over all edges.
struct NormalJerk {
  double largest = 0;  ///< of the absolute values
  double mean = 0;     ///< over all edges
};
/// 0 for polygons without such edges.
[[nodiscard]] NormalJerk normal_jerk(const Polyline& polyline);

/// How far a refined polygon is from the linear refinement J_{0,1} of its parent (jsplines 11), what a change
/// of levels moves: the largest |fine_i - linear_i|, where linear_{m j + r} divides edge j of the parent in
/// r : m - r. Throws std::invalid_argument when the fine polygon is not one refinement of the parent by their
/// numbers of points.
[[nodiscard]] double largest_displacement(const Polyline& parent, const Polyline& fine, int arity);

/// Refined `depth` times level by level, each coordinate by itself; over double.
[[nodiscard]] Polyline refine(const Scheme<double>& scheme, Polyline controls, int depth);

}  // namespace subdiv
