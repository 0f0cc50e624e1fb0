#pragma once

#include "analysis/real_set.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// Questions about the sign of a function of one parameter p = x_0 on a whole interval, decided exactly: the
/// real roots are isolated, and one rational number between them is tried. An interval with lower > upper,
/// and an open one with lower = upper, is a std::domain_error. Functions of other variables are a
/// std::domain_error.

/// f > 0 and f has no pole at every point of the interval.
[[nodiscard]] bool is_positive(const RationalFunction& f, const RealInterval& range);
/// f >= 0 and f has no pole at every point of the interval.
[[nodiscard]] bool is_nonnegative(const RationalFunction& f, const RealInterval& range);
/// f(p) != 0 at every point of the interval.
[[nodiscard]] bool has_no_root(const Polynomial& f, const RealInterval& range);
/// f has no pole in the interval.
[[nodiscard]] bool is_finite(const RationalFunction& f, const RealInterval& range);

/// A rational number in the interval; the point itself when it has only one (std::domain_error when that is
/// irrational).
[[nodiscard]] Rational sample(const RealInterval& range);

/// Intervals with rational ends.
[[nodiscard]] RealInterval closed_interval(const Rational& lower, const Rational& upper);
/// (lower, upper) without its ends.
[[nodiscard]] RealInterval open_interval(const Rational& lower, const Rational& upper);

}  // namespace subdiv
