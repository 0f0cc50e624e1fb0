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
/// R is any ring: exact for rationals, enclosing for intervals. A point is R itself or a vector that can be
/// added and multiplied by R from the left. Mixed and non-stationary schemes take step k at level k.
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
    rings_.resize(static_cast<std::size_t>(depth) + 1);
    if (end_ > 0) fill(scheme, vertex);
  }

  /// The index of the current point on the refined curve, and whether the curve has ended before it.
  [[nodiscard]] long long index() const { return rings_.back().centre; }
  [[nodiscard]] bool done() const { return index() >= end_; }
  /// The current point. Only while not done().
  [[nodiscard]] const Point& point() const { return at(rings_.back(), rings_.back().centre); }
  /// Moves to the next point. Moving past the end does nothing.
  void advance() {
    const long long next = index() + 1;
    if (next < end_) {
      advance(rings_.size() - 1);
    } else if (next == end_) {
      ++rings_.back().centre;  // nothing is computed for a point that does not exist
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
    /// What iterators name their elements' type.
    using value_type = Point;
    /// What iterators name their distances.
    using difference_type = std::ptrdiff_t;
    /// One pass only.
    using iterator_concept = std::input_iterator_tag;

    /// At the next point of the rings.
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
  [[nodiscard]] std::size_t levels() const { return rings_.size(); }
  /// The work so far: points that level k has loaded (k = 0) or computed.
  [[nodiscard]] std::size_t computed(std::size_t level) const { return rings_[level].computed; }

 private:
  /// Which points of the parent ring make a point: for the one that enters a ring next, this depends on the
  /// residue of the centre modulo m alone.
  struct Entry {
    std::size_t offset = 0;  // of the first one in the parent's window
    std::vector<R> weights;
  };
  struct Ring {
    long long centre = 0;
    std::size_t residue = 0;  // of the centre; a division a point would take longer than the point
    std::size_t first = 0;    // the slot of the point at the window's first offset
    std::vector<Point> points;
    std::vector<Entry> entries;  // by residue; none for the ring of the control polygon
    std::size_t computed = 0;
  };

  [[nodiscard]] const Point& at(const Ring& ring, long long index) const {
    std::size_t slot = ring.first + static_cast<std::size_t>(index - ring.centre - window_.first);
    if (slot >= ring.points.size()) slot -= ring.points.size();
    return ring.points[slot];
  }

  /// A point of a level is moved by its details.
  void add_details(std::size_t level, long long index, Point& point) const {
    const auto details = details_.at_level(static_cast<int>(level));
    if (details.empty()) return;
    const auto period =
        static_cast<long long>(refined_points(controls_->topology, arity_, static_cast<int>(level)));
    const long long place = controls_->topology.closed ? ((index % period) + period) % period : index;
    Details<Point>::apply(details, place, point);
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

  /// The point that an entry makes of its parent ring.
  [[nodiscard]] Point sum_of(const Ring& ring, const Entry& entry) const {
    const Point* const points = ring.points.data();
    const R* const weights = entry.weights.data();
    const std::size_t count = entry.weights.size();
    const std::size_t size = points_per_level();
    std::size_t slot = ring.first + entry.offset;
    if (slot >= size) slot -= size;
    Point sum = weights[0] * points[slot];
    for (std::size_t k = 1; k < count; ++k) {
      slot = slot + 1 == size ? 0 : slot + 1;
      sum = sum + weights[k] * points[slot];
    }
    return sum;
  }

  /// What makes a point of a level when the parent ring has a given centre.
  [[nodiscard]] Entry entry(const std::vector<RefinementRule<R>>& rules, long long index,
                            long long parent_centre) const {
    const long long m = arity_;
    const long long r = ((index % m) + m) % m;
    const RefinementRule<R>& rule = rules[static_cast<std::size_t>(r)];
    const long long offset = (index - r) / m + rule.first - parent_centre - window_.first;
    return {static_cast<std::size_t>(offset), rule.weights};
  }

  /// The rings around a control vertex: each derived from its parent alone.
  void fill(const Scheme<R>& scheme, long long vertex) {
    for (std::size_t level = 0; level < rings_.size(); ++level) {
      Ring& ring = rings_[level];
      ring.centre = level > 0 ? rings_[level - 1].centre * arity_ : vertex;
      std::vector<RefinementRule<R>> rules;
      if (level > 0) rules = refinement_rules(scheme.step(level - 1));
      for (int o = window_.first; o <= window_.last; ++o) {
        const long long index = ring.centre + o;
        if (level == 0) {
          ring.points.push_back(controls_->at(on_polygon(index)));
        } else {
          const Ring& parent = rings_[level - 1];
          ring.points.push_back(sum_of(parent, entry(rules, index, parent.centre)));
        }
        if (!details_.empty()) add_details(level, index, ring.points.back());
      }
      // Once a ring moves, its parent is ahead: at the next vertex behind the ring's centre.
      for (int r = 0; level > 0 && r < arity_; ++r)
        ring.entries.push_back(entry(rules, r + window_.last + 1, 1));
      ring.computed = ring.points.size();
    }
  }

  void advance(std::size_t level) {
    Ring& ring = rings_[level];
    Point& entering = ring.points[ring.first];
    const long long index = ring.centre + window_.last + 1;
    if (level == 0) {
      entering = controls_->at(on_polygon(index));
    } else {
      if (ring.residue == 0) advance(level - 1);
      entering = sum_of(rings_[level - 1], ring.entries[ring.residue]);
      ring.residue = ring.residue + 1 == ring.entries.size() ? 0 : ring.residue + 1;
    }
    if (!details_.empty()) add_details(level, index, entering);
    ring.first = ring.first + 1 == points_per_level() ? 0 : ring.first + 1;
    ++ring.centre;
    ++ring.computed;
  }

  const ControlPolygon<Point>* controls_;
  IndexWindow window_;
  int arity_;
  Details<Point> details_;
  long long end_ = 0;
  std::vector<Ring> rings_;
};

}  // namespace subdiv
