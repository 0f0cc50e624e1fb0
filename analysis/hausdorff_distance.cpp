#include "analysis/hausdorff_distance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <stdexcept>
#include <utility>

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost 1.74 includes its own deprecated headers
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace subdiv {
namespace {

namespace geometry = boost::geometry;
constexpr std::size_t indexed = 3;  // coordinates in the R-tree; distances in them are bounds from below
using IndexPoint = geometry::model::point<double, indexed, geometry::cs::cartesian>;
using IndexBox = geometry::model::box<IndexPoint>;
using IndexSegment = geometry::model::segment<IndexPoint>;
using Entry = std::pair<IndexSegment, std::size_t>;
constexpr std::size_t node_entries = 16;
using Tree = geometry::index::rtree<Entry, geometry::index::quadratic<node_entries>>;

using Point = std::vector<double>;

double distance(std::span<const double> a, std::span<const double> b) {
  double value = 0;
  for (std::size_t c = 0; c < a.size(); ++c) value = std::hypot(value, a[c] - b[c]);
  return value;
}

Point midpoint(const Point& a, const Point& b) {
  Point result(a.size());
  for (std::size_t c = 0; c < a.size(); ++c) result[c] = a[c] / 2 + b[c] / 2;
  return result;
}

/// The edges of a polyline; a single point is an edge of length 0.
class Edges {
 public:
  /// Coordinates are multiplied by 2^-exponent, so that squares neither overflow nor vanish.
  Edges(const Polyline& polyline, int exponent) {
    const std::size_t n = curve_size(polyline.topology);
    const std::size_t first = polyline.topology.closed ? 0 : polyline.topology.before;
    dimension_ = polyline.coordinates.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (const std::vector<double>& c : polyline.coordinates)
        values_.push_back(std::ldexp(c[first + i], -exponent));
    }
    if (n == 0 || dimension_ == 0) throw std::invalid_argument("an empty polyline has no distance");
    points_ = n;
    edges_ = std::max<std::size_t>(1, edge_count(polyline.topology));
  }

  [[nodiscard]] std::size_t size() const { return edges_; }
  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] std::size_t dimension() const { return dimension_; }
  /// Point i, the first one once more after the last.
  [[nodiscard]] std::span<const double> point(std::size_t i) const {
    return std::span<const double>(values_).subspan((i % points_) * dimension_, dimension_);
  }

  /// The distance of a point from edge i.
  [[nodiscard]] double distance_from(std::size_t i, std::span<const double> x) const {
    const auto a = point(i);
    const auto b = point(i + 1);
    double along = 0;
    double square = 0;
    for (std::size_t c = 0; c < dimension_; ++c) {
      along += (x[c] - a[c]) * (b[c] - a[c]);
      square += (b[c] - a[c]) * (b[c] - a[c]);
    }
    const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    double value = 0;
    for (std::size_t c = 0; c < dimension_; ++c) {
      value = std::hypot(value, x[c] - ((1 - t) * a[c] + t * b[c]));
    }
    return value;
  }

 private:
  std::vector<double> values_;  // point by point
  std::size_t dimension_ = 0;
  std::size_t points_ = 0;
  std::size_t edges_ = 0;
};

IndexPoint in_index(std::span<const double> x) {
  const auto at = [&](std::size_t c) { return c < x.size() ? x[c] : 0.0; };
  return {at(0), at(1), at(2)};
}

struct Nearest {
  std::size_t edge = 0;
  double distance = std::numeric_limits<double>::infinity();
};

/// Nearest edges of a polyline.
class EdgeIndex {
 public:
  explicit EdgeIndex(const Edges& edges) : edges_(&edges) {
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < edges.size(); ++i)
      entries.emplace_back(IndexSegment(in_index(edges.point(i)), in_index(edges.point(i + 1))), i);
    tree_ = Tree(entries);
  }

  [[nodiscard]] Nearest nearest(std::span<const double> x) const {
    Nearest best;
    const auto consider = [&](const Entry& entry) {
      const double distance = edges_->distance_from(entry.second, x);
      if (distance < best.distance) best = {entry.second, distance};
    };
    const IndexPoint place = in_index(x);
    tree_.query(geometry::index::nearest(place, 1),
                boost::make_function_output_iterator(std::cref(consider)));
    if (edges_->dimension() <= indexed) return best;
    // Nearer edges may exist in all dimensions: near enough in the indexed ones.
    IndexPoint low = place;
    IndexPoint high = place;
    geometry::subtract_value(low, best.distance);
    geometry::add_value(high, best.distance);
    tree_.query(geometry::index::intersects(IndexBox(low, high)),
                boost::make_function_output_iterator(std::cref(consider)));
    return best;
  }

 private:
  const Edges* edges_;
  Tree tree_;
};

/// A piece of an edge with what is known at its ends.
struct Piece {
  Point p;
  Point q;
  Nearest at_p;
  Nearest at_q;
  double upper = 0;

  friend bool operator<(const Piece& a, const Piece& b) { return a.upper < b.upper; }
};

Piece make_piece(const Edges& to, Point p, Point q, const Nearest& at_p, const Nearest& at_q) {
  const double lipschitz = (at_p.distance + at_q.distance + distance(p, q)) / 2;
  const double from_p = std::max(at_p.distance, to.distance_from(at_p.edge, q));
  const double from_q = std::max(at_q.distance, to.distance_from(at_q.edge, p));
  const double upper = std::min({lipschitz, from_p, from_q});
  return {std::move(p), std::move(q), at_p, at_q, upper};
}

DistanceBounds directed(const Edges& from, const Edges& to, double tolerance) {
  const EdgeIndex index(to);
  std::vector<Nearest> at;
  double lower = 0;
  for (std::size_t i = 0; i < from.points(); ++i) {
    at.push_back(index.nearest(from.point(i)));
    lower = std::max(lower, at.back().distance);
  }
  std::priority_queue<Piece> pieces;
  double upper = lower;  // of all that need not be looked at
  const auto add = [&](Piece piece) {
    if (piece.upper > lower + tolerance) {
      pieces.push(std::move(piece));
    } else {
      upper = std::max(upper, piece.upper);
    }
  };
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t next = (i + 1) % from.points();
    const auto p = from.point(i);
    const auto q = from.point(next);
    add(make_piece(to, {p.begin(), p.end()}, {q.begin(), q.end()}, at[i], at[next]));
  }
  while (!pieces.empty() && pieces.top().upper > lower + tolerance) {
    const Piece piece = pieces.top();
    pieces.pop();
    const Point middle = midpoint(piece.p, piece.q);
    if (middle == piece.p || middle == piece.q) {  // shorter pieces cannot be told apart
      upper = std::max(upper, piece.upper);
      continue;
    }
    const Nearest at_middle = index.nearest(middle);
    lower = std::max(lower, at_middle.distance);
    add(make_piece(to, piece.p, middle, piece.at_p, at_middle));
    add(make_piece(to, middle, piece.q, at_middle, piece.at_q));
  }
  if (!pieces.empty()) upper = std::max(upper, pieces.top().upper);
  return {lower, std::max(lower, upper)};
}

/// The exponent of the largest coordinate. Throws std::invalid_argument for one that is not finite.
int largest_exponent(const Polyline& a, const Polyline& b) {
  double largest = 0;
  for (const Polyline* polyline : {&a, &b}) {
    for (const std::vector<double>& c : polyline->coordinates) {
      for (const double x : c) {
        if (!std::isfinite(x)) throw std::invalid_argument("the distance of polylines needs finite points");
        largest = std::max(largest, std::abs(x));
      }
    }
  }
  return largest > 0 ? std::ilogb(largest) : 0;
}

}  // namespace

DistanceBounds directed_hausdorff_distance(const Polyline& a, const Polyline& b, double tolerance) {
  if (a.coordinates.size() != b.coordinates.size())
    throw std::invalid_argument("the distance of polylines needs points of the same dimension");
  if (!(tolerance > 0)) throw std::invalid_argument("a distance needs a positive tolerance");
  const int exponent = largest_exponent(a, b);
  const double scaled = std::max(std::ldexp(tolerance, -exponent), std::numeric_limits<double>::min());
  const DistanceBounds bounds = directed(Edges(a, exponent), Edges(b, exponent), scaled);
  return {std::ldexp(bounds.lower, exponent), std::ldexp(bounds.upper, exponent)};
}

DistanceBounds hausdorff_distance(const Polyline& a, const Polyline& b, double tolerance) {
  const DistanceBounds there = directed_hausdorff_distance(a, b, tolerance);
  const DistanceBounds back = directed_hausdorff_distance(b, a, tolerance);
  return {std::max(there.lower, back.lower), std::max(there.upper, back.upper)};
}

std::vector<Disparity> disparities(const Scheme<double>& scheme, Polyline controls, int levels,
                                   double tolerance) {
  std::vector<Disparity> result;
  for (int k = 0; k < levels; ++k) {
    const Scheme<double> step = stationary<double>("", scheme.step(static_cast<std::size_t>(k)));
    Polyline fine = refine(step, controls, 1);
    result.push_back({largest_displacement(controls, fine, scheme.arity()),
                      hausdorff_distance(controls, fine, tolerance)});
    controls = std::move(fine);
  }
  return result;
}

}  // namespace subdiv
