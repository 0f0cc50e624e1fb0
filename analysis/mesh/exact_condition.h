#pragma once

#include "analysis/decision.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// Reif's condition at a vertex of valence n (spectral_condition.h) where eigenvalues tie, which enclosures
/// never decide: `no` when the exact eigenvalues of the whole matrix show that 1 is not simple, that the next
/// modulus is reached by more than one real number, or by one of another multiplicity than 2; `undecided`
/// otherwise. The cost grows with the cube of the valence and more: some 10 ms at valence 3.
[[nodiscard]] Decision exact_condition(const MeshScheme<Rational>& scheme, int valence);

}  // namespace subdiv
