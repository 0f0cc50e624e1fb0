#include "optimize/common_form.h"

#include <algorithm>
#include <map>

#include "optimize/boxes.h"
#include "optimize/taylor_form.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {
namespace {

Polynomial quotient(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  if (!divides(b, a, result)) throw std::logic_error("a common denominator that is none");
  return result;
}

/// Leading coefficient 1: keeps integer factors from piling up.
Polynomial monic(const Polynomial& p) { return p * Polynomial(Rational(1) / p.terms().front().coefficient); }

Polynomial common_denominator(const std::vector<RationalFunction>& functions) {
  Polynomial result(1);
  for (const RationalFunction& f : functions) {
    const Polynomial below = monic(f.denominator());
    result *= quotient(below, gcd(below, result));
  }
  return result;
}

}  // namespace

std::vector<int> CommonForm::members(int k) const {
  std::vector<int> result;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] == k) result.push_back(static_cast<int>(i));
  }
  return result;
}

CommonForm common_form(const Problem& problem) {
  CommonForm form;
  form.denominator = common_denominator(problem.residuals);
  std::vector<Rational> centre;
  for (const Range& range : problem.box) centre.push_back((range.lower + range.upper) / Rational(2));
  if (form.denominator.evaluate<Rational>(centre).sign() < 0) form.denominator = -form.denominator;
  for (const RationalFunction& r : problem.residuals) {
    const Polynomial numerator = r.numerator() * quotient(form.denominator, r.denominator());
    if (numerator.is_zero()) {
      form.representative.push_back(-1);
      continue;
    }
    const Polynomial negative = -numerator;
    const auto known = std::ranges::find_if(
        form.numerators, [&](const Polynomial& p) { return p == numerator || p == negative; });
    form.representative.push_back(static_cast<int>(known - form.numerators.begin()));
    if (known == form.numerators.end()) {
      form.numerators.push_back(numerator);
      form.weights.push_back(0);
    }
    ++form.weights[static_cast<std::size_t>(form.representative.back())];
  }
  return form;
}

CommonForm objective_form(const Problem& problem, const CommonForm& form) {
  CommonForm result = form;
  if (problem.norm == Norm::linf) return result;
  if (problem.norm == Norm::l1) {
    for (std::size_t k = 0; k < form.numerators.size(); ++k)
      result.numerators[k] *= Polynomial(form.weights[k]);
    return result;
  }
  Polynomial total;
  for (std::size_t k = 0; k < form.numerators.size(); ++k) {
    total += Polynomial(form.weights[k]) * form.numerators[k] * form.numerators[k];
  }
  result.numerators = {total};
  result.denominator = form.denominator * form.denominator;
  return result;
}

std::vector<int> spanning_numerators(const CommonForm& form) {
  std::map<std::vector<long>, Eigen::Index> rows;  // of monomials
  for (const Polynomial& p : form.numerators) {
    for (const Polynomial::Term& term : p.terms())
      rows.emplace(term.exponents, static_cast<Eigen::Index>(rows.size()));
  }
  Matrix<Rational> coefficients = zero_matrix<Rational>(static_cast<Eigen::Index>(rows.size()),
                                                        static_cast<Eigen::Index>(form.numerators.size()));
  for (std::size_t k = 0; k < form.numerators.size(); ++k) {
    for (const Polynomial::Term& term : form.numerators[k].terms()) {
      coefficients(rows.at(term.exponents), static_cast<Eigen::Index>(k)) = term.coefficient;
    }
  }
  const auto pivots = row_reduce(std::move(coefficients)).second;
  return {pivots.begin(), pivots.end()};
}

bool is_positive_on(const Polynomial& p, const std::vector<Range>& box, long precision, int max_boxes) {
  if (p.is_constant()) return p.constant().sign() > 0;
  const TaylorForm about_zero(p, static_cast<int>(box.size()), precision);
  std::vector<Box> open{Box{box}};
  for (int examined = 0; !open.empty(); ++examined) {
    if (examined == max_boxes) return false;
    const Box next = std::move(open.back());
    open.pop_back();
    const TaylorForm local = about_zero.shifted(next.centre(precision)).scaled(next.radius(precision));
    if (certainly_positive(Interval(local.least_on_cube()))) continue;
    if (!certainly_positive(local.constant())) return false;
    std::size_t widest = 0;
    for (std::size_t j = 1; j < box.size(); ++j) {
      if (local.influence(static_cast<int>(j)) > local.influence(static_cast<int>(widest))) widest = j;
    }
    for (Box& half : next.halves(widest)) open.push_back(std::move(half));
  }
  return true;
}

}  // namespace subdiv
