#pragma once

#include <cstddef>
#include <vector>

#include "analysis/decision.h"
#include "analysis/jsr/word.h"
#include "schemes/algebra/matrix.h"
#include "schemes/mask.h"

namespace subdiv {

/// Parameters x_i in [lower_i, upper_i].
struct ParameterBox {
  std::vector<Rational> lower;
  std::vector<Rational> upper;

  [[nodiscard]] Rational volume() const;
};

/// A cell of a map, and whether the joint spectral radius is proved to be below the bound for all (yes) or
/// for none (no) of its parameters.
struct MapCell {
  ParameterBox box;
  Decision below = Decision::undecided;
  std::size_t vertices = 0;  // yes: of the polytope that all matrices of the cell map into itself
  Word word;  // no: its product has a spectral radius of at least bound^length everywhere in the cell
};

struct RadiusMap {
  std::vector<MapCell> cells;  // they cover the box and overlap in their borders only

  [[nodiscard]] Rational volume(Decision below) const;
};

struct RadiusMapOptions {
  int depth = 7;               // cells are halved in all directions at most so often
  std::size_t vertices = 120;  // of one polytope, up to sign
  int longest_word = 4;        // of the words tried
};

/// Where the joint spectral radius of T_0(x), T_1(x), .. is below the bound > 0: a tree of cells. The entries
/// are polynomials of degree at most 1 in each of x_0 .. x_{d-1}, d the dimension of the box
/// (std::domain_error otherwise).
///
/// yes: each T_i(x) is a convex combination of its values at the corners of the cell, and one polytope
/// contracts under all of these (corner_polytope.h): that settles all of the cell, and also products whose
/// factors come from different points of it. no: a condition (expanding_condition.h) holds on all of the
/// cell, in ball arithmetic.
[[nodiscard]] RadiusMap radius_map(const std::vector<Matrix<RationalFunction>>& family, const Rational& bound,
                                   const ParameterBox& box, const RadiusMapOptions& options = {});

/// Where a binary or ternary scheme is C^continuity in the sense of its differences: those of order
/// `continuity` of m^(k continuity) times the k-th refinement tend to zero. The symbol a(z) = m (sigma/m)^n
/// b(z) with the largest n that serves all parameters needs continuity <= n - 1 (std::domain_error); the
/// condition is rho(b) < m^(n-1-continuity).
[[nodiscard]] RadiusMap continuity_map(const Mask<RationalFunction>& mask, int continuity,
                                       const ParameterBox& box, const RadiusMapOptions& options = {});

}  // namespace subdiv
