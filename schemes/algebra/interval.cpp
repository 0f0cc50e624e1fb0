#include "schemes/algebra/interval.h"

#include <stdexcept>

#include <mag.h>

namespace subdiv {
namespace {

/// An exact rational from an arf (a dyadic number).
Rational from_arf(const arf_struct* x) {
  Rational result;
  arf_get_fmpq(result.raw(), x);
  return result;
}

void require_finite(const Interval& x) {
  if (!x.is_finite()) throw std::domain_error("an unbounded interval has no end points");
}

}  // namespace

Interval::Interval(const Rational& q, long precision) : precision_(precision) {
  arb_init(value_);
  arb_set_fmpq(value_, q.raw(), precision);
}

Interval Interval::hull(const Rational& lower, const Rational& upper, long precision) {
  return hull(Interval(lower, precision), Interval(upper, precision));
}

Interval Interval::hull(const Interval& a, const Interval& b) {
  Interval result;
  result.precision_ = std::max(a.precision_, b.precision_);
  arb_union(result.value_, a.value_, b.value_, result.working_precision());
  return result;
}

Rational Interval::lower() const {
  require_finite(*this);
  Rational radius;
  arf_t r;
  arf_init_set_mag_shallow(r, arb_radref(value_));
  arf_get_fmpq(radius.raw(), r);
  return midpoint() - radius;
}

Rational Interval::upper() const {
  require_finite(*this);
  Rational radius;
  arf_t r;
  arf_init_set_mag_shallow(r, arb_radref(value_));
  arf_get_fmpq(radius.raw(), r);
  return midpoint() + radius;
}

Rational Interval::midpoint() const {
  require_finite(*this);
  return from_arf(arb_midref(value_));
}

double Interval::radius() const { return mag_get_d(arb_radref(value_)); }

Interval Interval::center() const {
  Interval result(*this);
  mag_zero(arb_radref(result.value_));
  return result;
}

std::string Interval::to_string(int digits) const {
  char* raw = arb_get_str(value_, digits, 0);
  std::string text(raw);
  flint_free(raw);
  return text;
}

Interval Interval::with_precision(long bits) const {
  Interval result(*this);
  result.precision_ = bits;
  return result;
}

Interval abs(const Interval& x) {
  Interval result(x);
  arb_abs(result.raw(), x.raw());
  // Arb's abs keeps the ball's radius: where zero is inside, the part below zero has to go.
  if (x.contains_zero()) {
    arb_t magnitude;
    arb_init(magnitude);
    arf_t upper;
    arf_init(upper);
    arb_get_abs_ubound_arf(upper, x.raw(), x.working_precision());
    arb_set_arf(magnitude, upper);
    arb_t zero;
    arb_init(zero);
    arb_union(result.raw(), zero, magnitude, x.working_precision());
    arb_clear(zero);
    arb_clear(magnitude);
    arf_clear(upper);
  }
  return result;
}

Interval sqrt(const Interval& x) {
  Interval result(x);
  arb_sqrt(result.raw(), x.raw(), x.working_precision());
  return result;
}

Interval pow(const Interval& x, long n) {
  Interval result(x);
  if (n >= 0) {
    arb_pow_ui(result.raw(), x.raw(), static_cast<unsigned long>(n), x.working_precision());
  } else {
    arb_pow_ui(result.raw(), x.raw(), static_cast<unsigned long>(-n), x.working_precision());
    arb_inv(result.raw(), result.raw(), x.working_precision());
  }
  return result;
}

Interval log(const Interval& x) {
  Interval result(x);
  arb_log(result.raw(), x.raw(), x.working_precision());
  return result;
}

Interval exp(const Interval& x) {
  Interval result(x);
  arb_exp(result.raw(), x.raw(), x.working_precision());
  return result;
}

Interval cos(const Interval& x) {
  Interval result(x);
  arb_cos(result.raw(), x.raw(), x.working_precision());
  return result;
}

Interval sin(const Interval& x) {
  Interval result(x);
  arb_sin(result.raw(), x.raw(), x.working_precision());
  return result;
}

Interval max(const Interval& a, const Interval& b) {
  Interval result(a.precision() >= b.precision() ? a : b);
  arb_max(result.raw(), a.raw(), b.raw(), result.working_precision());
  return result;
}

Interval min(const Interval& a, const Interval& b) {
  Interval result(a.precision() >= b.precision() ? a : b);
  arb_min(result.raw(), a.raw(), b.raw(), result.working_precision());
  return result;
}

Interval pi(long precision) {
  Interval result = Interval(Rational(0), precision);
  arb_const_pi(result.raw(), precision);
  return result;
}

}  // namespace subdiv
