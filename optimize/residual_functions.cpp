#include "optimize/residual_functions.h"

#include <cmath>
#include <stdexcept>

namespace subdiv {

CompiledFunction::Part CompiledFunction::compile(const Polynomial& p, int variables, long precision) {
  Part part;
  for (const Polynomial::Term& term : p.terms()) {
    part.coefficients.emplace_back(term.coefficient, precision);
    part.rounded.push_back(term.coefficient.to_double());
    for (int i = 0; i < max_parameters; ++i) {
      const long exponent = term.exponents[static_cast<std::size_t>(i)];
      if (i < variables) {
        part.exponents.push_back(static_cast<int>(exponent));
      } else if (exponent != 0) {
        throw std::domain_error("a residual depends on a parameter that has no range");
      }
    }
  }
  return part;
}

CompiledFunction::CompiledFunction(const RationalFunction& f, int variables, long precision)
    : numerator_(compile(f.numerator(), variables, precision)) {
  const Polynomial below = f.denominator();
  has_denominator_ = !(below == Polynomial(1));
  if (has_denominator_) denominator_ = compile(below, variables, precision);
}

template <class T>
T CompiledFunction::evaluate_part(const Part& part, const std::vector<T>& coefficients,
                                  std::span<const T> x) {
  const std::size_t variables = x.size();
  if (variables == 1) {  // Horner; terms come in descending powers
    T value(0);
    for (std::size_t t = 0; t < coefficients.size(); ++t) {
      value += coefficients[t];
      const int next = t + 1 < coefficients.size() ? part.exponents[t + 1] : 0;
      for (int k = part.exponents[t]; k > next; --k) value *= x[0];
    }
    return value;
  }
  std::vector<std::vector<T>> powers(variables, std::vector<T>{T(1)});
  T sum(0);
  for (std::size_t t = 0; t < coefficients.size(); ++t) {
    T product = coefficients[t];
    for (std::size_t i = 0; i < variables; ++i) {
      const auto exponent = static_cast<std::size_t>(part.exponents[t * variables + i]);
      while (powers[i].size() <= exponent) powers[i].push_back(powers[i].back() * x[i]);
      if (exponent > 0) product *= powers[i][exponent];
    }
    sum += product;
  }
  return sum;
}

double CompiledFunction::evaluate(std::span<const double> x) const {
  const double above = evaluate_part(numerator_, numerator_.rounded, x);
  return has_denominator_ ? above / evaluate_part(denominator_, denominator_.rounded, x) : above;
}

Interval CompiledFunction::evaluate(std::span<const Interval> x) const {
  Interval above = evaluate_part(numerator_, numerator_.coefficients, x);
  return has_denominator_ ? above / evaluate_part(denominator_, denominator_.coefficients, x) : above;
}

bool CompiledFunction::may_have_pole(std::span<const Interval> x) const {
  return has_denominator_ && evaluate_part(denominator_, denominator_.coefficients, x).contains_zero();
}

CompiledResidual compile(const RationalFunction& residual, int variables, long precision) {
  CompiledResidual result{CompiledFunction(residual, variables, precision), {}};
  for (int i = 0; i < variables; ++i) {
    result.gradient.emplace_back(residual.derivative(i), variables, precision);
  }
  return result;
}

std::vector<CompiledResidual> compile(const Problem& problem, long precision) {
  std::vector<CompiledResidual> result;
  const int variables = static_cast<int>(problem.box.size());
  for (const RationalFunction& r : problem.residuals) result.push_back(compile(r, variables, precision));
  return result;
}

double objective(Norm norm, std::span<const double> residuals) {
  double total = 0;
  for (const double r : residuals) {
    if (norm == Norm::linf) {
      total = std::max(total, std::abs(r));
    } else {
      total += norm == Norm::l1 ? std::abs(r) : r * r;
    }
  }
  return total;
}

Interval objective(Norm norm, std::span<const Interval> residuals) {
  Interval total(0);
  for (const Interval& r : residuals) {
    if (norm == Norm::linf) {
      total = max(total, abs(r));
    } else {
      total += norm == Norm::l1 ? abs(r) : pow(r, 2);
    }
  }
  return total;
}

}  // namespace subdiv
