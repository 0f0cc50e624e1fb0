#include "analysis/nonnegative_symbol.h"

#include <stdexcept>
#include <utility>

#include "analysis/joint_spectral_radius.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// b with symmetric indices -N/2 .. N/2.
Laurent<Rational> centred(const NormalForm<Rational>& form) { return shift(form.b, -form.degree() / 2); }

/// c_0 + 2 sum c_k T_k(x), T_k the Chebyshev polynomials.
UnivariatePolynomial in_cosine(const Laurent<Rational>& c) {
  const UnivariatePolynomial x({Rational(0), Rational(1)});
  UnivariatePolynomial previous(1);
  UnivariatePolynomial current = x;
  UnivariatePolynomial sum(c[0]);
  for (int k = 1; k <= c.last(); ++k) {
    sum += UnivariatePolynomial(Rational(2) * c[k]) * current;
    UnivariatePolynomial next = UnivariatePolynomial(2) * x * current - previous;
    previous = std::exchange(current, std::move(next));
  }
  return sum;
}

}  // namespace

bool is_nonnegative(const NormalForm<Rational>& form) {
  const Laurent<Rational> c = centred(form);
  if (form.degree() % 2 != 0 || c != reverse(c)) return false;
  const UnivariatePolynomial p = in_cosine(c);
  // p(1) = b(1) = 1: p can only become negative behind a root of odd multiplicity in (-1, 1).
  for (const auto& [part, multiplicity] : factor(p)) {
    if (multiplicity % 2 == 0) continue;
    const int at_end = part.evaluate(Rational(-1)).sign() == 0 ? 1 : 0;
    if (count_roots(part, Rational(-1), Rational(1)) > at_end) return false;
  }
  return true;
}

Enclosure nonnegative_radius(const NormalForm<Rational>& form) {
  if (!is_nonnegative(form)) throw std::domain_error("the symbol is not non-negative");
  const Laurent<Rational> c = centred(form);
  const int most = c.last() / (form.arity - 1);
  Matrix<Rational> matrix(2 * most + 1, 2 * most + 1);
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) matrix(i + most, j + most) = c[form.arity * i - j];
  }
  Enclosure result = joint_spectral_radius(std::vector{std::move(matrix)}).value;
  result.method = "largest eigenvalue of the matrix of central coefficients";
  return result;
}

}  // namespace subdiv
