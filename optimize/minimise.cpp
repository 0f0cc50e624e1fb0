#include "optimize/problem.h"

#include <fmt/format.h>

#include "optimize/linear_minimax.h"
#include "optimize/local_search.h"
#include "optimize/one_parameter.h"
#include "optimize/several_parameters.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

void require_well_posed(const Problem& problem) {
  if (problem.box.empty())
    throw InputError("nothing to optimise: name a parameter and its range, for example s=-2..6");
  if (problem.residuals.empty()) throw InputError("the objective has no residuals");
  for (std::size_t i = 0; i < problem.box.size(); ++i) {
    const Range& range = problem.box[i];
    if (range.lower < range.upper) continue;
    const std::string name = i < problem.names.size() ? problem.names[i] : fmt::format("parameter {}", i + 1);
    throw InputError(fmt::format("{}={}..{}: the range is empty; its lower end must be below its upper end",
                                 name, range.lower.to_string(), range.upper.to_string()));
  }
}

}  // namespace

Summary minimise(const Problem& problem, const Options& options) {
  require_well_posed(problem);
  if (auto summary = minimise_linear(problem)) return *summary;
  const std::vector<LocalMinimum> minima = local_minima(problem, options);
  if (problem.box.size() > 1) return minimise_several_parameters(problem, options, minima);
  std::vector<double> candidates;
  for (const LocalMinimum& m : minima) candidates.push_back(m.x[0]);
  return minimise_one_parameter(problem, options, candidates);
}

std::string to_string(Norm norm) {
  switch (norm) {
    case Norm::l1:
      return "l1";
    case Norm::l2:
      return "l2";
    case Norm::linf:
      break;
  }
  return "linf";
}

std::string to_string(Termination termination) {
  switch (termination) {
    case Termination::proved:
      return "proved";
    case Termination::not_unique:
      return "not unique";
    case Termination::out_of_boxes:
      return "out of boxes";
    case Termination::not_isolated:
      return "not isolated";
    case Termination::pole_in_box:
      return "pole in box";
    case Termination::local:
      return "local";
    case Termination::no_local_minimum:
      break;
  }
  return "no local minimum";
}

}  // namespace subdiv
