#include "schemes/scheme_description.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "schemes/algebra/polynomial.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

constexpr std::string_view file_ending = ".json";

/// Where a step's name ends: the first ".json" that a ':' or the end follows, else the first ':'.
std::size_t name_length(std::string_view step) {
  for (std::size_t i = step.find(file_ending); i != std::string_view::npos;
       i = step.find(file_ending, i + 1)) {
    const std::size_t end = i + file_ending.size();
    if (end == step.size() || step[end] == ':') return end;
  }
  return std::min(step.find(':'), step.size());
}

std::optional<Expression> value_of(const std::vector<Argument>& arguments, const std::string& name) {
  const auto found =
      std::find_if(arguments.begin(), arguments.end(), [&](const Argument& a) { return a.name == name; });
  return found == arguments.end() ? std::nullopt : std::optional<Expression>(found->value);
}

long whole_value(const Parameter& parameter, const Expression& value) {
  const std::string expected = parameter.name + " must be " + parameter.range();
  if (!value.names().empty())
    throw InputError(expected + "; it cannot be left free as " + in_quotes(value.text()));
  Rational number;
  try {
    number = evaluate_constant<Rational>(value);
  } catch (const InputError& error) {
    throw InputError(expected + ": " + error.what());
  }
  const bool in_range = number.is_integer() && Rational(parameter.least) <= number &&
                        number <= Rational(parameter.greatest) &&
                        (number.to_integer() - parameter.least) % parameter.step == 0;
  if (!in_range) throw InputError(expected + ", not " + in_quotes(value.text()));
  return number.to_integer();
}

void complete_from_catalogue(StepDescription& step, std::string_view name,
                             const std::vector<Argument>& given) {
  step.family = &find_family(name);
  std::vector<std::string> names;
  for (const Argument& argument : given) names.push_back(argument.name);
  step.form = &find_form(*step.family, names);
  for (const Parameter& parameter : step.form->parameters) {
    const std::optional<Expression> value = value_of(given, parameter.name);
    step.arguments.push_back({parameter.name, value ? *value : Expression::parse(parameter.default_value)});
    if (parameter.whole) step.whole.push_back(whole_value(parameter, step.arguments.back().value));
  }
}

void complete_from_file(StepDescription& step, const std::vector<Argument>& given) {
  std::vector<std::string> known;
  for (const SchemeFile::Parameter& parameter : step.file->parameters) {
    known.push_back(parameter.name);
    const std::optional<Expression> value = value_of(given, parameter.name);
    step.arguments.push_back({parameter.name, value ? *value : parameter.default_value.expression});
  }
  for (const Argument& argument : given) {
    if (std::find(known.begin(), known.end(), argument.name) != known.end()) continue;
    const std::string listed =
        known.empty() ? " The file declares no parameters" : " The file declares " + joined(known, "and");
    throw InputError(step.file->path + " has no parameter " + in_quotes(argument.name) +
                     suggestion(argument.name, known) + listed);
  }
}

StepDescription parse_step(std::string_view text, std::vector<std::string>& free_parameters) {
  const std::size_t end = name_length(text);
  const std::string_view name = trimmed(text.substr(0, end));
  StepDescription step;
  step.text = text;
  if (name.empty()) {
    throw InputError(
        "a scheme's name is missing; steps are joined by one '+', and a sum in a value stands in "
        "parentheses");
  }
  std::vector<Argument> given;
  if (end < text.size()) given = parse_arguments(text.substr(end + 1));
  if (name.ends_with(file_ending)) {
    step.file = std::make_shared<const SchemeFile>(read_scheme_file(std::string(name)));
    complete_from_file(step, given);
  } else {
    complete_from_catalogue(step, name, given);
  }
  add_free_names(given, free_parameters);
  return step;
}

void require_one_arity(const SchemeDescription& scheme) {
  const int first = scheme.steps.front().arity();
  for (const StepDescription& step : scheme.steps) {
    if (step.arity() != first) {
      throw InputError("steps of different arity: " + in_quotes(scheme.steps.front().text) + " has arity " +
                       std::to_string(first) + ", " + in_quotes(step.text) + " has arity " +
                       std::to_string(step.arity()));
    }
  }
}

/// Computes the masks, so that errors come out before any question is asked.
void require_masks(const SchemeDescription& scheme) {
  const bool has_free = !scheme.free_parameters.empty();
  const bool inexact = smallest_field(scheme) == Field::inexact;
  if ((inexact || scheme.rounded) && !has_free) static_cast<void>(interval_scheme(scheme));
}

}  // namespace

SchemeDescription parse_scheme(std::string_view text, const SchemeOptions& options) {
  constexpr std::size_t most_steps = 1000;
  const std::string_view inner = trimmed(text);
  if (inner.empty())
    throw InputError("the scheme is empty; write a name, such as jspline:s=3/2, or a file.json");
  SchemeDescription scheme;
  scheme.text = inner;
  scheme.rounded = options.rounded;
  const std::vector<std::string_view> pieces = split_outside_parentheses(inner, '+');
  if (pieces.size() > most_steps) throw InputError("more than " + std::to_string(most_steps) + " steps");
  for (const std::string_view piece : pieces) {
    try {
      scheme.steps.push_back(parse_step(piece, scheme.free_parameters));
    } catch (const InputError& error) {
      throw InputError("scheme " + in_quotes(piece) + ": " + error.what());
    }
  }
  require_one_arity(scheme);
  require_masks(scheme);
  return scheme;
}

}  // namespace subdiv
