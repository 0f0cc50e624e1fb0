#pragma once

#include <algorithm>
#include <string>

#include <arb.h>

#include "schemes/algebra/rational.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// A real number known to lie in a ball [m - r, m + r]: a value over Arb, outward-rounded in every operation.
/// Each value carries the working precision in bits at which it was made; an operation works at the larger of
/// its operands' precisions, and integers carry none (0), so constants never lower the precision.
/// There is deliberately no operator<: ask certainly_less, contains_zero and the like.
class Interval {
 public:
  static constexpr long default_precision = 128;  ///< in bits

  Interval() { arb_init(value_); }
  /// A whole number, exact, of no precision of its own.
  Interval(int n) {
    arb_init(value_);
    arb_set_si(value_, n);
  }
  /// A whole number, exact, of no precision of its own.
  Interval(long n) {
    arb_init(value_);
    arb_set_si(value_, n);
  }
  /// The exact value of a finite double.
  explicit Interval(double x) {
    arb_init(value_);
    arb_set_d(value_, x);
  }
  explicit Interval(const Rational& q, long precision = default_precision);  ///< a ball around q
  /// The smallest ball at this precision that contains [lower, upper].
  static Interval hull(const Rational& lower, const Rational& upper, long precision = default_precision);
  static Interval hull(const Interval& a, const Interval& b);

  Interval(const Interval& o) : precision_(o.precision_) {
    arb_init(value_);
    arb_set(value_, o.value_);
  }
  Interval(Interval&& o) noexcept : precision_(o.precision_) {
    arb_init(value_);
    arb_swap(value_, o.value_);
  }
  Interval& operator=(const Interval& o) {
    arb_set(value_, o.value_);
    precision_ = o.precision_;
    return *this;
  }
  Interval& operator=(Interval&& o) noexcept {
    arb_swap(value_, o.value_);
    precision_ = o.precision_;
    return *this;
  }
  ~Interval() { arb_clear(value_); }

  Interval& operator+=(const Interval& o) {
    arb_add(value_, value_, o.value_, raise(o));
    return *this;
  }
  Interval& operator-=(const Interval& o) {
    arb_sub(value_, value_, o.value_, raise(o));
    return *this;
  }
  Interval& operator*=(const Interval& o) {
    arb_mul(value_, value_, o.value_, raise(o));
    return *this;
  }
  /// Division by an interval that contains zero gives the whole line (a ball that is not finite).
  Interval& operator/=(const Interval& o) {
    arb_div(value_, value_, o.value_, raise(o));
    return *this;
  }
  /// sum += a b, rounded once.
  friend void add_product(Interval& sum, const Interval& a, const Interval& b) {
    sum.raise(a);
    arb_addmul(sum.value_, a.value_, b.value_, sum.raise(b));
  }
  friend Interval operator+(Interval a, const Interval& b) { return a += b; }
  friend Interval operator-(Interval a, const Interval& b) { return a -= b; }
  friend Interval operator*(Interval a, const Interval& b) { return a *= b; }
  friend Interval operator/(Interval a, const Interval& b) { return a /= b; }
  friend Interval operator-(Interval a) {
    arb_neg(a.value_, a.value_);
    return a;
  }

  [[nodiscard]] bool is_finite() const { return arb_is_finite(value_) != 0; }
  [[nodiscard]] bool is_exactly_zero() const { return arb_is_zero(value_) != 0; }
  [[nodiscard]] bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  [[nodiscard]] bool contains(const Rational& q) const { return arb_contains_fmpq(value_, q.raw()) != 0; }
  [[nodiscard]] bool contains(const Interval& o) const { return arb_contains(value_, o.value_) != 0; }
  /// o lies strictly inside: what Krawczyk's and Newton's test for existence need.
  [[nodiscard]] bool contains_strictly(const Interval& o) const {
    return arb_contains_interior(value_, o.value_) != 0;
  }
  [[nodiscard]] bool overlaps(const Interval& o) const { return arb_overlaps(value_, o.value_) != 0; }

  /// Exact dyadic end points (of a finite ball; std::domain_error otherwise).
  [[nodiscard]] Rational lower() const;
  /// The right end, exact.
  [[nodiscard]] Rational upper() const;
  /// The middle of the ball, exact.
  [[nodiscard]] Rational midpoint() const;
  /// The radius as a double, rounded up.
  [[nodiscard]] double radius() const;
  [[nodiscard]] double to_double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  /// The ball without its radius.
  [[nodiscard]] Interval center() const;
  /// As Arb prints it, "[middle +/- radius]", with at most so many digits.
  [[nodiscard]] std::string to_string(int digits = 20) const;

  [[nodiscard]] long precision() const { return precision_; }
  /// The same ball with another working precision.
  [[nodiscard]] Interval with_precision(long bits) const;
  [[nodiscard]] const arb_struct* raw() const { return value_; }
  [[nodiscard]] arb_struct* raw() { return value_; }
  /// Precision to use for a library call on this value.
  [[nodiscard]] long working_precision() const { return precision_ > 0 ? precision_ : default_precision; }

 private:
  long raise(const Interval& o) {
    precision_ = std::max(precision_, o.precision_);
    return working_precision();
  }

  arb_t value_;
  long precision_ = 0;
};

/// True only when every point of a is below every point of b; false means "not known".
[[nodiscard]] inline bool certainly_less(const Interval& a, const Interval& b) {
  return arb_lt(a.raw(), b.raw()) != 0;
}
/// True only when every point of a is at most every point of b.
[[nodiscard]] inline bool certainly_at_most(const Interval& a, const Interval& b) {
  return arb_le(a.raw(), b.raw()) != 0;
}
[[nodiscard]] inline bool certainly_positive(const Interval& a) { return arb_is_positive(a.raw()) != 0; }
[[nodiscard]] inline bool certainly_negative(const Interval& a) { return arb_is_negative(a.raw()) != 0; }

/// Encloses |x|.
[[nodiscard]] Interval abs(const Interval& x);
/// Encloses the square root; not finite when the ball reaches below 0.
[[nodiscard]] Interval sqrt(const Interval& x);
/// Encloses x^n; n may be negative.
[[nodiscard]] Interval pow(const Interval& x, long n);
/// Encloses the natural logarithm; not finite unless the ball is positive.
[[nodiscard]] Interval log(const Interval& x);
/// Encloses the exponential.
[[nodiscard]] Interval exp(const Interval& x);
/// Encloses the cosine.
[[nodiscard]] Interval cos(const Interval& x);
/// Encloses the sine.
[[nodiscard]] Interval sin(const Interval& x);
/// Encloses the larger of the two.
[[nodiscard]] Interval max(const Interval& a, const Interval& b);
/// Encloses the smaller of the two.
[[nodiscard]] Interval min(const Interval& a, const Interval& b);
/// pi at the given precision.
[[nodiscard]] Interval pi(long precision = Interval::default_precision);

template <>
struct RingTraits<Interval> {
  static constexpr bool exact = false;
  static Interval from_rational(const Rational& q) { return Interval(q); }
  static bool is_zero(const Interval& x) { return x.is_exactly_zero(); }
};

}  // namespace subdiv
