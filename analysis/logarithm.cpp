#include "analysis/logarithm.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace subdiv {
namespace {

constexpr long precision = 192;

/// q = base^k * rest, rest without a factor of the base in numerator and denominator.
struct Split {
  long k = 0;
  Rational rest;
};

Split split_off_powers(const Rational& q, int base) {
  Split result{0, q};
  const Rational b(base);
  const auto whole = [](const Rational& x) { return x.is_integer(); };
  const auto numerator = [](const Rational& x) {
    Rational n;
    fmpz_set(fmpq_numref(n.raw()), fmpq_numref(x.raw()));
    return n;
  };
  const auto denominator = [](const Rational& x) {
    Rational n;
    fmpz_set(fmpq_numref(n.raw()), fmpq_denref(x.raw()));
    return n;
  };
  while (whole(numerator(result.rest) / b)) result = {result.k + 1, result.rest / b};
  while (whole(denominator(result.rest) / b)) result = {result.k - 1, result.rest * b};
  return result;
}

/// log_base(x) when it is rational: x^d = q is the minimal polynomial, and q a power of the base.
std::optional<Rational> rational_logarithm(const Algebraic& x, int base) {
  const std::vector<Rational> p = x.minimal_polynomial();
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    if (p[i].sign() != 0) return std::nullopt;
  }
  const Rational q = -p.front() / p.back();
  if (q.sign() <= 0) return std::nullopt;
  const Split split = split_off_powers(q, base);
  if (split.rest != Rational(1)) return std::nullopt;
  return Rational(split.k, x.degree());
}

/// "3-log2(73/100)"; whole powers of the base leave the logarithm when an integer or the inverse of one
/// remains.
std::string text(const Rational& offset, int base, int divisor, const Algebraic& x) {
  const std::string name = "log" + std::to_string(base) + "(";
  const std::string end = divisor == 1 ? ")" : ")/" + std::to_string(divisor);
  std::string plain = (offset.sign() == 0 ? "" : offset.to_string()) + "-" + name + x.to_string() + end;
  if (!x.is_rational()) return plain;
  const Split split = split_off_powers(x.to_rational(), base);
  const Rational rest_offset = offset - Rational(split.k, divisor);
  const std::string constant = rest_offset.sign() == 0 ? "" : rest_offset.to_string();
  if (split.rest.is_integer()) return constant + "-" + name + split.rest.to_string() + end;
  const Rational inverse = Rational(1) / split.rest;
  if (inverse.is_integer())
    return constant + (constant.empty() ? "" : "+") + name + inverse.to_string() + end;
  return plain;
}

}  // namespace

Enclosure minus_logarithm(const Rational& offset, int base, int divisor, const Enclosure& x,
                          const std::optional<Algebraic>& closed_form) {
  if (x.lower.sign() <= 0) throw std::domain_error("the logarithm of a number that may be 0 has no bounds");
  const Interval unit = log(Interval(Rational(base), precision)) * Interval(divisor);
  const auto value = [&](const Rational& y) {
    return Interval(offset, precision) - log(Interval(y, precision)) / unit;
  };
  Enclosure result{value(x.upper).lower(), value(x.lower).upper(), x.rigour, x.status, x.method, ""};
  if (result.rigour == Rigour::exact) result.rigour = Rigour::certified;
  if (!closed_form) return result;
  if (const std::optional<Rational> logarithm = rational_logarithm(*closed_form, base)) {
    return exact(offset - *logarithm / Rational(divisor), x.method);
  }
  result.rigour = Rigour::exact;
  result.exact = text(offset, base, divisor, *closed_form);
  return result;
}

}  // namespace subdiv
