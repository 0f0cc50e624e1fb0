#pragma once

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// An exact field with decided signs: Rational, Algebraic.
template <class F>
concept OrderedField = ExactRing<F> && requires(const F& x) {
  { x.sign() } -> std::convertible_to<int>;
};

/// A polynomial in one variable over an exact field F: coefficients of x^0, x^1, ..; the last is not zero.
/// Over Q alone, UnivariatePolynomial is faster and can factor; this one also serves algebraic coefficients.
template <ExactRing F>
class FieldPolynomial {
 public:
  FieldPolynomial() = default;
  /// Coefficients of x^0, x^1, ..; zeros at the end are dropped.
  explicit FieldPolynomial(std::vector<F> coefficients) : coefficients_(std::move(coefficients)) {
    while (!coefficients_.empty() && subdiv::is_zero(coefficients_.back())) coefficients_.pop_back();
  }

  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  /// -1 for the zero polynomial.
  [[nodiscard]] long degree() const { return static_cast<long>(coefficients_.size()) - 1; }
  [[nodiscard]] const std::vector<F>& coefficients() const { return coefficients_; }
  [[nodiscard]] const F& leading() const { return coefficients_.back(); }
  /// The value at x, by Horner's rule.
  [[nodiscard]] F evaluate(const F& x) const {
    F value(0);
    for (std::size_t i = coefficients_.size(); i-- > 0;) value = value * x + coefficients_[i];
    return value;
  }
  /// The derivative.
  [[nodiscard]] FieldPolynomial derivative() const {
    std::vector<F> result;
    for (std::size_t i = 1; i < coefficients_.size(); ++i)
      result.push_back(F(static_cast<int>(i)) * coefficients_[i]);
    return FieldPolynomial(std::move(result));
  }
  friend bool operator==(const FieldPolynomial&, const FieldPolynomial&) = default;
  friend FieldPolynomial operator-(FieldPolynomial p) {
    for (F& c : p.coefficients_) c = F(0) - c;
    return p;
  }

 private:
  std::vector<F> coefficients_;
};

/// Quotient and remainder; division by zero throws std::domain_error.
template <ExactRing F>
std::pair<FieldPolynomial<F>, FieldPolynomial<F>> divide(const FieldPolynomial<F>& a,
                                                         const FieldPolynomial<F>& b) {
  if (b.is_zero()) throw std::domain_error("division by zero");
  std::vector<F> rest = a.coefficients();
  const std::size_t length = b.coefficients().size();
  std::vector<F> quotient(rest.size() >= length ? rest.size() - length + 1 : 0, F(0));
  for (std::size_t i = quotient.size(); i-- > 0;) {
    quotient[i] = rest[i + length - 1] / b.leading();
    for (std::size_t j = 0; j < length; ++j) rest[i + j] = rest[i + j] - quotient[i] * b.coefficients()[j];
  }
  return {FieldPolynomial<F>(std::move(quotient)), FieldPolynomial<F>(std::move(rest))};
}

/// The greatest common divisor with leading coefficient 1; zero for two zeros.
template <ExactRing F>
FieldPolynomial<F> gcd(FieldPolynomial<F> a, FieldPolynomial<F> b) {
  while (!b.is_zero()) {
    FieldPolynomial<F> rest = divide(a, b).second;
    a = std::exchange(b, std::move(rest));
  }
  return a.is_zero() ? a : divide(a, FieldPolynomial<F>({a.leading()})).first;
}

/// Square-free factors of positive degree with their multiplicities, pairwise coprime; p is not zero.
template <ExactRing F>
std::vector<std::pair<FieldPolynomial<F>, int>> square_free_factors(const FieldPolynomial<F>& p) {
  std::vector<std::pair<FieldPolynomial<F>, int>> result;
  FieldPolynomial<F> repeated = gcd(p, p.derivative());
  FieldPolynomial<F> roots = divide(p, repeated).first;  // every root of p once
  for (int multiplicity = 1; roots.degree() > 0; ++multiplicity) {
    FieldPolynomial<F> more = gcd(roots, repeated);  // roots of a higher multiplicity
    FieldPolynomial<F> exact = divide(roots, more).first;
    if (exact.degree() > 0) result.emplace_back(std::move(exact), multiplicity);
    repeated = divide(repeated, more).first;
    roots = std::move(more);
  }
  return result;
}

namespace detail {
template <OrderedField F>
int sign_changes(const std::vector<FieldPolynomial<F>>& chain, const F& x) {
  int changes = 0;
  int last = 0;
  for (const FieldPolynomial<F>& p : chain) {
    const int sign = p.evaluate(x).sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}
}  // namespace detail

/// The number of distinct real roots in the closed interval [lower, upper], by Sturm's theorem; p is not zero
/// (std::domain_error).
template <OrderedField F>
int count_roots(const FieldPolynomial<F>& p, const F& lower, const F& upper) {
  if (p.is_zero()) throw std::domain_error("the zero polynomial has every number as a root");
  std::vector<FieldPolynomial<F>> chain{divide(p, gcd(p, p.derivative())).first};
  chain.push_back(chain[0].derivative());
  while (!chain.back().is_zero()) chain.push_back(-divide(chain[chain.size() - 2], chain.back()).second);
  const int at_lower = chain[0].evaluate(lower).sign() == 0 ? 1 : 0;
  return detail::sign_changes(chain, lower) - detail::sign_changes(chain, upper) + at_lower;
}

/// Whether all complex roots have a modulus strictly below the radius > 0: Schur's recursion. p of degree n
/// has all roots in the open unit disc exactly when |p_0| < |p_n| and (p_n p(x) - p_0 x^n p(1/x)) / x has
/// (Henrici, Applied and Computational Complex Analysis 1, theorem 6.8b). p is not zero (std::domain_error).
template <OrderedField F>
bool roots_inside(const FieldPolynomial<F>& p, const F& radius) {
  if (p.is_zero()) throw std::domain_error("the zero polynomial has every number as a root");
  std::vector<F> c = p.coefficients();
  F power(1);
  for (F& x : c) {
    x = x * power;
    power = power * radius;
  }
  while (c.size() > 1) {
    const F ratio = c.front() / c.back();
    if (!((F(1) - ratio * ratio).sign() > 0)) return false;
    std::vector<F> next;
    for (std::size_t i = 1; i < c.size(); ++i) next.push_back(c[i] - ratio * c[c.size() - 1 - i]);
    c = std::move(next);
  }
  return true;
}

}  // namespace subdiv
