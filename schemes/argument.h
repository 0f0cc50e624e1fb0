#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "schemes/expression.h"

namespace subdiv {

/// A parameter with the value given to it, unevaluated.
struct Argument {
  std::string name;  ///< of the parameter
  Expression value;  ///< as written
};

/// The pieces between separators that stand outside parentheses and are no sign of a decimal's exponent,
/// without white space at their ends.
[[nodiscard]] std::vector<std::string_view> split_outside_parentheses(std::string_view text, char separator);

/// "parameter=value,parameter=value". Throws InputError for a piece without a value or a name, and for a
/// parameter that is given twice.
[[nodiscard]] std::vector<Argument> parse_arguments(std::string_view text);

/// Adds the names that stand in the values, by first appearance, to those that are free already. Throws
/// InputError for names that no parameter may have and for too many of them.
void add_free_names(const std::vector<Argument>& arguments, std::vector<std::string>& free_parameters);

}  // namespace subdiv
