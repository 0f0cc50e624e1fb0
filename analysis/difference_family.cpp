#include "analysis/difference_family.h"

#include <stdexcept>
#include <utility>

#include "analysis/iterate_norm.h"

namespace subdiv {
namespace {

/// The family's vector of one class over a ring into which Q[s] has been sent. Digits count from the family's
/// own lowest power and vectors have the family's length, whatever coefficients vanish for a value of s.
template <class R>
std::vector<R> class_vector(const DifferenceFamily& family, const Laurent<R>& d, const ClassWord& word) {
  const int n = class_size(family.symbol, family.arity);
  std::vector<R> v(static_cast<std::size_t>(n), R(0));
  v[0] = R(1);
  for (const int digit : word) {
    std::vector<R> next(v.size(), R(0));
    for (int l = 0; l < n; ++l) {
      for (int j = 0; j < n; ++j) {
        const R coefficient = d[family.symbol.first() + digit + family.arity * l - j];
        next[static_cast<std::size_t>(l)] += coefficient * v[static_cast<std::size_t>(j)];
      }
    }
    v = std::move(next);
  }
  return v;
}

UnivariatePolynomial polynomial_in_s(const RationalFunction& f) {
  if (!f.denominator().is_constant()) throw std::domain_error("a mask's coefficients must be polynomials");
  const Rational denominator = f.denominator().constant();
  return UnivariatePolynomial(f.numerator(), 0) * UnivariatePolynomial(Rational(1) / denominator);
}

}  // namespace

DifferenceFamily difference_family(const Mask<RationalFunction>& mask, int continuity) {
  const auto d = difference_symbol(mask, continuity);
  if (!d) throw std::domain_error("the scheme has too few smoothing factors for this order of continuity");
  return {mask.arity, map_coefficients(*d, polynomial_in_s)};
}

DifferenceFamily reflected(const DifferenceFamily& family) {
  const auto reflect = [](const UnivariatePolynomial& p) {
    std::vector<Rational> coefficients;
    for (long i = 0; i <= p.degree(); ++i) {
      coefficients.push_back(i % 2 == 0 ? p.coefficient(i) : -p.coefficient(i));
    }
    return UnivariatePolynomial(coefficients);
  };
  return {family.arity, map_coefficients(family.symbol, reflect)};
}

std::vector<UnivariatePolynomial> class_polynomials(const DifferenceFamily& family, const ClassWord& word) {
  return class_vector(family, family.symbol, word);
}

Rational class_norm(const DifferenceFamily& family, const ClassWord& word, const Rational& s) {
  const auto at_s = [&](const UnivariatePolynomial& p) { return p.evaluate(s); };
  Rational sum;
  for (const Rational& x : class_vector(family, map_coefficients(family.symbol, at_s), word)) sum += abs(x);
  return sum;
}

std::vector<Algebraic> divisible_parameters(const Mask<RationalFunction>& mask, int continuity) {
  const auto power = pow(smoothing_factor<RationalFunction>(mask.arity), continuity + 1);
  UnivariatePolynomial common;
  const auto division = divide_from_below(mask.symbol, power);
  for (const RationalFunction& c : division.second.coefficients()) common = gcd(common, polynomial_in_s(c));
  if (common.is_zero()) throw std::domain_error("the division is exact for every value of the parameter");
  std::vector<Algebraic> result;
  if (common.degree() == 0) return result;
  for (const RealRoot& root : real_roots(common)) result.push_back(root.value);
  return result;
}

}  // namespace subdiv
