#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/laurent.h"
#include "schemes/algebra/polynomial.h"
#include "schemes/algebra/rational.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// A value that exists, but not in the ring at hand, or is too dear to compute there.
class OutsideRing : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// What an expression asks of its ring beyond RingTraits: quotients and square roots. Both throw
/// std::domain_error with a phrase for the user, OutsideRing where the value exists but the ring does not
/// hold it.
template <class R>
struct ExpressionRing {
  /// a / b; throws std::domain_error for b = 0.
  static R quotient(const R& a, const R& b) {
    if (is_zero(b)) throw std::domain_error("division by zero");
    return a / b;
  }
  /// The square root; throws std::domain_error for a negative number.
  static R square_root(const R& x) {
    using std::sqrt;
    if (x < R(0)) throw std::domain_error("square root of a negative number");
    return sqrt(x);
  }
};

template <>
struct ExpressionRing<Rational> {
  static Rational quotient(const Rational& a, const Rational& b) { return a / b; }
  static Rational square_root(const Rational& x);
};

/// Quotients that are polynomials, roots of constants.
template <>
struct ExpressionRing<Polynomial> {
  static Polynomial quotient(const Polynomial& a, const Polynomial& b);
  static Polynomial square_root(const Polynomial& p);
};

/// Roots of constants only: the root of s^2 is |s|.
template <>
struct ExpressionRing<RationalFunction> {
  static RationalFunction quotient(const RationalFunction& a, const RationalFunction& b) { return a / b; }
  static RationalFunction square_root(const RationalFunction& f);
};

template <>
struct ExpressionRing<Algebraic> {
  static Algebraic quotient(const Algebraic& a, const Algebraic& b) { return a / b; }
  static Algebraic square_root(const Algebraic& x) { return sqrt(x); }
};

/// Divisors and radicands must be bounded away from zero, unless they are exactly zero.
template <>
struct ExpressionRing<Interval> {
  static Interval quotient(const Interval& a, const Interval& b);
  static Interval square_root(const Interval& x);
};

/// Laurent polynomials in z: division by monomials in every ring; by other divisors in exact rings, when
/// exact.
template <class R>
struct ExpressionRing<Laurent<R>> {
  static Laurent<R> quotient(const Laurent<R>& a, const Laurent<R>& b) {
    if (b.is_zero()) throw std::domain_error("division by zero");
    if (b.size() == 1) {
      const R& unit = b.coefficients().front();
      return map_coefficients(shift(a, -b.first()),
                              [&](const R& c) { return ExpressionRing<R>::quotient(c, unit); });
    }
    if constexpr (ExactRing<R>) {
      if (auto result = divide_exactly(a, b)) return std::move(*result);
      throw std::domain_error("a symbol may be divided by powers of z and by its own factors only");
    } else {
      throw std::domain_error("division by a polynomial in z needs exact coefficients");
    }
  }
  static Laurent<R> square_root(const Laurent<R>& p) {
    if (p.is_zero()) return p;
    if (p.size() > 1 || p.first() != 0) {
      throw std::domain_error("the square root of an expression in z is no symbol");
    }
    return Laurent<R>::constant(ExpressionRing<R>::square_root(p[0]));
  }
};

}  // namespace subdiv
