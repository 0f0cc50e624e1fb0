#pragma once

#include <utility>
#include <vector>

#include "analysis/mesh/fan_matrix.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// The characteristic polynomials of the Fourier blocks of a scheme around a vertex of valence n, exact. Mode
/// k holds the control points whose sector j is w^j times sector 0, w = e^{2 pi i k/n}: its block is the sum
/// of blocks[j] w^j (fan_matrix.h). A scheme has no preferred orientation, so that w and 1/w have the same
/// polynomial, one in x and c = cos(2 pi k/n).
///
/// For k != 0 one polynomial serves all valences and modes: what a rule takes equally from all sectors
/// vanishes there, and the rest does not depend on n.

/// x_5 stands for c, x_4 for 1/n, x_0 and on for the scheme's parameters, x_7 (eigenvalue_variable) for x.
inline constexpr int turn_variable = 5;
/// The variable that stands for the valence n where the rules of mode 0 depend on it.
inline constexpr int valence_variable = 4;

/// A polynomial as a product of irreducible factors over Q with their multiplicities: 0 exactly at the
/// eigenvalues, wherever the leading coefficient in x is not 0 (it is constant but for poles of the rules).
struct ModeEquation {
  std::vector<std::pair<Polynomial, int>> factors;  ///< irreducible, with multiplicities

  /// The degree in x of the product.
  [[nodiscard]] long degree() const;
  /// The factors multiplied out.
  [[nodiscard]] Polynomial product() const;
};

/// The modes k != 0 of all valences. Throws std::logic_error when a rule reaches more than 4 sectors away or
/// prefers an orientation.
[[nodiscard]] ModeEquation turning_modes(const MeshScheme<RationalFunction>& scheme);

/// Of a matrix at valence 11 or more (std::logic_error), where the sectors that a rule reads around a place
/// do not meet on the far side, and with weights that depend on the valence only where they are the same for
/// all sectors.
[[nodiscard]] ModeEquation turning_modes(const FanMatrix<RationalFunction>& fan);

/// Mode 0 at one valence, the vertex itself included.
[[nodiscard]] ModeEquation invariant_mode(const MeshScheme<RationalFunction>& scheme, int valence);
[[nodiscard]] ModeEquation invariant_mode(const FanMatrix<RationalFunction>& fan);

/// Mode 0 at all valences but listed exceptions of the rules: entries of its matrix are linear in 1/n, which
/// is read off at two valences and verified at a third (std::logic_error).
[[nodiscard]] ModeEquation invariant_modes(const MeshScheme<RationalFunction>& scheme);

}  // namespace subdiv
