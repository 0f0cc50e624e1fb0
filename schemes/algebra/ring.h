#pragma once

#include <concepts>

#include "schemes/algebra/rational.h"

namespace subdiv {

/// What generic code asks of a coefficient ring R beyond +, -, * and construction from int:
/// the image of a rational number, whether a value is known to be zero, and whether that knowledge is exact.
/// A ring of inexact values (double, intervals) answers is_zero only for the value that is zero as stored.
template <class R>
struct RingTraits {
  static constexpr bool exact = false;  ///< whether is_zero decides
  static R from_rational(const Rational& q) { return R(q.to_double()); }
  static bool is_zero(const R& x) { return x == R(0); }
};

template <>
struct RingTraits<Rational> {
  static constexpr bool exact = true;
  static Rational from_rational(const Rational& q) { return q; }
  static bool is_zero(const Rational& x) { return x.sign() == 0; }
};

/// The image of a rational number in R.
template <class R>
R from_rational(const Rational& q) {
  return RingTraits<R>::from_rational(q);
}

/// p/q in R.
template <class R>
R fraction(long p, long q) {
  return RingTraits<R>::from_rational(Rational(p, q));
}

/// Whether a value is known to be 0.
template <class R>
bool is_zero(const R& x) {
  return RingTraits<R>::is_zero(x);
}

/// sum += a b. Rings with costly temporaries overload it.
template <class R>
void add_product(R& sum, const R& a, const R& b) {
  sum += a * b;
}

/// A ring whose zero test decides: rationals, algebraic numbers, polynomials and rational functions over Q.
template <class R>
concept ExactRing = RingTraits<R>::exact;

}  // namespace subdiv
