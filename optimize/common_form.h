#pragma once

#include <vector>

#include "optimize/problem.h"

namespace subdiv {

/// The residuals over one denominator: r_i = +-p_k / q with distinct polynomials p_k. Residuals that vanish
/// identically are left out; residuals that are equal or each other's negatives are kept once.
struct CommonForm {
  std::vector<Polynomial> numerators;  ///< p_k
  std::vector<int> weights;            ///< of each numerator: how many residuals it stands for
  std::vector<int> representative;     ///< of each residual: its numerator, or -1 where the residual is 0
  Polynomial denominator;              ///< positive at the box's centre

  /// p_k / q.
  [[nodiscard]] RationalFunction residual(int k) const {
    return RationalFunction(numerators[static_cast<std::size_t>(k)]) / RationalFunction(denominator);
  }
  /// The residuals that numerator k stands for.
  [[nodiscard]] std::vector<int> members(int k) const;
};

/// The form of a problem's residuals.
[[nodiscard]] CommonForm common_form(const Problem& problem);

/// The objective as such a form: l2: one numerator, the sum of squares, over q^2; l1: numerators times their
/// weights; linf: as it stands.
[[nodiscard]] CommonForm objective_form(const Problem& problem, const CommonForm& form);

/// Numerators that are linearly independent over Q and span all others: where these vanish, all do.
[[nodiscard]] std::vector<int> spanning_numerators(const CommonForm& form);

/// Is the polynomial positive on the whole box? Proved by Taylor forms on at most max_boxes boxes; false
/// means "not known".
[[nodiscard]] bool is_positive_on(const Polynomial& p, const std::vector<Range>& box, long precision,
                                  int max_boxes);

}  // namespace subdiv
