#pragma once

#include <span>
#include <vector>

#include "experiments/experiment.h"

namespace subdiv {

/// The characteristic ring of adjustable speed subdivision (speed III, V-B): formulas (9) and (12), a proof
/// of its regularity and injectivity, figures 7 and 8.
[[nodiscard]] std::span<const ClaimHead> speed_characteristic_ring_heads();
[[nodiscard]] Results run_speed_characteristic_ring();

/// Its part on (9) and (12): heads, and their claims.
[[nodiscard]] std::vector<ClaimHead> ring_formula_heads();
void add_ring_formulas(Results& results, std::span<const ClaimHead> heads);

/// The figures with their series and records.
void add_ring_construction_figure(Results& results, const ClaimHead& head);
void add_ring_speeds_figure(Results& results, const ClaimHead& head);

}  // namespace subdiv
