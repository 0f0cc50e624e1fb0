#include "analysis/transition_matrices.h"

namespace subdiv {
namespace {

/// The first coefficients of 1 / sigma(z)^power = ((1 - z) / (1 - z^m))^power.
std::vector<Rational> inverse_series(int arity, int power, int length) {
  const auto size = static_cast<std::size_t>(length);
  const auto m = static_cast<std::size_t>(arity);
  std::vector<Rational> series(size, Rational(0));
  if (size > 0) series[0] = Rational(1);
  for (int p = 0; p < power; ++p) {
    for (std::size_t i = size; i-- > 1;) series[i] -= series[i - 1];
    for (std::size_t i = m; i < size; ++i) series[i] += series[i - m];
  }
  return series;
}

const Interval& narrower(const Interval& a, const Interval& b) { return a.radius() <= b.radius() ? a : b; }

}  // namespace

NormalForm<Interval> normal_form(const Mask<Interval>& mask, int factors) {
  const std::vector<Interval>& a = mask.symbol.coefficients();
  const int length = static_cast<int>(a.size()) - factors * (mask.arity - 1);
  if (length < 1) throw std::domain_error("so many sum rules force the symbol to be zero");
  // Quotients of power series from either end: both hold, the one nearer to its end is narrower.
  const std::vector<Rational> series = inverse_series(mask.arity, factors, length);
  const auto size = static_cast<std::size_t>(length);
  std::vector<Interval> quotient;
  for (std::size_t i = 0; i < size; ++i) {
    Interval below(0);
    for (std::size_t j = 0; j <= i; ++j) below += Interval(series[i - j], a[j].working_precision()) * a[j];
    Interval above(0);
    for (std::size_t j = 0; j < size - i; ++j) {
      const Interval& c = a[a.size() - 1 - j];
      above += Interval(series[size - 1 - i - j], c.working_precision()) * c;
    }
    if (!below.overlaps(above)) throw std::domain_error("the coefficients contradict the assumed sum rules");
    quotient.push_back(narrower(below, above));
  }
  Laurent<Interval> cofactor(mask.symbol.first(), std::move(quotient));
  const Laurent<Interval> product = pow(smoothing_factor<Interval>(mask.arity), factors) * cofactor;
  for (int i = mask.symbol.first(); i <= mask.symbol.last(); ++i) {
    if (!product[i].overlaps(mask.symbol[i])) {
      throw std::domain_error("the coefficients contradict the assumed sum rules");
    }
  }
  return normal_form(mask.arity, factors, cofactor);
}

}  // namespace subdiv
