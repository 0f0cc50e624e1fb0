#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// The arrays DEN and NUM[0] .. NUM[4] of Karciauskas & Peters, Adjustable speed surface subdivision (2009),
/// appendix V-B, as printed: 15 rows i = 1 .. 15 of two lists of coefficients, [i][1][j] and [i][2][j].
using PrintedArray = std::vector<std::array<std::vector<int>, 2>>;
[[nodiscard]] const PrintedArray& printed_denominator();
[[nodiscard]] const std::array<PrintedArray, 5>& printed_numerators();

/// Sum over i of row_factor^(i-1) (sum over j of [i][1][j] c^(j-1) + lambda sum over j of [i][2][j] c^(j-1)),
/// by Horner's rule. (12) prints no factor of the rows: row_factor = 1.
template <class R>
R array_sum(const PrintedArray& rows, const R& row_factor, const R& c, const R& lambda) {
  const auto in_cosine = [&](const std::vector<int>& coefficients) {
    R sum(0);
    for (std::size_t j = coefficients.size(); j > 0; --j) sum = sum * c + R(coefficients[j - 1]);
    return sum;
  };
  R sum(0);
  for (std::size_t i = rows.size(); i > 0; --i)
    sum = sum * row_factor + (in_cosine(rows[i - 1][0]) + lambda * in_cosine(rows[i - 1][1]));
  return sum;
}

/// h_0 .. h_4 of (12), of which z_0 = h_0/(2 cos(pi/n)), z_1 = h_1 sin(pi/n), z_2 and z_3 like z_0, z_4 like
/// z_1.
template <class R>
std::array<R, 5> array_quotients(const R& row_factor, const R& c, const R& lambda) {
  const R below = array_sum(printed_denominator(), row_factor, c, lambda);
  std::array<R, 5> result;
  for (std::size_t r = 0; r < result.size(); ++r)
    result[r] = array_sum(printed_numerators()[r], row_factor, c, lambda) / below;
  return result;
}

}  // namespace subdiv
