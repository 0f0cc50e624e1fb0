#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/continuity_certificate.h"
#include "analysis/hoelder.h"
#include "analysis/limit_mask.h"
#include "analysis/reif.h"
#include "analysis/retrofit.h"
#include "analysis/sum_rules.h"
#include "experiments/cli/over.h"
#include "experiments/definition_parts.h"
#include "experiments/polygon_file.h"
#include "optimize/objectives.h"
#include "optimize/polygon_objectives.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

using Kind = DefinitionArgument::Kind;

std::vector<cli::ParameterRange> ranges_of(const DefinitionCall& call, const SchemeDescription& scheme,
                                           cli::RangeEnds ends) {
  return cli::parse_over(call.text("over"), scheme.free_parameters, ends, "\"over\"");
}

ContinuityCertificate certificate_of(const DefinitionCall& call) {
  const SchemeDescription description = scheme_of(call);
  const Scheme<RationalFunction> scheme = symbolic_scheme(description);
  ParameterBox box;
  for (const cli::ParameterRange& range : ranges_of(call, description, cli::RangeEnds::may_coincide)) {
    box.lower.push_back(range.lower);
    box.upper.push_back(range.upper);
  }
  CertificateOptions options;
  options.seconds = std::stod(call.text("budget"));
  try {
    for (const Mask<RationalFunction>& step : scheme.steps) {
      if (const auto violation = violated_affine_invariance(step))
        throw InputError(description.text + ": the step violates the first sum rule: " + *violation);
      if (box.lower.size() == 1) require_no_pole(step, box);
    }
    return certify_continuity(scheme.last(), static_cast<int>(call.whole("continuity")), box, options);
  } catch (const std::domain_error& error) {
    throw InputError(fmt::format("{} over {}: {}", call.text("scheme"), call.text("over"), error.what()));
  }
}

/// The cells with one answer as a set of the only parameter; those that touch are joined.
RealSet cells_with(const ContinuityCertificate& certificate, Decision smooth) {
  RealSet set;
  for (const CertificateCell& cell : certificate.cells) {
    if (cell.smooth != smooth) continue;
    const RealInterval& side = cell.sides.front();
    if (!set.parts.empty()) {
      RealInterval& last = set.parts.back();
      if (*last.upper == *side.lower && (last.upper_closed || side.lower_closed)) {
        last.upper = side.upper;
        last.upper_closed = side.upper_closed;
        continue;
      }
    }
    set.parts.push_back(side);
  }
  return set;
}

void check_ranges(const DefinitionCall& call) {
  (void)ranges_of(call, scheme_of(call), cli::RangeEnds::may_coincide);
}

void check_one_range(const DefinitionCall& call) {
  const SchemeDescription scheme = scheme_of(call);
  (void)ranges_of(call, scheme, cli::RangeEnds::differ);
  if (scheme.free_parameters.size() > 1) {
    throw InputError("the scheme " + in_quotes(call.text("scheme")) + " leaves " +
                     joined(scheme.free_parameters, "and") +
                     " free; a set of numbers needs one free parameter");
  }
}

/// All of it is decided, or InputError says what is not.
Answer smooth_range(const DefinitionCall& call) {
  const ContinuityCertificate certificate = certificate_of(call);
  const RealSet open = cells_with(certificate, Decision::undecided);
  if (!open.is_empty()) {
    Answer answer = property_answer(Decision::undecided, Rigour::certified,
                                    "Undecided within the budget: " + open.to_string() + "; proved: " +
                                        cells_with(certificate, Decision::yes).to_string() + ".");
    return answer;
  }
  return set_answer(call, cells_with(certificate, Decision::yes));
}

/// C^M in all of the box, or inside of it.
Answer smooth(const DefinitionCall& call) {
  const SchemeDescription description = scheme_of(call);
  const ContinuityCertificate certificate = certificate_of(call);
  const bool inside = call.text("ends") == "open";
  bool open = !certificate.exceptions.empty();
  std::string fails;
  for (const CertificateCell& cell : certificate.cells) {
    bool is_end = false;
    for (const RealInterval& side : cell.sides) is_end = is_end || side.is_point();
    if (inside && is_end && certificate.cells.size() > 1 &&
        (&cell == &certificate.cells.front() || &cell == &certificate.cells.back()))
      continue;
    open = open || cell.smooth == Decision::undecided;
    if (cell.smooth != Decision::no || !fails.empty()) continue;
    for (std::size_t i = 0; i < cell.sides.size(); ++i) {
      fails += (fails.empty() ? "" : ", ") + description.free_parameters[i] + " in " +
               RealSet{{cell.sides[i]}}.to_string();
    }
  }
  if (!fails.empty())
    return property_answer(Decision::no, Rigour::certified,
                           fmt::format("It fails for {}, in the sense of differences.", fails));
  return property_answer(open ? Decision::undecided : Decision::yes, Rigour::certified);
}

Answer retrofit(const DefinitionCall& call) {
  const Scheme<RationalFunction> scheme = symbolic_scheme(scheme_of(call));
  try {
    const Laurent<RationalFunction> mask = vertex_limit_mask(scheme);
    if (!call.has("points")) return set_answer(call, retrofit_range(mask));
    return set_answer(call, retrofit_range_of_loops(mask, static_cast<int>(call.whole("points"))));
  } catch (const std::domain_error& error) {
    throw InputError(call.text("scheme") + ": " + error.what());
  }
}

Answer necessary_range(const DefinitionCall& call) {
  const Scheme<RationalFunction> scheme = symbolic_scheme(scheme_of(call));
  return set_answer(call, reif_set(scheme.last(), static_cast<int>(call.whole("continuity"))));
}

void check_one_parameter(const DefinitionCall& call) {
  const std::size_t count = scheme_of(call).free_parameters.size();
  if (count != 1) {
    throw InputError(
        fmt::format("the scheme {} has {} free parameters; this definition needs one, as in jspline:s=s",
                    in_quotes(call.text("scheme")), count));
  }
}

Norm norm_of(const std::string& name) {
  for (const Norm norm : {Norm::l1, Norm::l2}) {
    if (to_string(norm) == name) return norm;
  }
  return Norm::linf;
}

Summary summary_of(const DefinitionCall& call) {
  const SchemeDescription description = scheme_of(call);
  std::vector<Range> box;
  for (const cli::ParameterRange& range : ranges_of(call, description, cli::RangeEnds::differ))
    box.push_back({range.lower, range.upper});
  const Scheme<RationalFunction> scheme = symbolic_scheme(description);
  const Norm norm = norm_of(call.text("norm"));
  Summary summary;
  if (call.has("polygon")) {
    const auto points = read_points<Rational>(call.folder / call.text("polygon"));
    summary = minimise_on_polygon(scheme, parse_polygon_objective(call.text("objective")), norm,
                                  points.coordinates, box, description.free_parameters);
  } else {
    summary =
        minimise(scheme, parse_objective(call.text("objective")), norm, box, description.free_parameters);
  }
  if (summary.minimiser.empty())
    throw InputError("no minimum is found: " + to_string(summary.termination) + " " + summary.message);
  return summary;
}

std::string summary_note(const Summary& summary) {
  if (summary.termination == Termination::proved)
    return summary.message.empty() ? "" : "Note: " + summary.message + ".";
  return "Termination: " + to_string(summary.termination) +
         (summary.message.empty() ? "" : "; " + summary.message) + ".";
}

Answer minimum(const DefinitionCall& call) {
  const Summary summary = summary_of(call);
  return number_answer(summary.minimum, summary_note(summary));
}

Answer minimiser(const DefinitionCall& call) {
  const SchemeDescription description = scheme_of(call);
  const Summary summary = summary_of(call);
  std::size_t which = 0;
  for (std::size_t i = 0; i < description.free_parameters.size(); ++i) {
    if (call.has("parameter") && description.free_parameters[i] == call.text("parameter")) which = i;
  }
  Enclosure value = summary.minimiser.at(which);
  // Where several are possible the enclosure holds one of them, which decides nothing about the others.
  if (summary.termination != Termination::proved && value.status == Status::closed)
    value.status = Status::ambiguous;
  return number_answer(std::move(value), summary_note(summary));
}

void check_optimum(const DefinitionCall& call) {
  const SchemeDescription scheme = scheme_of(call);
  (void)ranges_of(call, scheme, cli::RangeEnds::differ);
  if (!call.has("parameter")) {
    if (call.definition->name == "minimiser" && scheme.free_parameters.size() > 1)
      throw InputError("the scheme leaves " + joined(scheme.free_parameters, "and") +
                       " free; name the one that is meant, \"parameter\": \"" + scheme.free_parameters[0] +
                       "\"");
    return;
  }
  for (const std::string& name : scheme.free_parameters) {
    if (name == call.text("parameter")) return;
  }
  throw InputError("\"parameter\": " + in_quotes(call.text("parameter")) +
                   " is no free parameter of the scheme; it has " + joined(scheme.free_parameters, "and"));
}

std::vector<DefinitionArgument> optimum_arguments(bool names_parameter) {
  std::vector<DefinitionArgument> list{
      scheme_argument(),
      over_argument(),
      {.name = "objective", .kind = Kind::objective, .meaning = "what is minimised, as for optimize"},
      {.name = "norm",
       .kind = Kind::word,
       .meaning = "of the residuals; l2 is the sum of squares",
       .required = false,
       .default_value = "linf",
       .words = {"l1", "l2", "linf"}},
      {.name = "polygon",
       .kind = Kind::file,
       .meaning = "a closed polygon, for objectives of its curve",
       .required = false}};
  if (names_parameter) {
    list.push_back({.name = "parameter",
                    .kind = Kind::word,
                    .meaning = "which one, where several are free",
                    .required = false});
  }
  return list;
}

Definition set_definition(std::string name, std::string summary, std::vector<DefinitionArgument> arguments,
                          void (*check)(const DefinitionCall&), Answer (*answer)(const DefinitionCall&),
                          std::string example) {
  arguments.push_back(end_argument());
  return {std::move(name), std::move(summary), std::move(arguments), set_kind, check, nullptr, check_set,
          answer,          std::move(example)};
}

}  // namespace

std::vector<Definition> range_definitions() {
  constexpr long most_points = 100;
  std::vector<Definition> list;
  list.push_back(set_definition(
      "smooth-range",
      "All values of the parameter in the range for which the scheme is C^M in the sense of its differences",
      {scheme_argument(), over_argument(), continuity_argument(), seconds_argument("30")}, check_one_range,
      smooth_range,
      R"({"name": "smooth-range", "scheme": "four-point:w=w", "over": "w=-1..1", "continuity": 1})"));
  list.push_back(
      {"smooth",
       "Whether the scheme is C^M in the sense of its differences for all values of the parameters in the "
       "ranges",
       {scheme_argument(),
        over_argument(),
        continuity_argument(),
        {.name = "ends",
         .kind = Kind::word,
         .meaning = "whether the ends of the range belong to it",
         .required = false,
         .default_value = "closed",
         .words = {"closed", "open"}},
        seconds_argument("30")},
       [](const DefinitionCall&) { return AnswerKind::property; },
       check_ranges,
       nullptr,
       nullptr,
       smooth,
       R"({"name": "smooth", "scheme": "four-point:w=w", "over": "w=1/100..1/8", "continuity": 1})"});
  list.push_back(set_definition(
      "necessary-range",
      "All values of the parameter for which the eigenvalues of the subdivision matrix allow C^M (Reif)",
      {scheme_argument(), continuity_argument()}, check_one_parameter, necessary_range,
      R"({"name": "necessary-range", "scheme": "jspline:s=s", "continuity": 2, "end": "upper"})"));
  list.push_back(set_definition("retrofit-range",
                                "All values of the parameter for which the iteration converges that makes "
                                "the limit pass through the points",
                                {scheme_argument(),
                                 {.name = "points",
                                  .kind = Kind::whole,
                                  .meaning = "of a closed loop; the infinite polygon when not given",
                                  .required = false,
                                  .least = 2,
                                  .greatest = most_points}},
                                check_one_parameter, retrofit,
                                R"({"name": "retrofit-range", "scheme": "jspline:s=s", "end": "lower"})"));
  list.push_back(
      {"minimiser", "The value of the parameter in the range that minimises the objective",
       optimum_arguments(true), always_number, check_optimum, nullptr, nullptr, minimiser,
       R"({"name": "minimiser", "scheme": "jspline:s=s", "over": "s=0..1", "objective": "area"})"});
  list.push_back({"minimum", "The least value of the objective over the range", optimum_arguments(false),
                  always_number, check_optimum, nullptr, nullptr, minimum,
                  R"({"name": "minimum", "scheme": "jspline:s=s", "over": "s=0..1", "objective": "area"})"});
  // "parameter" is a word of the scheme's own, which check_optimum knows.
  return list;
}

}  // namespace subdiv
