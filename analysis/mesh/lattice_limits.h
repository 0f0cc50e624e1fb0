#pragma once

#include <optional>
#include <vector>

#include "analysis/mesh/characteristic_net.h"

namespace subdiv {

/// Limit position and first derivatives at the lattice points of a regular net P, in the plane coordinate z
/// in which the two directions of steps are 1 and i (quads), 1 and e^{i pi/3} (triangles):
///
///   f(x) = sum of position_o P(x + o),  df/dz = sum of derivative_o P(x + o),
///   df/dconj(z) = sum of conj(derivative_o) P(x + o).
///
/// They are left eigenvectors of the subdivision matrix at a regular vertex: mode 0, eigenvalue 1, and mode
/// 1, eigenvalue 1/2, to which all other eigenvectors are orthogonal (Halstead, Kass, DeRose 1993). For any
/// scheme for which these eigenvalues are simple in their modes, as it is when limits are C^1 and basis
/// functions independent. The Jacobian is |df/dz|^2 - |df/dconj(z)|^2 up to the area of a lattice cell.
struct LatticeLimits {
  std::vector<LatticeOffset> offsets;           ///< o, the support of both masks
  std::vector<double> position;                 ///< position_o, of sum 1
  std::vector<PlaneNumber<double>> derivative;  ///< derivative_o

  /// The limit f at the lattice point (a, b) of sector 0.
  [[nodiscard]] PlaneNumber<double> point(const CharacteristicNet<double>& net, int a, int b) const;
  /// The Jacobian there.
  [[nodiscard]] double jacobian(const CharacteristicNet<double>& net, int a, int b) const;
};

/// Nothing when an eigenvalue is not simple.
[[nodiscard]] std::optional<LatticeLimits> lattice_limits(const MeshScheme<double>& scheme);

}  // namespace subdiv
