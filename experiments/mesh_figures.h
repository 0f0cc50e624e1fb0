#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// The figures of meshes (jsplines 14; notes 5 .. 9), on meshes of this project in place of the lost ones,
/// each with a number, and the weights of Loop's and the butterfly scheme that they show.
[[nodiscard]] std::span<const ClaimHead> mesh_figure_heads();
[[nodiscard]] Results run_mesh_figures();

}  // namespace subdiv
