#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// What polyloops 1 says of estimates at vertices and edges: identities, orders of convergence as Taylor
/// series over Q, the circle-fit radius against the parabola-fit radius.
[[nodiscard]] std::span<const ClaimHead> polyloop_local_heads();
[[nodiscard]] Results run_polyloop_local();

/// What polyloops 3 says of the curves J0 .. J8 and Jm, on the stored polygons and on the family of simple
/// polygons.
[[nodiscard]] std::span<const ClaimHead> polyloop_curve_heads();
[[nodiscard]] Results run_polyloop_curves();

/// The figures of polyloops 1 and 3, on polygons of this project in place of the lost ones.
[[nodiscard]] std::span<const ClaimHead> polyloop_figure_heads();
[[nodiscard]] Results run_polyloop_figures();

/// The rows of polyloops 3.1 that build curves step by step from refine, dual and tuck.
[[nodiscard]] std::span<const ClaimHead> polyloop_construction_heads();
[[nodiscard]] Results run_polyloop_construction();

}  // namespace subdiv
