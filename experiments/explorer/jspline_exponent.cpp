#include "experiments/explorer/jspline_exponent.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace subdiv::explorer {
namespace {

constexpr long kept_bits = 160;  // of intermediate results

Rational rounded_down(const Rational& x) {
  return floor(x * Rational::power_of_two(kept_bits)) * Rational::power_of_two(-kept_bits);
}
Rational rounded_up(const Rational& x) { return -rounded_down(-x); }

/// `whole` - log2 x.
Bracket minus_log2(long whole, const Bracket& x) {
  return {Rational(whole) - log2_bracket(x.upper).upper, Rational(whole) - log2_bracket(x.lower).lower};
}

Exponent of_radius(long whole, const Rational& radius) {
  const Bracket value = minus_log2(whole, {radius, radius});
  return {value, value.is_exact() ? value.lower.to_string()
                                  : std::to_string(whole) + "-log2(" + radius.to_string() + ")"};
}

/// Between the quintic B-spline and s = 2, where a product of two matrices decides.
Exponent of_bent_piece(const Rational& s) {
  const Rational part = s - Rational(1);
  const Rational square = part * (Rational(15) - Rational(7) * s);
  const Bracket root = sqrt_bracket(square);
  const Rational four(4);
  const Bracket value = minus_log2(3, {(part + root.lower) / four, (part + root.upper) / four});
  return {value, value.is_exact() ? value.lower.to_string()
                                  : "3-log2((" + part.to_string() + "+sqrt(" + square.to_string() + "))/4)"};
}

}  // namespace

Bracket log2_bracket(const Rational& x) {
  if (x.sign() <= 0) throw std::domain_error("the logarithm of a number that is not positive");
  constexpr int bits = 60;
  long whole = 0;
  Rational mantissa = x;
  const Rational two(2);
  for (; mantissa >= two; ++whole) mantissa /= two;
  for (; mantissa < Rational(1); --whole) mantissa *= two;
  if (mantissa == Rational(1)) return {Rational(whole), Rational(whole)};
  // The binary digits one after the other: y < log2 of the mantissa < y + unit.
  Bracket m{mantissa, mantissa};
  Rational y(whole);
  Rational unit(1);
  for (int i = 0; i < bits; ++i) {
    m = {rounded_down(m.lower * m.lower), rounded_up(m.upper * m.upper)};
    if (m.lower < two && m.upper >= two) break;  // this digit cannot be told
    unit /= two;
    if (m.upper < two) continue;
    y += unit;
    m = {m.lower / two, m.upper / two};
  }
  return {y, y + unit};
}

Bracket sqrt_bracket(const Rational& x) {
  if (x.sign() < 0) throw std::domain_error("the square root of a negative number");
  Rational root = Rational::from_double(std::sqrt(x.to_double()));
  if (root * root == x) return {root, root};
  // A step of Newton's method ends above the root, and x divided by it is below.
  root = rounded_up((root + x / root) / Rational(2));
  return {rounded_down(x / root), root};
}

std::optional<Exponent> jspline_exponent(const Rational& s) {
  const Rational spline(3, 2);
  if (s <= Rational(-6) || s >= Rational(10)) return std::nullopt;
  if (s < spline) return of_radius(3, Rational(2) - s);
  if (s == spline) return Exponent{{Rational(5), Rational(5)}, "5"};
  if (s < Rational(2)) return of_bent_piece(s);
  if (s <= Rational(3)) return of_radius(4, s - Rational(1));
  return of_radius(3, s - Rational(2));
}

std::string decimal_text(const Rational& x, int digits, int direction) {
  const Rational scale = pow(Rational(10), digits);
  const Rational scaled = direction < 0 ? floor(x * scale) : -floor(-x * scale);
  std::string text = abs(scaled).to_string();
  const auto after = static_cast<std::size_t>(digits);
  if (text.size() <= after) text.insert(0, after + 1 - text.size(), '0');
  if (digits > 0) text.insert(text.size() - after, ".");
  return (scaled.sign() < 0 ? "-" : "") + text;
}

}  // namespace subdiv::explorer
