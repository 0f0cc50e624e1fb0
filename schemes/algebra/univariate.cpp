#include "schemes/algebra/univariate.h"

#include <algorithm>
#include <stdexcept>

#include <arb_fmpz_poly.h>
#include <arb_poly.h>
#include <flint/fmpz_poly_factor.h>

namespace subdiv {
namespace {

/// The primitive integer polynomial with the same roots.
class IntegerPolynomial {
 public:
  explicit IntegerPolynomial(const UnivariatePolynomial& p) {
    fmpz_poly_init(value_);
    fmpq_poly_get_numerator(value_, p.raw());
    fmpz_poly_primitive_part(value_, value_);
  }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }
  [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

void require_nonzero(const UnivariatePolynomial& p) {
  if (p.is_zero()) throw std::domain_error("the zero polynomial has every number as a root");
}

int sign_changes(const std::vector<UnivariatePolynomial>& chain, const Rational& x) {
  int changes = 0;
  int last = 0;
  for (const UnivariatePolynomial& p : chain) {
    const int sign = p.evaluate(x).sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

}  // namespace

UnivariatePolynomial::UnivariatePolynomial(const std::vector<Rational>& coefficients)
    : UnivariatePolynomial() {
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    fmpq_poly_set_coeff_fmpq(value_, static_cast<long>(i), coefficients[i].raw());
  }
}

UnivariatePolynomial::UnivariatePolynomial(const Polynomial& p, int variable) : UnivariatePolynomial() {
  const std::vector<Polynomial> coefficients = p.coefficients_in(variable);
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    fmpq_poly_set_coeff_fmpq(value_, static_cast<long>(i), coefficients[i].constant().raw());
  }
}

Rational UnivariatePolynomial::coefficient(long i) const {
  Rational result;
  fmpq_poly_get_coeff_fmpq(result.raw(), value_, i);
  return result;
}

UnivariatePolynomial UnivariatePolynomial::derivative() const {
  UnivariatePolynomial result;
  fmpq_poly_derivative(result.value_, value_);
  return result;
}

Rational UnivariatePolynomial::evaluate(const Rational& x) const {
  Rational result;
  fmpq_poly_evaluate_fmpq(result.raw(), value_, x.raw());
  return result;
}

Interval UnivariatePolynomial::evaluate(const Interval& x) const {
  Interval sum = Interval(0).with_precision(x.working_precision());
  for (long i = degree(); i >= 0; --i) sum = sum * x + Interval(coefficient(i), x.working_precision());
  return sum;
}

std::string UnivariatePolynomial::to_string(const std::string& name) const {
  char* raw = fmpq_poly_get_str_pretty(value_, name.c_str());
  std::string text(raw);
  flint_free(raw);
  return text;
}

UnivariatePolynomial gcd(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
  UnivariatePolynomial result;
  fmpq_poly_gcd(result.raw(), a.raw(), b.raw());
  return result;
}

std::pair<UnivariatePolynomial, UnivariatePolynomial> divide(const UnivariatePolynomial& a,
                                                             const UnivariatePolynomial& b) {
  if (b.is_zero()) throw std::domain_error("division by zero");
  UnivariatePolynomial quotient;
  UnivariatePolynomial remainder;
  fmpq_poly_divrem(quotient.raw(), remainder.raw(), a.raw(), b.raw());
  return {quotient, remainder};
}

std::vector<std::pair<UnivariatePolynomial, int>> factor(const UnivariatePolynomial& p) {
  require_nonzero(p);
  const IntegerPolynomial integer(p);
  fmpz_poly_factor_t raw;
  fmpz_poly_factor_init(raw);
  fmpz_poly_factor(raw, integer.get());
  std::vector<std::pair<UnivariatePolynomial, int>> result;
  for (long i = 0; i < raw->num; ++i) {
    UnivariatePolynomial base;
    fmpq_poly_set_fmpz_poly(base.raw(), raw->p + i);
    result.emplace_back(std::move(base), static_cast<int>(raw->exp[i]));
  }
  fmpz_poly_factor_clear(raw);
  return result;
}

std::vector<RealRoot> real_roots(const UnivariatePolynomial& p) {
  std::vector<RealRoot> result;
  for (const auto& [base, multiplicity] : factor(p)) {
    const IntegerPolynomial integer(base);
    const long degree = base.degree();
    std::vector<qqbar_struct> roots(static_cast<std::size_t>(degree));
    for (qqbar_struct& root : roots) qqbar_init(&root);
    constexpr int known_irreducible = 1;
    qqbar_roots_fmpz_poly(roots.data(), integer.get(), known_irreducible);
    for (qqbar_struct& root : roots) {
      if (qqbar_sgn_im(&root) == 0) {
        Algebraic value;
        qqbar_swap(value.raw(), &root);
        result.push_back({std::move(value), multiplicity});
      }
      qqbar_clear(&root);
    }
  }
  std::sort(result.begin(), result.end(),
            [](const RealRoot& a, const RealRoot& b) { return a.value < b.value; });
  return result;
}

int count_roots(const UnivariatePolynomial& p, const Rational& lower, const Rational& upper) {
  require_nonzero(p);
  if (lower > upper) return 0;
  std::vector<UnivariatePolynomial> chain{divide(p, gcd(p, p.derivative())).first};
  chain.push_back(chain[0].derivative());
  while (!chain.back().is_zero()) chain.push_back(-divide(chain[chain.size() - 2], chain.back()).second);
  // Sturm counts the roots in (lower, upper] of a square-free polynomial.
  const int at_lower = chain[0].evaluate(lower).sign() == 0 ? 1 : 0;
  return sign_changes(chain, lower) - sign_changes(chain, upper) + at_lower;
}

std::vector<ComplexRoot> complex_roots(const UnivariatePolynomial& p, long precision) {
  std::vector<ComplexRoot> result;
  for (const auto& [base, multiplicity] : factor(p)) {
    const IntegerPolynomial integer(base);
    const long degree = base.degree();
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, integer.get(), 0, precision);
    for (long i = 0; i < degree; ++i) {
      ComplexRoot root{Interval(Rational(0), precision), Interval(Rational(0), precision), multiplicity};
      arb_set(root.real.raw(), acb_realref(roots + i));
      arb_set(root.imaginary.raw(), acb_imagref(roots + i));
      result.push_back(std::move(root));
    }
    _acb_vec_clear(roots, degree);
  }
  return result;
}

}  // namespace subdiv
