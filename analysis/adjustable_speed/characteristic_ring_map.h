#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "analysis/adjustable_speed/characteristic_ring.h"
#include "analysis/adjustable_speed/ring_conditions.h"
#include "analysis/mesh/characteristic_map.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/taylor.h"

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
  Decision hold = Decision::undecided;  ///< yes, or undecided
  int cells = 0;                        ///< intervals of sigma that were looked at
};
/// Outward-rounded Taylor expansions in sigma on parts of the interval, halved where they say too little, at
/// most `cells` of them. An interval that reaches 0 or 1 stays undecided. valence >= 3
/// (std::invalid_argument).
[[nodiscard]] RingRange ring_conditions_on(const Interval& sigma, int valence, int cells = 400);

/// Conditions as functions of sigma, expanded about an interval: the last coefficient is the remainder's.
inline constexpr std::size_t ring_order = 4;
/// The conditions of one ring, each as a Taylor expansion in sigma.
using RingExpansion = std::vector<RingCondition<Taylor<Interval, ring_order + 1>>>;
/// Those of the ring of a valence.
[[nodiscard]] RingExpansion ring_expansion(const Interval& sigma, int valence);
/// ring_conditions_on for any conditions.
[[nodiscard]] RingRange conditions_on(const Interval& sigma,
                                      const std::function<RingExpansion(const Interval&)>& expanded,
                                      int cells);

/// The verdict on the characteristic map for all speeds in an interval, and valence >= 3
/// (std::invalid_argument): certified by ring_conditions_on; where that stays open, as it does very near 0
/// and 1, by prove_ring_theorem if the interval surely lies in (0, 1). Else regular and injective are
/// undecided and the rigour is approximate. In each Fourier block k
/// != 0 the eigenvalues are 0, powers of q from q^3 on and the roots of (7), whose product is q^4 and whose
/// larger one increases with cos(2 pi k/n): mode 1 has the largest. jacobian_ratio is that of the interval's
/// middle, 0 where its precision does not tell.
[[nodiscard]] CharacteristicMap speed_characteristic_map(const Interval& sigma, int valence);
/// For one speed in (0, 1) (std::invalid_argument): always decided.
[[nodiscard]] CharacteristicMap speed_characteristic_map(const Rational& sigma, int valence);

}  // namespace subdiv
