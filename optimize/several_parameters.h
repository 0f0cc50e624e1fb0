#pragma once

#include "optimize/local_search.h"
#include "optimize/problem.h"

namespace subdiv {

/// Certified minimisation over two or three parameters (any number in principle). From the points of a local
/// solver: guess which residuals are active and which parameters stand at an end of their range; prove the
/// critical point of that guess by Krawczyk's test and that it is the only minimum in a neighbourhood
/// (LocalModel); exclude the rest of the box by branch and bound with dual-weighted Taylor bounds (exclude),
/// going on from any better point met there. Where all residuals can vanish together the minimum is 0, proved
/// when as many of them as there are parameters span the others; when fewer do, one point of a curve or
/// surface of zeros is given (not_unique).
[[nodiscard]] Summary minimise_several_parameters(const Problem& problem, const Options& options,
                                                  const std::vector<LocalMinimum>& candidates);

}  // namespace subdiv
