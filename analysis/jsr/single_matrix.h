#pragma once

#include <optional>

#include "analysis/jsr/block_radius.h"

namespace subdiv {

/// The spectral radius of the only matrix of a family, from enclosures of all its eigenvalues (van der Hoeven
/// & Mourrain 2017 and Rump 2001 in Arb's acb_mat_eig_multiple): of every matrix in the balls. Those of
/// multiple eigenvalues are wide. Nothing when the eigenvalues could not be enclosed.
[[nodiscard]] std::optional<BlockRadius> single_matrix_radius(const MatrixFamily& family);

}  // namespace subdiv
