#include "schemes/algebra/rational.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <flint/fmpz.h>

namespace subdiv {
namespace {

/// The digits of an integer held as a rational.
std::string integer_string(const fmpz* n) {
  char* raw = fmpz_get_str(nullptr, 10, n);
  std::string text(raw);
  flint_free(raw);
  return text;
}

/// x times 10^digits, rounded to an integer in the given direction.
Rational scaled_integer(const Rational& x, long digits, int direction) {
  const Rational scaled = x * pow(Rational(10), digits);
  if (direction < 0) return floor(scaled);
  if (direction > 0) return -floor(-scaled);
  const Rational half(1, 2);
  return x.sign() >= 0 ? floor(scaled + half) : -floor(half - scaled);
}

/// The integer n shown with its last `digits` digits behind a decimal point.
std::string with_point(const Rational& n, long digits) {
  std::string text = abs(n).to_string();
  if (digits > 0) {
    const auto places = static_cast<std::size_t>(digits);
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, ".");
  } else {
    text.append(static_cast<std::size_t>(-digits), '0');
  }
  return n.sign() < 0 ? "-" + text : text;
}

[[noreturn]] void reject_number(std::string_view text) {
  throw std::invalid_argument("'" + std::string(text) +
                              "' is not a number: expected an integer, a fraction p/q or a decimal");
}

Rational parse_integer(std::string_view digits, std::string_view whole) {
  std::string buffer(digits);
  if (buffer.empty() || buffer.find_first_not_of("0123456789") != std::string::npos) reject_number(whole);
  Rational result;
  fmpz_set_str(fmpq_numref(result.raw()), buffer.c_str(), 10);
  return result;
}

Rational parse_unsigned_decimal(std::string_view text, std::string_view whole) {
  constexpr long largest_exponent = 10000;
  long exponent = 0;
  if (const auto e = text.find_first_of("eE"); e != std::string_view::npos) {
    std::string_view tail = text.substr(e + 1);
    const bool negative = tail.starts_with('-');
    if (negative || tail.starts_with('+')) tail.remove_prefix(1);
    const Rational value = parse_integer(tail, whole);
    if (value > Rational(largest_exponent)) reject_number(whole);
    exponent = static_cast<long>(value.to_integer()) * (negative ? -1 : 1);
    text = text.substr(0, e);
  }
  const auto point = text.find('.');
  if (point == std::string_view::npos) return parse_integer(text, whole) * pow(Rational(10), exponent);
  const std::string digits = std::string(text.substr(0, point)) + std::string(text.substr(point + 1));
  const auto decimals = static_cast<long>(text.size() - point - 1);
  return parse_integer(digits, whole) * pow(Rational(10), exponent - decimals);
}

}  // namespace

Rational::Rational(std::int64_t p, std::int64_t q) {
  if (q == 0) throw std::domain_error("division by zero");
  fmpq_init(value_);
  fmpz_set_si(fmpq_numref(value_), p);
  fmpz_set_si(fmpq_denref(value_), q);
  fmpq_canonicalise(value_);
}

Rational Rational::from_double(double x) {
  if (!std::isfinite(x)) throw std::domain_error("not a finite number");
  int exponent = 0;
  constexpr int mantissa_bits = 53;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), mantissa_bits);
  return Rational(static_cast<std::int64_t>(mantissa)) * power_of_two(exponent - mantissa_bits);
}

Rational Rational::power_of_two(long exponent) {
  Rational result(1);
  if (exponent >= 0) {
    fmpq_mul_2exp(result.value_, result.value_, static_cast<mp_bitcnt_t>(exponent));
  } else {
    fmpq_div_2exp(result.value_, result.value_, static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

Rational Rational::parse(std::string_view text) {
  const std::string_view whole = text;
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const auto slash = text.find('/');
  Rational value = parse_unsigned_decimal(text.substr(0, slash), whole);
  if (slash != std::string_view::npos) {
    const Rational denominator = parse_integer(text.substr(slash + 1), whole);
    if (denominator.sign() == 0) throw std::invalid_argument("'" + std::string(whole) + "' divides by zero");
    value /= denominator;
  }
  return negative ? -value : value;
}

Rational& Rational::operator/=(const Rational& o) {
  if (o.sign() == 0) throw std::domain_error("division by zero");
  fmpq_div(value_, value_, o.value_);
  return *this;
}

std::int64_t Rational::to_integer() const {
  if (!is_integer() || fmpz_fits_si(fmpq_numref(value_)) == 0) {
    throw std::domain_error(to_string() + " is not a 64-bit integer");
  }
  return fmpz_get_si(fmpq_numref(value_));
}

std::string Rational::to_string() const {
  const std::string numerator = integer_string(fmpq_numref(value_));
  return is_integer() ? numerator : numerator + "/" + integer_string(fmpq_denref(value_));
}

Rational abs(Rational x) {
  fmpq_abs(x.raw(), x.raw());
  return x;
}

Rational pow(const Rational& x, long n) {
  if (n < 0 && x.sign() == 0) throw std::domain_error("division by zero");
  Rational result;
  fmpq_pow_si(result.raw(), x.raw(), n);
  return result;
}

Rational floor(const Rational& x) {
  Rational result;
  fmpz_fdiv_q(fmpq_numref(result.raw()), fmpq_numref(x.raw()), fmpq_denref(x.raw()));
  return result;
}

Rational simplest_between(const Rational& lower, const Rational& upper) {
  if (lower > upper) throw std::domain_error("empty interval");
  Rational result;
  fmpq_simplest_between(result.raw(), lower.raw(), upper.raw());
  return result;
}

std::string to_decimal(const Rational& x, int digits, int direction) {
  return with_point(scaled_integer(x, digits, direction), digits);
}

std::string to_significant(const Rational& x, int digits, int direction) {
  if (x.sign() == 0) return "0";
  // The decimal exponent: 10^(e-1) <= |x| < 10^e, found from an estimate and mended exactly.
  long e = static_cast<long>(integer_string(fmpq_numref(abs(x).raw())).size()) -
           static_cast<long>(integer_string(fmpq_denref(x.raw())).size());
  while (abs(x) >= pow(Rational(10), e)) ++e;
  while (abs(x) < pow(Rational(10), e - 1)) --e;
  Rational mantissa = scaled_integer(x, digits - e, direction);
  if (abs(mantissa) >= pow(Rational(10), digits)) {  // 9.99 rounded up to 10.0
    ++e;
    mantissa /= Rational(10);
  }
  constexpr long smallest_plain = -5;
  constexpr long largest_plain = 21;
  if (e < smallest_plain || e > largest_plain) {
    return with_point(mantissa, digits - 1) + "e" + std::to_string(e - 1);
  }
  return with_point(mantissa, digits - e);
}

}  // namespace subdiv
