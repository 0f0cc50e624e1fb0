#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/decision.h"
#include "analysis/enclosure.h"
#include "analysis/jsr/word.h"
#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// The joint spectral radius of a finite family of square matrices,
///
///   rho(T_0, .., T_{m-1}) = lim over k of  max over words w of length k of |T_{w_k} .. T_{w_1}|^(1/k)
///
/// (Rota & Strang 1960), in any norm. For every word, rho(P_w)^(1/length) is a lower bound (Berger & Wang
/// 1992).
struct JointSpectralRadius {
  /// exact when a polytope closed at the radius of a word that has a closed form; certified otherwise. The
  /// status is closed when the bounds are those of one word, else which budget ran out.
  Enclosure value;
  std::optional<Algebraic> exact;  ///< the closed form, when there is one
  /// The words found with the largest radius; when `attained`, theirs is the joint spectral radius.
  std::vector<Word> words;
  bool attained = false;  ///< whether the words above attain it
  /// Whether |T_w| <= C rho^length for all words w, for some C.
  Decision bounded = Decision::undecided;
  /// Vertices, up to sign, of the polytopes behind the upper bound.
  std::size_t vertices = 0;
  /// Dimensions of the diagonal blocks in a basis in which all matrices are block triangular.
  std::vector<int> blocks;
};

/// Where the computation gives up and hands over the enclosure reached.
struct JointSpectralRadiusBudget {
  double seconds = 30;          ///< of wall-clock time
  std::size_t vertices = 1200;  ///< of one polytope
  long precision = 192;         ///< bits of the ball arithmetic
};

/// Certified bounds: from below by the spectral radii of products, from above by polytopes P with T_i P in c
/// P, verified in ball or exact rational arithmetic. Common invariant subspaces are split off first, in exact
/// arithmetic for rational matrices. Intervals stand for all matrices within them: the value encloses the
/// radius of each such family. Throws std::domain_error for an empty family or matrices that are not square,
/// of one size and finite.
[[nodiscard]] JointSpectralRadius joint_spectral_radius(const std::vector<Matrix<Rational>>& family,
                                                        const JointSpectralRadiusBudget& budget = {});
/// The same for intervals: the answer encloses those of all families in them.
[[nodiscard]] JointSpectralRadius joint_spectral_radius(const std::vector<Matrix<Interval>>& family,
                                                        const JointSpectralRadiusBudget& budget = {});
/// The same over the real algebraic numbers.
[[nodiscard]] JointSpectralRadius joint_spectral_radius(const std::vector<Matrix<Algebraic>>& family,
                                                        const JointSpectralRadiusBudget& budget = {});

}  // namespace subdiv
