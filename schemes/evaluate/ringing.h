#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "schemes/evaluate/control_polygon.h"
#include "schemes/evaluate/details.h"
#include "schemes/evaluate/refinement_rule.h"

namespace subdiv {

/// Ringing (js-report 12): the points of a refined curve one after the other, without its intermediate
/// polygons. Level k = 0 .. depth keeps a ring of consecutive points around its centre c_k; whenever the last
/// ring has passed a vertex of its parent, the parent moves on, so that c_k = ceil(c_{k+1} / m), and every
/// ring that moves computes one point from its parent's. 5 points a level for J_{a,b} (ring_window).
///
/// R is any ring with +, *: exact for rationals, enclosing for intervals. A point is R itself or a vector
/// with
/// + and multiplication by R from the left. Mixed and non-stationary schemes take step k at level k.
template <class R, class Point>
class Ringing {
 public:
  /// Stands at the first refined point. `controls` must outlive the object. Throws std::out_of_range when an
  /// open polygon has too few added points for the rings, or a detail has no place; std::invalid_argument for
  /// a negative depth.
  Ringing(const Scheme<R>& scheme, const ControlPolygon<Point>& controls, int depth,
          Details<Point> details = {})
      : Ringing(scheme, controls, depth, 0, std::move(details)) {}

  /// Stands at control vertex `vertex`, refined index vertex m^depth: evaluation may begin anywhere.
  Ringing(const Scheme<R>& scheme, const ControlPolygon<Point>& controls, int depth, long long vertex,
          Details<Point> details = {})
      : controls_(&controls),
        window_(ring_window(scheme)),
        arity_(scheme.arity()),
        details_(std::move(details)) {
    if (depth < 0) throw std::invalid_argument("a refinement depth is at least 0");
    require_places(details_, controls.topology, arity_, depth);
    require_ends(vertex_reach(scheme, depth));
    end_ = static_cast<long long>(refined_points(controls.topology, arity_, depth));
    for (int k = 0; k < depth; ++k)
      rules_.push_back(refinement_rules(scheme.step(static_cast<std::size_t>(k))));
    computed_.assign(static_cast<std::size_t>(depth) + 1, 0);
    if (end_ > 0) fill(vertex);
  }

  /// The index of the current point on the refined curve, and whether the curve has ended before it.
  [[nodiscard]] long long index() const { return rings_.empty() ? 0 : rings_.back().centre; }
  [[nodiscard]] bool done() const { return index() >= end_; }
  /// The current point. Only while not done().
  [[nodiscard]] const Point& point() const { return at(rings_.back(), rings_.back().centre); }
  /// Moves to the next point. Moving past the end does nothing.
  void advance() {
    if (done()) return;
    if (index() + 1 == end_) {
      ++rings_.back().centre;  // nothing is computed for a point that does not exist
    } else {
      advance(rings_.size() - 1);
    }
  }

  /// The next points of the curve into a buffer of any size; returns how many there were.
  std::size_t write(std::span<Point> buffer) {
    std::size_t count = 0;
    for (; count < buffer.size() && !done(); ++count) {
      buffer[count] = point();
      advance();
    }
    return count;
  }

  /// One pass over the points that remain: for (const Point& p : ringing).
  class Iterator {
   public:
    using value_type = Point;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::input_iterator_tag;

    explicit Iterator(Ringing& rings) : rings_(&rings) {}
    const Point& operator*() const { return rings_->point(); }
    Iterator& operator++() {
      rings_->advance();
      return *this;
    }
    void operator++(int) { rings_->advance(); }
    friend bool operator==(const Iterator& i, std::default_sentinel_t) { return i.rings_->done(); }

   private:
    Ringing* rings_;
  };
  [[nodiscard]] Iterator begin() { return Iterator(*this); }
  [[nodiscard]] static std::default_sentinel_t end() { return {}; }

  /// The footprint: points kept at each level, and levels, the control polygon's among them.
  [[nodiscard]] std::size_t points_per_level() const { return static_cast<std::size_t>(window_.size()); }
  [[nodiscard]] std::size_t levels() const { return computed_.size(); }
  /// The work so far: points that level k has loaded (k = 0) or computed.
  [[nodiscard]] std::size_t computed(std::size_t level) const { return computed_[level]; }

 private:
  struct Ring {
    long long centre = 0;
    std::size_t first = 0;  // the slot of the point at the window's first offset
    std::vector<Point> points;
  };

  [[nodiscard]] const Point& at(const Ring& ring, long long index) const {
    std::size_t slot = ring.first + static_cast<std::size_t>(index - ring.centre - window_.first);
    if (slot >= ring.points.size()) slot -= ring.points.size();
    return ring.points[slot];
  }

  /// Point `index` of a level from its parent ring, or from the control polygon.
  [[nodiscard]] Point computed_point(std::size_t level, long long index) {
    ++computed_[level];
    Point result = level == 0 ? controls_->at(on_polygon(index)) : refined(level, index);
    if (!details_.empty()) {
      const auto period =
          static_cast<long long>(refined_points(controls_->topology, arity_, static_cast<int>(level)));
      const long long place = controls_->topology.closed ? ((index % period) + period) % period : index;
      Details<Point>::apply(details_.at_level(static_cast<int>(level)), place, result);
    }
    return result;
  }

  void require_ends(const IndexWindow& reach) const {
    const Topology& t = controls_->topology;
    if (t.closed || t.points == 0) return;
    if (static_cast<long long>(t.before) < -reach.first || static_cast<long long>(t.after) < reach.last) {
      throw std::out_of_range("an open polygon needs " + std::to_string(-reach.first) +
                              " points before its first vertex and " + std::to_string(reach.last) +
                              " behind its last, it has " + std::to_string(t.before) + " and " +
                              std::to_string(t.after));
    }
  }

  /// A ring may hold a point that no point of the curve depends on; where an open polygon has none, any does.
  [[nodiscard]] long long on_polygon(long long index) const {
    const Topology& t = controls_->topology;
    if (t.closed) return index;
    const long long first = -static_cast<long long>(t.before);
    return std::clamp(index, first, first + static_cast<long long>(t.points) - 1);
  }

  [[nodiscard]] Point refined(std::size_t level, long long index) const {
    const Ring& parent = rings_[level - 1];
    const auto m = static_cast<long long>(arity_);
    const long long r = ((index % m) + m) % m;
    const RefinementRule<R>& rule = rules_[level - 1][static_cast<std::size_t>(r)];
    const long long first = (index - r) / m + rule.first;
    Point sum = rule.weights.front() * at(parent, first);
    for (std::size_t k = 1; k < rule.weights.size(); ++k)
      sum = sum + rule.weights[k] * at(parent, first + static_cast<long long>(k));
    return sum;
  }

  /// The rings around a control vertex: each derived from its parent alone.
  void fill(long long vertex) {
    for (std::size_t level = 0; level < computed_.size(); ++level) {
      const long long centre = level == 0 ? vertex : rings_.back().centre * arity_;
      Ring ring{centre, 0, {}};
      for (int o = window_.first; o <= window_.last; ++o)
        ring.points.push_back(computed_point(level, centre + o));
      rings_.push_back(std::move(ring));
    }
  }

  void advance(std::size_t level) {
    Ring& ring = rings_[level];
    if (level > 0 && ring.centre % arity_ == 0) advance(level - 1);
    ring.points[ring.first] = computed_point(level, ring.centre + window_.last + 1);
    ring.first = ring.first + 1 == ring.points.size() ? 0 : ring.first + 1;
    ++ring.centre;
  }

  const ControlPolygon<Point>* controls_;
  IndexWindow window_;
  int arity_;
  Details<Point> details_;
  long long end_ = 0;
  std::vector<std::vector<RefinementRule<R>>> rules_;  // of the step from level k to k + 1
  std::vector<Ring> rings_;
  std::vector<std::size_t> computed_;
};

}  // namespace subdiv
