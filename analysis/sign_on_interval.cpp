#include "analysis/sign_on_interval.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "schemes/algebra/specialize.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

void require_points(const RealInterval& range) {
  if (!range.lower || !range.upper || *range.lower < *range.upper) return;
  if (range.is_point() && range.lower_closed && range.upper_closed) return;
  throw std::domain_error("an empty interval");
}

bool is_inside(const Algebraic& x, const RealInterval& range) {
  return (!range.lower || *range.lower < x) && (!range.upper || x < *range.upper);
}

/// Where a polynomial vanishes in an interval.
struct Roots {
  bool at_lower = false;
  bool at_upper = false;
  bool inside = false;
  bool sign_change = false;  // a root of odd multiplicity inside
};

void note_root(const Algebraic& x, int multiplicity, const RealInterval& range, Roots& roots) {
  if (range.lower && *range.lower == x) roots.at_lower = true;
  if (range.upper && *range.upper == x) roots.at_upper = true;
  if (!is_inside(x, range)) return;
  roots.inside = true;
  roots.sign_change = roots.sign_change || multiplicity % 2 != 0;
}

/// Divides f by the minimal polynomial of an end as often as possible, and notes its roots.
void take_end(UnivariatePolynomial& f, const std::optional<Algebraic>& end, const RealInterval& range,
              Roots& roots) {
  if (!end) return;
  const UnivariatePolynomial minimal(end->minimal_polynomial());
  int multiplicity = 0;
  for (auto [quotient, rest] = divide(f, minimal); rest.is_zero();
       std::tie(quotient, rest) = divide(f, minimal)) {
    f = quotient;
    ++multiplicity;
  }
  if (multiplicity == 0) return;
  for (const RealRoot& root : real_roots(minimal)) note_root(root.value, multiplicity, range, roots);
}

/// No root of f has a larger modulus (Cauchy).
Rational root_bound(const UnivariatePolynomial& f) {
  Rational largest(0);
  for (long i = 0; i < f.degree(); ++i)
    largest = std::max(largest, abs(f.coefficient(i) / f.coefficient(f.degree())));
  return largest + Rational(1);
}

/// f(a + b x).
UnivariatePolynomial compose(const UnivariatePolynomial& f, const Rational& a, const Rational& b) {
  const UnivariatePolynomial line(std::vector<Rational>{a, b});
  UnivariatePolynomial result;
  for (long i = f.degree(); i >= 0; --i) result = result * line + UnivariatePolynomial(f.coefficient(i));
  return result;
}

/// The sign changes in the coefficients of (1 + x)^n f(1 / (1 + x)): at least the number of roots in (0, 1),
/// and as many modulo 2 (Descartes).
int descartes_bound(const UnivariatePolynomial& f) {
  std::vector<Rational> reversed;
  for (long i = f.degree(); i >= 0; --i) reversed.push_back(f.coefficient(i));
  const UnivariatePolynomial g = compose(UnivariatePolynomial(reversed), Rational(1), Rational(1));
  int changes = 0;
  int last = 0;
  for (long i = 0; i <= g.degree(); ++i) {
    const int sign = g.coefficient(i).sign();
    if (sign * last < 0) ++changes;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// Whether it is proved, with so many bisections, that f has no root in [0, 1].
bool is_rootless(const UnivariatePolynomial& f, int bisections) {
  if (f.coefficient(0).sign() == 0 || f.evaluate(Rational(1)).sign() == 0) return false;
  const int bound = descartes_bound(f);
  if (bound <= 1) return bound == 0;
  const Rational half(1, 2);
  return bisections > 0 && is_rootless(compose(f, Rational(0), half), bisections - 1) &&
         is_rootless(compose(f, half, half), bisections - 1);
}

/// Proves mostly, and quickly, that f has no root in the closed range; false means "not proved".
bool is_rootless_nearby(const UnivariatePolynomial& f, const RealInterval& range) {
  const Rational lower = range.lower ? range.lower->to_interval().lower() : -root_bound(f);
  const Rational upper = range.upper ? range.upper->to_interval().upper() : root_bound(f);
  constexpr int bisections = 10;
  return lower > upper || is_rootless(compose(f, lower, upper - lower), bisections);
}

/// f is not zero.
Roots roots_in(const Polynomial& polynomial, const RealInterval& range) {
  UnivariatePolynomial f(polynomial, 0);
  Roots roots;
  take_end(f, range.lower, range, roots);
  take_end(f, range.upper, range, roots);
  if (range.is_point() || f.degree() <= 0 || is_rootless_nearby(f, range)) return roots;
  for (const RealRoot& root : real_roots(f)) note_root(root.value, root.multiplicity, range, roots);
  return roots;
}

/// The sign of f somewhere in the interior where it does not vanish; f is not zero and has no pole there.
int sign_inside(const RationalFunction& f, RealInterval range) {
  if (range.is_point()) {
    return range.lower->is_rational() ? specialize(f, 0, range.lower->to_rational()).sign()
                                      : specialize(f, 0, *range.lower).sign();
  }
  for (;;) {
    const Rational at = sample(range);
    const Rational value = specialize(f, 0, at);
    if (value.sign() != 0) return value.sign();
    range.upper = Algebraic(at);
  }
}

}  // namespace

bool has_no_root(const Polynomial& f, const RealInterval& range) {
  require_points(range);
  if (f.is_zero()) return false;
  const Roots roots = roots_in(f, range);
  return !roots.inside && !(roots.at_lower && range.lower_closed) && !(roots.at_upper && range.upper_closed);
}

bool is_finite(const RationalFunction& f, const RealInterval& range) {
  const Polynomial below = f.denominator();
  return below.is_constant() || has_no_root(below, range);
}

bool is_positive(const RationalFunction& f, const RealInterval& range) {
  return is_finite(f, range) && has_no_root(f.numerator(), range) && sign_inside(f, range) > 0;
}

bool is_nonnegative(const RationalFunction& f, const RealInterval& range) {
  require_points(range);
  if (f.is_zero()) return true;
  return is_finite(f, range) && !roots_in(f.numerator(), range).sign_change && sign_inside(f, range) >= 0;
}

Rational sample(const RealInterval& range) {
  require_points(range);
  if (range.is_point()) return range.lower->to_rational();
  if (range.lower && range.upper) return rational_between(*range.lower, *range.upper);
  if (range.lower) return floor(range.lower->to_interval().upper()) + Rational(1);
  if (range.upper) return floor(range.upper->to_interval().lower()) - Rational(1);
  return 0;
}

RealInterval closed_interval(const Rational& lower, const Rational& upper) {
  return {Algebraic(lower), Algebraic(upper), true, true};
}

RealInterval open_interval(const Rational& lower, const Rational& upper) {
  return {Algebraic(lower), Algebraic(upper), false, false};
}

}  // namespace subdiv
