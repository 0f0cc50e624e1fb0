#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

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

/// What an expression asks of its ring beyond RingTraits: quotients and square roots (both throw
/// std::domain_error with a phrase for the user), and the size of a value in units such that an operation
/// costs about the product of its operands' sizes. Dearer operations than cost_limit are refused;
/// laurent_cost_limit is the same for Laurent polynomials over R.
template <class R>
struct ExpressionRing {
  static constexpr long cost_limit = 1;
  static constexpr long laurent_cost_limit = 4'000'000;
  static long size(const R&) { return 1; }
  static R quotient(const R& a, const R& b) {
    if (is_zero(b)) throw std::domain_error("division by zero");
    return a / b;
  }
  static R square_root(const R& x) {
    using std::sqrt;
    if (x < R(0)) throw std::domain_error("square root of a negative number");
    return sqrt(x);
  }
};

/// The rational square root of a rational number; OutsideRing when it is irrational, std::domain_error when
/// negative.
[[nodiscard]] Rational rational_square_root(const Rational& x);

template <>
struct ExpressionRing<Rational> {
  static constexpr long cost_limit = 1;
  static constexpr long laurent_cost_limit = 4'000'000;
  static long size(const Rational&) { return 1; }
  static Rational quotient(const Rational& a, const Rational& b) { return a / b; }
  static Rational square_root(const Rational& x) { return rational_square_root(x); }
};

template <>
struct ExpressionRing<Polynomial> {
  static constexpr long cost_limit = 100'000;
  static constexpr long laurent_cost_limit = 1'000'000;
  static long size(const Polynomial& p) { return static_cast<long>(p.terms().size()); }
  static Polynomial quotient(const Polynomial& a, const Polynomial& b);
  static Polynomial square_root(const Polynomial& p);
};

template <>
struct ExpressionRing<RationalFunction> {
  static constexpr long cost_limit = 20'000;
  static constexpr long laurent_cost_limit = 100'000;
  static long size(const RationalFunction& f);
  static RationalFunction quotient(const RationalFunction& a, const RationalFunction& b) { return a / b; }
  static RationalFunction square_root(const RationalFunction& f);
};

template <>
struct ExpressionRing<Algebraic> {
  // Two numbers of degree 8 take 50 ms to add, of degree 16 several seconds.
  static constexpr long cost_limit = 64;
  static constexpr long laurent_cost_limit = 5'000;
  static long size(const Algebraic& x) { return x.degree(); }
  static Algebraic quotient(const Algebraic& a, const Algebraic& b);
  static Algebraic square_root(const Algebraic& x) { return sqrt(x); }
};

template <>
struct ExpressionRing<Interval> {
  static constexpr long cost_limit = 1;
  static constexpr long laurent_cost_limit = 4'000'000;
  static long size(const Interval&) { return 1; }
  static Interval quotient(const Interval& a, const Interval& b);
  static Interval square_root(const Interval& x);
};

/// Refuses (OutsideRing) an operation on values too large.
template <class R>
void require_affordable(const R& a, const R& b) {
  if (ExpressionRing<R>::size(a) * ExpressionRing<R>::size(b) > ExpressionRing<R>::cost_limit) {
    throw OutsideRing("the value is too large to compute");
  }
}

template <class R>
R affordable_sum(const R& a, const R& b) {
  require_affordable(a, b);
  return a + b;
}

template <class R>
R affordable_product(const R& a, const R& b) {
  require_affordable(a, b);
  return a * b;
}

/// x^n by repeated squaring; a negative n inverts first.
template <class R>
R integer_power(R x, long n) {
  if (n < 0) {
    x = ExpressionRing<R>::quotient(R(1), x);
    n = -n;
  }
  R result(1);
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = affordable_product<R>(result, x);
    if (n > 1) x = affordable_product<R>(x, x);
  }
  return result;
}

/// Laurent polynomials in z: division by monomials in every ring; by other divisors in exact rings, when
/// exact.
template <class R>
struct ExpressionRing<Laurent<R>> {
  static constexpr long cost_limit = ExpressionRing<R>::laurent_cost_limit;

  static long size(const Laurent<R>& p) {
    long total = 0;
    for (const R& c : p.coefficients()) total += ExpressionRing<R>::size(c);
    return total;
  }
  static Laurent<R> quotient(const Laurent<R>& a, const Laurent<R>& b) {
    if (b.is_zero()) throw std::domain_error("division by zero");
    require_affordable(a, b);
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
    if (p.size() > 1 || p.first() != 0)
      throw std::domain_error("the square root of an expression in z is no symbol");
    return Laurent<R>::constant(ExpressionRing<R>::square_root(p[0]));
  }
};

}  // namespace subdiv
