#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace subdiv {

/// How the points of a control polygon follow each other. Point 0 stands at the parameter t = 0 and points
/// are a unit apart. A closed polygon has period `points`: t runs over [0, points). An open one has `before`
/// points ahead of point 0 and `after` points behind its last one, which carry the ends of the curve but bear
/// no span (js-report 11): t runs over [0, points - before - after - 1].
struct Topology {
  std::size_t points = 0;  ///< all of them, those added at the ends included
  bool closed = true;      ///< whether the last point is followed by the first
  std::size_t before = 0;  ///< added ahead of point 0; 0 when closed
  std::size_t after = 0;   ///< added behind the last point; 0 when closed

  /// Unit intervals of t that the curve runs over; 0 for an empty polygon or a single open point.
  [[nodiscard]] std::size_t spans() const {
    if (closed) return points;
    const std::size_t added = before + after + 1;
    return points > added ? points - added : 0;
  }

  /// Where point i is stored, i of any sign. Throws std::out_of_range beyond the ends of an open polygon, or
  /// when there are no points.
  [[nodiscard]] std::size_t slot(long long i) const {
    const auto n = static_cast<long long>(points);
    if (closed && n > 0) return static_cast<std::size_t>(((i % n) + n) % n);
    const long long place = i + static_cast<long long>(before);
    if (closed || place < 0 || place >= n)
      throw std::out_of_range("control point " + std::to_string(i) + " does not exist");
    return static_cast<std::size_t>(place);
  }

  friend bool operator==(const Topology&, const Topology&) = default;
};

/// A polygon of points of any kind: numbers, or vectors with + and multiplication by a scalar from the left.
template <class Point>
struct ControlPolygon {
  Topology topology;          ///< how they follow each other
  std::vector<Point> points;  ///< added ones included, in order

  [[nodiscard]] const Point& at(long long i) const { return points[topology.slot(i)]; }
};

/// A closed polygon of these points, point 0 first.
template <class Point>
ControlPolygon<Point> closed_polygon(std::vector<Point> points) {
  const std::size_t n = points.size();
  return {{n, true, 0, 0}, std::move(points)};
}

/// An open polygon whose first `before` and last `after` points bear no span.
template <class Point>
ControlPolygon<Point> open_polygon(std::vector<Point> points, std::size_t before, std::size_t after) {
  const std::size_t n = points.size();
  return {{n, false, before, after}, std::move(points)};
}

/// A polygon as one array a coordinate, for evaluation at speed: coordinate c of point i stands at
/// coordinates[c][topology.slot(i)].
template <class T>
struct CoordinateArrays {
  Topology topology;                        ///< how they follow each other
  std::vector<std::vector<T>> coordinates;  ///< an array for each coordinate
};

/// m^depth. Throws std::overflow_error beyond a quarter of what std::size_t holds (2^62).
[[nodiscard]] inline std::size_t refined_spacing(int arity, int depth) {
  constexpr std::size_t most = std::size_t{1} << (std::numeric_limits<std::size_t>::digits - 2);
  std::size_t power = 1;
  for (int k = 0; k < depth; ++k) {
    if (power > most / static_cast<std::size_t>(arity))
      throw std::overflow_error("too many points: " + std::to_string(arity) + "^" + std::to_string(depth));
    power *= static_cast<std::size_t>(arity);
  }
  return power;
}

/// How many points the curve has after `depth` steps: indices 0, 1, .. at parameters i / m^depth; one for
/// each 1 / m^depth of a closed curve, one more for an open one (none for an empty polygon). Throws
/// std::overflow_error beyond a quarter of what std::size_t holds (2^62).
[[nodiscard]] inline std::size_t refined_points(const Topology& topology, int arity, int depth) {
  constexpr std::size_t most = std::size_t{1} << (std::numeric_limits<std::size_t>::digits - 2);
  if (topology.points == 0) return 0;
  const std::size_t spacing = refined_spacing(arity, depth);
  if (topology.spans() > most / spacing)
    throw std::overflow_error("too many points: " + std::to_string(topology.spans()) + " spans of " +
                              std::to_string(spacing) + " points");
  return topology.spans() * spacing + (topology.closed ? 0 : 1);
}

}  // namespace subdiv
