#include "experiments/definitions.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "experiments/definition_parts.h"
#include "optimize/objectives.h"
#include "optimize/polygon_objectives.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

using Kind = DefinitionArgument::Kind;

std::vector<std::string> names_of(std::span<const DefinitionArgument> arguments) {
  std::vector<std::string> names;
  for (const DefinitionArgument& argument : arguments) names.push_back(argument.name);
  return names;
}

/// A finite number above 0 with nothing behind it.
bool is_positive(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) && value > 0;
}

bool is_whole(const std::string& text, long least, long greatest) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= least && value <= greatest;
}

/// InputError when a value is none for the argument; what needs other arguments is checked by the definition.
void check_value(const DefinitionArgument& argument, const DefinitionCall& call) {
  const std::string& value = call.text(argument.name);
  const std::string wrong =
      fmt::format("\"{}\" must be {}, not {}", argument.name, argument.range(), in_quotes(value));
  switch (argument.kind) {
    case Kind::scheme:
      (void)scheme_of(call);
      return;
    case Kind::whole:
      if (!is_whole(value, argument.least, argument.greatest)) throw InputError(wrong);
      return;
    case Kind::word:
      if (!argument.words.empty() && std::ranges::find(argument.words, value) == argument.words.end())
        throw InputError(wrong);
      return;
    case Kind::objective:
      if (!names_polygon_objective(value) || !call.has("polygon"))
        (void)parse_objective(value);
      else
        (void)parse_polygon_objective(value);
      return;
    case Kind::seconds:
      if (!is_positive(value)) throw InputError(wrong);
      return;
    case Kind::file:
      if (!std::filesystem::is_regular_file(call.folder / value))
        throw InputError(
            fmt::format("\"{}\": there is no file {}", argument.name, (call.folder / value).string()));
      return;
    case Kind::over:
      return;
  }
}

}  // namespace

std::string DefinitionArgument::range() const {
  switch (kind) {
    case Kind::scheme:
      return "a scheme";
    case Kind::over:
      return "ranges w=LO..HI";
    case Kind::whole:
      return fmt::format("a whole number from {} to {}", least, greatest);
    case Kind::word:
      return words.empty() ? "a word" : joined(words);
    case Kind::objective:
      return "an objective ('subdivlab list objectives')";
    case Kind::seconds:
      return "a positive number of seconds";
    case Kind::file:
      break;
  }
  return "the name of a file";
}

std::span<const Definition> definitions() {
  static const std::vector<Definition> all = [] {
    std::vector<Definition> list = scheme_definitions();
    std::ranges::move(range_definitions(), std::back_inserter(list));
    return list;
  }();
  return all;
}

const Definition& find_definition(std::string_view name) {
  std::vector<std::string> known;
  for (const Definition& definition : definitions()) {
    if (definition.name == name) return definition;
    known.push_back(definition.name);
  }
  throw InputError("there is no definition " + in_quotes(name) + suggestion(name, known) + " There are " +
                   joined(known, "and") + "; 'subdivlab list definitions' describes them");
}

std::vector<std::string> complete(DefinitionCall& call) {
  const Definition& definition = *call.definition;
  const std::vector<std::string> names = names_of(definition.arguments);
  std::vector<std::string> wrong;
  for (const auto& [name, value] : call.arguments) {
    if (std::ranges::find(names, name) != names.end()) continue;
    wrong.push_back(fmt::format("{} takes no argument {}{} It takes {}", definition.name, in_quotes(name),
                                suggestion(name, names), joined(names, "and")));
  }
  for (const DefinitionArgument& argument : definition.arguments) {
    if (!call.has(argument.name)) {
      if (argument.required)
        wrong.push_back(fmt::format("{} needs the argument \"{}\", {}: {}; for example {}", definition.name,
                                    argument.name, argument.range(), argument.meaning, definition.example));
      if (argument.default_value.empty()) continue;
      call.arguments[argument.name] = argument.default_value;
    }
    try {
      check_value(argument, call);
    } catch (const InputError& error) {
      wrong.emplace_back(error.what());
    }
  }
  if (!wrong.empty()) return wrong;
  try {
    definition.check(call);
  } catch (const InputError& error) {
    wrong.emplace_back(error.what());
  }
  return wrong;
}

std::string sentence(const DefinitionCall& call) {
  std::string text = call.definition->summary + ". ";
  std::string separator;
  for (const DefinitionArgument& argument : call.definition->arguments) {
    if (!call.has(argument.name) || argument.kind == Kind::seconds) continue;
    text += separator + argument.name + " " + call.text(argument.name);
    separator = "; ";
  }
  return text + ".";
}

}  // namespace subdiv
