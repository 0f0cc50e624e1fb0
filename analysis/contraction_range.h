#pragma once

#include <optional>
#include <vector>

#include "analysis/parametric_polytope.h"

namespace subdiv {

/// Where the joint spectral radius of a family T_0(p), T_1(p), .. is below 1, as an exact interval: one of
/// its ends is the algebraic number p* at which the leading product gets an eigenvalue 1.
struct ContractionRange {
  RealInterval range;  ///< of the parameter p
  int length = 1;      ///< of the products that `products` bounds
  std::vector<PolytopeProof>
      products;  ///< unit ball of the 1-norm for all products of this length, away from p*
  std::vector<PolytopeProof> polytopes;  ///< near p*
};

/// The vertices of a polytope that the family maps into itself for p below (or above) p* and near it. Let the
/// matrix `leading` have a simple eigenvalue 1 at p*. Then
///
///     v(p) = adj(I - leading) v_0 obeys leading v = v - det(I - leading) v_0,
///
/// and it is the leading eigenvector at p*: with v_0 near that eigenvector, leading v lies inside wherever
/// the determinant is positive. v_0 is the eigenvector at `at`, a number near p*, rounded to three digits.
/// The other vertices are images under products of the family that leave the hull of those before at p = at,
/// lengthened by 1/100. When the family is invariant under conjugation with an involution F, give it as
/// `mirror`: vertices then come in pairs v, F v. Nothing when the eigenvector is not found in floating point
/// or more than 60 vertices are needed. A leading product of several factors T_k .. T_1 needs its shorter
/// products T_1, T_2 T_1, .. as `beginnings`: the images of v under them are vertices as they are.
[[nodiscard]] std::optional<Matrix<RationalFunction>> critical_vertices(
    const std::vector<Matrix<RationalFunction>>& matrices, const Matrix<RationalFunction>& leading,
    const std::optional<Matrix<RationalFunction>>& mirror, const Rational& at,
    const std::vector<Matrix<RationalFunction>>& beginnings = {});

/// Proves that the joint spectral radius is below 1 exactly in the open interval `range` with finite ends, as
/// far as the part inside is concerned: one of the ends is the p* of `leading`. That it is not below 1 at and
/// beyond the ends is for the caller to know (see contraction_set.h). Nothing when no proof is found.
[[nodiscard]] std::optional<ContractionRange> prove_contraction(
    const std::vector<Matrix<RationalFunction>>& matrices, const Matrix<RationalFunction>& leading,
    const std::optional<Matrix<RationalFunction>>& mirror, const RealInterval& range);

/// The matrix of the permutation that reverses the order of n coordinates.
[[nodiscard]] Matrix<RationalFunction> reversal(Eigen::Index n);

}  // namespace subdiv
