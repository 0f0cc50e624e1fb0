#include "analysis/expanding_condition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/eigenvalues.h"

namespace subdiv {
namespace {

constexpr long precision = 96;

/// x^0, x^1, .. x^degree for each x.
std::vector<std::vector<Interval>> powers_of(const std::vector<Interval>& x, long degree) {
  std::vector<std::vector<Interval>> result;
  for (const Interval& value : x) {
    result.emplace_back(1, Interval(1));
    for (long k = 1; k <= degree; ++k) result.back().push_back(pow(value, k));
  }
  return result;
}

}  // namespace

std::vector<ExpandingCondition> expanding_conditions(const std::vector<Matrix<RationalFunction>>& family,
                                                     const Word& word) {
  std::vector<ExpandingCondition> result;
  for (const auto& [base, multiplicity] : factor(characteristic_equation(product(family, word))).factors) {
    const std::vector<Polynomial> c = base.coefficients_in(eigenvalue_variable);
    if (c.size() < 2) continue;
    const Polynomial& leading = c.back();
    const Polynomial scale = leading.is_constant() ? Polynomial(Rational(1) / leading.constant()) : leading;
    Polynomial at_one;
    Polynomial at_minus_one;  // times (-1)^degree
    for (std::size_t i = 0; i < c.size(); ++i) {
      at_one += c[i];
      at_minus_one += (c.size() - 1 - i) % 2 == 0 ? c[i] : -c[i];
    }
    for (const Polynomial& g : {at_one, at_minus_one, leading - c[0], leading + c[0]})
      result.push_back({word, g * scale});
  }
  return result;
}

std::vector<ExpandingCondition> expanding_conditions(const std::vector<Matrix<RationalFunction>>& family,
                                                     int longest, const Deadline& deadline) {
  const int letters = static_cast<int>(family.size());
  std::vector<Word> words;
  for (Word word = next_lyndon_word({}, letters, longest); !word.empty();
       word = next_lyndon_word(word, letters, longest)) {
    words.push_back(word);
  }
  std::ranges::stable_sort(words, {}, &Word::size);
  std::vector<ExpandingCondition> result;
  for (const Word& word : words) {
    if (deadline.passed()) break;
    for (ExpandingCondition& condition : expanding_conditions(family, word)) {
      const auto is_it = [&](const ExpandingCondition& known) { return known.g == condition.g; };
      if (std::ranges::none_of(result, is_it)) result.push_back(std::move(condition));
    }
  }
  return result;
}

std::vector<ExpandingCondition> expanding_conditions(const std::vector<Matrix<RationalFunction>>& family,
                                                     int longest) {
  constexpr double for_ever = 1e9;
  return expanding_conditions(family, longest, Deadline(for_ever));
}

RangedPolynomial::RangedPolynomial(const Polynomial& p, std::size_t variables)
    : terms_(terms_of(p, variables)) {
  for (std::size_t k = 0; k < variables; ++k) {
    derivatives_.push_back(terms_of(p.derivative(static_cast<int>(k)), variables));
    degree_ = std::max(degree_, p.degree(static_cast<int>(k)));
  }
}

RangedPolynomial::Terms RangedPolynomial::terms_of(const Polynomial& p, std::size_t variables) {
  Terms result;
  for (Polynomial::Term& term : p.terms()) {
    for (std::size_t k = variables; k < term.exponents.size(); ++k) {
      if (term.exponents[k] != 0) throw std::domain_error("a polynomial uses a variable that has no range");
    }
    term.exponents.resize(variables);
    result.push_back(
        {Interval(term.coefficient, precision), term.coefficient.to_double(), std::move(term.exponents)});
  }
  return result;
}

Interval RangedPolynomial::sum(const Terms& terms, const std::vector<std::vector<Interval>>& powers) {
  Interval total(0);
  for (const Term& term : terms) {
    Interval product = term.coefficient;
    for (std::size_t k = 0; k < powers.size(); ++k) {
      if (term.exponents[k] > 0) product *= powers[k][static_cast<std::size_t>(term.exponents[k])];
    }
    total += product;
  }
  return total;
}

Interval RangedPolynomial::range(const std::vector<Interval>& box) const {
  std::vector<Interval> centre;
  for (const Interval& x : box) centre.push_back(x.center());
  const auto powers = powers_of(box, degree_);
  Interval by_slopes = sum(terms_, powers_of(centre, degree_));
  for (std::size_t k = 0; k < box.size(); ++k)
    by_slopes += sum(derivatives_[k], powers) * (box[k] - centre[k]);
  const Interval plain = sum(terms_, powers);
  return plain.radius() < by_slopes.radius() ? plain : by_slopes;
}

double RangedPolynomial::value(const std::vector<double>& x) const {
  double total = 0;
  for (const Term& term : terms_) {
    double product = term.approximate;
    for (std::size_t k = 0; k < x.size(); ++k)
      product *= std::pow(x[k], static_cast<double>(term.exponents[k]));
    total += product;
  }
  return total;
}

}  // namespace subdiv
