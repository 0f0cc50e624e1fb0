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

/// The verdict on the characteristic map for all speeds in an interval, and valence >= 3
/// (std::invalid_argument): certified by outward-rounded ring_conditions. Undecided where the interval is too
/// wide, or contains 0 or 1. In each Fourier block k != 0 the eigenvalues are 0, powers of q from q^3 on and
/// the roots of (7), whose product is q^4 and whose larger one increases with cos(2 pi k/n): mode 1 has the
/// largest.
[[nodiscard]] CharacteristicMap speed_characteristic_map(const Interval& sigma, int valence);

/// All conditions hold for all speeds in the interval.
[[nodiscard]] bool ring_conditions_hold(const Interval& sigma, int valence);

}  // namespace subdiv
