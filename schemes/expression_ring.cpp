#include "schemes/expression_ring.h"

#include <flint/fmpz.h>

namespace subdiv {

Rational ExpressionRing<Rational>::square_root(const Rational& x) {
  if (x.sign() < 0) throw std::domain_error("square root of a negative number");
  const fmpz* numerator = fmpq_numref(x.raw());
  const fmpz* denominator = fmpq_denref(x.raw());
  if (fmpz_is_square(numerator) == 0 || fmpz_is_square(denominator) == 0) {
    throw OutsideRing("the square root of " + x.to_string() + " is irrational");
  }
  Rational root;
  fmpz_sqrt(fmpq_numref(root.raw()), numerator);
  fmpz_sqrt(fmpq_denref(root.raw()), denominator);
  return root;
}

Polynomial ExpressionRing<Polynomial>::quotient(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw std::domain_error("division by zero");
  Polynomial result;
  if (!divides(b, a, result)) throw std::domain_error("the quotient is no polynomial");
  return result;
}

Polynomial ExpressionRing<Polynomial>::square_root(const Polynomial& p) {
  if (!p.is_constant()) throw OutsideRing("the square root of a free parameter is no polynomial");
  return Polynomial(ExpressionRing<Rational>::square_root(p.constant()));
}

RationalFunction ExpressionRing<RationalFunction>::square_root(const RationalFunction& f) {
  if (!f.is_constant()) throw OutsideRing("the square root of a free parameter is no rational function");
  return RationalFunction(ExpressionRing<Rational>::square_root(f.constant()));
}

Interval ExpressionRing<Interval>::quotient(const Interval& a, const Interval& b) {
  if (b.is_exactly_zero()) throw std::domain_error("division by zero");
  if (b.contains_zero()) throw std::domain_error("division by an interval that contains zero");
  return a / b;
}

Interval ExpressionRing<Interval>::square_root(const Interval& x) {
  if (x.is_exactly_zero()) return x;
  if (certainly_negative(x)) throw std::domain_error("square root of a negative number");
  if (!certainly_positive(x)) throw std::domain_error("square root of an interval that reaches zero");
  return sqrt(x);
}

}  // namespace subdiv
