#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// Characteristic maps of mesh schemes at extraordinary vertices (jsplines 10; notes 4, 5): regular and
/// injective, proved where limit surfaces are splines; how often Butterfly's map winds; figure 13 of
/// jsplines.
[[nodiscard]] std::span<const ClaimHead> characteristic_map_heads();
[[nodiscard]] Results run_characteristic_maps();

/// The figure, its series and its record.
void add_characteristic_map_figure(Results& results, const ClaimHead& head);

}  // namespace subdiv
