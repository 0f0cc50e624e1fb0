#pragma once

#include "optimize/problem.h"

namespace subdiv {

/// Certified minimisation over one parameter. Branch and bound with mean-value forms in ball arithmetic
/// excludes all of the range but one interval of options.width; there the kind of the minimum is proved: a
/// kink (linf: an increasing and a decreasing residual meet; l1: a residual vanishes whose slope outweighs
/// the others') or a smooth minimum (positive second derivative), hence unique, and its defining polynomial
/// over Q is known. `candidates` are points from a local solver; they speed the search and are not trusted.
[[nodiscard]] Summary minimise_one_parameter(const Problem& problem, const Options& options,
                                             const std::vector<double>& candidates = {});

}  // namespace subdiv
