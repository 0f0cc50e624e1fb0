#pragma once

#include <vector>

#include "analysis/jsr/ball_matrix.h"

namespace subdiv {

/// A ball that contains an eigenvalue of every matrix in a ball matrix, and one (a column) that contains an
/// eigenvector to it, normalised to one entry; existence is proved (Rump 2001; Arb's
/// acb_mat_eig_enclosure_rump).
struct Eigenpair {
  BallMatrix value;   ///< 1 x 1
  BallMatrix vector;  ///< a column

  [[nodiscard]] bool is_real() const { return acb_is_real(value.at(0, 0)) != 0; }
};

/// Enclosures of the eigenpairs with the largest modulus, up to `tolerance` relative to it as judged by an
/// approximate diagonalisation, of a real matrix: one of each conjugate pair. Where eigenvalue and vector are
/// real, so are the balls. Eigenvalues that cannot be isolated (defective or nearly multiple ones) are left
/// out.
[[nodiscard]] std::vector<Eigenpair> leading_eigenpairs(const BallMatrix& matrix, double tolerance,
                                                        long precision);

}  // namespace subdiv
