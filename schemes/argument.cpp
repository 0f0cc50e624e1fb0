#include "schemes/argument.h"

#include <algorithm>
#include <cstddef>

#include "schemes/input_error.h"
#include "schemes/scheme_file.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether the '+' or '-' at i is the sign of a decimal's exponent, as in w=1e+3.
bool is_exponent_sign(std::string_view text, std::size_t i) {
  if (i < 2 || i + 1 >= text.size() || !is_digit(text[i + 1])) return false;
  return (text[i - 1] == 'e' || text[i - 1] == 'E') && (is_digit(text[i - 2]) || text[i - 2] == '.');
}

Argument parse_argument(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    throw InputError(in_quotes(text) +
                     " gives no value; write parameter=value, such as s=3/2, separated by commas");
  }
  const std::string name(trimmed(text.substr(0, equals)));
  if (name.empty()) throw InputError(in_quotes(text) + " names no parameter before '='");
  try {
    return {name, Expression::parse(text.substr(equals + 1))};
  } catch (const InputError& error) {
    throw InputError("value of " + in_quotes(name) + ", " + error.what());
  }
}

}  // namespace

std::vector<std::string_view> split_outside_parentheses(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') depth = std::max(0, depth - 1);
    if (depth > 0 || text[i] != separator || is_exponent_sign(text, i)) continue;
    pieces.push_back(trimmed(text.substr(start, i - start)));
    start = i + 1;
  }
  pieces.push_back(trimmed(text.substr(start)));
  return pieces;
}

std::vector<Argument> parse_arguments(std::string_view text) {
  std::vector<Argument> arguments;
  for (const std::string_view piece : split_outside_parentheses(text, ',')) {
    arguments.push_back(parse_argument(piece));
    const auto same_name = [&](const Argument& a) { return a.name == arguments.back().name; };
    if (std::count_if(arguments.begin(), arguments.end(), same_name) > 1) {
      throw InputError("parameter " + in_quotes(arguments.back().name) + " is given twice");
    }
  }
  return arguments;
}

void add_free_names(const std::vector<Argument>& arguments, std::vector<std::string>& free_parameters) {
  for (const Argument& argument : arguments) {
    for (const std::string& name : argument.value.names()) {
      if (std::find(free_parameters.begin(), free_parameters.end(), name) != free_parameters.end()) continue;
      require_parameter_name(name, "value of " + argument.name);
      free_parameters.push_back(name);
    }
  }
  if (free_parameters.size() > static_cast<std::size_t>(max_free_parameters)) {
    throw InputError("more than " + std::to_string(max_free_parameters) +
                     " free parameters: " + joined(free_parameters, "and") + "; give some of them values");
  }
}

}  // namespace subdiv
