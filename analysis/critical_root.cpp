#include "analysis/critical_root.h"

#include <algorithm>
#include <utility>

#include "schemes/algebra/interval.h"

namespace subdiv {
namespace {

/// The sign of p on the whole of [lower, upper], by the mean-value form; 0 for the zero polynomial, nothing
/// when unknown.
std::optional<int> sign_on(const UnivariatePolynomial& p, const Rational& lower, const Rational& upper) {
  if (p.is_zero()) return 0;
  constexpr long precision = 256;
  const Interval box = Interval::hull(lower, upper, precision);
  const Rational center = (lower + upper) / Rational(2);
  const Interval offset = box - Interval(center, precision);
  const Interval value = Interval(p.evaluate(center), precision) + p.derivative().evaluate(box) * offset;
  if (certainly_positive(value)) return 1;
  if (certainly_negative(value)) return -1;
  return std::nullopt;
}

/// The sign of p on [lower, root), where p may vanish at the root: the sign of what is left without its
/// factors (s - root).
std::optional<int> sign_before(UnivariatePolynomial p, const Rational& lower, const Rational& root) {
  if (p.is_zero()) return 0;
  const UnivariatePolynomial to_root({root, Rational(-1)});
  while (p.evaluate(root).sign() == 0) p = divide(p, to_root).first;
  return sign_on(p, lower, root);
}

/// The norm of a class minus 1 as a polynomial, where sign(p) tells the sign of a coefficient; nothing when
/// it does not.
template <class Sign>
std::optional<UnivariatePolynomial> excess(const DifferenceFamily& family, const ClassWord& word, Sign sign) {
  UnivariatePolynomial sum(-1);
  for (const UnivariatePolynomial& p : class_polynomials(family, word)) {
    const std::optional<int> known = sign(p);
    if (!known) return std::nullopt;
    sum += p * UnivariatePolynomial(*known);
  }
  return sum;
}

/// Bisects [lower, upper], p(lower) < 0 <= p(upper), p increasing, down to about 2^-80.
IsolatedRoot bisect(const UnivariatePolynomial& p, Rational lower, Rational upper) {
  const Rational width = Rational::power_of_two(-80);
  while (upper - lower > width) {
    const Rational middle = (lower + upper) / Rational(2);
    (p.evaluate(middle).sign() < 0 ? lower : upper) = middle;
  }
  return {lower, upper, std::nullopt, p.degree()};
}

/// The root in closed form if it belongs to a factor of degree 1 or 2.
std::optional<Algebraic> closed_form(const UnivariatePolynomial& p, const IsolatedRoot& root) {
  for (const auto& [base, multiplicity] : factor(p)) {
    if (base.degree() > 2 || count_roots(base, root.lower, root.upper) == 0) continue;
    for (const RealRoot& candidate : real_roots(base)) {
      if (Algebraic(root.lower) <= candidate.value && candidate.value <= Algebraic(root.upper))
        return candidate.value;
    }
  }
  return std::nullopt;
}

bool same_root(const UnivariatePolynomial& p, const UnivariatePolynomial& q, const IsolatedRoot& root) {
  const UnivariatePolynomial common = gcd(p, q);
  return common.degree() > 0 && count_roots(common, root.lower, root.upper) > 0;
}

}  // namespace

std::optional<IsolatedRoot> first_critical_root(const DifferenceFamily& family,
                                                const std::vector<ClassWord>& classes, const Rational& inside,
                                                const Rational& outside) {
  std::vector<UnivariatePolynomial> excesses;
  for (const ClassWord& word : classes) {
    const auto p = excess(family, word, [&](const auto& c) { return sign_on(c, inside, outside); });
    if (!p) return std::nullopt;
    if (sign_on(*p, inside, outside) == -1) continue;
    if (sign_on(p->derivative(), inside, outside) != 1 || p->evaluate(inside).sign() >= 0)
      return std::nullopt;
    if (p->evaluate(outside).sign() < 0) continue;
    if (std::find(excesses.begin(), excesses.end(), *p) == excesses.end()) excesses.push_back(*p);
  }
  std::optional<IsolatedRoot> first;
  const UnivariatePolynomial* of_first = nullptr;
  for (const UnivariatePolynomial& p : excesses) {
    const IsolatedRoot root = bisect(p, inside, outside);
    if (!first || root.upper < first->lower) {
      first = root;
      of_first = &p;
    } else if (root.lower <= first->upper && !same_root(p, *of_first, *first)) {
      return std::nullopt;
    }
  }
  if (first) first->exact = closed_form(*of_first, *first);
  return first;
}

bool reaches_one_first_at(const DifferenceFamily& family, const std::vector<ClassWord>& classes,
                          const Rational& inside, const Rational& root) {
  const auto sign = [&](const UnivariatePolynomial& p) { return sign_before(p, inside, root); };
  bool reached = false;
  for (const ClassWord& word : classes) {
    const auto p = excess(family, word, sign);
    if (!p || sign(*p) != -1) return false;
    reached = reached || p->evaluate(root).sign() == 0;
  }
  return reached;
}

}  // namespace subdiv
