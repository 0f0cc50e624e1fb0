#pragma once

#include <span>
#include <vector>

#include "optimize/residual_functions.h"

namespace subdiv {

/// Descends from x by sequential quadratic programming (NLopt's SLSQP) on the smooth form of a norm with
/// kinks: linf: minimise E subject to -E <= r_i <= E; l1: minimise the sum of t_i subject to -t_i <= r_i <=
/// t_i. Follows curved valleys where derivative-free searches stall. Returns a point of the box that is not
/// worse than x; x itself for l2 or too many residuals.
[[nodiscard]] std::vector<double> descend_epigraph(const Problem& problem,
                                                   std::span<const CompiledResidual> residuals,
                                                   const std::vector<double>& x);

}  // namespace subdiv
