#include "analysis/sobolev.h"

#include <algorithm>
#include <utility>

#include "analysis/logarithm.h"

namespace subdiv {
namespace {

template <class R>
Enclosure exponent(const NormalForm<R>& form, const JointSpectralRadiusBudget& budget) {
  const Laurent<R> r = form.b * reverse(form.b);
  const int most = form.degree() / (form.arity - 1);
  Matrix<R> transfer(2 * most + 1, 2 * most + 1);
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) transfer(i + most, j + most) = r[form.arity * i - j];
  }
  JointSpectralRadius radius = joint_spectral_radius(std::vector{std::move(transfer)}, budget);
  // The central one of at most about 2 K m^k coefficients of the k-th iterate of r, with sum 1, is the
  // largest.
  const Rational least(1, form.arity);
  radius.value.lower = std::max(radius.value.lower, least);
  radius.value.upper = std::max(radius.value.upper, least);
  const Rational offset = Rational(form.factors) - Rational(1, 2);
  Enclosure result = minus_logarithm(offset, form.arity, 2, radius.value, radius.exact);
  if (radius.value.lower == least && may_have_more_factors(form)) {
    const int factors = form.factors + most;
    result.upper = std::max(result.upper, Rational(factors) + Rational(1, 2));
    result.status = Status::ambiguous;
  }
  result.method = "largest eigenvalue of the transfer operator";
  return result;
}

}  // namespace

Enclosure sobolev_exponent(const NormalForm<Rational>& form, const JointSpectralRadiusBudget& budget) {
  return exponent(form, budget);
}

Enclosure sobolev_exponent(const NormalForm<Interval>& form, const JointSpectralRadiusBudget& budget) {
  return exponent(form, budget);
}

}  // namespace subdiv
