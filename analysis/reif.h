#pragma once

#include <vector>

#include "analysis/real_set.h"
#include "analysis/subdivision_matrix.h"
#include "schemes/algebra/field_polynomial.h"

namespace subdiv {

/// Reif's necessary condition for C^k limits of a stationary scheme of arity m, at the parameter 0 (Reif
/// 1995; js-report 3): the eigenvalues of the subdivision matrix, with multiplicities, are 1, m^-1, .., m^-k
/// and others of modulus strictly below m^-k. Everything is decided exactly, by division of the
/// characteristic polynomial and Schur's recursion.

/// The condition for a monic characteristic polynomial.
template <OrderedField F>
bool satisfies_reif(FieldPolynomial<F> characteristic, int arity, int order) {
  Rational power(1);
  for (int k = 0; k <= order; ++k) {
    auto [rest, value] = divide(characteristic, FieldPolynomial<F>({F(-power), F(1)}));
    if (!value.is_zero()) return false;
    characteristic = std::move(rest);
    if (k < order) power /= Rational(arity);
  }
  return roots_inside(characteristic, F(power));
}

/// The largest k for which the condition holds; -1 when it fails for C^0. The condition for k implies that
/// for k - 1.
template <OrderedField F>
int reif_order(const Mask<F>& mask) {
  const FieldPolynomial<F> characteristic(characteristic_polynomial(subdivision_matrix(mask)));
  int order = -1;
  while (satisfies_reif(characteristic, mask.arity, order + 1)) ++order;
  return order;
}

/// The exact set of all real values of parameter x_i for which the condition for C^order holds. The mask uses
/// no other parameter (std::domain_error); poles of its coefficients do not belong to the set.
[[nodiscard]] RealSet reif_set(const Mask<RationalFunction>& mask, int order, int parameter = 0);

}  // namespace subdiv
