#pragma once

#include <array>
#include <optional>
#include <vector>

#include "schemes/evaluate/patch_table.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// Where a vertex of valence n tends to, and how: weights of the vertex and of the places (sector_places) of
/// `rings` rings around it, computed in double.
struct LimitStencil {
  int rings = 1;  ///< the neighbourhood that the weights cover
  /// The limit position: `centre` P_0 + sum over sectors and places of position[p] P_{k,p}; left eigenvector
  /// of the subdivision matrix for 1, weights of sum 1.
  double centre = 1;
  std::vector<double> position;  ///< by the place p
  /// The tangent plane: with w = e^{2 pi i/n}, the real and the imaginary part of the sum of w^-k tangent[p]
  /// P_{k,p} span it; the left eigenvector of Fourier mode 1 for its largest eigenvalue, up to a factor.
  /// Their cross product, imaginary part first, points to the side from which the mesh is counter-clockwise.
  /// Nothing where the limit surface need not have a tangent plane there: where that eigenvalue is not real
  /// and larger in modulus than all others but 1 and its copy in mode -1.
  std::optional<std::vector<std::array<double, 2>>> tangent;
};

/// Throws std::domain_error when 1 is no simple eigenvalue that dominates all others: there is no limit.
[[nodiscard]] LimitStencil limit_stencil(const MeshScheme<double>& scheme, int valence);

/// The rules that take points of a mesh to their limit positions, and to the two tangents whose cross
/// product, second x first, is normal (zero where there is none), for MeshRefinement. They throw InputError
/// for a mesh with other faces than the scheme's. At a border whose rules the scheme has itself, the border
/// curve's limit: the cubic B-spline's for schemes that move border vertices by (1, 6, 1)/8, the point itself
/// where it stays; tangents there are not offered (zero).
struct LimitRules {
  FinalRule position;        ///< weights of the limit position
  FinalRule first_tangent;   ///< the real part of the sum that tangents are made of
  FinalRule second_tangent;  ///< the imaginary part
};
/// The rules of one scheme.
[[nodiscard]] LimitRules limit_rules(const MeshScheme<double>& scheme);

}  // namespace subdiv
