#pragma once

#include <string>
#include <vector>

#include "analysis/adjustable_speed/characteristic_ring.h"

namespace subdiv {

/// Differences that vanish exactly when the patches of a characteristic ring and its copy, lambda times as
/// large, join C^2 (paper, section III: "a symmetric scalable C^2 map"). With the tensor border's piece over
/// the unit square, (0, 0) the corner on the bisectrix, the corner patch lies over [0, sigma]^2, the sides
/// over [0, sigma] x [sigma, 1] and its mirror image, and lambda times the border over [sigma, 1]^2.
template <class R>
struct RingJoin {
  std::string name;         ///< which derivative across which border
  RingPoint<R> difference;  ///< 0 where the patches join
};

namespace detail {
template <class R>
using CubicPoints = std::array<RingPoint<R>, 4>;

template <class R>
RingPoint<R> combined(const R& a, const RingPoint<R>& p, const R& b, const RingPoint<R>& q) {
  return {a * p[0] + b * q[0], a * p[1] + b * q[1]};
}

/// The derivatives of order 0, 1, 2 at the end of a piece with the points .., b1, b2, b3 on a parameter
/// interval of length h, but for the common factors 1, 3, 6: the sign of h is the direction.
template <class R>
std::array<RingPoint<R>, 3> end_derivatives(const RingPoint<R>& b3, const RingPoint<R>& b2,
                                            const RingPoint<R>& b1, const R& h) {
  const R inverse = R(1) / h;
  const RingPoint<R> first = combined(inverse, b3, R(0) - inverse, b2);
  const RingPoint<R> before = combined(inverse, b2, R(0) - inverse, b1);
  return {b3, first, combined(inverse, first, R(0) - inverse, before)};
}
}  // namespace detail

/// A point reflected in the first spoke.
template <class R>
RingPoint<R> reflected(const RingPoint<R>& p, const R& one_plus_cosine) {
  const R cosine = one_plus_cosine - R(1);
  return {cosine * p[0] - (R(2) - one_plus_cosine) * p[1], R(0) - one_plus_cosine * p[0] - cosine * p[1]};
}

/// The differences across all borders of sector 0: value, first and second derivative.
template <class R>
std::vector<RingJoin<R>> ring_joins(const CharacteristicRing<R>& ring, const RingShape<R>& shape) {
  std::vector<RingJoin<R>> result;
  const R& sigma = shape.sigma;
  const R q = shape.rest();
  const R eigenvalue = shape.eigenvalue();
  const BezierPatch<RingPoint<R>>& corner = ring.sector.corner;
  const BezierPatch<RingPoint<R>>& side = ring.sector.first_side;
  const auto add = [&](const std::string& name, const std::array<RingPoint<R>, 3>& a,
                       const std::array<RingPoint<R>, 3>& b) {
    for (std::size_t order = 0; order < a.size(); ++order)
      result.push_back(
          {name + " order " + std::to_string(order), detail::combined(R(1), a[order], R(-1), b[order])});
  };
  const auto same = [&](const std::string& name, const RingPoint<R>& a, const RingPoint<R>& b) {
    result.push_back({name, detail::combined(R(1), a, R(-1), b)});
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string line = " " + std::to_string(k);
    add("corner and side" + line,
        detail::end_derivatives(corner[4 * k + 3], corner[4 * k + 2], corner[4 * k + 1], sigma),
        detail::end_derivatives(side[4 * k], side[4 * k + 1], side[4 * k + 2], R(0) - q));
    const auto mirrored = [&](std::size_t j) { return reflected(side[4 * k + j], shape.one_plus_cosine()); };
    add("side across the spoke" + line,
        detail::end_derivatives(side[4 * k + 3], side[4 * k + 2], side[4 * k + 1], q),
        detail::end_derivatives(mirrored(3), mirrored(2), mirrored(1), R(0) - q));
    const auto next = [&](std::size_t i) {
      return RingPoint<R>{eigenvalue * ring.border[4 * i + k][0], eigenvalue * ring.border[4 * i + k][1]};
    };
    add("side and next ring" + line, detail::end_derivatives(side[12 + k], side[8 + k], side[4 + k], sigma),
        detail::end_derivatives(next(0), next(1), next(2), R(0) - q));
    for (std::size_t j = 0; j < 4; ++j) {  // mirror images in the bisectrix
      const RingPoint<R>& a = corner[4 * j + k];
      const RingPoint<R>& b = ring.sector.next_side[4 * j + k];
      same("corner's mirror image", corner[4 * k + j], {a[0], R(0) - a[1]});
      same("side's mirror image", side[4 * k + j], {b[0], R(0) - b[1]});
    }
  }
  return result;
}

}  // namespace subdiv
