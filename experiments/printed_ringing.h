#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// The Ringing code of js-report, appendix 1, in its own structure and with its own faults, over any ring R
/// of coefficients and any points: what the papers print, for the claims about it. The evaluator of this
/// project is schemes/evaluate/ringing.h.
namespace printed {

constexpr std::size_t ring_points = 5;     // pt[] P = new pt[5]
constexpr std::size_t ring_count = 7;      // ring [] R = new ring[7]
constexpr std::size_t stepper_flags = 10;  // boolean [] B = new boolean[10]

/// Which ring moves at a step. Flags are true for the rings whose two steps since their parent moved are
/// done.
struct Stepper {
  std::array<bool, stepper_flags> flags{};
  std::size_t depth = 0;

  /// As printed: the flags of the old depth are set, and only then the depth is the new one.
  void reset(std::size_t new_depth) {
    for (std::size_t i = 0; i < depth; ++i) flags.at(i) = true;
    depth = new_depth;
  }
  /// "returns ID of ring that should do a b3 step".
  std::size_t next() {
    std::size_t c = 0;
    while (flags.at(c) && c < depth) flags.at(c++) = false;
    flags.at(c) = true;
    return c;
  }
};

/// Five points A, B, C, D, E; `c` is the slot of C.
template <class R, class Point>
struct Ring {
  std::array<Point, ring_points> points;
  std::size_t c = 2;

  static std::size_t n(std::size_t i) { return (i + 1) % ring_points; }
  static std::size_t p(std::size_t i) { return (i + ring_points - 1) % ring_points; }
  static Point l(const Point& a, const R& s, const Point& b) { return a + s * Point(b - a); }
  static Point b(const Point& a, const Point& middle, const Point& d, const R& s) {
    const R quarter = s * fraction<R>(1, 4);
    return l(l(middle, quarter, a), fraction<R>(1, 2), l(middle, quarter, d));
  }
  static Point f(const Point& a, const Point& b, const Point& c, const Point& d, const R& s) {
    const R out = R(1) + (R(1) - s) * fraction<R>(1, 8);
    return l(l(a, out, b), fraction<R>(1, 2), l(d, out, c));
  }

  void push(const Point& point) {
    c = n(c);
    points[n(n(c))] = point;
  }
  [[nodiscard]] const Point& point() const { return points[c]; }
  [[nodiscard]] Point b1(const R& s) const { return b(points[p(p(c))], points[p(c)], points[c], s); }
  [[nodiscard]] Point f12(const R& s) const {
    return f(points[p(p(c))], points[p(c)], points[c], points[n(c)], s);
  }
  [[nodiscard]] Point b2(const R& s) const { return b(points[p(c)], points[c], points[n(c)], s); }
  [[nodiscard]] Point f23(const R& s) const {
    return f(points[p(c)], points[c], points[n(c)], points[n(n(c))], s);
  }
  [[nodiscard]] Point b3(const R& s) const { return b(points[c], points[n(c)], points[n(n(c))], s); }
  void derive(const Ring& q, const R& a, const R& s) {
    c = 2;
    points = {q.b1(a), q.f12(s), q.b2(a), q.f23(s), q.b3(a)};
  }
};

/// What one call of next() did: the stepper's answer and the rings that were pushed, in order, with the
/// function that gave their point: 0 a control point, 'b' b3, 'f' f23.
struct Step {
  std::size_t answer = 0;
  std::vector<std::pair<std::size_t, char>> pushed;
};

/// A closed loop under {J_{ga,gb}, *J_gs}.
template <class R, class Point>
class Polyloop {
 public:
  Polyloop(std::vector<Point> points, R ga, R gb, R gs)
      : points_(std::move(points)), ga_(std::move(ga)), gb_(std::move(gb)), gs_(std::move(gs)) {}

  /// A Stepper made for this depth, the only use under which reset() does not matter.
  void make_stepper(std::size_t depth) { stepper_ = Stepper{.flags = {}, .depth = depth}; }
  /// loadRing and deriveRings: std::out_of_range where the code has too few rings for the depth.
  void load(std::size_t depth) {
    rec_ = depth;
    stepper_.reset(depth);
    rings_.at(0).c = 2;
    rc_ = 0;
    for (std::size_t i = 0; i < ring_points; ++i) push_control();
    rings_[0].c = 2;
    for (std::size_t r = 1; r <= rec_; ++r) rings_.at(r).derive(rings_[r - 1], a(r), b(r));
  }

  Point next(Step* step = nullptr) {
    const std::size_t answer = stepper_.next();
    const std::size_t level = rec_ - answer;
    if (level == 0) {
      push_control();
    } else {
      rings_.at(level).push(rings_[level - 1].b3(a(level)));
    }
    if (step) *step = {answer, {{level, level == 0 ? '0' : 'b'}}};
    for (std::size_t r = level + 1; r <= rec_; ++r) {
      rings_.at(r).push(rings_[r - 1].f23(b(r)));
      if (step) step->pushed.emplace_back(r, 'f');
    }
    return rings_.at(rec_).point();
  }

 private:
  [[nodiscard]] const R& a(std::size_t r) const { return r == 1 ? ga_ : gs_; }
  [[nodiscard]] const R& b(std::size_t r) const { return r == 1 ? gb_ : gs_; }
  void push_control() {
    rings_[0].push(points_[rc_]);
    rc_ = (rc_ + 1) % points_.size();
  }

  std::vector<Point> points_;
  R ga_, gb_, gs_;
  std::array<Ring<R, Point>, ring_count> rings_{};
  Stepper stepper_;
  std::size_t rec_ = 0;
  std::size_t rc_ = 0;
};

}  // namespace printed
}  // namespace subdiv
