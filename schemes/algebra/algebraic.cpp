#include "schemes/algebra/algebraic.h"

#include <stdexcept>

#include "schemes/algebra/univariate.h"

namespace subdiv {

Algebraic& Algebraic::operator/=(const Algebraic& o) {
  if (o.is_zero()) throw std::domain_error("division by zero");
  qqbar_div(value_, value_, o.value_);
  return *this;
}

Rational Algebraic::to_rational() const {
  if (!is_rational()) throw std::domain_error(to_string() + " is irrational");
  Rational result;
  qqbar_get_fmpq(result.raw(), value_);
  return result;
}

Interval Algebraic::to_interval(long precision) const {
  Interval result(Rational(0), precision);
  qqbar_get_arb(result.raw(), value_, precision);
  return result;
}

std::vector<Rational> Algebraic::minimal_polynomial() const {
  std::vector<Rational> result;
  const fmpz_poly_struct* poly = &value_->poly;
  for (long i = 0; i <= fmpz_poly_degree(poly); ++i) {
    Rational c;
    fmpz_poly_get_coeff_fmpz(fmpq_numref(c.raw()), poly, i);
    result.push_back(c);
  }
  return result;
}

std::string Algebraic::to_string() const {
  if (is_rational()) return to_rational().to_string();
  const std::vector<Rational> p = minimal_polynomial();
  if (p.size() == 3) {
    // a x^2 + b x + c: (-b +- sqrt(b^2 - 4 a c)) / (2 a), with a square taken out of the root.
    fmpz_t a, b, c, q;
    fmpz_init(a), fmpz_init(b), fmpz_init(c), fmpz_init(q);
    qqbar_get_quadratic(a, b, c, q, value_, 2);
    Rational ra, rb, rc, rq;
    fmpz_set(fmpq_numref(ra.raw()), a);
    fmpz_set(fmpq_numref(rb.raw()), b);
    fmpz_set(fmpq_numref(rc.raw()), c);
    fmpz_set(fmpq_numref(rq.raw()), q);
    fmpz_clear(a), fmpz_clear(b), fmpz_clear(c), fmpz_clear(q);
    std::string root = "sqrt(" + rc.to_string() + ")";
    if (abs(rb) != Rational(1)) root = abs(rb).to_string() + "*" + root;
    std::string text = rb.sign() < 0 ? "-" + root : root;
    if (ra.sign() != 0) text = ra.to_string() + (rb.sign() < 0 ? "-" : "+") + root;
    if (rq == Rational(1)) return text;
    return (ra.sign() != 0 ? "(" + text + ")" : text) + "/" + rq.to_string();
  }
  constexpr int shown_digits = 12;
  return "root of " + UnivariatePolynomial(p).to_string("x") + " near " +
         to_significant(to_interval().midpoint(), shown_digits);
}

Algebraic sqrt(const Algebraic& x) {
  if (x.sign() < 0) throw std::domain_error("square root of a negative number");
  Algebraic result;
  qqbar_root_ui(result.raw(), x.raw(), 2);
  return result;
}

Algebraic abs(const Algebraic& x) { return x.sign() < 0 ? -x : x; }

}  // namespace subdiv
