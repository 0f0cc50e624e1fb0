#include "analysis/three_tap_smoothness.h"

#include <stdexcept>

namespace subdiv {
namespace {

const Rational spline_tap(1, 4);

void require_factors(int factors) {
  if (factors < 1) throw std::domain_error("a convergent scheme has at least one smoothing factor");
}

/// k when x = 2^k.
std::optional<int> exact_log2(const Algebraic& x) {
  if (!x.is_rational()) return std::nullopt;
  Rational rest = x.to_rational();
  int k = 0;
  for (; rest >= Rational(2); ++k) rest /= Rational(2);
  for (; rest < Rational(1) && rest.sign() > 0; --k) rest *= Rational(2);
  return rest == Rational(1) ? std::optional(k) : std::nullopt;
}

}  // namespace

RealSet three_tap_continuity_set(int factors, int continuity) {
  require_factors(factors);
  if (continuity < 0) throw std::domain_error("the order of continuity is at least 0");
  if (continuity <= factors - 1) return three_tap_radius_below(pow(Rational(2), factors - 1 - continuity));
  // Exponents are at most n, and n only for splines of degree n, which are not C^n; but for p = 1/4.
  if (continuity == factors)
    return {{RealInterval{Algebraic(spline_tap), Algebraic(spline_tap), true, true}}};
  return {};
}

Enclosure minus_log2(int n, const Algebraic& x) {
  if (const auto k = exact_log2(x)) return exact(Rational(n - *k));
  const Interval value = x.to_interval();
  Enclosure result =
      certified(Interval(n) - log(value) / log(Interval(Rational(2), value.working_precision())),
                "closed form, ball arithmetic");
  result.exact = std::to_string(n) + "-log2(" + x.to_string() + ")";
  return result;
}

Enclosure three_tap_exponent(int factors, const Algebraic& p) {
  require_factors(factors);
  if (p == Algebraic(spline_tap)) return exact(Rational(factors + 1));
  const Algebraic radius = three_tap_radius(p);
  if (!(radius < Algebraic(pow(Rational(2), factors - 1)))) throw std::domain_error("the scheme diverges");
  return minus_log2(factors - 1, radius);
}

int three_tap_continuity(int factors, const Algebraic& p) {
  int continuity = -1;
  while (three_tap_continuity_set(factors, continuity + 1).contains(p)) ++continuity;
  return continuity;
}

}  // namespace subdiv
