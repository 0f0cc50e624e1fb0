#include <algorithm>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/mesh/characteristic_map.h"
#include "analysis/mesh/exact_condition.h"
#include "analysis/mesh/spectral_condition.h"
#include "experiments/cli/over.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/record.h"
#include "schemes/expression_ring.h"
#include "schemes/input_error.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int least_valence = 3;
constexpr int greatest_valence = 1000;

struct Valences {
  int first = least_valence;
  int last = least_valence;
};

Valences parse_valences(const std::string& text) {
  const auto bad = [&](const std::string& what) {
    return InputError(
        fmt::format("--valence {}: {}; expected N or LO..HI, whole numbers from {} to {}, such as "
                    "5 or 3..30",
                    in_quotes(text), what, least_valence, greatest_valence));
  };
  const auto number = [&](const std::string& part) {
    const bool digits = !part.empty() && part.size() <= 4 &&
                        std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits) throw bad(in_quotes(part) + " is no such number");
    const int n = std::stoi(part);
    if (n < least_valence || n > greatest_valence) throw bad(part + " lies outside");
    return n;
  };
  const std::size_t dots = text.find("..");
  const Valences result{number(text.substr(0, dots)),
                        number(dots == std::string::npos ? text : text.substr(dots + 2))};
  if (result.last < result.first) throw bad("the range is empty");
  return result;
}

/// The exact equations of a scheme: of the modes k != 0, and of mode 0 valence by valence.
struct Equations {
  MeshScheme<RationalFunction> scheme;
  ModeEquation turning;

  explicit Equations(const MeshSchemeDescription& description)
      : scheme(symbolic_mesh_scheme(description, turn_variable)), turning(turning_modes(scheme)) {}

  [[nodiscard]] SpectralCondition condition(int valence) const {
    return {turning, invariant_mode(scheme, valence), valence};
  }
};

Json decision_json(Decision decision) {
  if (decision == Decision::undecided) return nullptr;
  return decision == Decision::yes;
}

std::string decision_text(Decision decision) {
  if (decision == Decision::undecided) return "undecided";
  return decision == Decision::yes ? "holds" : "fails";
}

Json interval_json(const Interval& x, Rigour rigour) {
  const DecimalEnds ends = decimal_ends(x.lower(), x.upper(), rigour);
  return {{"lower", ends.lower}, {"upper", ends.upper}};
}

/// The eigenvalues of a mode: enclosures, or approximate ones where roots cannot be told apart.
Json mode_json(const ModeTable& table, const SpectralCondition& condition, int mode) {
  Json values = Json::array();
  const Interval c = cosine_of_turn<Interval>(std::max(mode, 1), condition.valence());
  for (const auto& [factor, multiplicity] : table.at(Rational(0), Rational(0)).at_turn(c)) {
    if (const auto roots = enclosed_roots(factor.middle)) {
      for (const ComplexRoot& root : *roots) {
        values.push_back({{"real", interval_json(root.real, Rigour::certified)},
                          {"imaginary", interval_json(root.imaginary, Rigour::certified)},
                          {"multiplicity", multiplicity * root.multiplicity},
                          {"rigour", "certified"}});
      }
      continue;
    }
    for (const std::complex<double>& root : approximate_roots(factor.middle)) {
      values.push_back({{"real", interval_json(Interval(root.real()), Rigour::approximate)},
                        {"imaginary", interval_json(Interval(root.imag()), Rigour::approximate)},
                        {"multiplicity", multiplicity},
                        {"rigour", "approximate"}});
    }
  }
  return {{"mode", mode}, {"values", std::move(values)}};
}

/// What is known at one valence, for a scheme without free parameters.
struct Answer {
  int valence = 0;
  Decision condition = Decision::undecided;
  Interval subdominant;
  Interval next;
  Rigour rigour = Rigour::certified;  // of the two
  CharacteristicMap map;
};

/// Ties are looked for up to this valence: exact eigenvalues of larger matrices take seconds.
constexpr int most_exact_valence = 12;

Answer answer_at(const SpectralCondition& condition, const MeshSchemeForms& forms) {
  Answer answer;
  answer.valence = condition.valence();
  answer.condition = condition.decide(Rational(0));
  if (answer.condition == Decision::undecided && forms.exact && answer.valence <= most_exact_valence)
    answer.condition = exact_condition(*forms.exact, answer.valence);
  if (const auto leading = condition.leading(Rational(0))) {
    answer.subdominant = leading->subdominant;
    answer.next = leading->next;
  } else {
    // The largest two moduli but for 1, whatever their modes: a pair of one mode counts once.
    const Rival rival = condition.rival(Rational(0));
    const double other = std::abs(rival.value);
    answer.subdominant = Interval(std::max(rival.subdominant, other));
    answer.next = Interval(std::min(rival.subdominant, other));
    answer.rigour = Rigour::approximate;
  }
  answer.map = characteristic_map(forms, condition.valence());
  return answer;
}

std::string rigour_word(Rigour rigour) { return rigour == Rigour::approximate ? "approximate" : "certified"; }

Json map_json(const CharacteristicMap& map) {
  Json json = {{"regular", map.exists() ? decision_json(map.regular) : Json(nullptr)},
               {"injective", map.exists() ? decision_json(map.injective) : Json(nullptr)},
               {"rigour", rigour_word(map.rigour)},
               {"mode", map.mode}};
  json["winding"] = map.exists() && map.winding ? Json(*map.winding) : Json(nullptr);
  json["method"] = map.exists() ? map.method : "no map: " + map.missing;
  return json;
}

Json parameters_json(const MeshSchemeDescription& description) {
  Json json = Json::object();
  const auto no_names = [](const std::string& name, const Expression::Node& /*node*/) -> Rational {
    throw std::logic_error("a free parameter " + name);
  };
  for (const Argument& argument : description.arguments)
    json[argument.name] = evaluate<Rational>(argument.value, no_names).to_string();
  return json;
}

Json answer_json(const Answer& answer, const SpectralCondition& condition, const ModeTable& turning,
                 const ModeTable& invariant, const MeshSchemeDescription& description) {
  Json modes = Json::array();
  for (int k = 0; 2 * k <= answer.valence; ++k)
    modes.push_back(mode_json(k == 0 ? invariant : turning, condition, k));
  return {{"valence", answer.valence},
          {"parameters", parameters_json(description)},
          {"eigenvalues", std::move(modes)},
          {"subdominant", interval_json(answer.subdominant, answer.rigour)},
          {"next", interval_json(answer.next, answer.rigour)},
          {"rigour", rigour_word(answer.rigour)},
          {"condition", decision_json(answer.condition)},
          {"characteristic_map", map_json(answer.map)}};
}

std::string number_text(const Interval& x, Rigour rigour) {
  constexpr std::size_t width = 15;
  const DecimalEnds ends = decimal_ends(x.lower(), x.upper(), rigour);
  ClaimRecord record;
  record.lower = ends.lower;
  record.upper = ends.upper;
  record.rigour = rigour_word(rigour);
  return value_text(record, width);
}

std::string map_text(const CharacteristicMap& map) {
  if (!map.exists()) return "none: " + map.missing;
  const auto word = [](Decision d, const char* yes, const char* no) {
    return d == Decision::undecided ? std::string("undecided") : d == Decision::yes ? yes : no;
  };
  std::string text =
      word(map.regular, "regular", "not regular") + ", " + word(map.injective, "injective", "not injective");
  if (map.mode != 1) text += fmt::format(", of mode {}", map.mode);
  return text + " (" + rigour_word(map.rigour) + ")";
}

int eigen_at_values(const EigenOptions& options, const MeshSchemeDescription& description,
                    const Valences& valences) {
  const Equations equations(description);
  const MeshSchemeForms forms = mesh_scheme_forms(description);
  const ModeTable turning(equations.turning);
  Json json = Json::array();
  bool open = false;
  constexpr const char* row = "{:>7}  {:<16}{:<16}{:<11}{}\n";
  if (!options.json)
    std::cout << fmt::format(row, "valence", "sub-dominant", "next", "condition", "characteristic map");
  for (int n = valences.first; n <= valences.last; ++n) {
    const SpectralCondition condition = equations.condition(n);
    const Answer answer = answer_at(condition, forms);
    open = open || answer.condition == Decision::undecided;
    if (options.json) {
      json.push_back(answer_json(answer, condition, turning, ModeTable(invariant_mode(equations.scheme, n)),
                                 description));
      continue;
    }
    std::cout << fmt::format(row, n, number_text(answer.subdominant, answer.rigour),
                             number_text(answer.next, answer.rigour), decision_text(answer.condition),
                             map_text(answer.map));
  }
  if (options.json) std::cout << json.dump(2) << '\n';
  return open ? ExitCode::undecided : ExitCode::done;
}

/// The range is cut down to this share of it where the answer changes.
constexpr long finest_cells = 1L << 24;

int eigen_over(const EigenOptions& options, const MeshSchemeDescription& description,
               const Valences& valences, const ParameterRange& range) {
  const Equations equations(description);
  const Rational width = (range.upper - range.lower) / Rational(finest_cells);
  constexpr int digits = 9;
  Json json = Json::array();
  if (!options.json) std::cout << fmt::format("{:>7}  condition on {}\n", "valence", range.name);
  for (int n = valences.first; n <= valences.last; ++n) {
    const std::vector<ConditionCell> cells = equations.condition(n).cells(range.lower, range.upper, width);
    Json parts = Json::array();
    std::string line;
    for (const ConditionCell& cell : cells) {
      const DecimalEnds ends = decimal_ends(cell.lower, cell.upper, Rigour::certified);
      parts.push_back(
          {{"lower", ends.lower}, {"upper", ends.upper}, {"condition", decision_json(cell.holds)}});
      line += fmt::format("{}{} [{}, {}]", line.empty() ? "" : "; ", decision_text(cell.holds),
                          to_significant(cell.lower, digits), to_significant(cell.upper, digits));
    }
    if (!options.json) {
      std::cout << fmt::format("{:>7}  {}\n", n, line);
      continue;
    }
    const bool one = cells.size() == 1;
    json.push_back({{"valence", n},
                    {"parameters", {{range.name, {range.lower.to_string(), range.upper.to_string()}}}},
                    {"eigenvalues", nullptr},
                    {"subdominant", nullptr},
                    {"next", nullptr},
                    {"condition", one ? decision_json(cells[0].holds) : Json(nullptr)},
                    {"cells", std::move(parts)},
                    {"characteristic_map", nullptr}});
  }
  if (options.json) std::cout << json.dump(2) << '\n';
  return ExitCode::done;
}

}  // namespace

int eigen(const EigenOptions& options) {
  const Valences valences = parse_valences(options.valence);
  const MeshSchemeDescription description = parse_mesh_scheme(options.scheme);
  const std::vector<std::string>& free = description.free_parameters;
  if (free.empty() && !options.over.empty()) {
    throw InputError("--over: the scheme " + in_quotes(options.scheme) +
                     " has no free parameter; a name as a value leaves one free, as in jspline-mesh:s=s");
  }
  if (free.size() == 1 && options.over.empty()) {
    throw InputError(fmt::format("{}: {} has no value; give it a range with --over {}=LO..HI",
                                 in_quotes(options.scheme), free[0], free[0]));
  }
  if (free.size() > 1)
    throw InputError(in_quotes(options.scheme) + ": eigen takes one free parameter, not " +
                     joined(free, "and"));
  try {
    if (free.empty()) return eigen_at_values(options, description, valences);
    return eigen_over(options, description, valences, parse_over(options.over, free, RangeEnds::differ)[0]);
  } catch (const OutsideRingError& error) {
    throw InputError(std::string(error.what()) + "; eigen takes rational values");
  }
}

}  // namespace subdiv::cli
