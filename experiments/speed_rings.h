#pragma once

#include <span>

#include "analysis/adjustable_speed/sector_form.h"
#include "experiments/experiment.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// Surface rings of adjustable speed (speed II, IV): how they join, what high speeds do to shape and to the
/// fault of a cap, and the figures 1, 6 and 9 on a net of this project in place of the lost ones.
[[nodiscard]] std::span<const ClaimHead> speed_ring_heads();
[[nodiscard]] Results run_speed_rings();

/// Which joints of a surface ring have equal derivatives up to the second, for all valences and nets: the
/// ring between a net over the knots of speed `sigma` and the net `refined` that a step makes of it.
struct RingJoints {
  bool inside = false;   // between the patches of a sector
  bool sectors = false;  // between those of neighbouring sectors
  bool inwards = false;  // with the tensor border of the refined net

  [[nodiscard]] bool all() const { return inside && sectors && inwards; }
};
[[nodiscard]] RingJoints ring_joints(const RationalFunction& sigma, const FormNet<RationalFunction>& refined);

/// The figures alone: pictures of a surface with rings.
void add_speed_ring_figures(Results& results);

}  // namespace subdiv
