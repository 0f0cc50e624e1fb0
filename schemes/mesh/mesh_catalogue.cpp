#include "schemes/mesh/mesh_catalogue.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include <fmt/format.h>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/input_error.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

std::vector<MeshFamily> make_mesh_catalogue() {
  const Parameter tension{
      .name = "s", .meaning = "0 Kobbelt's interpolating scheme, 1 Catmull-Clark", .default_value = ""};
  return {
      {.name = "catmull-clark",
       .summary = "cubic B-splines on quads; faces with other numbers of corners are split once",
       .source =
           "Catmull, Clark: Recursively generated B-spline surfaces on arbitrary topological meshes, 1978",
       .parameters = {},
       .split = MeshSplit::quads},
      {.name = "kobbelt",
       .summary = "the interpolating four-point scheme on quads",
       .source =
           "Kobbelt: Interpolatory subdivision on open quadrilateral nets with arbitrary topology, 1996",
       .parameters = {},
       .split = MeshSplit::quads},
      {.name = "jspline-mesh",
       .summary = "J-splines on quads, rows then columns: J_s x J_s in regular regions",
       .source = "Rossignac, Schaefer: J-splines, section 10",
       .parameters = {tension},
       .split = MeshSplit::quads},
      {.name = "jspline-mesh-literal",
       .summary = "J-splines on quads by the printed formula: (1-s) Kobbelt + s Catmull-Clark",
       .source = "Rossignac, Schaefer: J-splines, section 10",
       .parameters = {tension},
       .split = MeshSplit::quads},
      {.name = "loop",
       .summary = "quartic box splines on triangles, with Warren's weights",
       .source = "Warren: Subdivision methods for geometric design, 1995; Loop 1987",
       .parameters = {},
       .split = MeshSplit::triangles},
      {.name = "loop-1987",
       .summary = "quartic box splines on triangles, with Loop's own weights",
       .source = "Loop: Smooth subdivision surfaces based on triangles, 1987",
       .parameters = {},
       .split = MeshSplit::triangles},
      {.name = "butterfly",
       .summary = "interpolating, on triangles",
       .source = "Dyn, Levin, Gregory: A butterfly subdivision scheme for surface interpolation with tension "
                 "control, 1990",
       .parameters = {},
       .split = MeshSplit::triangles},
      {.name = "adjustable-speed",
       .summary = "bicubic surface rings around extraordinary vertices, knots in geometric progression",
       .source = "Karciauskas, Peters: Adjustable speed surface subdivision, 2009",
       .parameters = {{.name = "sigma",
                       .meaning = "the speed, 0 < sigma < 1: the hole shrinks by about 1 - sigma a step; 1/2 "
                                  "Catmull-Clark",
                       .default_value = ""}},
       .split = MeshSplit::quads,
       .rings_only = true},
  };
}

std::string_view name_of(std::string_view text) { return trimmed(text.substr(0, text.find(':'))); }

const MeshFamily* find(std::string_view name) {
  for (const MeshFamily& family : mesh_catalogue()) {
    if (family.name == name) return &family;
  }
  return nullptr;
}

bool is_curve_scheme(std::string_view name) {
  return name.ends_with(".json") ||
         std::any_of(catalogue().begin(), catalogue().end(), [&](const Family& family) {
           return family.name == name ||
                  std::find(family.aliases.begin(), family.aliases.end(), name) != family.aliases.end();
         });
}

const MeshFamily& find_mesh_family(std::string_view name) {
  if (const MeshFamily* family = find(name)) return *family;
  const std::vector<std::string> known = mesh_scheme_names();
  if (is_curve_scheme(name)) {
    throw InputError(in_quotes(name) + " is a scheme for curves and grids; the schemes for meshes are " +
                     joined(known, "and"));
  }
  throw InputError("unknown mesh scheme " + in_quotes(name) + suggestion(name, known) +
                   " Known mesh schemes: " + joined(known, "and"));
}

/// The arguments in the order of the family's parameters.
std::vector<Argument> completed(const MeshFamily& family, const std::vector<Argument>& given) {
  std::vector<std::string> known;
  for (const Parameter& parameter : family.parameters) known.push_back(parameter.name);
  for (const Argument& argument : given) {
    if (std::find(known.begin(), known.end(), argument.name) != known.end()) continue;
    throw InputError(family.name + " has no parameter " + in_quotes(argument.name) +
                     suggestion(argument.name, known) + " " + usage(family));
  }
  std::vector<Argument> result;
  for (const std::string& name : known) {
    const auto found =
        std::find_if(given.begin(), given.end(), [&](const Argument& a) { return a.name == name; });
    if (found == given.end()) {
      throw InputError(fmt::format("a value is missing for {}: {}, for example {}:{}=1/2", name,
                                   usage(family), family.name, name));
    }
    result.push_back(*found);
  }
  return result;
}

}  // namespace

template <class R>
std::vector<R> parameter_values(const MeshSchemeDescription& description, std::span<const R> free_values) {
  const std::vector<std::string>& free = description.free_parameters;
  if (free_values.size() != free.size())
    throw std::domain_error("a scheme needs one value for each of its free parameters");
  const auto lookup = [&](const std::string& name, const Expression::Node& /*node*/) {
    return free_values[static_cast<std::size_t>(std::find(free.begin(), free.end(), name) - free.begin())];
  };
  std::vector<R> values;
  for (const Argument& argument : description.arguments) {
    const std::string place = in_quotes(description.text) + ": value of " + argument.name + ", ";
    try {
      values.push_back(evaluate<R>(argument.value, lookup));
    } catch (const OutsideRingError& error) {
      throw OutsideRingError(place + error.what());
    } catch (const InputError& error) {
      throw InputError(place + error.what());
    }
  }
  return values;
}

namespace {

template <class R>
bool may_be_zero(const R& x) {
  if constexpr (std::is_same_v<R, Interval>) return x.contains_zero();
  return is_zero(x);
}

template <class R>
void require_no_pole(const MeshSchemeDescription& description, const R& s) {
  if (!may_be_zero(R(9) - s)) return;
  throw InputError(in_quotes(description.text) +
                   ": the scheme does not exist at s = 9, where the points that stand for missing ones at "
                   "irregular vertices have the weight (1 - s)/(9 - s); jspline-mesh-literal does");
}

template <class R>
bool lies_between_0_and_1(const R& sigma) {
  if constexpr (std::is_same_v<R, Interval>) {
    return certainly_positive(sigma) && certainly_less(sigma, Interval(1));
  } else if constexpr (std::is_same_v<R, RationalFunction>) {
    return !sigma.is_constant() || lies_between_0_and_1(sigma.constant());
  } else {
    return R(0) < sigma && sigma < R(1);
  }
}

/// Throws InputError when there is no scheme for these values.
template <class R>
void require_scheme_over(const MeshSchemeDescription& description, std::span<const R> free_values = {}) {
  if (!description.family->rings_only) {
    static_cast<void>(mesh_scheme<R>(description, free_values));
    return;
  }
  if (lies_between_0_and_1(parameter_values<R>(description, free_values).front())) return;
  throw InputError(
      "a speed lies strictly between 0 and 1; towards 0 rings become thin, towards 1 they close "
      "the hole, and 1/2 is Catmull-Clark");
}

/// The free parameters as indeterminates.
std::vector<RationalFunction> indeterminates(const MeshSchemeDescription& description) {
  std::vector<RationalFunction> variables;
  for (std::size_t i = 0; i < description.free_parameters.size(); ++i)
    variables.push_back(RationalFunction::variable(static_cast<int>(i)));
  return variables;
}

/// Evaluates the scheme over the smallest ring that holds its values, so that errors come out at once.
void require_scheme(const MeshSchemeDescription& description) {
  try {
    if (!description.free_parameters.empty()) {
      require_scheme_over<RationalFunction>(description, indeterminates(description));
    } else {
      require_scheme_over<Rational>(description);
    }
    return;
  } catch (const OutsideRingError&) {
    if (!description.free_parameters.empty()) return;
  }
  try {
    require_scheme_over<Algebraic>(description);
  } catch (const OutsideRingError&) {
    require_scheme_over<Interval>(description);
  }
}

MeshSchemeDescription parse_unlocated(std::string_view inner) {
  if (split_outside_parentheses(inner, '+').size() > 1) {
    throw InputError("a mesh scheme is one step, repeated; a sum in a value stands in parentheses");
  }
  MeshSchemeDescription result;
  result.text = inner;
  result.family = &find_mesh_family(name_of(inner));
  const std::size_t colon = inner.find(':');
  std::vector<Argument> given;
  if (colon != std::string_view::npos) given = parse_arguments(inner.substr(colon + 1));
  result.arguments = completed(*result.family, given);
  add_free_names(result.arguments, result.free_parameters);
  return result;
}

}  // namespace

std::span<const MeshFamily> mesh_catalogue() {
  static const std::vector<MeshFamily> families = make_mesh_catalogue();
  return families;
}

std::vector<std::string> mesh_scheme_names() {
  std::vector<std::string> names;
  for (const MeshFamily& family : mesh_catalogue()) names.push_back(family.name);
  return names;
}

bool names_mesh_scheme(std::string_view text) { return find(name_of(text)) != nullptr; }

std::string usage(const MeshFamily& family) {
  std::vector<std::string> names;
  for (const Parameter& parameter : family.parameters) names.push_back(parameter.name);
  return family.name + " takes " + (names.empty() ? "no parameters" : joined(names, "and"));
}

MeshSchemeDescription parse_mesh_scheme(std::string_view text) {
  const std::string_view inner = trimmed(text);
  if (inner.empty()) throw InputError("the scheme is empty; meshes take " + joined(mesh_scheme_names()));
  try {
    MeshSchemeDescription result = parse_unlocated(inner);
    require_scheme(result);
    return result;
  } catch (const InputError& error) {
    throw InputError("scheme " + in_quotes(inner) + ": " + error.what());
  }
}

template <class R>
MeshScheme<R> mesh_scheme(const MeshSchemeDescription& description, std::span<const R> free_values) {
  const std::string& name = description.family->name;
  const std::vector<R> values = parameter_values(description, free_values);
  if (description.family->rings_only) {
    throw InputError(in_quotes(description.text) +
                     ": the scheme makes rings of surface around extraordinary vertices and has no rules for "
                     "whole meshes; subdivlab rings makes them");
  }
  if (name == "catmull-clark") return catmull_clark<R>();
  if (name == "kobbelt") return kobbelt<R>();
  if (name == "loop") return loop<R>();
  if (name == "loop-1987") return loop_1987<R>();
  if (name == "butterfly") return butterfly<R>();
  if (name == "jspline-mesh-literal") return jspline_mesh_literal(values.front());
  if (name != "jspline-mesh") throw std::logic_error("no rules for the mesh scheme " + name);
  require_no_pole(description, values.front());
  return jspline_mesh(values.front());
}

template std::vector<double> parameter_values(const MeshSchemeDescription&, std::span<const double>);
template std::vector<Interval> parameter_values(const MeshSchemeDescription&, std::span<const Interval>);
template std::vector<Rational> parameter_values(const MeshSchemeDescription&, std::span<const Rational>);
template std::vector<Algebraic> parameter_values(const MeshSchemeDescription&, std::span<const Algebraic>);
template std::vector<RationalFunction> parameter_values(const MeshSchemeDescription&,
                                                        std::span<const RationalFunction>);

template MeshScheme<double> mesh_scheme(const MeshSchemeDescription&, std::span<const double>);
template MeshScheme<Interval> mesh_scheme(const MeshSchemeDescription&, std::span<const Interval>);
template MeshScheme<Rational> mesh_scheme(const MeshSchemeDescription&, std::span<const Rational>);
template MeshScheme<Algebraic> mesh_scheme(const MeshSchemeDescription&, std::span<const Algebraic>);
template MeshScheme<RationalFunction> mesh_scheme(const MeshSchemeDescription&,
                                                  std::span<const RationalFunction>);

MeshScheme<RationalFunction> symbolic_mesh_scheme(const MeshSchemeDescription& description,
                                                  std::optional<int> turn_variable) {
  if (turn_variable && description.family->name == "loop-1987") {
    return loop_1987<RationalFunction>(
        [turn = RationalFunction::variable(*turn_variable)](int /*n*/) { return turn; });
  }
  return mesh_scheme<RationalFunction>(description, indeterminates(description));
}

}  // namespace subdiv
