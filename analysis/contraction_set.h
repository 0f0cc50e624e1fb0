#pragma once
#include "analysis/real_set.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// The exact set of all real p = x_0 for which every eigenvalue of the matrix has a modulus strictly below
/// the radius > 0. Poles of the entries do not belong to it. Eigenvalues can cross the circle only where a
/// factor of the characteristic polynomial vanishes at +-radius or has a resultant zero with its mirror image
/// at the circle; between such values Schur's recursion decides.
[[nodiscard]] RealSet contraction_set(const Matrix<RationalFunction>& matrix,
                                      const Rational& radius = Rational(1));

/// Points that belong to both sets.
[[nodiscard]] RealSet intersection(const RealSet& a, const RealSet& b);

}  // namespace subdiv
