#include <algorithm>
#include <array>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/speed_matrix.h"
#include "analysis/adjustable_speed/speed_spectrum.h"
#include "analysis/mesh/characteristic_map.h"
#include "analysis/mesh/exact_condition.h"
#include "analysis/mesh/spectral_condition.h"
#include "analysis/sign_on_interval.h"
#include "experiments/cli/over.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/record.h"
#include "schemes/adjustable_speed/limit_point.h"
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
  ModeEquation turning;
  std::function<ModeEquation(int valence)> invariant;

  [[nodiscard]] SpectralCondition condition(int valence) const {
    return {turning, invariant(valence), valence};
  }
};

/// The speed as a function of the free parameter, if there is one.
RationalFunction speed_of(const MeshSchemeDescription& description) {
  const std::vector<RationalFunction> free(description.free_parameters.size(), RationalFunction::variable(0));
  return parameter_values<RationalFunction>(description, free).front();
}

Equations equations_of(const MeshSchemeDescription& description) {
  if (description.family->rings_only) {
    const RationalFunction sigma = speed_of(description);
    constexpr int far = 11;  // no sector is read from both sides
    return {turning_modes(speed_matrix(sigma, far)),
            [sigma](int valence) { return invariant_mode(speed_matrix(sigma, valence)); }};
  }
  const MeshScheme<RationalFunction> scheme = symbolic_mesh_scheme(description, turn_variable);
  return {turning_modes(scheme), [scheme](int valence) { return invariant_mode(scheme, valence); }};
}

/// Ties are looked for up to this valence: exact eigenvalues of larger matrices take seconds.
constexpr int most_exact_valence = 12;

/// What is asked of a scheme without free parameters beside its equations.
struct Questions {
  /// Asked where enclosures do not decide.
  std::function<Decision(int valence)> exact_condition;
  std::function<CharacteristicMap(int valence)> map;
  /// Of adjustable speed: the weights of the limit point.
  std::function<VertexWeights<Rational>(int valence)> limit;
};

Questions questions_of(const MeshSchemeDescription& description) {
  if (description.family->rings_only) {
    const Rational sigma = parameter_values<Rational>(description).front();
    return {[](int /*valence*/) { return lambda_is_subdominant() ? Decision::yes : Decision::undecided; },
            [sigma](int valence) { return speed_characteristic_map(sigma, valence); },
            [sigma](int valence) { return limit_weights(vertex_weights(sigma, valence), sigma); }};
  }
  const MeshSchemeForms forms = mesh_scheme_forms(description);
  const auto ties = [exact = forms.exact](int valence) {
    return exact && valence <= most_exact_valence ? exact_condition(*exact, valence) : Decision::undecided;
  };
  return {ties, [forms](int valence) { return characteristic_map(forms, valence); }, {}};
}

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

/// An eigenvalue of a mode k, 0 <= k <= n/2; `copies` counts those of mode n - k with it.
struct ModeRoot {
  int mode = 0;
  Interval real;
  Interval imaginary;
  int multiplicity = 1;
  int copies = 1;
  Rigour rigour = Rigour::certified;
};

Interval modulus(const ModeRoot& root) {
  if (root.imaginary.is_exactly_zero()) return abs(root.real);
  return sqrt(root.real * root.real + root.imaginary * root.imaginary);
}

/// cos(2 pi k/n) where it is rational.
std::optional<Rational> rational_cosine(int k, int n) {
  constexpr std::array orders{1, 2, 3, 4, 6};
  if (std::ranges::find(orders, n / std::gcd(k, n)) == orders.end()) return std::nullopt;
  return cosine_of_turn<Rational>(k, n);
}

/// All eigenvalues of a mode from its exact polynomial, in which multiple ones show; nothing when its
/// coefficients are irrational.
std::optional<std::vector<ComplexRoot>> exact_mode(const ModeEquation& equation, int mode, int valence) {
  const std::optional<Rational> c = rational_cosine(std::max(mode, 1), valence);
  std::vector<ComplexRoot> result;
  for (const auto& [factor, multiplicity] : equation.factors) {
    if (factor.uses(turn_variable) && !c) return std::nullopt;
    const Polynomial p = c ? factor.substitute(turn_variable, Polynomial(*c)) : factor;
    for (ComplexRoot& root :
         complex_roots(UnivariatePolynomial(p, eigenvalue_variable), ModeTable::precision)) {
      root.multiplicity *= multiplicity;
      result.push_back(std::move(root));
    }
  }
  return result;
}

/// All eigenvalues by mode: enclosures, or approximate ones where Arb cannot tell roots apart.
std::vector<ModeRoot> spectrum(const Equations& equations, int valence) {
  const ModeEquation invariant_equation = equations.invariant(valence);
  const ModeTable turning(equations.turning);
  const ModeTable invariant(invariant_equation);
  const Rational none(0);  // there is no parameter
  std::vector<ModeRoot> result;
  for (int k = 0; 2 * k <= valence; ++k) {
    const Interval c = cosine_of_turn<Interval>(std::max(k, 1), valence);
    const int mirrored = k > 0 && 2 * k < valence ? 2 : 1;
    if (const auto roots = exact_mode(k == 0 ? invariant_equation : equations.turning, k, valence)) {
      for (const ComplexRoot& root : *roots) {
        result.push_back({k, root.real, root.imaginary, root.multiplicity, mirrored * root.multiplicity,
                          Rigour::certified});
      }
      continue;
    }
    for (const auto& [factor, multiplicity] : (k == 0 ? invariant : turning).at(none, none).at_turn(c)) {
      if (const auto roots = enclosed_roots(factor.middle)) {
        for (const ComplexRoot& root : *roots) {
          const int times = multiplicity * root.multiplicity;
          result.push_back({k, root.real, root.imaginary, times, mirrored * times, Rigour::certified});
        }
        continue;
      }
      for (const std::complex<double>& root : approximate_roots(factor.middle)) {
        result.push_back({k, Interval(root.real()), Interval(root.imag()), multiplicity,
                          mirrored * multiplicity, Rigour::approximate});
      }
    }
  }
  return result;
}

/// The moduli but for one eigenvalue 1 of mode 0, each as often as it occurs, largest first: the i-th largest
/// lies between the i-th largest lower end and the i-th largest upper end.
std::vector<Interval> ordered_moduli(const std::vector<ModeRoot>& roots) {
  std::vector<Rational> lower;
  std::vector<Rational> upper;
  bool one_left_out = false;
  for (const ModeRoot& root : roots) {
    const Interval size = modulus(root);
    int copies = root.copies;
    if (root.mode == 0 && !one_left_out && size.contains(Rational(1))) {
      one_left_out = true;
      --copies;
    }
    lower.insert(lower.end(), static_cast<std::size_t>(copies), size.lower());
    upper.insert(upper.end(), static_cast<std::size_t>(copies), size.upper());
  }
  std::sort(lower.begin(), lower.end(), std::greater<>());
  std::sort(upper.begin(), upper.end(), std::greater<>());
  std::vector<Interval> result;
  for (std::size_t i = 0; i < lower.size(); ++i)
    result.push_back(
        Interval::hull(Interval(lower[i], ModeTable::precision), Interval(upper[i], ModeTable::precision)));
  return result;
}

/// What is known at one valence, for a scheme without free parameters.
struct Answer {
  int valence = 0;
  std::vector<ModeRoot> roots;
  Decision condition = Decision::undecided;
  Interval subdominant;
  Interval next;
  Rigour rigour = Rigour::certified;  // of the two
  CharacteristicMap map;
  std::optional<VertexWeights<Rational>> limit;
};

Answer answer_at(const Equations& equations, const Questions& questions, int valence) {
  Answer answer;
  answer.valence = valence;
  answer.roots = spectrum(equations, valence);
  answer.condition = equations.condition(valence).decide(Rational(0));
  if (answer.condition == Decision::undecided) answer.condition = questions.exact_condition(valence);
  const std::vector<Interval> moduli = ordered_moduli(answer.roots);
  answer.subdominant = moduli[0];
  answer.next = moduli[2];  // after the pair
  for (const ModeRoot& root : answer.roots) {
    if (root.rigour == Rigour::approximate) answer.rigour = Rigour::approximate;
  }
  answer.map = questions.map(valence);
  if (questions.limit) answer.limit = questions.limit(valence);
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

Json answer_json(const Answer& answer, const MeshSchemeDescription& description) {
  Json modes = Json::array();
  for (const ModeRoot& root : answer.roots) {
    if (static_cast<std::size_t>(root.mode) == modes.size())
      modes.push_back({{"mode", root.mode}, {"values", Json::array()}});
    modes[static_cast<std::size_t>(root.mode)]["values"].push_back(
        {{"real", interval_json(root.real, root.rigour)},
         {"imaginary", interval_json(root.imaginary, root.rigour)},
         {"multiplicity", root.multiplicity},
         {"rigour", rigour_word(root.rigour)}});
  }
  Json json = {{"valence", answer.valence},
               {"parameters", parameters_json(description)},
               {"eigenvalues", std::move(modes)},
               {"subdominant", interval_json(answer.subdominant, answer.rigour)},
               {"next", interval_json(answer.next, answer.rigour)},
               {"rigour", rigour_word(answer.rigour)},
               {"condition", decision_json(answer.condition)},
               {"characteristic_map", map_json(answer.map)}};
  if (answer.limit) {
    const auto& [beta, gamma] = *answer.limit;
    json["limit_stencil"] = {{"alpha", (Rational(1) - beta - gamma).to_string()},
                             {"beta", beta.to_string()},
                             {"gamma", gamma.to_string()}};
  }
  return json;
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
  const Equations equations = equations_of(description);
  const Questions questions = questions_of(description);
  Json json = Json::array();
  bool open = false;
  constexpr const char* row = "{:>7}  {:<16}{:<16}{:<11}{}\n";
  if (!options.json)
    std::cout << fmt::format(row, "valence", "sub-dominant", "next", "condition", "characteristic map");
  for (int n = valences.first; n <= valences.last; ++n) {
    const Answer answer = answer_at(equations, questions, n);
    open = open || answer.condition == Decision::undecided;
    if (options.json) {
      json.push_back(answer_json(answer, description));
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

constexpr int json_digits = 18;
constexpr int text_digits = 9;

/// Cells that are decided are rounded inwards, the others outwards.
std::string end_text(const ConditionCell& cell, const Rational& end, int digits) {
  const int outwards = end == cell.lower ? -1 : 1;
  return to_significant(end, digits, cell.holds == Decision::undecided ? outwards : -outwards);
}

/// Speeds lie between 0 and 1 on the whole range.
void require_speeds(const MeshSchemeDescription& description, const ParameterRange& range) {
  if (!description.family->rings_only) return;
  const RationalFunction sigma = speed_of(description);
  const RealInterval closed = closed_interval(range.lower, range.upper);
  if (is_positive(sigma, closed) && is_positive(RationalFunction(1) - sigma, closed)) return;
  throw InputError(
      fmt::format("--over {}={}..{}: speeds lie strictly between 0 and 1, and sigma = {} leaves that "
                  "interval; for example --over sigma=1/100..99/100",
                  range.name, range.lower.to_string(), range.upper.to_string(),
                  sigma.to_string(std::vector{range.name})));
}

int eigen_over(const EigenOptions& options, const MeshSchemeDescription& description,
               const Valences& valences, const ParameterRange& range) {
  require_speeds(description, range);
  const Equations equations = equations_of(description);
  const bool proved_for_all = description.family->rings_only && lambda_is_subdominant();
  const Rational width = (range.upper - range.lower) / Rational(finest_cells);
  Json json = Json::array();
  if (!options.json) std::cout << fmt::format("{:>7}  condition on {}\n", "valence", range.name);
  for (int n = valences.first; n <= valences.last; ++n) {
    const std::vector<ConditionCell> cells =
        proved_for_all ? std::vector{ConditionCell{range.lower, range.upper, Decision::yes}}
                       : equations.condition(n).cells(range.lower, range.upper, width);
    Json parts = Json::array();
    std::string line;
    for (const ConditionCell& cell : cells) {
      parts.push_back({{"lower", end_text(cell, cell.lower, json_digits)},
                       {"upper", end_text(cell, cell.upper, json_digits)},
                       {"condition", decision_json(cell.holds)}});
      line += fmt::format("{}{} [{}, {}]", line.empty() ? "" : "; ", decision_text(cell.holds),
                          end_text(cell, cell.lower, text_digits), end_text(cell, cell.upper, text_digits));
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
