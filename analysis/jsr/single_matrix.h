#pragma once

#include "analysis/jsr/block_radius.h"

namespace subdiv {

/// The spectral radius of the only matrix of a family, for every matrix in the balls: from enclosures of all
/// its eigenvalues (van der Hoeven & Mourrain 2017 and Rump 2001 in Arb's acb_mat_eig_multiple), else, for
/// defective ones, from norms and traces of high powers.
[[nodiscard]] BlockRadius single_matrix_radius(const MatrixFamily& family);

}  // namespace subdiv
