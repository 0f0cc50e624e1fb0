#include "analysis/sobolev.h"

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
  const JointSpectralRadius radius = joint_spectral_radius(std::vector{std::move(transfer)}, budget);
  const Rational offset = Rational(form.factors) - Rational(1, 2);
  Enclosure result = minus_logarithm(offset, form.arity, 2, radius.value, radius.exact);
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
