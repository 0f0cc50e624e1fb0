#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "schemes/algebra/matrix.h"

namespace subdiv {

/// Looks for a symmetric polytope in R^n that contains the unit vectors and that every matrix maps into c
/// times itself, for one c < 1: proof that the joint spectral radius of the family, and of every family in
/// its convex hull, is below 1. Returns the number of vertices up to sign; nothing when the search stops
/// without a proof, at the latest with `most` vertices.
///
/// The search starts from the unit vectors and adds images that are not inside. Vertices and coefficients are
/// doubles; each containment T v = sum c_k v_k + rest is checked by itself: sum |c_k| + |rest|_1, which
/// bounds the gauge of T v, stays at most 1 - margin with a bound of all rounding errors. A margin far above
/// those errors and below the distance of the radius from 1 serves; larger ones need fewer vertices.
[[nodiscard]] std::optional<std::size_t> contracting_polytope(const std::vector<Matrix<Rational>>& matrices,
                                                              std::size_t most, double margin = 1e-4);

}  // namespace subdiv
