#pragma once

#include <compare>
#include <string>
#include <vector>

#include "schemes/algebra/calcium.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// An exact real algebraic number: its minimal polynomial and an isolating enclosure; a value over Calcium's
/// qqbar. Equality and order are decided. Exact but slow: meant for small systems, not for inner loops.
class Algebraic {
 public:
  Algebraic() { qqbar_init(value_); }
  Algebraic(int n) : Algebraic() { qqbar_set_si(value_, n); }
  Algebraic(const Rational& q) : Algebraic() { qqbar_set_fmpq(value_, q.raw()); }

  Algebraic(const Algebraic& o) : Algebraic() { qqbar_set(value_, o.value_); }
  Algebraic(Algebraic&& o) noexcept : Algebraic() { qqbar_swap(value_, o.value_); }
  Algebraic& operator=(const Algebraic& o) {
    if (this != &o) qqbar_set(value_, o.value_);
    return *this;
  }
  Algebraic& operator=(Algebraic&& o) noexcept {
    qqbar_swap(value_, o.value_);
    return *this;
  }
  ~Algebraic() { qqbar_clear(value_); }

  Algebraic& operator+=(const Algebraic& o) {
    qqbar_add(value_, value_, o.value_);
    return *this;
  }
  Algebraic& operator-=(const Algebraic& o) {
    qqbar_sub(value_, value_, o.value_);
    return *this;
  }
  Algebraic& operator*=(const Algebraic& o) {
    qqbar_mul(value_, value_, o.value_);
    return *this;
  }
  /// Throws std::domain_error on division by zero.
  Algebraic& operator/=(const Algebraic& o);
  friend Algebraic operator+(Algebraic a, const Algebraic& b) { return a += b; }
  friend Algebraic operator-(Algebraic a, const Algebraic& b) { return a -= b; }
  friend Algebraic operator*(Algebraic a, const Algebraic& b) { return a *= b; }
  friend Algebraic operator/(Algebraic a, const Algebraic& b) { return a /= b; }
  friend Algebraic operator-(Algebraic a) {
    qqbar_neg(a.value_, a.value_);
    return a;
  }
  friend bool operator==(const Algebraic& a, const Algebraic& b) {
    return qqbar_equal(a.value_, b.value_) != 0;
  }
  friend std::strong_ordering operator<=>(const Algebraic& a, const Algebraic& b) {
    return qqbar_cmp_re(a.value_, b.value_) <=> 0;
  }

  [[nodiscard]] int sign() const { return qqbar_sgn_re(value_); }
  [[nodiscard]] bool is_zero() const { return degree() == 1 && fmpz_is_zero(value_->poly.coeffs) != 0; }
  [[nodiscard]] bool is_rational() const { return degree() == 1; }
  /// Throws std::domain_error when the number is irrational.
  [[nodiscard]] Rational to_rational() const;
  /// A ball around the number.
  [[nodiscard]] Interval to_interval(long precision = Interval::default_precision) const;
  /// Degree of the minimal polynomial.
  [[nodiscard]] long degree() const { return fmpz_poly_degree(&value_->poly); }
  /// Integer coefficients of the minimal polynomial, constant term first.
  [[nodiscard]] std::vector<Rational> minimal_polynomial() const;
  /// "5/8", "(1+3*sqrt(5))/4" for quadratics, else "root of 32*x^3 + 4*x - 1 near 0.1927".
  [[nodiscard]] std::string to_string() const;

  [[nodiscard]] const qqbar_struct* raw() const { return value_; }
  [[nodiscard]] qqbar_struct* raw() { return value_; }

 private:
  qqbar_t value_;
};

/// The square root of a number that is not negative (std::domain_error otherwise).
[[nodiscard]] Algebraic sqrt(const Algebraic& x);
/// The absolute value.
[[nodiscard]] Algebraic abs(const Algebraic& x);

template <>
struct RingTraits<Algebraic> {
  static constexpr bool exact = true;
  static Algebraic from_rational(const Rational& q) { return Algebraic(q); }
  static bool is_zero(const Algebraic& x) { return x.is_zero(); }
};

}  // namespace subdiv
