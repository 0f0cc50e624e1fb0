#pragma once

#include <optional>
#include <vector>

#include "optimize/common_form.h"
#include "optimize/local_model.h"

namespace subdiv {

/// A minimum that is proved to be the only one in a neighbourhood.
struct VerifiedMinimum {
  CriticalPoint point;       ///< with its multipliers
  Interval value;            ///< of the objective there; exactly 0 where all residuals vanish
  std::vector<int> active;   ///< numerators of the objective's form
  Box neighbourhood;         ///< in which it is the only one
  bool on_boundary = false;  ///< a parameter stands at an end of its range
};

/// Tries the guesses of active residuals that the objective near a point suggests, the simplest first;
/// nothing when none of them can be proved. `form` is the objective_form of the problem.
[[nodiscard]] std::optional<VerifiedMinimum> verify_minimum(const Problem& problem, const CommonForm& form,
                                                            const std::vector<double>& near, long precision);

}  // namespace subdiv
