#pragma once

#include <memory>
#include <stdexcept>
#include <utility>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/matrix.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {

/// Q(x) for a real algebraic number x, given with its minimal polynomial.
struct NumberField {
  /// Q(x).
  explicit NumberField(Algebraic x)
      : generator(std::move(x)), modulus(UnivariatePolynomial(generator.minimal_polynomial())) {}

  Algebraic generator;           ///< x
  UnivariatePolynomial modulus;  ///< the minimal polynomial of x
};

/// An element of a number field as a polynomial in the generator, reduced: sums, products, quotients,
/// equality and signs are exact, and far cheaper than those of Algebraic, which computes a minimal polynomial
/// for each. Elements of different fields must not meet; rational numbers belong to all.
class FieldElement {
 public:
  FieldElement() = default;
  /// A whole number.
  FieldElement(int n) : value_(n) {}
  /// A rational number, in every field.
  FieldElement(const Rational& q) : value_(q) {}
  /// The element x of Q(x).
  static FieldElement generator(std::shared_ptr<const NumberField> field) {
    return FieldElement(UnivariatePolynomial({Rational(0), Rational(1)}), std::move(field));
  }

  friend FieldElement operator+(const FieldElement& a, const FieldElement& b) {
    return FieldElement(a.value_ + b.value_, common(a, b));
  }
  friend FieldElement operator-(const FieldElement& a, const FieldElement& b) {
    return FieldElement(a.value_ - b.value_, common(a, b));
  }
  friend FieldElement operator*(const FieldElement& a, const FieldElement& b) {
    return FieldElement(a.value_ * b.value_, common(a, b));
  }
  /// Throws std::domain_error on division by zero.
  friend FieldElement operator/(const FieldElement& a, const FieldElement& b) { return a * b.inverse(); }
  friend FieldElement operator-(const FieldElement& a) { return FieldElement(-a.value_, a.field_); }
  FieldElement& operator+=(const FieldElement& b) { return *this = *this + b; }
  FieldElement& operator-=(const FieldElement& b) { return *this = *this - b; }
  FieldElement& operator*=(const FieldElement& b) { return *this = *this * b; }
  FieldElement& operator/=(const FieldElement& b) { return *this = *this / b; }
  friend bool operator==(const FieldElement& a, const FieldElement& b) { return a.value_ == b.value_; }

  [[nodiscard]] bool is_zero() const { return value_.is_zero(); }
  [[nodiscard]] int sign() const;  ///< -1, 0 or 1, decided.

 private:
  FieldElement(UnivariatePolynomial value, std::shared_ptr<const NumberField> field);
  static std::shared_ptr<const NumberField> common(const FieldElement& a, const FieldElement& b) {
    return a.field_ ? a.field_ : b.field_;
  }
  [[nodiscard]] FieldElement inverse() const;

  UnivariatePolynomial value_;
  std::shared_ptr<const NumberField> field_;  // none for rational constants
};

[[nodiscard]] inline FieldElement abs(const FieldElement& x) { return x.sign() < 0 ? -x : x; }

template <>
struct RingTraits<FieldElement> {
  static constexpr bool exact = true;
  static FieldElement from_rational(const Rational& q) { return FieldElement(q); }
  static bool is_zero(const FieldElement& x) { return x.is_zero(); }
};

}  // namespace subdiv

namespace Eigen {
template <>
struct NumTraits<subdiv::FieldElement> : subdiv::detail::RingNumTraits<subdiv::FieldElement> {};
}  // namespace Eigen
