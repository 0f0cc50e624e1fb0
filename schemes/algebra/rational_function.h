#pragma once

#include <span>
#include <stdexcept>
#include <string>

#include "schemes/algebra/calcium.h"
#include "schemes/algebra/polynomial.h"

namespace subdiv {

/// A quotient of two polynomials over Q in x_0 .. x_7, in lowest terms: a value over Calcium's fmpz_mpoly_q.
/// Division by zero throws std::domain_error.
class RationalFunction {
 public:
  RationalFunction();
  /// A constant.
  RationalFunction(int n);
  /// A constant.
  RationalFunction(const Rational& q);
  /// A polynomial.
  RationalFunction(const Polynomial& p);
  /// The indeterminate x_i.
  static RationalFunction variable(int i);

  RationalFunction(const RationalFunction& o);
  RationalFunction(RationalFunction&& o) noexcept;
  RationalFunction& operator=(const RationalFunction& o);
  RationalFunction& operator=(RationalFunction&& o) noexcept;
  ~RationalFunction();

  RationalFunction& operator+=(const RationalFunction& o);
  RationalFunction& operator-=(const RationalFunction& o);
  RationalFunction& operator*=(const RationalFunction& o);
  RationalFunction& operator/=(const RationalFunction& o);
  friend RationalFunction operator+(RationalFunction a, const RationalFunction& b) { return a += b; }
  friend RationalFunction operator-(RationalFunction a, const RationalFunction& b) { return a -= b; }
  friend RationalFunction operator*(RationalFunction a, const RationalFunction& b) { return a *= b; }
  friend RationalFunction operator/(RationalFunction a, const RationalFunction& b) { return a /= b; }
  friend RationalFunction operator-(RationalFunction a) { return a *= RationalFunction(-1); }
  friend bool operator==(const RationalFunction& a, const RationalFunction& b);

  /// Whether it is 0.
  [[nodiscard]] bool is_zero() const;
  /// Whether no variable occurs.
  [[nodiscard]] bool is_constant() const;
  /// The constant's value; throws std::domain_error when the function is not constant.
  [[nodiscard]] Rational constant() const;
  /// Numerator and denominator have integer coefficients and no common factor.
  [[nodiscard]] Polynomial numerator() const;
  /// Not 0.
  [[nodiscard]] Polynomial denominator() const;
  /// The derivative with respect to one variable.
  [[nodiscard]] RationalFunction derivative(int variable) const;

  /// The value at a point of any field; a denominator that vanishes there throws std::domain_error when the
  /// field is exact.
  template <class R>
  [[nodiscard]] R evaluate(std::span<const R> values) const {
    R below = denominator().evaluate(values);
    if (RingTraits<R>::exact && subdiv::is_zero(below)) throw std::domain_error("division by zero");
    return numerator().evaluate(values) / below;
  }

  /// "(s^2 - s)/(12*s + 72)"; factored: "s*(s - 1)/(12*(s + 6))".
  [[nodiscard]] std::string to_string(std::span<const std::string> names = {}) const;
  /// With numerator and denominator factored.
  [[nodiscard]] std::string to_factored_string(std::span<const std::string> names = {}) const;

 private:
  fmpz_mpoly_q_t value_;
};

template <>
struct RingTraits<RationalFunction> {
  static constexpr bool exact = true;
  static RationalFunction from_rational(const Rational& q) { return RationalFunction(q); }
  static bool is_zero(const RationalFunction& f) { return f.is_zero(); }
};

}  // namespace subdiv
