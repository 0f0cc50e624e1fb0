#pragma once

#include <string>
#include <vector>

#include "analysis/adjustable_speed/characteristic_ring.h"
#include "analysis/decision.h"
#include "analysis/sign_on_domain.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// The characteristic ring of adjustable speed subdivision is regular and injective for every valence n >= 3
/// and every speed 0 < sigma < 1: the conditions of ring_conditions.h over Q(sigma, v) on the set of all
/// shapes with 2/5 < 1 + c < 2, which contains all valences (1 + cos(2 pi/3) = 1/2), and the joins of
/// characteristic_ring_joins.h as identities.
///
/// At sigma = 1, c = 1, where v = 2, some differences vanish in a way that depends on the direction. So the
/// set is taken in the coordinates x_0 = 2 - v, x_1 = (1 - sigma)/(2 - v), in which that point is a line. The
/// box (0, 8/5) x (0, 2) contains it:
///
///   v < 2: for v >= 2, v^2 < 2 W would say v (v - 2 sigma) < 2 (1 - sigma), but the left side is at least
///   4 (1 - sigma). v > 2/5: for v < 1 W > v, and 5 v^2 > 2 W says 5 v > 2. x_1 < 2: for v <= sqrt 2 it is
///   below 1/(2 - sqrt 2); beyond, v^2 < 2 W says (1 - sigma)/(2 - v) < v/(2 v - 2) < 1/(2 - sqrt 2) too.
struct RingTheorem {
  Decision holds = Decision::undecided;  ///< yes: proved; no: a condition fails somewhere
  int conditions = 0;                    ///< how many there are
  int identities = 0;                    ///< how many joins there are
  long cells = 0;                        ///< of the box, over all factors
  std::vector<std::string> open;         ///< names of what is not proved, wrong or not
};

/// Some 0.2 s. cells: the budget of each factor.
[[nodiscard]] RingTheorem prove_ring_theorem(long cells = 1000);

/// The same of any ring over Q(x_0, x_1), with the sizes sigma and the lambda of a shape, on a domain. A
/// wrong one gives no, or stays open: prove_ring_theorem is of the ring in ring_coordinates() on
/// ring_shapes().
[[nodiscard]] RingTheorem prove_ring(const CharacteristicRing<RationalFunction>& ring,
                                     const RingShape<RationalFunction>& shape, const PlaneDomain& domain,
                                     long cells);

/// sigma = 1 - x_0 x_1, v = 2 - x_0.
[[nodiscard]] RingShape<RationalFunction> ring_coordinates();

/// All shapes of the theorem in these coordinates.
[[nodiscard]] PlaneDomain ring_shapes();

}  // namespace subdiv
