#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/polynomial.h"

namespace subdiv {

/// An interval of real numbers with exact ends; an absent end is infinite. A single point has both ends
/// closed and equal.
struct RealInterval {
  std::optional<Algebraic> lower;  ///< absent: -infinity
  std::optional<Algebraic> upper;  ///< absent: infinity
  bool lower_closed = false;       ///< whether the lower end belongs to it
  bool upper_closed = false;       ///< whether the upper end belongs to it

  [[nodiscard]] bool is_point() const { return lower && upper && *lower == *upper; }
  /// Decided exactly.
  [[nodiscard]] bool contains(const Algebraic& x) const;
};

/// A set of real numbers: finitely many intervals, ascending, with gaps between them.
struct RealSet {
  std::vector<RealInterval> parts;  ///< in ascending order

  [[nodiscard]] bool is_empty() const { return parts.empty(); }
  /// Decided exactly.
  [[nodiscard]] bool contains(const Algebraic& x) const;
  /// "(-2, 6)", "[0, 1) u {3/2} u (5, inf)", "empty".
  [[nodiscard]] std::string to_string() const;
};

/// Appends the real roots of a polynomial that uses no variable but x_i (std::domain_error); none for a
/// constant.
void append_real_roots(const Polynomial& p, int i, std::vector<Algebraic>& roots);

/// A rational number of small denominator strictly between two different real numbers a < b.
[[nodiscard]] Rational rational_between(const Algebraic& a, const Algebraic& b);

/// The set of all x where a condition holds that can only change at the given numbers (in any order): decided
/// at each of them, and at one rational number in each interval between neighbours.
[[nodiscard]] RealSet solve_by_cells(std::vector<Algebraic> critical,
                                     const std::function<bool(const Algebraic&)>& holds);

}  // namespace subdiv
