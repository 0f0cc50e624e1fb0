#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <flint/fmpq_mpoly.h>

#include "schemes/algebra/rational.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// Polynomials over Q have at most this many indeterminates x_0 .. x_7. The first ones are the parameters of
/// a scheme in the order of their names; the last two serve as the symbol's z and a matrix's eigenvalue.
inline constexpr int max_parameters = 8;
inline constexpr int symbol_variable = 6;      ///< the z of a symbol
inline constexpr int eigenvalue_variable = 7;  ///< the indeterminate of a characteristic polynomial
/// Parameters that a scheme may leave free.
inline constexpr int max_free_parameters = 6;

/// A polynomial over Q in x_0 .. x_7: a value over FLINT's fmpq_mpoly.
class Polynomial {
 public:
  Polynomial();
  /// A constant.
  Polynomial(int n);
  /// A constant.
  Polynomial(const Rational& q);
  /// The indeterminate x_i, 0 <= i < max_parameters.
  static Polynomial variable(int i);

  Polynomial(const Polynomial& o);
  Polynomial(Polynomial&& o) noexcept;
  Polynomial& operator=(const Polynomial& o);
  Polynomial& operator=(Polynomial&& o) noexcept;
  ~Polynomial();

  Polynomial& operator+=(const Polynomial& o);
  Polynomial& operator-=(const Polynomial& o);
  Polynomial& operator*=(const Polynomial& o);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
  friend Polynomial operator*(Polynomial a, const Polynomial& b) { return a *= b; }
  friend Polynomial operator-(Polynomial a) { return a *= Polynomial(-1); }
  friend bool operator==(const Polynomial& a, const Polynomial& b);

  /// Whether it is 0.
  [[nodiscard]] bool is_zero() const;
  /// Whether no variable occurs.
  [[nodiscard]] bool is_constant() const;
  /// The constant's value; throws std::domain_error when the polynomial is not constant.
  [[nodiscard]] Rational constant() const;
  /// The degree in one variable; -1 for 0.
  [[nodiscard]] long degree(int variable) const;
  [[nodiscard]] bool uses(int variable) const { return degree(variable) > 0; }
  /// The derivative with respect to one variable.
  [[nodiscard]] Polynomial derivative(int variable) const;
  /// The coefficients, as polynomials in the other variables, of powers 0 .. degree of one variable.
  [[nodiscard]] std::vector<Polynomial> coefficients_in(int variable) const;
  /// x_i replaced by a polynomial.
  [[nodiscard]] Polynomial substitute(int variable, const Polynomial& by) const;

  /// The value at a point of any ring: values[i] stands for x_i; variables beyond the span must not occur
  /// (std::domain_error).
  template <class R>
  [[nodiscard]] R evaluate(std::span<const R> values) const;

  /// A monomial with its coefficient.
  struct Term {
    Rational coefficient;         ///< not 0
    std::vector<long> exponents;  ///< max_parameters of them
  };
  /// The terms in lexicographic order, highest first.
  [[nodiscard]] std::vector<Term> terms() const;

  /// names[i] is printed for x_i; missing names print as x0, x1, ..; "1/2*s^2 - 3*s + 1".
  [[nodiscard]] std::string to_string(std::span<const std::string> names = {}) const;

  [[nodiscard]] const fmpq_mpoly_struct* raw() const { return value_; }
  [[nodiscard]] fmpq_mpoly_struct* raw() { return value_; }
  /// FLINT's context, one for all polynomials.
  static const fmpq_mpoly_ctx_struct* context();

 private:
  fmpq_mpoly_t value_;
};

[[nodiscard]] Polynomial pow(const Polynomial& p, unsigned n);  ///< p^n.
/// a / b when b divides a: true and the quotient; false otherwise (also for b = 0).
[[nodiscard]] bool divides(const Polynomial& b, const Polynomial& a, Polynomial& quotient);
/// The monic greatest common divisor.
[[nodiscard]] Polynomial gcd(const Polynomial& a, const Polynomial& b);
/// Resultant with respect to one variable; throws std::domain_error when FLINT cannot compute it.
[[nodiscard]] Polynomial resultant(const Polynomial& a, const Polynomial& b, int variable);

/// A polynomial as a product.
struct Factorization {
  Rational constant;  ///< the factor without variables
  /// Irreducible over Q, with multiplicities.
  std::vector<std::pair<Polynomial, int>> factors;
};
/// Factorisation into irreducibles over Q; p must not be 0 (std::domain_error).
[[nodiscard]] Factorization factor(const Polynomial& p);
/// "(1/8)*(s - 2)*(s + 1)^2".
[[nodiscard]] std::string to_factored_string(const Polynomial& p, std::span<const std::string> names = {});

template <class R>
R Polynomial::evaluate(std::span<const R> values) const {
  R sum(0);
  for (const Term& term : terms()) {
    R product = from_rational<R>(term.coefficient);
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      if (i >= values.size()) throw std::domain_error("a polynomial's variable has no value");
      for (long k = 0; k < term.exponents[i]; ++k) product = product * values[i];
    }
    sum = sum + product;
  }
  return sum;
}

template <>
struct RingTraits<Polynomial> {
  static constexpr bool exact = true;
  static Polynomial from_rational(const Rational& q) { return Polynomial(q); }
  static bool is_zero(const Polynomial& p) { return p.is_zero(); }
};

}  // namespace subdiv
