#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Exact continuity of *J_{a,b} on the lines of the (a, b) plane where the shifts of its basis function are
/// dependent, and from that where limits are C2 (jsplines 6).
[[nodiscard]] std::span<const ClaimHead> two_parameter_smoothness_heads();
[[nodiscard]] Results run_two_parameter_smoothness();

}  // namespace subdiv
