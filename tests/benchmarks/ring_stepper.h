#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace subdiv::testing {

/// Ringing as the appendix of the paper on ringing writes it (js-report, section 17), for comparison: rings
/// of five 3D points, one point at a time, indices modulo 5, a flag a level that says whether the level's
/// next point is an edge point or a vertex point.
class RingStepper {
 public:
  struct Point {
    double x = 0;
    double y = 0;
    double z = 0;
  };

  RingStepper(std::span<const Point> loop, double s, int levels)
      : loop_(loop.begin(), loop.end()),
        s_(s),
        rings_(static_cast<std::size_t>(levels) + 1),
        flags_(static_cast<std::size_t>(levels) + 1, true) {
    for (int i = 0; i < 5; ++i) load();
    for (std::size_t level = 1; level < rings_.size(); ++level) derive(level);
  }

  /// Moves the last ring on by one point, and those above it as far as that needs; gives the ring's centre.
  Point next() {
    const std::size_t last = rings_.size() - 1;
    std::size_t up = 0;
    while (up < last && flags_[up]) flags_[up++] = false;
    flags_[up] = true;
    std::size_t level = last - up;
    if (level == 0) {
      load();
    } else {
      push(level, vertex_after(rings_[level - 1]));
    }
    while (++level <= last) push(level, edge_after(rings_[level - 1]));
    return rings_[last].points[rings_[last].centre];
  }

 private:
  struct Ring {
    std::array<Point, 5> points;
    std::size_t centre = 2;
  };

  static std::size_t following(std::size_t i) { return (i + 1) % 5; }
  static std::size_t preceding(std::size_t i) { return (i + 4) % 5; }
  static Point between(const Point& a, double t, const Point& b) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
  }
  /// A vertex moves towards its neighbours.
  [[nodiscard]] Point vertex(const Point& a, const Point& b, const Point& c) const {
    return between(between(b, s_ / 4, a), 0.5, between(b, s_ / 4, c));
  }
  /// A new point between b and c moves outwards.
  [[nodiscard]] Point edge(const Point& a, const Point& b, const Point& c, const Point& d) const {
    return between(between(a, 1 + (1 - s_) / 8, b), 0.5, between(d, 1 + (1 - s_) / 8, c));
  }
  [[nodiscard]] Point vertex_after(const Ring& r) const {
    const std::size_t c = r.centre;
    return vertex(r.points[c], r.points[following(c)], r.points[following(following(c))]);
  }
  [[nodiscard]] Point edge_after(const Ring& r) const {
    const std::size_t c = r.centre;
    return edge(r.points[preceding(c)], r.points[c], r.points[following(c)],
                r.points[following(following(c))]);
  }

  void push(std::size_t level, const Point& p) {
    Ring& ring = rings_[level];
    ring.centre = following(ring.centre);
    ring.points[following(following(ring.centre))] = p;
  }
  void load() {
    push(0, loop_[loaded_]);
    loaded_ = loaded_ + 1 == loop_.size() ? 0 : loaded_ + 1;
  }
  void derive(std::size_t level) {
    const Ring& parent = rings_[level - 1];
    const auto at = [&](std::size_t offset) { return parent.points[(parent.centre + 3 + offset) % 5]; };
    rings_[level].centre = 2;
    rings_[level].points = {vertex(at(0), at(1), at(2)), edge(at(0), at(1), at(2), at(3)),
                            vertex(at(1), at(2), at(3)), edge(at(1), at(2), at(3), at(4)),
                            vertex(at(2), at(3), at(4))};
  }

  std::vector<Point> loop_;
  std::size_t loaded_ = 0;
  double s_;
  std::vector<Ring> rings_;
  std::vector<bool> flags_;
};

}  // namespace subdiv::testing
