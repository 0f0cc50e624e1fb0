#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// The characteristic ring of adjustable speed subdivision (speed III, V-B): formulas (9) and (12), a proof
/// of its regularity and injectivity, figures 7 and 8.
[[nodiscard]] std::span<const ClaimHead> speed_characteristic_ring_heads();
[[nodiscard]] Results run_speed_characteristic_ring();

/// The figures with their series and records.
void add_ring_construction_figure(Results& results, const ClaimHead& head);
void add_ring_speeds_figure(Results& results, const ClaimHead& head);

}  // namespace subdiv
