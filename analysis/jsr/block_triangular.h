#pragma once

#include <vector>

#include "schemes/algebra/matrix.h"

namespace subdiv {

/// The diagonal blocks of a family in a basis in which all its matrices are block triangular at once: by
/// restriction to common invariant subspaces and their quotients. The joint spectral radius of the family is
/// the largest of the blocks'. Subspaces are looked for as in the Meataxe (Holt & Rees 1994): null vectors of
/// factors of characteristic polynomials of a few elements of the algebra, and of their transposes, are spun
/// under the family, in exact arithmetic. Where Norton's criterion proves a block irreducible over Q the
/// search ends; it may leave a reducible block undivided.
[[nodiscard]] std::vector<std::vector<Matrix<Rational>>> diagonal_blocks(
    const std::vector<Matrix<Rational>>& family);

/// The same by permutations of the coordinates alone, from the pattern of entries that are exactly zero.
[[nodiscard]] std::vector<std::vector<Matrix<Interval>>> diagonal_blocks(
    const std::vector<Matrix<Interval>>& family);
[[nodiscard]] std::vector<std::vector<Matrix<Algebraic>>> diagonal_blocks(
    const std::vector<Matrix<Algebraic>>& family);

}  // namespace subdiv
