#pragma once

#include <string>
#include <utility>
#include <vector>

#include <flint/fmpq_poly.h>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/polynomial.h"
#include "schemes/algebra/rational.h"

namespace subdiv {

/// A polynomial over Q in one variable: a value over FLINT's fmpq_poly, with the questions that only one
/// variable allows: exact real roots, sign changes, signs on an interval.
class UnivariatePolynomial {
 public:
  UnivariatePolynomial() { fmpq_poly_init(value_); }
  /// A constant.
  UnivariatePolynomial(int n) : UnivariatePolynomial(Rational(n)) {}
  UnivariatePolynomial(const Rational& q) : UnivariatePolynomial() { fmpq_poly_set_fmpq(value_, q.raw()); }
  /// Coefficients of x^0, x^1, ...
  explicit UnivariatePolynomial(const std::vector<Rational>& coefficients);
  /// A polynomial that uses no variable but the given one; std::domain_error otherwise.
  UnivariatePolynomial(const Polynomial& p, int variable);

  UnivariatePolynomial(const UnivariatePolynomial& o) : UnivariatePolynomial() {
    fmpq_poly_set(value_, o.value_);
  }
  UnivariatePolynomial(UnivariatePolynomial&& o) noexcept : UnivariatePolynomial() {
    fmpq_poly_swap(value_, o.value_);
  }
  UnivariatePolynomial& operator=(const UnivariatePolynomial& o) {
    fmpq_poly_set(value_, o.value_);
    return *this;
  }
  UnivariatePolynomial& operator=(UnivariatePolynomial&& o) noexcept {
    fmpq_poly_swap(value_, o.value_);
    return *this;
  }
  ~UnivariatePolynomial() { fmpq_poly_clear(value_); }

  UnivariatePolynomial& operator+=(const UnivariatePolynomial& o) {
    fmpq_poly_add(value_, value_, o.value_);
    return *this;
  }
  UnivariatePolynomial& operator-=(const UnivariatePolynomial& o) {
    fmpq_poly_sub(value_, value_, o.value_);
    return *this;
  }
  UnivariatePolynomial& operator*=(const UnivariatePolynomial& o) {
    fmpq_poly_mul(value_, value_, o.value_);
    return *this;
  }
  friend UnivariatePolynomial operator+(UnivariatePolynomial a, const UnivariatePolynomial& b) {
    return a += b;
  }
  friend UnivariatePolynomial operator-(UnivariatePolynomial a, const UnivariatePolynomial& b) {
    return a -= b;
  }
  friend UnivariatePolynomial operator*(UnivariatePolynomial a, const UnivariatePolynomial& b) {
    return a *= b;
  }
  friend UnivariatePolynomial operator-(UnivariatePolynomial a) {
    fmpq_poly_neg(a.value_, a.value_);
    return a;
  }
  friend bool operator==(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
    return fmpq_poly_equal(a.value_, b.value_) != 0;
  }

  [[nodiscard]] bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  /// -1 for the zero polynomial.
  [[nodiscard]] long degree() const { return fmpq_poly_degree(value_); }
  /// Of x^i; 0 beyond the degree.
  [[nodiscard]] Rational coefficient(long i) const;
  /// The derivative.
  [[nodiscard]] UnivariatePolynomial derivative() const;
  /// The exact value.
  [[nodiscard]] Rational evaluate(const Rational& x) const;
  /// Encloses the values at all points of x.
  [[nodiscard]] Interval evaluate(const Interval& x) const;
  /// With a name for the variable: "1/2*s^2 - 3*s + 1".
  [[nodiscard]] std::string to_string(const std::string& name) const;

  [[nodiscard]] const fmpq_poly_struct* raw() const { return value_; }
  [[nodiscard]] fmpq_poly_struct* raw() { return value_; }

 private:
  fmpq_poly_t value_;
};

/// The monic greatest common divisor; 0 when both are 0.
[[nodiscard]] UnivariatePolynomial gcd(const UnivariatePolynomial& a, const UnivariatePolynomial& b);
/// Quotient and remainder; division by zero throws std::domain_error.
[[nodiscard]] std::pair<UnivariatePolynomial, UnivariatePolynomial> divide(const UnivariatePolynomial& a,
                                                                           const UnivariatePolynomial& b);
/// Irreducible factors over Q with multiplicities, constants left out; p not zero.
[[nodiscard]] std::vector<std::pair<UnivariatePolynomial, int>> factor(const UnivariatePolynomial& p);

/// A real root.
struct RealRoot {
  Algebraic value;   ///< the root
  int multiplicity;  ///< at least 1
};
/// All real roots, ascending, exact; p not zero.
[[nodiscard]] std::vector<RealRoot> real_roots(const UnivariatePolynomial& p);
/// The number of distinct real roots in the closed interval [lower, upper], by Sturm's theorem.
[[nodiscard]] int count_roots(const UnivariatePolynomial& p, const Rational& lower, const Rational& upper);
/// Enclosures of all complex roots with multiplicity: (real part, imaginary part) at the given precision;
/// exactly real roots have the imaginary part exactly 0.
struct ComplexRoot {
  Interval real;       ///< the real part
  Interval imaginary;  ///< the imaginary part
  int multiplicity;    ///< at least 1
};
/// All of them.
[[nodiscard]] std::vector<ComplexRoot> complex_roots(const UnivariatePolynomial& p,
                                                     long precision = Interval::default_precision);

template <>
struct RingTraits<UnivariatePolynomial> {
  static constexpr bool exact = true;
  static UnivariatePolynomial from_rational(const Rational& q) { return UnivariatePolynomial(q); }
  static bool is_zero(const UnivariatePolynomial& p) { return p.is_zero(); }
};

}  // namespace subdiv
