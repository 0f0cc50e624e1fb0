#pragma once

#include <array>
#include <optional>

#include "analysis/mesh/characteristic_map.h"

namespace subdiv {

/// Bounds for limits of any scheme on the regular lattice, by contraction of local differences. Let a scheme
/// reproduce constants, and let W be the lattice points whose basis functions do not vanish on the unit
/// square; the new values on the W of a quarter of the square are A_e times the old ones on W, e one of four.
/// With the values v_c + u, u_c = 0, at the reference point c of W, steps e_1 .. e_m make them v_c + M u, M =
/// A_{e_m} .. A_{e_1}: the reference's own differs from v_c by at most alpha max |u|, and the others from it
/// by at most rho max |u|,
///
///     alpha = sum_j |M_cj|,  rho = max over i of sum_j |M_ij - M_cj|,  j != c.
///
/// Take words e_1 .. e_m one of which begins every infinite word. If rho < 1 for all of them, the scheme
/// converges to continuous limits (W has 2 points or more in each direction, so that squares side by side
/// share some), and on the square, for real or complex values,
///
///     |limit - v_c| <= factor max |v_j - v_c|,   factor = max over the words of alpha/(1 - rho).
///
/// For a tensor product of two schemes of curves, factor is the product of the two norms max over u of sum_j
/// |b_j(u)|, b_j the basis functions: with j = c in the sums too, a norm is at most max of alpha + factor
/// rho.
struct LatticeWindow {
  LatticeOffset first;      ///< W: first + (i, j), 0 <= i < size.a, 0 <= j < size.b
  LatticeOffset size;       ///< of W, in points along the two directions
  LatticeOffset reference;  ///< c, near the middle
  double factor = 0;        ///< an upper bound, rounding errors included
};

/// Nothing when the scheme does not reproduce constants, W is too small, or words of moderate length have rho
/// >= 1.
[[nodiscard]] std::optional<LatticeWindow> lattice_window(const LatticeMask<Rational>& mask);

/// The mask that refines the divided differences along the first or the second direction, 2 z c(z, w)/(1 +
/// z): D(x) = P(x + step) - P(x), doubled at each level. Nothing when the division leaves a remainder.
[[nodiscard]] std::optional<LatticeMask<Rational>> derivative_scheme(const LatticeMask<Rational>& mask,
                                                                     bool first_direction);

/// Windows of a scheme and of its derivatives along the two directions: that they exist proves limits C^1.
struct DerivativeBounds {
  LatticeWindow position;                    ///< of the limit itself
  std::array<LatticeWindow, 2> derivatives;  ///< of the derivatives along the two directions
};
/// All three windows; nothing when one of them is missing.
[[nodiscard]] std::optional<DerivativeBounds> derivative_bounds(const LatticeMask<Rational>& mask);

/// The verdict on a net that has 2 reach + 2 rings or more and is extended as needed: on each square of the
/// lattice both derivatives lie in discs, which have a sign of the Jacobian or are looked at again a level
/// later, in at most `levels` levels.
[[nodiscard]] CharacteristicMap enclosed_verdict(CharacteristicNet<Interval> net,
                                                 const LatticeMask<Interval>& mask,
                                                 const DerivativeBounds& bounds, int levels);

}  // namespace subdiv
