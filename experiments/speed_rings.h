#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// Surface rings of adjustable speed (speed II, IV): how they join, what high speeds do to shape and to the
/// fault of a cap, and the figures 1, 6 and 9 on a net of this project in place of the lost ones.
[[nodiscard]] std::span<const ClaimHead> speed_ring_heads();
[[nodiscard]] Results run_speed_rings();

/// The figures alone: pictures of a surface with rings.
void add_speed_ring_figures(Results& results);

}  // namespace subdiv
