#pragma once

#include <vector>

#include "analysis/curve_measures.h"
#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/laurent.h"

namespace subdiv {

/// What repeated smoothing makes of a closed polyloop of n vertices. Mode k, 0 <= k <= n/2, is its part of
/// the frequencies +-2 pi k/n; mode 0 is the centroid. A step multiplies mode k by the transfer function
/// there, so that, scaled to its size, the polyloop tends to the modes of the largest gain. Mode 1 by itself
/// is an affine image of the regular polygon of n vertices: they lie on an ellipse.

/// The transfer function at mode 0 .. n/2, exact, of symmetric weights (std::domain_error for others, and for
/// n < 1).
[[nodiscard]] std::vector<Algebraic> mode_gains(const Laurent<Rational>& weights, int n);

/// The modes 1 .. n/2 whose gain has the largest modulus, ascending; none for n = 1.
[[nodiscard]] std::vector<int> slowest_modes(const Laurent<Rational>& weights, int n);

/// The t* up to which mode 1 shrinks slowest under tuck(t): for 0 < t < t* and for no t from t* on, n >= 4
/// (std::domain_error below: there is no other mode). 2/(x_1 + max x_k), x_k = 1 - cos(2 pi k/n), where 1 - t
/// x_1 = -(1 - t max x_k).
[[nodiscard]] Algebraic ellipse_end(int n);

/// The ellipse of mode 1 of a closed plane polygon, half axes; both 0 when the polygon has no such part.
/// Throws std::invalid_argument for an open polygon or another dimension than 2.
struct HalfAxes {
  double major = 0;  ///< the longer half axis
  double minor = 0;  ///< the shorter half axis
};
/// The ellipse of a closed plane polygon.
[[nodiscard]] HalfAxes limit_ellipse(const Polyline& polygon);

}  // namespace subdiv
