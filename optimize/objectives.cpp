#include "optimize/objectives.h"

#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

constexpr int greatest_degree = 20;
constexpr int greatest_fit_level = 10;
constexpr int greatest_popping_level = 8;
constexpr int documents_fit_level = 8;
constexpr int greatest_continuity = 20;

const std::array table{
    ObjectiveDescription{
        "fit-bspline",
        "coefficients of an iterate minus the uniform B-spline of a degree at the same abscissae",
        "l1, l2, linf",
        {{"degree=D", fmt::format("degree of the B-spline, 1 to {}; must be given", greatest_degree)},
         {"level=K",
          fmt::format("which iterate, 1 to {}; {} when not given", greatest_fit_level, documents_fit_level)},
         {"continuum",
          "the limit functions over the real line instead (l1 and linf: for jspline:s=NAME, degrees 1 to "
          "5)"}},
        "fit-bspline:degree=2"},
    ObjectiveDescription{
        "vertex", "limit mask at an old vertex minus the identity", "l1, l2, linf", {}, "vertex"},
    ObjectiveDescription{
        "edge", "limit mask at a new mid-edge vertex minus (1/2, 1/2)", "l1, l2, linf", {}, "edge"},
    ObjectiveDescription{"area", "area mask minus that of polygons", "l1, l2, linf", {}, "area"},
    ObjectiveDescription{
        "popping",
        "coefficients of the refined impulse minus linear subdivision's, after the best levels before",
        "l1, l2, linf",
        {{"level=K",
          fmt::format("the level to optimise, 1 to {}; 1 when not given", greatest_popping_level)}},
        "popping:level=2"},
    ObjectiveDescription{
        "difference-norm",
        "norm of the difference scheme of an order, which proves continuity where it is below 1",
        "linf",
        {{"continuity=M", fmt::format("for C^M, M from 0 to {}; must be given", greatest_continuity)}},
        "difference-norm:continuity=2"},
};

Objective::Kind parse_kind(std::string_view name) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].name == name) return static_cast<Objective::Kind>(i);
    known.push_back(table[i].name);
  }
  throw InputError(fmt::format("objective {}: unknown{} The objectives are {}.", in_quotes(name),
                               suggestion(name, known), joined(known, "and")));
}

int parse_number(const std::string& place, std::string_view text, int least, int greatest) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > greatest) {
    throw InputError(fmt::format("{}: expected a whole number from {} to {}, found {}", place, least,
                                 greatest, in_quotes(text)));
  }
  return value;
}

[[noreturn]] void unknown_option(const ObjectiveDescription& entry, std::string_view option) {
  std::vector<std::string> known;
  for (const ObjectiveOption& o : entry.options) known.push_back(o.name);
  throw InputError(fmt::format("objective {}: unknown option {}; {}", entry.name, in_quotes(option),
                               known.empty() ? "it takes none" : "it takes " + joined(known, "and")));
}

void apply_option(const ObjectiveDescription& entry, std::string_view option, Objective& objective) {
  const auto equals = option.find('=');
  const std::string_view name = trimmed(option.substr(0, equals));
  const bool has_value = equals != std::string_view::npos;
  const std::string_view value = has_value ? trimmed(option.substr(equals + 1)) : "";
  const std::string place = fmt::format("objective {}: {}", entry.name, name);
  const bool fits = objective.kind == Objective::Kind::fit_bspline;
  const bool has_level = fits || objective.kind == Objective::Kind::popping;
  if (fits && name == "degree") {
    objective.degree = parse_number(place, value, 1, greatest_degree);
  } else if (has_level && name == "level") {
    objective.level = parse_number(place, value, 1, fits ? greatest_fit_level : greatest_popping_level);
  } else if (fits && name == "continuum" && !has_value) {
    objective.continuum = true;
  } else if (objective.kind == Objective::Kind::difference_norm && name == "continuity") {
    objective.continuity = parse_number(place, value, 0, greatest_continuity);
  } else {
    unknown_option(entry, option);
  }
}

}  // namespace

std::span<const ObjectiveDescription> objectives() { return table; }

Objective parse_objective(std::string_view text) {
  const auto colon = text.find(':');
  Objective objective;
  objective.kind = parse_kind(trimmed(text.substr(0, colon)));
  const ObjectiveDescription& entry = table[static_cast<std::size_t>(objective.kind)];
  std::string_view rest = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  while (!rest.empty()) {
    const auto comma = rest.find(',');
    apply_option(entry, trimmed(rest.substr(0, comma)), objective);
    rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
  }
  if (objective.kind == Objective::Kind::fit_bspline) {
    if (objective.degree == 0) {
      throw InputError(
          fmt::format("objective {}: give the B-spline's degree, as in {}", entry.name, entry.example));
    }
    if (objective.continuum && objective.level != 0) {
      throw InputError(
          fmt::format("objective {}: 'continuum' has no level; leave one of the two out", entry.name));
    }
    if (!objective.continuum && objective.level == 0) objective.level = documents_fit_level;
  }
  if (objective.kind == Objective::Kind::popping && objective.level == 0) objective.level = 1;
  if (objective.kind == Objective::Kind::difference_norm && objective.continuity < 0) {
    throw InputError(
        fmt::format("objective {}: give the order of continuity, as in {}", entry.name, entry.example));
  }
  return objective;
}

std::string to_string(const Objective& objective) {
  std::vector<std::string> options;
  if (objective.degree != 0) options.push_back(fmt::format("degree={}", objective.degree));
  if (objective.level != 0) options.push_back(fmt::format("level={}", objective.level));
  if (objective.continuum) options.emplace_back("continuum");
  if (objective.continuity >= 0) options.push_back(fmt::format("continuity={}", objective.continuity));
  const std::string& name = table[static_cast<std::size_t>(objective.kind)].name;
  return options.empty() ? name : fmt::format("{}:{}", name, fmt::join(options, ","));
}

}  // namespace subdiv
