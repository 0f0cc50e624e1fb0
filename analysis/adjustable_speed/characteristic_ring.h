#pragma once

#include <array>
#include <cstddef>

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/evaluate/surface_ring.h"

namespace subdiv {

/// The characteristic ring of adjustable speed subdivision (Karciauskas & Peters: Adjustable speed surface
/// subdivision, 2009, section III, figure 7): the surface ring in the plane of the eigenvector of mode 1 with
/// the larger eigenvalue lambda of (7).
///
/// All of it is rational in sigma and one more number v, of which c = cos(2 pi/n) is a function: with q = 1 -
/// sigma and
///
///   lambda = q W,   W = q + sigma v,
///
/// (7) for k = 1 reads (W - q)^2 = sigma^2 (1 + c) W, that is 1 + c = v^2/W. For 0 < sigma < 1 the valences n
/// >= 3 (-1/2 <= c < 1) are W/2 <= v^2 < 2 W with 1/2 < v < 2.
///
/// Points are (x/cos(pi/n), y/sin(pi/n)) in the frame of sector 0: its bisectrix is the positive x-axis, its
/// first spoke has the angle -pi/n. So no root is left: with 2 cos^2(pi/n) = 1 + c and 2 sin^2(pi/n) = 1 - c,
/// turns by 2 pi/n are rational too.
template <class R>
struct RingShape {
  R sigma;  ///< the speed, 0 < sigma < 1
  R v;      ///< the larger eigenvalue is q (q + sigma v)

  [[nodiscard]] R rest() const { return R(1) - sigma; }  ///< q
  [[nodiscard]] R width() const { return rest() + sigma * v; }
  [[nodiscard]] R eigenvalue() const { return rest() * width(); }
  [[nodiscard]] R one_plus_cosine() const { return v * v / width(); }
};

/// A point of the plane: x/cos(pi/n), y/sin(pi/n) in the frame of sector 0.
template <class R>
using RingPoint = std::array<R, 2>;

/// The eigenvector: (1, 0) is the point (1, -1), the vertex is 0. Nothing in it cancels for sigma near 1: the
/// differences that the rows' equations divide by have been factored,
///
///   lambda - q^2 = q sigma v,   lambda - q^4 = q sigma (v + q (1 + q)),
///   lambda - q^6 = q sigma (v + q (1 + q) (1 + q^2)),
///
/// so that only positive numbers are added.
template <class R>
class CharacteristicSpeedNet {
 public:
  /// The points of one sector; those of the others are turned copies.
  explicit CharacteristicSpeedNet(const RingShape<R>& shape) : cosine_(shape.one_plus_cosine()) {
    const R& s = shape.sigma;
    const R& v = shape.v;
    const R q = shape.rest();
    const R e1 = s * s + q;
    const R e2 = s * s + R(3) * q;
    const R turned = v / shape.width();  // (1, 1) and its mirror image in the spoke add up to 2 v/W in x
    const R below = v + q * (R(1) + q);
    // Of (2, 0), which is g (1, -1), and (2, 1), which is (x1 + x2, -x1).
    const R g = e2 * (e1 + q * q * q / below * (q * turned + s) + s * q * turned) /
                (q * (v + q) * (R(1) + q * q * q / below));
    const R face = R(2) / v;
    const R x1 = (q * q * g + s * e2 / q) / below;
    const R x2 = e2 / below * face;
    const R corner =
        (R(2) * q * q * e2 * (x1 + x2) + s / q * e2 * e2 * face) / (v + q * (R(1) + q) * (R(1) + q * q));
    set(1, 0, {R(1), R(-1)});
    set(1, 1, {face, R(0)});
    set(2, 0, {g, R(0) - g});
    set(2, 1, {x1 + x2, R(0) - x1});
    set(1, 2, {x1 + x2, x1});
    set(2, 2, {corner, R(0)});
    for (std::size_t place = 0; place < places; ++place) {
      const RingPoint<R> own = points_[1][place];
      const RingPoint<R> mirrored = turned_on({own[0], R(0) - own[1]});
      points_[0][place] = {mirrored[0], R(0) - mirrored[1]};  // turned back
      points_[2][place] = turned_on(own);
      points_[3][place] = turned_on(points_[2][place]);
    }
  }

  [[nodiscard]] const RingPoint<R>& centre() const { return centre_; }
  /// Sectors -1 .. 2, all that stencils reach.
  [[nodiscard]] const RingPoint<R>& at(int sector, int place) const {
    const int slot = sector + 1;
    return points_.at(static_cast<std::size_t>(slot))[static_cast<std::size_t>(place)];
  }

 private:
  static constexpr std::size_t places = SectorNet<R>::places;

  void set(int i, int j, const RingPoint<R>& point) {
    points_[1][static_cast<std::size_t>(sector_place(i, j).place)] = point;
  }
  [[nodiscard]] RingPoint<R> turned_on(const RingPoint<R>& p) const {
    const R cosine = cosine_ - R(1);
    return {cosine * p[0] - (R(2) - cosine_) * p[1], cosine_ * p[0] + cosine * p[1]};
  }

  R cosine_;  // 1 + c
  RingPoint<R> centre_{R(0), R(0)};
  std::array<std::array<RingPoint<R>, places>, 4> points_;
};

/// The tensor border of sector 0 (paper (9) but for the unit) and the ring's three patches in it; the inner
/// border is lambda times the border. The patches at the two spokes are mirror images of each other.
template <class R>
struct CharacteristicRing {
  BezierPatch<RingPoint<R>> border;  ///< all but (3, 3)
  RingSector<RingPoint<R>> sector;   ///< the patches of sector 0
};
/// The ring of a shape, from the points of its eigenvector.
template <class R>
CharacteristicRing<R> characteristic_ring(const RingShape<R>& shape) {
  CharacteristicRing<R> result;
  const RingRules<R> rules{shape.sigma, {}, tensor_border(shape.sigma)};
  result.border = border_points(CharacteristicSpeedNet<R>(shape), rules, 0);
  const R eigenvalue = shape.eigenvalue();
  BezierPatch<RingPoint<R>> inner = result.border;
  for (RingPoint<R>& point : inner) point = {eigenvalue * point[0], eigenvalue * point[1]};
  result.sector = ring_sector(result.border, inner, shape.sigma);
  return result;
}

}  // namespace subdiv
