#include "analysis/bernstein_form.h"

#include <cstdint>

namespace subdiv {
namespace {

Rational binomial(std::size_t n, std::size_t k) {
  Rational result(1);
  for (std::size_t i = 1; i <= k; ++i)
    result *= Rational(static_cast<std::int64_t>(n - k + i), static_cast<std::int64_t>(i));
  return result;
}

}  // namespace

BernsteinForm::BernsteinForm(const Polynomial& f, const ParameterBox& cell) {
  Polynomial moved = f;  // in u and v
  for (int k = 0; k < 2; ++k) {
    const auto slot = static_cast<std::size_t>(k);
    degree_.at(slot) = static_cast<std::size_t>(f.degree(k));
    moved =
        moved.substitute(k, Polynomial(cell.lower[slot]) +
                                Polynomial(cell.upper[slot] - cell.lower[slot]) * Polynomial::variable(k));
  }
  c_.assign((degree_[0] + 1) * (degree_[1] + 1), Rational(0));
  for (const Polynomial::Term& term : moved.terms())
    entry(true, static_cast<std::size_t>(term.exponents[1]), static_cast<std::size_t>(term.exponents[0])) =
        term.coefficient;
  // u^k = sum over i >= k of binomial(i, k)/binomial(n, k) B_i(u), along one direction, then the other.
  for (const bool first : {true, false}) {
    const std::size_t n = degree_.at(first ? 0 : 1);
    for (std::size_t line = 0; line <= degree_.at(first ? 1 : 0); ++line) {
      for (std::size_t k = 0; k <= n; ++k) entry(first, line, k) /= binomial(n, k);
      for (std::size_t i = n + 1; i-- > 0;) {
        Rational sum(0);
        for (std::size_t k = 0; k <= i; ++k) sum += binomial(i, k) * entry(first, line, k);
        entry(first, line, i) = sum;
      }
    }
  }
}

bool BernsteinForm::has_sign(int sign, const std::array<bool, 4>& free) const {
  std::vector<bool> corner(c_.size(), false);
  std::vector<bool> fixed(c_.size(), false);
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::size_t slot = corner_slot(k >= 2, k % 2 != 0);
    corner[slot] = true;
    fixed[slot] = fixed[slot] || !free.at(k);
  }
  for (std::size_t k = 0; k < c_.size(); ++k) {
    const int own = c_[k].sign();
    if (own != sign && !(own == 0 && corner[k] && !fixed[k])) return false;
  }
  return true;  // not all are 0, as f is not
}

std::array<BernsteinForm, 2> BernsteinForm::halves(bool first) const {
  std::array<BernsteinForm, 2> result{*this, *this};
  BernsteinForm& low = result[0];
  BernsteinForm& high = result[1];
  const Rational half(1, 2);
  const std::size_t n = degree_.at(first ? 0 : 1);
  for (std::size_t line = 0; line <= degree_.at(first ? 1 : 0); ++line) {
    for (std::size_t level = 0; level <= n; ++level) {
      low.entry(first, line, level) = high.entry(first, line, 0);
      for (std::size_t i = 0; i + level < n; ++i) {
        Rational& point = high.entry(first, line, i);
        point = half * (point + high.entry(first, line, i + 1));
      }
    }
  }
  return result;
}

}  // namespace subdiv
