#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Interpolation of vertices and mid-edge points by mixed schemes (js-report 6, 7; jsplines 6, 7), and the
/// drift of the limit curve from its vertices (js-report 5, jsplines 5).
[[nodiscard]] std::span<const ClaimHead> interpolation_heads();
[[nodiscard]] Results run_interpolation();

}  // namespace subdiv
