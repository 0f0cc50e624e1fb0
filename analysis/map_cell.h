#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/bernstein_hull.h"
#include "analysis/decision.h"
#include "analysis/expanding_condition.h"
#include "analysis/transition_matrices.h"

namespace subdiv {

/// A box of parameters, and whether the joint spectral radius is proved to be below 1 for all (yes) or for
/// none (no) of them.
struct MapCell {
  ParameterBox box;                      ///< of the parameters
  Decision below = Decision::undecided;  ///< whether the radius is below 1
  std::size_t vertices = 0;  ///< yes: of the polytope that all matrices of the cell map into itself
  Word word;                 ///< no: its product has a spectral radius of at least 1 everywhere in the cell
};

/// What is tried on each cell.
struct CellOptions {
  std::size_t vertices = 120;  ///< of one polytope, up to sign
  int longest_word = 4;        ///< of the words tried
  double margin = 1e-4;        ///< polytopes contract by 1 - margin at least
};

/// Decides cells for one family T_0(x), T_1(x), .. whose entries are rational functions of x_0 .. x_{d-1},
/// d >= 1 the dimension (std::domain_error otherwise).
///
/// yes: the T_r(x) are convex combinations of finitely many matrices (bernstein_hull.h), and one polytope
/// contracts under all of these (corner_polytope.h): that settles all of the cell, and also products whose
/// factors come from different points of it. no: the family has no pole in the cell and a condition
/// (expanding_condition.h) holds on all of it, in ball arithmetic.
class CellDecider {
 public:
  /// With the conditions of all words up to options.longest_word.
  CellDecider(const std::vector<Matrix<RationalFunction>>& family, std::size_t dimension,
              const CellOptions& options = {});
  /// With these conditions.
  CellDecider(const std::vector<Matrix<RationalFunction>>& family, std::size_t dimension,
              const std::vector<ExpandingCondition>& conditions, const CellOptions& options);

  /// Decides one cell; undecided where neither proof succeeds.
  [[nodiscard]] MapCell decide(const ParameterBox& box) const;

 private:
  CellOptions options_;
  BernsteinHull hull_;
  std::vector<std::pair<Word, RangedPolynomial>> conditions_;
};

/// The transition matrices of b times m^(continuity-n+1), n the number of factors: the scheme is
/// C^continuity, 0 <= continuity < n, where their joint spectral radius is below 1 (hoelder.h).
[[nodiscard]] std::vector<Matrix<RationalFunction>> continuity_family(
    const NormalForm<RationalFunction>& form, int continuity);

/// The family divided by the bound.
[[nodiscard]] std::vector<Matrix<RationalFunction>> divided(std::vector<Matrix<RationalFunction>> family,
                                                            const Rational& bound);

}  // namespace subdiv
