#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// Rules and conversions of adjustable speed subdivision (speed II, III, IV, V-A, V-C): every numbered
/// formula as an identity over Q(sigma), for all valences.
[[nodiscard]] std::span<const ClaimHead> speed_rule_heads();
[[nodiscard]] Results run_speed_rules();

}  // namespace subdiv
