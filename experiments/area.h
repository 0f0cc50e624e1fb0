#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Area preservation in 2D (js-report 8, jsplines 8): optimal parameters of four families, the claim of exact
/// preservation, and the errors printed for a polygon that is lost.
[[nodiscard]] std::span<const ClaimHead> area_heads();
[[nodiscard]] Results run_area();

/// Parts of the experiment, each settling its own heads.
/// {J_{a,b}, *J_s} and exact preservation.
[[nodiscard]] Results run_area_exact();
/// The polygon of the documents' figures.
[[nodiscard]] Results run_area_model();

}  // namespace subdiv
