#pragma once

// Stands in for the header of the same name where there is no FLINT, in the browser: this folder comes before
// the source tree's root among the include folders. The same class over Boost's cpp_rational, as far as the
// curve of the explorer needs it; what both have means the same.

#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

namespace subdiv {

/// An exact rational number p/q in lowest terms, q > 0. Division by zero throws std::domain_error.
class Rational {
 public:
  using Value = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                              boost::multiprecision::et_off>;
  using Integer = boost::multiprecision::cpp_int;

  Rational() = default;
  template <std::signed_integral Whole>
  Rational(Whole n) : value_(static_cast<std::int64_t>(n)) {}
  Rational(std::int64_t p, std::int64_t q) : Rational(Rational(p) / Rational(q)) {}
  explicit Rational(Value value) : value_(std::move(value)) {}

  static Rational from_double(double x) {
    if (!std::isfinite(x)) throw std::domain_error("not a finite number");
    int exponent = 0;
    constexpr int digits = 53;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), digits));
    return Rational(mantissa) * power_of_two(exponent - digits);
  }

  static Rational power_of_two(long exponent) {
    const Integer power = Integer(1) << static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
    return Rational(exponent < 0 ? Value(1) / Value(power) : Value(power));
  }

  /// "-33/26", "7" or a decimal "0.46415", "-1.5e-3". Throws std::invalid_argument.
  static Rational parse(std::string_view text) {
    const std::string whole(text);
    const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    const auto slash = text.find('/');
    Rational value = decimal(text.substr(0, slash), whole);
    if (slash != std::string_view::npos) {
      const Rational denominator(Value(integer(text.substr(slash + 1), whole)));
      if (denominator.sign() == 0) throw std::invalid_argument("'" + whole + "' divides by zero");
      value /= denominator;
    }
    return negative ? -value : value;
  }

  Rational& operator+=(const Rational& o) {
    value_ += o.value_;
    return *this;
  }
  Rational& operator-=(const Rational& o) {
    value_ -= o.value_;
    return *this;
  }
  Rational& operator*=(const Rational& o) {
    value_ *= o.value_;
    return *this;
  }
  Rational& operator/=(const Rational& o) {
    if (o.sign() == 0) throw std::domain_error("division by zero");
    value_ /= o.value_;
    return *this;
  }

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(const Rational& a) { return Rational(Value(-a.value_)); }
  friend bool operator==(const Rational& a, const Rational& b) { return a.value_ == b.value_; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return a.value_.compare(b.value_) <=> 0;
  }

  [[nodiscard]] int sign() const { return value_.sign(); }
  [[nodiscard]] Integer numerator() const { return boost::multiprecision::numerator(value_); }
  [[nodiscard]] Integer denominator() const { return boost::multiprecision::denominator(value_); }
  [[nodiscard]] bool is_integer() const { return denominator() == 1; }
  /// Within one unit in the last place.
  [[nodiscard]] double to_double() const { return value_.convert_to<double>(); }
  [[nodiscard]] std::string to_string() const {
    return is_integer() ? numerator().str() : numerator().str() + "/" + denominator().str();
  }

 private:
  static Integer integer(std::string_view digits, const std::string& whole) {
    constexpr std::size_t most = 1000;
    if (digits.empty() || digits.size() > most ||
        digits.find_first_not_of("0123456789") != std::string_view::npos)
      throw std::invalid_argument("'" + whole + "' is not a number");
    const std::size_t first = digits.find_first_not_of('0');  // a leading 0 would mean octal
    return first == std::string_view::npos ? Integer(0) : Integer(std::string(digits.substr(first)));
  }

  static Rational decimal(std::string_view text, const std::string& whole) {
    long exponent = 0;
    if (const auto e = text.find_first_of("eE"); e != std::string_view::npos) {
      std::string_view power = text.substr(e + 1);
      const bool negative = power.starts_with('-');
      if (negative || power.starts_with('+')) power.remove_prefix(1);
      constexpr int most = 1000;
      const Integer size = integer(power, whole);
      if (size > most) throw std::invalid_argument("'" + whole + "' has too large an exponent");
      exponent = negative ? -size.convert_to<long>() : size.convert_to<long>();
      text = text.substr(0, e);
    }
    std::string digits(text);
    if (const auto point = digits.find('.'); point != std::string::npos) {
      exponent -= static_cast<long>(digits.size() - point - 1);
      digits.erase(point, 1);
    }
    const Integer ten =
        boost::multiprecision::pow(Integer(10), static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
    const Rational value(Value(integer(digits, whole)));
    return exponent < 0 ? value / Rational(Value(ten)) : value * Rational(Value(ten));
  }

  Value value_;
};

/// The absolute value.
[[nodiscard]] inline Rational abs(Rational x) { return x.sign() < 0 ? -x : x; }

/// x^n for any integer n; throws std::domain_error for 0 to a negative power.
[[nodiscard]] inline Rational pow(const Rational& x, long n) {
  Rational result(1);
  for (long i = 0; i < (n < 0 ? -n : n); ++i) result *= x;
  return n < 0 ? Rational(1) / result : result;
}

/// The largest integer not above x.
[[nodiscard]] inline Rational floor(const Rational& x) {
  Rational::Integer quotient = x.numerator() / x.denominator();  // towards 0
  if (x.sign() < 0 && !x.is_integer()) --quotient;
  return Rational(Rational::Value(quotient));
}

}  // namespace subdiv
