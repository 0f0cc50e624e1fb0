#include "analysis/unstable_conditions.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

namespace subdiv {
namespace {

/// The part of b at even or odd powers as a polynomial in y = z^2, over a common denominator.
Polynomial part_of(const Laurent<Polynomial>& b, int parity) {
  const Polynomial y = Polynomial::variable(symbol_variable);
  Polynomial result;
  for (int i = parity; i <= b.last(); i += 2) result += b[i] * pow(y, static_cast<unsigned>(i / 2));
  return result;
}

/// b times a common denominator of its coefficients, first power 0.
Laurent<Polynomial> without_denominators(const Laurent<RationalFunction>& b) {
  Polynomial denominator(1);
  for (const RationalFunction& c : b.coefficients()) denominator *= c.denominator();
  const Laurent<Polynomial> result = map_coefficients(b, [&](const RationalFunction& c) {
    const RationalFunction scaled = c * RationalFunction(denominator);
    return scaled.numerator() * Polynomial(Rational(1) / scaled.denominator().constant());
  });
  return shift(result, -result.first());
}

/// 1 - z + z^2 - .. : its roots are the negatives of the primitive m-th roots of unity, m an odd prime.
Laurent<Polynomial> opposite_cyclotomic(int m) {
  std::vector<Polynomial> c;
  for (int i = 0; i < m; ++i) c.emplace_back(i % 2 == 0 ? 1 : -1);
  return {0, std::move(c)};
}

/// p divided by a constant, so that the highest coefficient is 1.
Polynomial monic(const Polynomial& p) { return p * Polynomial(Rational(1) / p.terms().front().coefficient); }

bool uses_only(const Polynomial& p, int variable) {
  for (int i = 0; i < max_parameters; ++i) {
    if (i != variable && p.uses(i)) return false;
  }
  return true;
}

/// Equations in one variable with no common root.
bool contradict(const std::vector<Polynomial>& equations) {
  for (int variable = 0; variable < max_parameters; ++variable) {
    Polynomial common;
    for (const Polynomial& e : equations) {
      if (uses_only(e, variable)) common = gcd(common, e);
    }
    if (!common.is_zero() && common.is_constant()) return true;
  }
  return false;
}

std::optional<UnstableCondition> cycle_condition(const Laurent<Polynomial>& b, int m) {
  if (b.size() < m) return std::nullopt;
  UnstableCondition condition{m, {}};
  const Laurent<Polynomial> remainder = divide_from_below(b, opposite_cyclotomic(m)).second;
  for (const Polynomial& c : remainder.coefficients()) {
    if (c.is_zero()) continue;
    const Polynomial equation = monic(c);
    const bool known =
        std::ranges::any_of(condition.equations, [&](const Polynomial& e) { return e == equation; });
    if (!known) condition.equations.push_back(equation);
  }
  return contradict(condition.equations) ? std::nullopt : std::optional(condition);
}

}  // namespace

std::vector<UnstableCondition> unstable_conditions(const Laurent<RationalFunction>& b) {
  if (b.is_zero() || b.size() > 5)
    throw std::domain_error("a symbol with one to five coefficients is needed");
  const Laurent<Polynomial> p = without_denominators(b);
  std::vector<UnstableCondition> result;
  const Polynomial even = part_of(p, 0);
  const Polynomial odd = part_of(p, 1);
  const Polynomial common =
      odd.is_zero() || even.is_zero() ? Polynomial(0) : resultant(even, odd, symbol_variable);
  if (common.is_zero()) {
    if (b.size() > 1) result.push_back({0, {}});
  } else if (!common.is_constant()) {
    for (auto& [base, multiplicity] : factor(common).factors) result.push_back({0, {base}});
  }
  for (const int m : {3, 5}) {
    if (auto condition = cycle_condition(p, m)) result.push_back(std::move(*condition));
  }
  return result;
}

}  // namespace subdiv
