#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

#include <flint/fmpq.h>

namespace subdiv {

/// An exact rational number p/q in lowest terms, q > 0: a value over FLINT's fmpq. Division by zero throws
/// std::domain_error. Moved-from values may only be assigned to or destroyed.
class Rational {
 public:
  Rational() { fmpq_init(value_); }
  /// A whole number.
  Rational(int n) : Rational(static_cast<std::int64_t>(n)) {}
  /// A whole number.
  Rational(std::int64_t n) {
    fmpq_init(value_);
    fmpq_set_si(value_, n, 1);
  }
  /// p/q; throws std::domain_error when q is 0.
  Rational(std::int64_t p, std::int64_t q);
  /// The exact value of a finite double; throws std::domain_error otherwise.
  static Rational from_double(double x);
  /// "-33/26", "7" or a decimal "0.46415", "-1.5e-3": always the exact value. Throws std::invalid_argument.
  static Rational parse(std::string_view text);
  /// 2^exponent, any sign of the exponent.
  static Rational power_of_two(long exponent);

  Rational(const Rational& o) {
    fmpq_init(value_);
    fmpq_set(value_, o.value_);
  }
  Rational(Rational&& o) noexcept {
    fmpq_init(value_);
    fmpq_swap(value_, o.value_);
  }
  Rational& operator=(const Rational& o) {
    fmpq_set(value_, o.value_);
    return *this;
  }
  Rational& operator=(Rational&& o) noexcept {
    fmpq_swap(value_, o.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  Rational& operator+=(const Rational& o) {
    fmpq_add(value_, value_, o.value_);
    return *this;
  }
  Rational& operator-=(const Rational& o) {
    fmpq_sub(value_, value_, o.value_);
    return *this;
  }
  Rational& operator*=(const Rational& o) {
    fmpq_mul(value_, value_, o.value_);
    return *this;
  }
  Rational& operator/=(const Rational& o);

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(Rational a) {
    fmpq_neg(a.value_, a.value_);
    return a;
  }
  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.value_, b.value_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.value_, b.value_) <=> 0;
  }

  [[nodiscard]] int sign() const { return fmpq_sgn(value_); }
  [[nodiscard]] bool is_integer() const { return fmpz_is_one(fmpq_denref(value_)) != 0; }
  /// The nearest double is not promised: the result is within one unit in the last place.
  [[nodiscard]] double to_double() const { return fmpq_get_d(value_); }
  /// The value as a 64-bit integer; throws std::domain_error when it is none.
  [[nodiscard]] std::int64_t to_integer() const;
  /// "p/q", or "p" for integers.
  [[nodiscard]] std::string to_string() const;

  [[nodiscard]] const fmpq* raw() const { return value_; }
  [[nodiscard]] fmpq* raw() { return value_; }

 private:
  fmpq_t value_;
};

/// The absolute value.
[[nodiscard]] Rational abs(Rational x);
/// x^n for any integer n; throws std::domain_error for 0 to a negative power.
[[nodiscard]] Rational pow(const Rational& x, long n);
/// The largest integer not above x.
[[nodiscard]] Rational floor(const Rational& x);
/// The simplest fraction (smallest denominator) in the closed interval [lower, upper].
[[nodiscard]] Rational simplest_between(const Rational& lower, const Rational& upper);

/// x rounded to `digits` decimals after the point, "-0.46415"; direction -1 down, 0 nearest (ties away from
/// zero), +1 up. The result is exact: plain decimal notation without exponent.
[[nodiscard]] std::string to_decimal(const Rational& x, int digits, int direction = 0);
/// x rounded to `digits` significant digits in decimal notation; numbers below 1e-6 get an exponent.
[[nodiscard]] std::string to_significant(const Rational& x, int digits, int direction = 0);

}  // namespace subdiv
