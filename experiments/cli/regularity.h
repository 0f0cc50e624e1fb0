#pragma once

#include <span>
#include <string>

#include "experiments/cli/scheme_analysis.h"
#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/mask.h"

namespace subdiv::cli {

/// Bounds of the continuity of a repeated step's limits: C^c is certified where a power of its c-th
/// difference scheme has a norm below 1, and Reif's condition is necessary. With one free parameter, for all
/// its values at once; with several, or with coefficients that are no polynomials, only what can be had.
[[nodiscard]] RegularityText regularity(const Mask<Rational>& mask, std::span<const std::string> names);
[[nodiscard]] RegularityText regularity(const Mask<Algebraic>& mask, std::span<const std::string> names);
[[nodiscard]] RegularityText regularity(const Mask<RationalFunction>& mask,
                                        std::span<const std::string> names);

}  // namespace subdiv::cli
