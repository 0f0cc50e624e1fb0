#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "analysis/curve_measures.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// What the vertices of a polyloop say of a smooth curve that passes one of them in each unit of time
/// (Rossignac: Smoothing and subdivision of polyloops, 2006, section 1). A, B, C, D are consecutive vertices
/// in any number of dimensions; with vertices h apart in another parameter, velocities are h times, and
/// accelerations and jerks h^2 and h^3 times the derivatives by it. Curvatures do not depend on the
/// parameter.
///
/// Curvatures are 0, and radii infinite, where A, B and C lie on one line, in any order and also when some of
/// them are equal: then no circle and no parabola turns. The functions over a field R are exact where R is,
/// and give squares, which need no roots.

/// The velocity at B, (AB + BC)/2 = (C - A)/2.
template <class R>
Vector<R> vertex_velocity(const Vector<R>& a, const Vector<R>& c) {
  return (c - a) * fraction<R>(1, 2);
}

/// The acceleration at B, BC - AB = A - 2B + C: twice the way from B to the middle of A and C.
template <class R>
Vector<R> vertex_acceleration(const Vector<R>& a, const Vector<R>& b, const Vector<R>& c) {
  return a - b - b + c;
}

/// The jerk of edge BC, the difference of the accelerations at its ends: -A + 3B - 3C + D.
template <class R>
Vector<R> edge_jerk(const Vector<R>& a, const Vector<R>& b, const Vector<R>& c, const Vector<R>& d) {
  return (b - c) * R(3) + d - a;
}

/// u . u.
template <class R>
R squared_length(const Vector<R>& u) {
  R sum(0);
  for (Eigen::Index i = 0; i < u.size(); ++i) sum = sum + u(i) * u(i);
  return sum;
}

/// The square of the area of the parallelogram that two vectors span: the sum of its squared minors, |u|^2
/// |v|^2 - (u . v)^2 without the cancellation.
template <class R>
R squared_area(const Vector<R>& u, const Vector<R>& v) {
  R sum(0);
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    for (Eigen::Index j = i + 1; j < u.size(); ++j) {
      const R minor = u(i) * v(j) - u(j) * v(i);
      sum = sum + minor * minor;
    }
  }
  return sum;
}

/// 1/r^2 of the circle through A, B and C: r = |AB| |BC| |CA| / (2 |AB x BC|).
template <class R>
R squared_circle_curvature(const Vector<R>& a, const Vector<R>& b, const Vector<R>& c) {
  const Vector<R> u = b - a;
  const Vector<R> v = c - b;
  const R area = squared_area(u, v);
  if (is_zero(area)) return R(0);
  return R(4) * area / (squared_length(u) * squared_length(v) * squared_length(Vector<R>(c - a)));
}

/// 1/r^2 of the parabola that passes A, B and C at times -1, 0 and 1, at B: r = V^2/(2h), V the velocity at B
/// and h the distance of B from the line AC, so that 2h is the length of the part of the acceleration across
/// V.
template <class R>
R squared_parabola_curvature(const Vector<R>& a, const Vector<R>& b, const Vector<R>& c) {
  const Vector<R> chord = c - a;
  const R area = squared_area(Vector<R>(b - a), chord);
  if (is_zero(area)) return R(0);
  const R square = squared_length(chord);
  return R(64) * area / (square * square * square);
}

/// The square of the part of the jerk of BC across BC; of the whole jerk where B = C (normal_jerks).
template <class R>
R squared_normal_jerk(const Vector<R>& a, const Vector<R>& b, const Vector<R>& c, const Vector<R>& d) {
  const Vector<R> jerk = edge_jerk(a, b, c, d);
  const Vector<R> edge = c - b;
  const R square = squared_length(edge);
  return is_zero(square) ? squared_length(jerk) : squared_area(edge, jerk) / square;
}

/// The estimates at a vertex in double precision. Directions of unit length; empty where there is none.
struct VertexGeometry {
  std::vector<double> velocity;      ///< a component for each coordinate
  std::vector<double> acceleration;  ///< likewise
  std::vector<double> tangent;       ///< of the velocity; none where A = C
  /// In the plane the tangent turned left by a right angle. In other dimensions the direction of the part of
  /// the acceleration across the tangent, towards the centre of curvature; none where A, B, C lie on a line.
  std::vector<double> normal;
  double circle_curvature = 0;    ///< in the plane positive for a turn to the left; else not negative
  double parabola_curvature = 0;  ///< the same

  [[nodiscard]] double circle_radius() const { return radius(circle_curvature); }
  [[nodiscard]] double parabola_radius() const { return radius(parabola_curvature); }

 private:
  /// Infinite for curvature 0.
  static double radius(double curvature) {
    return curvature == 0 ? std::numeric_limits<double>::infinity() : 1 / std::abs(curvature);
  }
};

/// At every vertex of a closed polyloop; at the inner ones of an open one, from its second point. Points that
/// are not finite give values that are not.
[[nodiscard]] std::vector<VertexGeometry> vertex_geometry(const Polyline& polyline);

/// The jerks of all edges that normal_jerks speaks of, in its order: edge i of a closed polyloop from point
/// i, of an open one from point i + 1.
[[nodiscard]] std::vector<std::vector<double>> edge_jerks(const Polyline& polyline);

}  // namespace subdiv
