#pragma once

#include <optional>

#include "optimize/problem.h"

namespace subdiv {

/// A problem whose residuals are affine in the parameters, in l1 or linf: an exact LP, so the optimum is
/// rational and the dual solution proves it. Further LPs over the set of optima decide whether the minimiser
/// is unique. Nothing when a residual is not affine or the norm is l2.
[[nodiscard]] std::optional<Summary> minimise_linear(const Problem& problem);

}  // namespace subdiv
