#include "analysis/polyloop/local_geometry.h"

#include <algorithm>
#include <cstddef>

namespace subdiv {
namespace {

using Double = Vector<double>;

/// Place i on the curve; a closed one goes round.
Double point(const Polyline& polyline, std::size_t i) {
  Double result(static_cast<Eigen::Index>(polyline.coordinates.size()));
  const std::size_t slot = polyline.topology.slot(static_cast<long long>(i));
  for (Eigen::Index c = 0; c < result.size(); ++c)
    result(c) = polyline.coordinates[static_cast<std::size_t>(c)][slot];
  return result;
}

std::vector<double> values(const Double& v) { return {v.data(), v.data() + v.size()}; }

/// The same direction with the largest coordinate in [1, 2), so that squares neither overflow nor vanish; 0
/// and vectors that are not finite stay.
Double scaled(const Double& v, int& exponent) {
  const double largest = v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff();
  exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  return v.unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
}

Double unit(const Double& v) {
  int exponent = 0;
  const Double direction = scaled(v, exponent);
  return direction / std::sqrt(squared_length(direction));
}

/// Whether a plane polygon turns right at B.
bool turns_right(const Double& u, const Double& v) { return u.size() == 2 && u(0) * v(1) < u(1) * v(0); }

/// Each vector in units of a power of 2 of its own.
void add_curvatures(VertexGeometry& at, const Double& a, const Double& b, const Double& c) {
  int of_u = 0;
  int of_v = 0;
  int of_w = 0;
  const Double u = scaled(b - a, of_u);
  const Double v = scaled(c - b, of_v);
  const Double w = scaled(c - a, of_w);
  const double area = std::sqrt(squared_area(u, v));
  if (area == 0 || at.tangent.empty()) return;
  const double edges = std::sqrt(squared_length(u)) * std::sqrt(squared_length(v));
  const double chord = std::sqrt(squared_length(w));
  const double sign = turns_right(u, v) ? -1 : 1;
  at.circle_curvature = sign * std::ldexp(2 * area / (edges * chord), -of_w);
  at.parabola_curvature = sign * std::ldexp(8 * area / (chord * chord * chord), of_u + of_v - 3 * of_w);
}

VertexGeometry geometry_between(const Double& a, const Double& b, const Double& c) {
  VertexGeometry at;
  const Double velocity = vertex_velocity(a, c);
  const Double acceleration = vertex_acceleration(a, b, c);
  at.velocity = values(velocity);
  at.acceleration = values(acceleration);
  if (velocity.size() == 0 || (velocity.array() == 0).all()) return at;
  const Double tangent = unit(velocity);
  at.tangent = values(tangent);
  add_curvatures(at, a, b, c);
  constexpr Eigen::Index plane = 2;
  if (velocity.size() == plane) {
    at.normal = {-tangent(1), tangent(0)};
  } else if (at.circle_curvature != 0) {
    const Double across = acceleration - tangent * tangent.dot(acceleration);
    if ((across.array() != 0).any()) at.normal = values(unit(across));
  }
  return at;
}

}  // namespace

std::vector<VertexGeometry> vertex_geometry(const Polyline& polyline) {
  const std::size_t n = curve_size(polyline.topology);
  const bool closed = polyline.topology.closed;
  std::vector<VertexGeometry> result;
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    result.push_back(geometry_between(point(polyline, closed ? i + n - 1 : i - 1), point(polyline, i),
                                      point(polyline, i + 1)));
  }
  return result;
}

std::vector<std::vector<double>> edge_jerks(const Polyline& polyline) {
  const std::size_t n = curve_size(polyline.topology);
  const std::size_t count = polyline.topology.closed ? (n >= 2 ? n : 0) : (n > 3 ? n - 3 : 0);
  std::vector<std::vector<double>> result;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = polyline.topology.closed ? i + n - 1 : i;
    result.push_back(values(edge_jerk(point(polyline, first), point(polyline, first + 1),
                                      point(polyline, first + 2), point(polyline, first + 3))));
  }
  return result;
}

}  // namespace subdiv
