#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/jsr/matrix_family.h"
#include "analysis/jsr/number_field.h"
#include "analysis/jsr/word.h"
#include "schemes/algebra/algebraic.h"

namespace subdiv {

/// An eigenvector v of the product P of a word of length k, P v = lambda v, for a polytope to start with. Its
/// radius |lambda|^(1/k) is a lower bound of the joint spectral radius.
struct LeadingVector {
  Word word;              ///< the word
  BallMatrix eigenvalue;  ///< 1 x 1
  Interval radius;        ///< |lambda|^(1/k)
  BallMatrix vector;      ///< in adapted coordinates; in the family's own, the entry `unit` is 1
  Eigen::Index unit = 0;  ///< the entry that is made 1
  std::optional<Vector<Rational>> rational;  ///< in the family's own coordinates, when lambda is rational

  [[nodiscard]] bool is_real() const { return acb_mat_is_real(vector.raw()) != 0; }
};

/// Eigenvectors to the eigenvalues of largest modulus: exact null vectors where the family and the eigenvalue
/// are rational, else enclosures. The entry made 1 is the largest, so that vectors with the same entries in
/// other places (those of T_0 and T_1 of a mask) agree in scale. Empty when no eigenvector to an eigenvalue
/// other than 0 could be enclosed.
[[nodiscard]] std::vector<LeadingVector> leading_vectors(const MatrixFamily& family,
                                                         const AdaptedFamily& adapted, const Word& word);

/// The radius as an algebraic number: nothing when the family is not rational, or the degree unwieldy.
[[nodiscard]] std::optional<Algebraic> exact_radius(const MatrixFamily& family, const LeadingVector& leading);

/// The vector in the family's own coordinates over Q(radius), for a real eigenvalue of a rational family;
/// nothing when the eigenvalue is not simple.
[[nodiscard]] std::optional<Vector<FieldElement>> exact_vector(
    const MatrixFamily& family, const LeadingVector& leading,
    const std::shared_ptr<const NumberField>& radius);

}  // namespace subdiv
