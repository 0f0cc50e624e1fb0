#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Hoelder exponents of the limits of *J_s in closed form, and their figures (jsplines 3).
[[nodiscard]] std::span<const ClaimHead> hoelder_exponent_heads();
[[nodiscard]] Results run_hoelder_exponents();

}  // namespace subdiv
