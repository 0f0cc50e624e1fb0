#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "analysis/deadline.h"
#include "analysis/jsr/word.h"

namespace subdiv {

/// A word with rho(P)^(1/length) of its product in floating point.
struct CandidateProduct {
  Word word;          ///< the letters, in the order in which matrices are applied
  double radius = 0;  ///< rho(P)^(1/length)
};

/// How far the search goes.
struct CandidateSearch {
  /// All Lyndon words are tried up to the length at which there would be more than this, and at least to
  /// length 2.
  int words = 6000;
  /// Longer words grow from those with the largest norms (Gripenberg 1996: only a word all of whose
  /// beginnings have a norm above the best radius^length can have a larger radius).
  int beam = 48;
  int longest = 40;  ///< length of a word
  /// How many are returned.
  int wanted = 24;
};

/// The words with the largest radii found, largest first; of radii equal to 12 digits the shorter words
/// first. The norms that guide the search are Euclidean (Frobenius): give the family in adapted coordinates.
[[nodiscard]] std::vector<CandidateProduct> candidate_products(const std::vector<Eigen::MatrixXd>& family,
                                                               const Deadline& deadline,
                                                               const CandidateSearch& search = {});

/// Inserts, drops or changes letters one at a time as long as that makes the radius larger: the best of words
/// like 0^k 1 with a long run.
[[nodiscard]] CandidateProduct locally_best(const std::vector<Eigen::MatrixXd>& family,
                                            const CandidateProduct& start, const Deadline& deadline);

/// The largest modulus of an eigenvalue, in floating point.
[[nodiscard]] double approximate_radius(const Eigen::MatrixXd& matrix);
/// Its root of the given order.
[[nodiscard]] double root_radius(const Eigen::MatrixXd& matrix, std::size_t order);

}  // namespace subdiv
