#pragma once

#include <optional>
#include <string>

#include "schemes/algebra/rational.h"

namespace subdiv::explorer {

/// A real number between two rational ones, proved in exact arithmetic.
struct Bracket {
  Rational lower;
  Rational upper;

  [[nodiscard]] bool is_exact() const { return lower == upper; }
};

/// log2 x for x > 0, to about 2^-60; exact for powers of 2. Throws std::domain_error for other x.
[[nodiscard]] Bracket log2_bracket(const Rational& x);

/// The square root of x >= 0, to about 30 digits; exact for 0 and for the squares of doubles.
[[nodiscard]] Bracket sqrt_bracket(const Rational& x);

/// A Hoelder exponent in closed form.
struct Exponent {
  Bracket value;
  std::string formula;  // "3-log2(1311/1000)"
};

/// The exponent of the limits of *J_s: the closed form that smooth.exponent.formula proves for -6 < s < 10.
/// Nothing elsewhere: the scheme diverges.
[[nodiscard]] std::optional<Exponent> jspline_exponent(const Rational& s);

/// x in decimals, rounded down (direction < 0) or up: "-0.4642".
[[nodiscard]] std::string decimal_text(const Rational& x, int digits, int direction);

}  // namespace subdiv::explorer
