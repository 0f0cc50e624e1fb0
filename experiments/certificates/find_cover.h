#pragma once

#include <string>

#include "experiments/verifier/cover.h"

namespace subdiv {

/// Cells, in the order of a walk, on which Bernstein coefficients prove the condition: halved, where they do
/// not, in the direction in which the coefficients vary most. Throws verifier::Rejected when more than
/// `most_cells` are needed.
[[nodiscard]] std::string find_cover(const verifier::Cover& cover, const verifier::Cell& cell,
                                     std::size_t most_cells = 4000);

}  // namespace subdiv
