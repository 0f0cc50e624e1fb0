#pragma once

#include <vector>

#include "analysis/map_cell.h"
#include "schemes/algebra/matrix.h"
#include "schemes/mask.h"

namespace subdiv {

/// Where a joint spectral radius is below a bound, cell by cell.
struct RadiusMap {
  std::vector<MapCell> cells;  ///< they cover the box and overlap in their borders only

  /// The volume of the cells with this decision.
  [[nodiscard]] Rational volume(Decision below) const;
};

/// Where the map gives up.
struct RadiusMapOptions {
  int depth = 7;     ///< cells are halved in all directions at most so often
  CellOptions cell;  ///< for each cell
};

/// Where the joint spectral radius of T_0(x), T_1(x), .. is below the bound > 0: a tree of cells, each
/// decided by itself (map_cell.h). The entries are rational functions of x_0 .. x_{d-1}, d the dimension of
/// the box (std::domain_error otherwise).
[[nodiscard]] RadiusMap radius_map(const std::vector<Matrix<RationalFunction>>& family, const Rational& bound,
                                   const ParameterBox& box, const RadiusMapOptions& options = {});

/// Where a binary or ternary scheme is C^continuity in the sense of its differences: those of order
/// `continuity` of m^(k continuity) times the k-th refinement tend to zero. The symbol a(z) = m (sigma/m)^n
/// b(z) with the largest n that serves all parameters needs continuity <= n - 1 (std::domain_error); the
/// condition is rho(b) < m^(n-1-continuity).
[[nodiscard]] RadiusMap continuity_map(const Mask<RationalFunction>& mask, int continuity,
                                       const ParameterBox& box, const RadiusMapOptions& options = {});

}  // namespace subdiv
