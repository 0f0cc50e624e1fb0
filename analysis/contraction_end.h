#pragma once

#include <optional>
#include <vector>

#include "analysis/jsr/word.h"
#include "analysis/parametric_polytope.h"

namespace subdiv {

/// Proof that the joint spectral radius of T_0(p), T_1(p), .. is below 1 for all p between `end`, which is
/// left out, and `cut`, which belongs to it: polytopes that all products of one length map into themselves
/// and contract.
struct ContractionEnd {
  Algebraic end;                         ///< the excluded end, where a product gets the spectral radius 1
  Rational cut;                          ///< how far the proof reaches
  int length = 1;                        ///< of the products that contract
  std::vector<PolytopeProof> polytopes;  ///< on parts that cover the range in turn
};

/// Looks for that proof at the number `end` where the product of a word gets the eigenvalue 1 or -1, with the
/// cut between `end` and `inside`. Tried are
///
///   polytopes that stand still: images of the unit vectors at p = end, which must be rational; and the unit
///   ball of the 1-norm for products of the length 2 or 3;
///   polytopes that move: the orbit of an adjugate column (contraction_range.h) for the product, or, where
///   the family is invariant under the reversal F of the coordinates and the word is u followed by its mirror
///   image, for F T_u, the square of which is a product.
///
/// Nothing when none closes.
[[nodiscard]] std::optional<ContractionEnd> prove_contraction_at_end(
    const std::vector<Matrix<RationalFunction>>& matrices, const Word& word, const Algebraic& end,
    const Rational& inside);

}  // namespace subdiv
