#pragma once

#include <string>
#include <vector>

#include "schemes/algebra/polynomial.h"

namespace subdiv {

/// The points where all equations vanish and none of `nonzero` does, over the complex numbers.
struct ZeroSet {
  std::vector<Polynomial> equations;  ///< all of which vanish
  std::vector<Polynomial> nonzero;    ///< none of which vanishes
};

/// What was found, with the cases of the proof as readable lines, indented by depth.
struct EmptinessProof {
  bool proved = false;             ///< false: not empty, or not decided
  std::vector<std::string> cases;  ///< one step of the proof a line
};

/// Tries to prove in exact arithmetic that the set is empty. Factors that cannot vanish are dropped; an
/// equation that factors splits into cases; one that is linear in a variable, c v + d, eliminates it where c
/// != 0, with c = d = 0 as a case of its own; polynomials of one variable have no common zero when their gcd
/// is 1; what remains is projected by resultants. Each step keeps every zero, so "proved" is a proof; the
/// converse does not hold. `names` are for the lines.
[[nodiscard]] EmptinessProof prove_empty(const ZeroSet& set, const std::vector<std::string>& names = {});

}  // namespace subdiv
