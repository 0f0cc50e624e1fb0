#pragma once

#include <vector>

#include "optimize/boxes.h"
#include "optimize/common_form.h"

namespace subdiv {

/// What became of the proof that the objective exceeds `level` everywhere on a box but in given
/// neighbourhoods.
struct Exclusion {
  /// How the search ended.
  enum class Outcome {
    proved,
    better_point,  ///< `point` has an objective certainly below the level
    out_of_boxes,
  } outcome = Outcome::proved;  ///< which of them
  std::vector<Rational> point;  ///< of better_point; else empty
  int boxes = 0;                ///< that were examined
};

/// Branch and bound for norm(p_1 .. p_k) / q > level (l1: sum of |p_i|; linf: maximum; one p_1 for l2), q > 0
/// on the box; see objective_form. A box is excluded when sum of w_i p_i - |w| level q > 0 on it for some
/// weights w, |w| their dual norm: polynomials only, bounded by their Taylor forms about its centre, with the
/// multipliers of the linearised problem as weights. Boxes inside a neighbourhood are not examined.
[[nodiscard]] Exclusion exclude(Norm norm, const CommonForm& form, const Interval& level,
                                const std::vector<Range>& box, const std::vector<Box>& neighbourhoods,
                                long precision, int max_boxes);

}  // namespace subdiv
