#include "experiments/cli/over.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "schemes/expression.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

Rational parse_end(std::string_view text, const std::string& place) {
  try {
    return evaluate_constant<Rational>(Expression::parse(text));
  } catch (const InputError& error) {
    throw InputError(place + error.what());
  }
}

/// One piece "s=LO..HI" of the option.
ParameterRange parse_range(std::string_view text, RangeEnds ends, const std::string& option) {
  const std::string place = option + " " + in_quotes(text) + ": ";
  const std::size_t equals = text.find('=');
  const std::size_t dots = text.find("..", equals == std::string_view::npos ? 0 : equals);
  if (equals == std::string_view::npos || dots == std::string_view::npos) {
    throw InputError(place + "expected parameter=LO..HI, such as s=-1.7..5.8");
  }
  ParameterRange range{std::string(trimmed(text.substr(0, equals))),
                       parse_end(trimmed(text.substr(equals + 1, dots - equals - 1)), place),
                       parse_end(trimmed(text.substr(dots + 2)), place)};
  if (range.lower > range.upper || (range.lower == range.upper && ends == RangeEnds::differ)) {
    throw InputError(place + "the lower end must " +
                     (ends == RangeEnds::differ ? "be below" : "not be above") + " the upper end");
  }
  return range;
}

}  // namespace

std::vector<ParameterRange> parse_over(std::string_view text, const std::vector<std::string>& free_parameters,
                                       RangeEnds ends, const std::string& option) {
  if (free_parameters.empty()) {
    throw InputError(option +
                     ": the scheme has no free parameter; give a parameter a name as its value, such as "
                     "jspline:s=s");
  }
  std::vector<ParameterRange> given;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    given.push_back(parse_range(trimmed(text.substr(begin, end - begin)), ends, option));
    begin = end + 1;
  }
  std::vector<ParameterRange> box;
  for (const std::string& name : free_parameters) {
    const auto count = std::ranges::count(given, name, &ParameterRange::name);
    if (count == 0)
      throw InputError(fmt::format("{}: the free parameter {} has no range; add {}=LO..HI", option,
                                   in_quotes(name), name));
    if (count > 1) throw InputError(option + ": " + in_quotes(name) + " has two ranges; give one");
    box.push_back(*std::ranges::find(given, name, &ParameterRange::name));
  }
  for (const ParameterRange& range : given) {
    if (std::ranges::find(free_parameters, range.name) != free_parameters.end()) continue;
    throw InputError(option + ": " + in_quotes(range.name) + " is no free parameter of the scheme; it has " +
                     joined(free_parameters, "and"));
  }
  return box;
}

}  // namespace subdiv::cli
