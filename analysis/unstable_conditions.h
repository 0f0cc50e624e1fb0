#pragma once

#include <vector>

#include "schemes/algebra/laurent.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// A way in which the integer shifts of the limit functions of a binary symbol ((1+z)/2)^n b(z) may be
/// linearly dependent (unstable), as polynomial equations in the parameters of b.
struct UnstableCondition {
  /// 0: b has the roots z and -z for some z; odd m: b vanishes at -w for all primitive m-th roots of unity w.
  int order = 0;
  std::vector<Polynomial> equations;  ///< all hold
};

/// Every way in which shifts can be unstable for real parameters: where none of the conditions holds, the
/// shifts are stable in the maximum norm (Jia & Wang 1993, theorem 4.3: unstable only when the symbol has a
/// pair of opposite roots, or vanishes at the negatives of all w, w^2, w^4, .. for a root of unity w != 1 of
/// odd order). One condition for each irreducible factor of the resultant of the even and the odd part of b,
/// and one for each order m; contradictory conditions (a constant equation) are left out. Conditions for
/// opposite roots may hold without instability where the outer coefficients vanish. b has at most 4 roots
/// (std::domain_error): the cycles w, w^2, w^4, .. that fit are then those of all primitive roots of order 3
/// and 5.
[[nodiscard]] std::vector<UnstableCondition> unstable_conditions(const Laurent<RationalFunction>& b);

}  // namespace subdiv
