#pragma once

#include "experiments/experiment.h"

namespace subdiv {

/// What polyloops 2 and 3 say of smoothing: tuck, dual and push-pull as filters, what they fix, and what
/// becomes of a polyloop under many steps.
[[nodiscard]] std::span<const ClaimHead> polyloop_smoothing_heads();
[[nodiscard]] Results run_polyloop_smoothing();

/// The sequences of polyloops 2 and 3.1 as subdivision schemes, Split & Tweak among them.
[[nodiscard]] std::span<const ClaimHead> polyloop_operator_heads();
[[nodiscard]] Results run_polyloop_operators();

/// Transfer functions, and a noisy polyloop before and after smoothing.
[[nodiscard]] std::span<const ClaimHead> polyloop_filter_heads();
[[nodiscard]] Results run_polyloop_filters();

}  // namespace subdiv
