#include "analysis/jsr/number_field.h"

namespace subdiv {

FieldElement::FieldElement(UnivariatePolynomial value, std::shared_ptr<const NumberField> field)
    : value_(std::move(value)), field_(std::move(field)) {
  if (field_ && value_.degree() >= field_->modulus.degree()) value_ = divide(value_, field_->modulus).second;
}

FieldElement FieldElement::inverse() const {
  if (is_zero()) throw std::domain_error("division by zero");
  if (value_.degree() == 0) return FieldElement(Rational(1) / value_.coefficient(0));
  UnivariatePolynomial divisor;
  UnivariatePolynomial cofactor;
  UnivariatePolynomial unused;
  fmpq_poly_xgcd(divisor.raw(), cofactor.raw(), unused.raw(), value_.raw(), field_->modulus.raw());
  return FieldElement(std::move(cofactor), field_);
}

int FieldElement::sign() const {
  if (value_.degree() <= 0) return value_.coefficient(0).sign();
  // The value is not zero: some precision separates it from 0.
  for (long precision = Interval::default_precision;; precision *= 2) {
    const Interval x = value_.evaluate(field_->generator.to_interval(precision));
    if (!x.contains_zero()) return certainly_positive(x) ? 1 : -1;
  }
}

}  // namespace subdiv
