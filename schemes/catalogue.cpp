#include "schemes/catalogue.h"

#include <algorithm>
#include <cstddef>

#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// A mask without real parameters, computed over the rationals.
Mask<Polynomial> constant_mask(const Mask<Rational>& mask) {
  return map_coefficients(mask, [](const Rational& q) { return Polynomial(q); });
}

Mask<Polynomial> symmetric_jspline(std::span<const long> /*whole*/) {
  return jspline(Polynomial::variable(0));
}
Mask<Polynomial> general_jspline(std::span<const long> /*whole*/) {
  return jspline(Polynomial::variable(0), Polynomial::variable(1));
}
Mask<Polynomial> bspline_of_degree(std::span<const long> whole) {
  return constant_mask(bspline<Rational>(static_cast<int>(whole[0])));
}
Mask<Polynomial> tension_four_point(std::span<const long> /*whole*/) {
  return four_point(Polynomial::variable(0));
}
Mask<Polynomial> tension_dyn_floater_hormann(std::span<const long> /*whole*/) {
  return dyn_floater_hormann(Polynomial::variable(0));
}
Mask<Polynomial> interpolation_by_points(std::span<const long> whole) {
  return constant_mask(deslauriers_dubuc<Rational>(static_cast<int>(whole[0])));
}

Parameter real_parameter(std::string name, std::string meaning, std::string default_value = "") {
  return {.name = std::move(name), .meaning = std::move(meaning), .default_value = std::move(default_value)};
}

std::vector<Family> make_catalogue() {
  constexpr long highest_degree = 200;
  constexpr long most_points = 64;
  const Parameter degree{.name = "degree",
                         .meaning = "polynomial degree of the pieces",
                         .default_value = "",
                         .whole = true,
                         .least = 0,
                         .greatest = highest_degree};
  const Parameter points{.name = "points",
                         .meaning = "points of the interpolating polynomial",
                         .default_value = "4",
                         .whole = true,
                         .least = 2,
                         .greatest = most_points,
                         .step = 2};
  return {
      {.name = "jspline",
       .aliases = {},
       .summary =
           "J-splines: (1-s) four-point + s cubic B-spline, or J_{a,b} with even rule a and odd rule b",
       .source = "Rossignac, Schaefer: J-splines, section 1",
       .forms = {{{real_parameter("s",
                                  "even and odd rule alike; 0 four-point, 1 cubic, 3/2 quintic B-spline")},
                  symmetric_jspline},
                 {{real_parameter("a", "even rule (a, 8-2a, a)/8"),
                   real_parameter("b", "odd rule (b-1, 9-b, 9-b, b-1)/16")},
                  general_jspline}}},
      {.name = "bspline",
       .aliases = {"lane-riesenfeld"},
       .summary = "uniform B-splines: one doubling and `degree` averagings",
       .source =
           "Lane, Riesenfeld: A theoretical development for the computer generation of piecewise polynomial "
           "surfaces, 1980",
       .forms = {{{degree}, bspline_of_degree}}},
      {.name = "four-point",
       .aliases = {},
       .summary = "interpolating four-point scheme with tension w",
       .source = "Dyn, Levin, Gregory: A 4-point interpolatory subdivision scheme for curve design, 1987",
       .forms = {{{real_parameter("w", "tension; 1/16 reproduces cubics, 0 gives the polygon", "1/16")},
                  tension_four_point}}},
      {.name = "dyn-floater-hormann",
       .aliases = {},
       .summary = "dual four-point scheme with tension w",
       .source =
           "Dyn, Floater, Hormann: A C2 four-point subdivision scheme with fourth order accuracy and its "
           "extensions, 2005",
       .forms = {{{real_parameter("w", "tension; 1/128 reproduces cubics, 0 gives corner cutting", "1/128")},
                  tension_dyn_floater_hormann}}},
      {.name = "deslauriers-dubuc",
       .aliases = {},
       .summary = "interpolating schemes by local polynomials through an even number of points",
       .source = "Deslauriers, Dubuc: Symmetric iterative interpolation processes, 1989",
       .forms = {{{points}, interpolation_by_points}}},
  };
}

bool takes(const FamilyForm& form, const std::string& name) {
  return std::any_of(form.parameters.begin(), form.parameters.end(),
                     [&](const Parameter& p) { return p.name == name; });
}

std::vector<std::string> all_parameter_names(const Family& family) {
  std::vector<std::string> names;
  for (const FamilyForm& form : family.forms) {
    for (const Parameter& p : form.parameters) names.push_back(p.name);
  }
  return names;
}

std::string example(const Family& family) {
  const FamilyForm& form = family.forms.front();
  const Parameter& parameter = form.parameters.front();
  const std::string value =
      parameter.is_required() ? (parameter.whole ? "3" : "1/2") : parameter.default_value;
  return family.name + ":" + parameter.name + "=" + value;
}

}  // namespace

std::string Parameter::range() const {
  if (!whole) return "a real number";
  const std::string kind = step == 2 && least % 2 == 0 ? "an even number" : "a whole number";
  return kind + " from " + std::to_string(least) + " to " + std::to_string(greatest);
}

std::span<const Family> catalogue() {
  static const std::vector<Family> families = make_catalogue();
  return families;
}

const Family& find_family(std::string_view name) {
  std::vector<std::string> known;
  for (const Family& family : catalogue()) {
    known.push_back(family.name);
    known.insert(known.end(), family.aliases.begin(), family.aliases.end());
    if (std::find(known.begin(), known.end(), name) != known.end()) return family;
  }
  const std::vector<std::string> meshes = mesh_scheme_names();
  if (names_mesh_scheme(name)) {
    throw InputError(in_quotes(name) + " is a scheme for meshes; the schemes for curves and grids are " +
                     joined(known, "and"));
  }
  std::vector<std::string> near = known;
  near.insert(near.end(), meshes.begin(), meshes.end());
  throw InputError("unknown scheme " + in_quotes(name) + suggestion(name, near) +
                   " Known schemes: " + joined(known, "and") + ", and for meshes " + joined(meshes, "and") +
                   "; a scheme of your own is a file whose name ends in .json");
}

const FamilyForm& find_form(const Family& family, std::span<const std::string> given) {
  const std::vector<std::string> known = all_parameter_names(family);
  for (const std::string& name : given) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError(family.name + " has no parameter " + in_quotes(name) + suggestion(name, known) + " " +
                       usage(family));
    }
  }
  const auto is_given = [&](const std::string& name) {
    return std::find(given.begin(), given.end(), name) != given.end();
  };
  std::string problem = "these parameters do not go together";
  for (const FamilyForm& form : family.forms) {
    if (!std::all_of(given.begin(), given.end(), [&](const std::string& name) { return takes(form, name); }))
      continue;
    std::vector<std::string> missing;
    for (const Parameter& p : form.parameters) {
      if (p.is_required() && !is_given(p.name)) missing.push_back(p.name);
    }
    if (missing.empty()) return form;
    problem = given.empty() ? "a parameter is missing" : "a value is missing for " + joined(missing, "and");
  }
  throw InputError(problem + ": " + usage(family) + ", for example " + example(family));
}

std::string usage(const Family& family) {
  std::string result = family.name + " takes ";
  for (std::size_t i = 0; i < family.forms.size(); ++i) {
    std::vector<std::string> words;
    for (const Parameter& p : family.forms[i].parameters) {
      words.push_back(p.name + (p.is_required() ? "" : " (default " + p.default_value + ")"));
    }
    result += (i > 0 ? ", or " : "") + joined(words, "and");
  }
  return result;
}

}  // namespace subdiv
