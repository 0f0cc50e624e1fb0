#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// The schedule of parameters that reduces popping between levels of detail (jsplines 11).
[[nodiscard]] std::span<const ClaimHead> popping_heads();
[[nodiscard]] Results run_popping();

}  // namespace subdiv
