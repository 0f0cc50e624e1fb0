#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Fits of basis functions to B-splines of even degree and to the hat function (js-report 4, 9; jsplines 4).
[[nodiscard]] std::span<const ClaimHead> basis_fit_heads();
[[nodiscard]] Results run_basis_fit();

}  // namespace subdiv
