#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optimize/problem.h"

namespace subdiv {

/// A point where a local solver stopped. Approximate: a starting point for a proof, never one.
struct LocalMinimum {
  std::vector<double> x;  ///< a value for each parameter
  double objective = 0;   ///< the norm there
};

/// Local minima from options.starts points spread over the box (a Halton sequence: deterministic), best
/// first: Ceres for l2, NLopt's Sbplx for the norms with kinks, over several parameters followed by
/// descend_epigraph. Points that agree to 1e-7 are listed once;
/// empty when no start converged.
[[nodiscard]] std::vector<LocalMinimum> local_minima(const Problem& problem, const Options& options);

/// The same for any function of the parameters, by Sbplx alone: values that are not finite count as very
/// large. tolerance is that of the parameters, relative to their size.
[[nodiscard]] std::vector<LocalMinimum> local_minima(
    const std::function<double(const std::vector<double>&)>& function, const std::vector<Range>& box,
    int starts, double tolerance);

/// One such descent from a given point of the box; nothing when the solver fails.
[[nodiscard]] std::optional<LocalMinimum> improve(const Problem& problem, const std::vector<double>& start);

}  // namespace subdiv
