#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/mesh/bernstein_patch.h"
#include "analysis/mesh/characteristic_net.h"

namespace subdiv {

/// Uniform splines on the regular lattices.
struct LatticeSpline {
  int sides = 4;   ///< 4: tensor products of B-splines of odd degree; 3: the quartic box spline of the three
  int degree = 3;  ///< directions of the triangles' edges, each taken twice
};

/// The masks of their subdivision: (1 + z)^(d + 1) (1 + w)^(d + 1)/4^d, and (1 + z)^2 (1 + w)^2 (1 +
/// w/z)^2/16, centred (Loop 1987; de Boor, Hoellig, Riemenschneider: Box Splines, chapter VII).
[[nodiscard]] LatticeMask<Rational> spline_mask(const LatticeSpline& spline);

/// The spline that has this very mask, if there is one.
[[nodiscard]] std::optional<LatticeSpline> spline_with_mask(const LatticeMask<Rational>& mask, int sides);

/// A face of the lattice in sector 0: the quad or, upright, the triangle with the corners (a, b), (a + 1, b),
/// (a, b + 1); else the triangle (a + 1, b + 1), (a, b + 1), (a + 1, b).
struct LatticeCell {
  int a = 0;            ///< along the first spoke
  int b = 0;            ///< along the second direction
  bool upright = true;  ///< of the two triangles of a quad; true for quads
};

/// The cells between row r and row 2 r, those of them with b <= a: their reflections are the others.
[[nodiscard]] std::vector<LatticeCell> ring_cells(int sides, int r);

/// The limit surface over a cell, x and y in Bernstein form: (degree + 1)^2 coefficients (i, j), i along the
/// first direction, or those with i + j <= 4 of a triangle from its first corner on. The net needs
/// (degree + 1)/2 rows around the cell (triangles: 1).
[[nodiscard]] std::pair<SquarePatch, SquarePatch> square_piece(const CharacteristicNet<Interval>& net,
                                                               int degree, const LatticeCell& cell);
/// The coordinates x and y of the map on a triangle of the lattice, box splines in Bernstein form.
[[nodiscard]] std::pair<TrianglePatch, TrianglePatch> triangle_piece(const CharacteristicNet<Interval>& net,
                                                                     const LatticeCell& cell);

/// The Jacobian with respect to lattice steps, over the unit square.
[[nodiscard]] SquarePatch jacobian(const CharacteristicNet<Interval>& net, const LatticeSpline& spline,
                                   const LatticeCell& cell);

/// The curve along row r from the first spoke on, Bezier pieces with b <= a, in order.
[[nodiscard]] std::vector<std::vector<PlaneNumber<Interval>>> row_curve(
    const CharacteristicNet<Interval>& net, const LatticeSpline& spline, int r);

}  // namespace subdiv
