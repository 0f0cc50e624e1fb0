#include "analysis/curve_measures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "schemes/evaluate/level_by_level.h"

namespace subdiv {
namespace {

/// Neumaier's compensated sum.
class Sum {
 public:
  void add(double x) {
    const double total = total_ + x;
    if (!std::isfinite(total)) {
      lost_ = 0;  // inf - inf would hide an infinity behind a NaN
    } else if (std::abs(total_) >= std::abs(x)) {
      lost_ += (total_ - total) + x;
    } else {
      lost_ += (x - total) + total_;
    }
    total_ = total;
  }
  [[nodiscard]] double value() const { return total_ + lost_; }

 private:
  double total_ = 0;
  double lost_ = 0;
};

/// The points of the curve alone, by place on it; a closed curve goes round.
class Points {
 public:
  explicit Points(const Polyline& polyline)
      : polyline_(&polyline),
        size_(curve_size(polyline.topology)),
        offset_(polyline.topology.closed ? 0 : polyline.topology.before) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t dimension() const { return polyline_->coordinates.size(); }
  [[nodiscard]] double operator()(std::size_t coordinate, std::size_t i) const {
    return polyline_->coordinates[coordinate][offset_ + i % size_];
  }

 private:
  const Polyline* polyline_;
  std::size_t size_;
  std::size_t offset_;
};

/// The length of a vector given by its coordinates, without overflow on the way.
template <class Coordinate>
double norm(std::size_t dimension, Coordinate coordinate) {
  double value = 0;
  for (std::size_t c = 0; c < dimension; ++c) value = std::hypot(value, coordinate(c));
  return value;
}

void require_closed(const Polyline& polyline, std::size_t dimension, const std::string& what) {
  if (!polyline.topology.closed) throw std::invalid_argument(what + " needs a closed polygon");
  if (polyline.coordinates.size() != dimension) {
    throw std::invalid_argument(what + " needs points of " + std::to_string(dimension) +
                                " coordinates, these have " + std::to_string(polyline.coordinates.size()));
  }
}

/// 1/2 sum of P_i x P_{i+1} in the plane of two coordinates; seen from P_0, so that a polygon far from the
/// origin loses no digits.
double projected_area(const Points& points, std::size_t x, std::size_t y) {
  Sum sum;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double px = points(x, i) - points(x, 0);
    const double py = points(y, i) - points(y, 0);
    sum.add(px * (points(y, i + 1) - points(y, 0)));
    sum.add(-py * (points(x, i + 1) - points(x, 0)));
  }
  return sum.value() / 2;
}

/// Of edge BC, A being point `first`.
double normal_jerk_from(const Points& points, std::size_t first) {
  const auto jerk = [&](std::size_t c) {
    return -points(c, first) + 3 * points(c, first + 1) - 3 * points(c, first + 2) + points(c, first + 3);
  };
  const auto edge = [&](std::size_t c) { return points(c, first + 2) - points(c, first + 1); };
  const std::size_t dimension = points.dimension();
  const double long_edge = norm(dimension, edge);
  if (long_edge == 0) return norm(dimension, jerk);
  constexpr std::size_t plane = 2;
  if (dimension == plane) return (edge(0) / long_edge) * jerk(1) - (edge(1) / long_edge) * jerk(0);
  double along = 0;
  for (std::size_t c = 0; c < dimension; ++c) along += (edge(c) / long_edge) * jerk(c);
  return norm(dimension, [&](std::size_t c) { return jerk(c) - along * (edge(c) / long_edge); });
}

}  // namespace

Polyline make_polyline(std::vector<std::vector<double>> coordinates, bool closed) {
  const std::size_t n = coordinates.empty() ? 0 : coordinates.front().size();
  for (const std::vector<double>& c : coordinates) {
    if (c.size() != n) throw std::invalid_argument("a polyline's coordinate arrays have different lengths");
  }
  return {{n, closed, 0, 0}, std::move(coordinates)};
}

std::size_t curve_size(const Topology& topology) {
  if (topology.closed) return topology.points;
  const std::size_t added = topology.before + topology.after;
  return topology.points > added ? topology.points - added : 0;
}

std::size_t edge_count(const Topology& topology) {
  return topology.closed ? topology.points : topology.spans();
}

double length(const Polyline& polyline) {
  const Points points(polyline);
  Sum sum;
  for (std::size_t i = 0; i < edge_count(polyline.topology); ++i) {
    sum.add(norm(points.dimension(), [&](std::size_t c) { return points(c, i + 1) - points(c, i); }));
  }
  return sum.value();
}

double signed_area(const Polyline& polyline) {
  require_closed(polyline, 2, "the signed area");
  return projected_area(Points(polyline), 0, 1);
}

std::array<double, 3> vector_area(const Polyline& polyline) {
  require_closed(polyline, 3, "the vector area");
  const Points points(polyline);
  return {projected_area(points, 1, 2), projected_area(points, 2, 0), projected_area(points, 0, 1)};
}

std::vector<double> normal_jerks(const Polyline& polyline) {
  const Points points(polyline);
  const std::size_t n = points.size();
  std::vector<double> result;
  constexpr std::size_t reach = 3;
  if (!polyline.topology.closed) {
    for (std::size_t i = 0; i + reach < n; ++i) result.push_back(normal_jerk_from(points, i));
  } else if (n >= 2) {
    for (std::size_t i = 0; i < n; ++i) result.push_back(normal_jerk_from(points, (i + n - 1) % n));
  }
  return result;
}

NormalJerk normal_jerk(const Polyline& polyline) {
  const std::vector<double> jerks = normal_jerks(polyline);
  NormalJerk result;
  Sum sum;
  for (const double j : jerks) {
    result.largest = std::max(result.largest, std::abs(j));
    sum.add(std::abs(j));
  }
  if (!jerks.empty()) result.mean = sum.value() / static_cast<double>(jerks.size());
  return result;
}

double largest_displacement(const Polyline& parent, const Polyline& fine, int arity) {
  const Points coarse(parent);
  const Points refined(fine);
  const std::size_t expected = refined_points(parent.topology, arity, 1);
  if (refined.size() != expected || parent.coordinates.size() != fine.coordinates.size()) {
    throw std::invalid_argument("no refinement of the parent polygon: it has " +
                                std::to_string(refined.size()) + " points, one refinement has " +
                                std::to_string(expected));
  }
  const auto m = static_cast<std::size_t>(arity);
  double largest = 0;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    const double share = static_cast<double>(i % m) / static_cast<double>(m);
    const auto offset = [&](std::size_t c) {
      const double linear =
          share == 0 ? coarse(c, i / m) : (1 - share) * coarse(c, i / m) + share * coarse(c, i / m + 1);
      return refined(c, i) - linear;
    };
    largest = std::max(largest, norm(coarse.dimension(), offset));
  }
  return largest;
}

Polyline refine(const Scheme<double>& scheme, Polyline controls, int depth) {
  Polyline result{controls.topology, {}};
  for (std::vector<double>& values : controls.coordinates) {
    ControlPolygon<double> refined =
        refine_level_by_level(scheme, ControlPolygon<double>{controls.topology, std::move(values)}, depth);
    result.topology = refined.topology;
    result.coordinates.push_back(std::move(refined.points));
  }
  return result;
}

}  // namespace subdiv
