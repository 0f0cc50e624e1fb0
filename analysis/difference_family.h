#pragma once

#include <vector>

#include "schemes/algebra/laurent.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/algebra/univariate.h"
#include "schemes/mask.h"

namespace subdiv {

/// The difference symbols of a one-parameter family of schemes: d(z) with coefficients in Q[s] (see
/// iterate_norm.h).
struct DifferenceFamily {
  int arity = 2;                         ///< m, 2 or 3
  Laurent<UnivariatePolynomial> symbol;  ///< d(z), coefficients polynomials in s
};

/// m^c a(z) / (1 + .. + z^(m-1))^(c+1) for a mask whose only parameter is s = x_0. Throws std::domain_error
/// when the division is not exact for all s, or when a coefficient is no polynomial in x_0 alone.
[[nodiscard]] DifferenceFamily difference_family(const Mask<RationalFunction>& mask, int continuity);

/// The family of -s.
[[nodiscard]] DifferenceFamily reflected(const DifferenceFamily& family);

/// One residue class of an iterate, by the digits e_1 .. e_k of its residue e_1 + m e_2 + ..
using ClassWord = std::vector<int>;

/// The coefficients (D_k)_{r + m^k l}, 0 <= l < n, of one class as polynomials in s.
[[nodiscard]] std::vector<UnivariatePolynomial> class_polynomials(const DifferenceFamily& family,
                                                                  const ClassWord& word);

/// sum over l of |(D_k)_{r + m^k l}| at a value of s: a lower bound of norm_k there.
[[nodiscard]] Rational class_norm(const DifferenceFamily& family, const ClassWord& word, const Rational& s);

/// The values of s, ascending, at which the division above is exact; for families where it is so for single
/// values only. Throws std::domain_error when it is exact for all s.
[[nodiscard]] std::vector<Algebraic> divisible_parameters(const Mask<RationalFunction>& mask, int continuity);

}  // namespace subdiv
