#pragma once

#include <span>

#include "experiments/experiment.h"

namespace subdiv {

/// The figures that explain adjustable speed subdivision (speed, figures 2, 3, 4, 5, 10), drawn anew from the
/// rules, each with an identity that a second route proves.
[[nodiscard]] std::span<const ClaimHead> speed_figure_heads();
[[nodiscard]] Results run_speed_figures();

}  // namespace subdiv
