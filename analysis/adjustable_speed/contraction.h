#pragma once

#include "analysis/adjustable_speed/characteristic_ring.h"

namespace subdiv {

/// d lambda/d sigma at a fixed valence: with v' by v^2 = (1 + c) (q + sigma v) and 1 + c = v^2/W,
///
///   lambda' = -(2 q^2 (2 - v) + q sigma v (5 - 2 v) + sigma^2 v^2)/(2 q + sigma v),
///
/// negative for 0 < sigma < 1 and 0 < v < 2: the contraction at a vertex of any valence n >= 3 gets stronger
/// with the speed, from lambda = 1 at sigma = 0, where (7) is (lambda - 1)^2 = 0, to 0 at sigma = 1.
template <class R>
R contraction_rate(const RingShape<R>& shape) {
  const R& s = shape.sigma;
  const R& v = shape.v;
  const R q = shape.rest();
  const R falling = R(2) * q * q * (R(2) - v) + q * s * v * (R(5) - R(2) * v) + s * s * v * v;
  return R(0) - falling / (R(2) * q + s * v);
}

}  // namespace subdiv
