#include "schemes/instantiate.h"

#include <algorithm>

#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

bool holds_rationals_only(const Scheme<Algebraic>& scheme) {
  return std::all_of(scheme.steps.begin(), scheme.steps.end(), [](const Mask<Algebraic>& mask) {
    const std::vector<Algebraic>& c = mask.symbol.coefficients();
    return std::all_of(c.begin(), c.end(), [](const Algebraic& x) { return x.is_rational(); });
  });
}

/// Whether the step's sum can be the arity once every decimal is taken as rounded.
bool sums_within_rounding(const SchemeDescription& scheme, const StepDescription& step) {
  if (scheme.rounded || !scheme.free_parameters.empty() || !step.file || !step.file->has_decimals())
    return false;
  SchemeDescription rounded{step.text, {step}, {}, true};
  try {
    static_cast<void>(interval_scheme(rounded));
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

namespace detail {

std::string values_text(const StepDescription& step) {
  std::vector<std::string> values;
  for (const Argument& argument : step.arguments)
    values.push_back(argument.name + " = " + argument.value.text());
  return values.empty() ? "" : " at " + joined(values, "and");
}

void require_size(const StepDescription& step, int size) {
  if (size == 0) throw InputError(in_quotes(step.text) + ": the mask is zero" + values_text(step));
  if (size > most_taps) {
    throw InputError(in_quotes(step.text) + ": the mask has " + std::to_string(size) +
                     " coefficients; at most " + std::to_string(most_taps) + " are supported");
  }
}

void reject_sum(const SchemeDescription& scheme, const StepDescription& step, const std::string& sum,
                const std::string& miss) {
  const std::string arity = std::to_string(step.arity());
  std::string message = (step.file ? step.file->path : in_quotes(step.text)) + ": the coefficients sum to " +
                        sum + values_text(step) + ", not to the arity " + arity + "; the sum minus " + arity +
                        " is " + miss;
  if (!scheme.free_parameters.empty()) {
    message += ", which is not zero for all values of the free parameters; give them values or mend the mask";
  } else if (scheme.rounded) {
    message += ", more than the rounding of the decimals explains";
  } else if (sums_within_rounding(scheme, step)) {
    message +=
        ", no more than the rounding of the written decimals; write the coefficients exactly, as fractions "
        "or with sqrt, or let 'analyze --rounded' take every decimal as an interval";
  } else {
    message += "; mend the coefficients or the arity";
  }
  throw InputError(message);
}

std::string shown(const Rational& x) {
  constexpr int most_decimals = 30;
  for (int decimals = 0; decimals <= most_decimals; ++decimals) {
    const std::string text = to_decimal(x, decimals);
    if (Rational::parse(text) == x) return text;
  }
  constexpr std::size_t readable = 40;
  constexpr int digits = 17;
  const std::string exact = x.to_string();
  return exact.size() <= readable ? exact : "about " + to_significant(x, digits);
}

std::string shown(const Algebraic& x) {
  if (x.is_rational()) return shown(x.to_rational());
  constexpr int digits = 4;
  return x.to_string() + " (about " + to_significant(x.to_interval().midpoint(), digits) + ")";
}

}  // namespace detail

Scheme<RationalFunction> symbolic_scheme(const SchemeDescription& scheme) {
  std::vector<RationalFunction> variables;
  for (std::size_t i = 0; i < scheme.free_parameters.size(); ++i) {
    variables.push_back(RationalFunction::variable(static_cast<int>(i)));
  }
  return instantiate<RationalFunction>(scheme, variables);
}

Scheme<Interval> interval_scheme(const SchemeDescription& scheme, std::span<const Interval> free_values,
                                 long precision) {
  return detail::instantiate_with(scheme, free_values, IntervalLiteral{precision, !scheme.rounded});
}

std::vector<FactoredSymbol<Interval>> factored_interval_symbols(const SchemeDescription& scheme,
                                                                std::span<const Interval> free_values,
                                                                long precision) {
  const detail::Evaluator<Interval, IntervalLiteral> evaluator(scheme, free_values,
                                                               {precision, !scheme.rounded});
  std::vector<FactoredSymbol<Interval>> result;
  for (const StepDescription& step : scheme.steps) result.push_back(evaluator.factored_symbol(step));
  return result;
}

Field smallest_field(const SchemeDescription& scheme) {
  try {
    if (!scheme.free_parameters.empty()) {
      static_cast<void>(symbolic_scheme(scheme));
      return Field::rational_function;
    }
    static_cast<void>(instantiate<Rational>(scheme));
    return Field::rational;
  } catch (const OutsideRingError&) {
    if (!scheme.free_parameters.empty()) return Field::inexact;
  }
  try {
    static_cast<void>(instantiate<Algebraic>(scheme));
    return Field::algebraic;
  } catch (const OutsideRingError&) {
    return Field::inexact;
  }
}

ExactScheme exact_scheme(const SchemeDescription& scheme) {
  if (!scheme.free_parameters.empty()) return symbolic_scheme(scheme);
  try {
    return instantiate<Rational>(scheme);
  } catch (const OutsideRingError&) {
    Scheme<Algebraic> algebraic = instantiate<Algebraic>(scheme);
    if (!holds_rationals_only(algebraic)) return algebraic;
    return map_coefficients(algebraic, [](const Algebraic& x) { return x.to_rational(); });
  }
}

}  // namespace subdiv
