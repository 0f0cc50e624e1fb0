#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// The lecture notes on subdivision: Bezier curves (notes 1), B-splines by doubling and averaging (notes 2),
/// the four-point rule and the ends of open curves (notes 3), what meshes must be and how smooth surfaces are
/// (notes 4, 5). Weights and worked examples of surfaces are in mesh_figures.h, eigenvalues in
/// mesh_smoothness.h.
[[nodiscard]] std::span<const ClaimHead> lecture_note_heads();
[[nodiscard]] Results run_lecture_notes();

}  // namespace subdiv
