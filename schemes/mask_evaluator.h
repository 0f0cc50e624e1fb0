#pragma once

#include <functional>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "schemes/mask.h"
#include "schemes/scheme_description.h"
#include "schemes/symbol_expression.h"

// How schemes/instantiate.h evaluates a description.
namespace subdiv::detail {

/// " at s = -6, t = 1/2": the values under which something failed.
[[nodiscard]] std::string values_text(const StepDescription& step);
/// Throws InputError unless the mask is neither zero nor too long.
void require_size(const StepDescription& step, int size);
/// Throws InputError that says by how much the sum misses the arity.
[[noreturn]] void reject_sum(const SchemeDescription& scheme, const StepDescription& step,
                             const std::string& sum, const std::string& miss);
/// Text for a message: the exact value, and its size where that is hard to see.
[[nodiscard]] std::string shown(const Rational& x);
[[nodiscard]] std::string shown(const Algebraic& x);

/// Evaluates the steps of a scheme over R, with given values for the free parameters and a way to represent
/// numbers (ExactLiteral or IntervalLiteral).
template <class R, class Literal>
class Evaluator {
 public:
  Evaluator(const SchemeDescription& scheme, std::span<const R> free_values, Literal literal)
      : scheme_(scheme), literal_(literal) {
    if (free_values.size() != scheme.free_parameters.size()) {
      throw std::domain_error("a scheme needs one value for each of its free parameters");
    }
    for (std::size_t i = 0; i < free_values.size(); ++i)
      free_.emplace(scheme.free_parameters[i], free_values[i]);
  }

  [[nodiscard]] FactoredSymbol<R> factored_symbol(const StepDescription& step) const {
    return in_step(step, [&](const Bindings<R>& bindings) -> FactoredSymbol<R> {
      if (!step.file || !step.file->symbol) return {0, symbol(step, bindings)};
      return in_place(step.file->symbol_place(), [&] {
        return subdiv::factored_symbol(step.file->symbol->expression, step.file->arity, bindings, literal_);
      });
    });
  }

  [[nodiscard]] Mask<R> mask(const StepDescription& step) const {
    Mask<R> result{step.arity(), in_step(step, [&](const Bindings<R>& b) { return symbol(step, b); })};
    require_size(step, result.symbol.size());
    require_sum(step, result);
    return result;
  }

 private:
  /// The values of a step's parameters.
  [[nodiscard]] Bindings<R> bind(const StepDescription& step) const {
    const auto lookup = [&](const std::string& name, const Expression::Node& /*node*/) {
      return free_.at(name);
    };
    const auto exact = [&](const Rational& number, const Rational&) { return literal_(number, Rational(0)); };
    Bindings<R> result;
    for (const Argument& argument : step.arguments) {
      const Expression& value = argument.value;
      try {
        result.values.emplace(argument.name, evaluate<R>(value, value.root(), lookup, exact));
        if (value.names().empty()) result.rational.emplace(argument.name, evaluate_constant<Rational>(value));
      } catch (const OutsideRingError& error) {
        if (!result.values.contains(argument.name)) {
          throw OutsideRingError(in_quotes(step.text) + ": value of " + argument.name + ", " + error.what());
        }
      } catch (const InputError& error) {
        throw InputError(in_quotes(step.text) + ": value of " + argument.name + ", " + error.what());
      }
    }
    return result;
  }

  [[nodiscard]] Laurent<R> family_symbol(const StepDescription& step, const Bindings<R>& bindings) const {
    std::vector<R> real_values;
    for (const Parameter& parameter : step.form->parameters) {
      if (!parameter.whole) real_values.push_back(bindings.values.at(parameter.name));
    }
    const auto at_values = [&](const Polynomial& coefficient) {
      R sum(0);
      for (const Polynomial::Term& term : coefficient.terms()) {
        R product = literal_(term.coefficient, Rational(0));
        for (std::size_t i = 0; i < real_values.size(); ++i) {
          for (long k = 0; k < term.exponents[i]; ++k) product = product * real_values[i];
        }
        sum = sum + product;
      }
      return sum;
    };
    return map_coefficients(step.form->mask(step.whole).symbol, at_values);
  }

  [[nodiscard]] Laurent<R> file_symbol(const SchemeFile& file, const Bindings<R>& bindings) const {
    if (file.symbol) {
      return in_place(file.symbol_place(),
                      [&] { return symbol_value(file.symbol->expression, bindings, literal_); });
    }
    const auto lookup = [&](const std::string& name, const Expression::Node&) {
      return bindings.values.at(name);
    };
    std::vector<R> coefficients;
    for (std::size_t i = 0; i < file.coefficients.size(); ++i) {
      const Expression& value = file.coefficients[i].expression;
      coefficients.push_back(in_place(file.coefficient_place(i),
                                      [&] { return evaluate<R>(value, value.root(), lookup, literal_); }));
    }
    return Laurent<R>(file.first, std::move(coefficients));
  }

  [[nodiscard]] Laurent<R> symbol(const StepDescription& step, const Bindings<R>& bindings) const {
    return step.file ? file_symbol(*step.file, bindings) : family_symbol(step, bindings);
  }

  /// Runs a computation with a step's values; they close the message of its InputError.
  template <class Computation>
  auto in_step(const StepDescription& step, const Computation& computation) const {
    const Bindings<R> bindings = bind(step);
    try {
      return computation(bindings);
    } catch (const OutsideRingError& error) {
      throw OutsideRingError(error.what() + values_text(step));
    } catch (const InputError& error) {
      throw InputError(error.what() + values_text(step));
    }
  }

  /// Runs a computation; the place opens the message of its InputError.
  template <class Computation>
  static auto in_place(const std::string& place, const Computation& computation) {
    try {
      return computation();
    } catch (const OutsideRingError& error) {
      throw OutsideRingError(place + ": " + error.what());
    } catch (const InputError& error) {
      throw InputError(place + ": " + error.what());
    }
  }

  void require_sum(const StepDescription& step, const Mask<R>& mask) const {
    const R total = sum(mask.symbol);
    const R miss = total - R(mask.arity);
    if constexpr (ExactRing<R>) {
      if (!scheme_.rounded && !is_zero(miss)) reject(step, total, miss);
    } else if constexpr (std::is_same_v<R, Interval>) {
      const bool checked = !scheme_.rounded || !literal_.decimals_are_exact;
      if (checked && !miss.contains_zero()) reject_sum(scheme_, step, total.to_string(), miss.to_string());
    }
  }
  [[noreturn]] void reject(const StepDescription& step, const R& total, const R& miss) const {
    if constexpr (std::is_same_v<R, RationalFunction>) {
      const std::vector<std::string>& names = scheme_.free_parameters;
      reject_sum(scheme_, step, total.to_string(names), miss.to_string(names));
    } else if constexpr (std::is_same_v<R, Rational>) {
      reject_sum(scheme_, step, shown(total), shown(miss));
    } else {
      reject_sum(scheme_, step, shown(total), shown(miss));
    }
  }

  const SchemeDescription& scheme_;
  Literal literal_;
  std::map<std::string, R, std::less<>> free_;
};

}  // namespace subdiv::detail
