#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// Eigenvalues of adjustable speed subdivision (speed III): (6), (7), (8), lambda and mu.
[[nodiscard]] std::span<const ClaimHead> speed_spectrum_heads();
[[nodiscard]] Results run_speed_spectrum();

}  // namespace subdiv
