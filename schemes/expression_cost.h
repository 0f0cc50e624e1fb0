#pragma once

#include <algorithm>

#include "schemes/expression_ring.h"

namespace subdiv {

/// The size of a value over R, in units such that a product costs about the product of its factors' sizes,
/// and the dearest operation that an expression may ask for. Sums cost as much as products where
/// sums_are_products (fractions have to be brought to a common denominator), else they cost next to nothing.
/// laurent_limit is the limit for Laurent polynomials over R. All limits are a second or so.
template <class R>
struct ExpressionCost {
  static constexpr bool sums_are_products = false;  ///< whether a sum costs as much as a product
  static constexpr long limit = 1'000'000;          ///< of one operation over R
  static constexpr long laurent_limit = 300'000;    ///< of one operation on Laurent polynomials over R
  static long size(const R& /*x*/) { return 1; }
};

template <>
struct ExpressionCost<Rational> {
  static constexpr bool sums_are_products = false;
  static constexpr long limit = 100'000'000;
  static constexpr long laurent_limit = 4'000'000;
  /// In words of 64 bits.
  static long size(const Rational& x);
};

template <>
struct ExpressionCost<Polynomial> {
  static constexpr bool sums_are_products = false;
  static constexpr long limit = 100'000;
  static constexpr long laurent_limit = 1'000'000;
  /// In terms.
  static long size(const Polynomial& p) { return static_cast<long>(p.terms().size()); }
};

template <>
struct ExpressionCost<RationalFunction> {
  static constexpr bool sums_are_products = true;
  static constexpr long limit = 20'000;
  static constexpr long laurent_limit = 100'000;
  static long size(const RationalFunction& f);
};

/// Two numbers of degree 8 take 50 ms to add, of degree 16 several seconds.
template <>
struct ExpressionCost<Algebraic> {
  static constexpr bool sums_are_products = true;
  static constexpr long limit = 64;
  static constexpr long laurent_limit = 5'000;
  static long size(const Algebraic& x) { return x.degree(); }
};

template <class R>
struct ExpressionCost<Laurent<R>> {
  static constexpr bool sums_are_products = false;
  static constexpr long limit = ExpressionCost<R>::laurent_limit;
  static long size(const Laurent<R>& p) {
    long total = 0;
    for (const R& c : p.coefficients()) total += ExpressionCost<R>::size(c);
    return total;
  }
  /// The size of the largest coefficient.
  static long largest(const Laurent<R>& p) {
    long result = 0;
    for (const R& c : p.coefficients()) result = std::max(result, ExpressionCost<R>::size(c));
    return result;
  }
};

/// What a product would cost.
template <class R>
long product_cost(const R& a, const R& b) {
  return ExpressionCost<R>::size(a) * ExpressionCost<R>::size(b);
}

/// Beyond the limit when some product of coefficients is.
template <class R>
long product_cost(const Laurent<R>& a, const Laurent<R>& b) {
  using Cost = ExpressionCost<Laurent<R>>;
  const bool too_dear = Cost::largest(a) * Cost::largest(b) > ExpressionCost<R>::limit;
  return too_dear ? Cost::limit + 1 : Cost::size(a) * Cost::size(b);
}

/// What a sum would cost.
template <class R>
long sum_cost(const R& a, const R& b) {
  using Cost = ExpressionCost<R>;
  return Cost::sums_are_products ? Cost::size(a) * Cost::size(b) : Cost::size(a) + Cost::size(b);
}

/// Beyond the limit when some sum of coefficients is.
template <class R>
long sum_cost(const Laurent<R>& a, const Laurent<R>& b) {
  using Cost = ExpressionCost<Laurent<R>>;
  long total = Cost::size(a) + Cost::size(b);
  for (int i = std::max(a.first(), b.first()); i <= std::min(a.last(), b.last()); ++i) {
    const long cost = sum_cost(a[i], b[i]);
    total += cost > ExpressionCost<R>::limit ? Cost::limit + 1 : cost;
  }
  return total;
}

/// Adds up what an expression costs; OutsideRing when one operation is beyond the limit, or all of them are
/// beyond twenty times as much.
template <class R>
class CostMeter {
 public:
  /// Adds the cost of an operation that is about to be done; throws OutsideRing beyond the limits.
  void charge(long cost) {
    constexpr long operations_in_all = 20;
    constexpr long limit = ExpressionCost<R>::limit;
    total_ += cost;
    if (cost > limit || total_ > operations_in_all * limit) {
      throw OutsideRing("the value is too large to compute");
    }
  }

 private:
  long total_ = 0;
};

/// a b, charged first.
template <class R>
R metered_product(const R& a, const R& b, CostMeter<R>& meter) {
  meter.charge(product_cost(a, b));
  return a * b;
}

/// x^n by repeated squaring; a negative n inverts first.
template <class R>
R integer_power(R x, long n, CostMeter<R>& meter) {
  if (n < 0) {
    x = ExpressionRing<R>::quotient(R(1), x);
    n = -n;
  }
  R result(1);
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = metered_product(result, x, meter);
    if (n > 1) x = metered_product(x, x, meter);
  }
  return result;
}

}  // namespace subdiv
