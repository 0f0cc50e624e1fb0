#pragma once

#include "analysis/adjustable_speed/characteristic_ring.h"
#include "analysis/mesh/characteristic_map.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// The shape at a valence n >= 3 (std::invalid_argument) and a speed: v is the positive root of v^2 = (1 + c)
/// (q + sigma v), c = cos(2 pi/n), as a sum of positive numbers.
template <class R>
[[nodiscard]] RingShape<R> ring_shape(const R& sigma, int valence);
template <>
RingShape<double> ring_shape(const double& sigma, int valence);
template <>
RingShape<Interval> ring_shape(const Interval& sigma, int valence);

/// What is proved of ring_conditions for all speeds in an interval.
struct RingRange {
  Decision hold = Decision::undecided;  // yes, or undecided
  int cells = 0;                        // intervals of sigma that were looked at
};
/// Outward-rounded Taylor expansions in sigma on parts of the interval, halved where they say too little, at
/// most `cells` of them. An interval that reaches 0 or 1 stays undecided. valence >= 3
/// (std::invalid_argument).
[[nodiscard]] RingRange ring_conditions_on(const Interval& sigma, int valence, int cells = 400);

/// The verdict on the characteristic map for all speeds in an interval, and valence >= 3
/// (std::invalid_argument): certified by ring_conditions_on; undecided where that is. In each Fourier block k
/// != 0 the eigenvalues are 0, powers of q from q^3 on and the roots of (7), whose product is q^4 and whose
/// larger one increases with cos(2 pi k/n): mode 1 has the largest. jacobian_ratio is that of the interval's
/// middle.
[[nodiscard]] CharacteristicMap speed_characteristic_map(const Interval& sigma, int valence);

}  // namespace subdiv
