#pragma once

#include <vector>

#include "analysis/jsr/leading_vectors.h"
#include "analysis/jsr/matrix_family.h"
#include "schemes/algebra/rational.h"

namespace subdiv {

/// Factors a_i for leading vectors v_i of several words with one radius r, with which one polytope may hold
/// them all: with u_j the leading left eigenvector to v_j, <u_j, v_j> = 1,
///
///   a_i |<u_j, T_w v_i>| / r^|w| <= s a_j   for the words w tried and all i != j, s as small as may be;
///
/// with s > 1 the orbit of some v_i leaves any polytope along some v_j (Guglielmi & Protasov, SIAM J. Matrix
/// Anal. Appl. 37, 2016, section 3). All 1 when a left eigenvector is not known. In floating point: nothing
/// depends on them.
[[nodiscard]] std::vector<Rational> balanced_scales(const AdaptedFamily& family,
                                                    const std::vector<LeadingVector>& vectors);

}  // namespace subdiv
