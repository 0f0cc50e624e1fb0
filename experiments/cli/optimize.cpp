#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "experiments/cli/over.h"
#include "experiments/cli/verbs.h"
#include "experiments/polygon_file.h"
#include "experiments/report/record.h"
#include "experiments/report/utf8.h"
#include "optimize/objectives.h"
#include "optimize/polygon_objectives.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

Norm parse_norm(const std::string& name) {
  for (const Norm norm : {Norm::l1, Norm::l2, Norm::linf}) {
    if (to_string(norm) == name) return norm;
  }
  throw InputError("--norm: " + in_quotes(name) + " is no norm; expected l1, l2 or linf");
}

std::vector<Range> parse_box(const std::string& over, const std::vector<std::string>& free_parameters) {
  std::vector<Range> box;
  for (const ParameterRange& range : parse_over(over, free_parameters, RangeEnds::differ)) {
    box.push_back({range.lower, range.upper});
  }
  return box;
}

ClaimRecord as_record(const Enclosure& value) {
  return to_record(settle({"value", "", "", std::nullopt, ClaimKind::exact, ""}, value));
}

Json to_json(const Enclosure& value) {
  const ClaimRecord record = as_record(value);
  Json json = Json::object();
  if (record.exact) json["exact"] = *record.exact;
  json["lower"] = *record.lower;
  json["upper"] = *record.upper;
  json["rigour"] = record.rigour;
  return json;
}

/// What is asked: the objective as text, and the norm and box of a problem without residuals.
struct Question {
  std::string objective;
  Problem problem;
  bool one_number = false;  // whose norms are all its absolute value
};

Json summary_json(const OptimizeOptions& options, const Question& asked, const Summary& summary) {
  const Problem& question = asked.problem;
  Json over = Json::array();
  Json minimiser = Json::array();
  for (std::size_t i = 0; i < question.names.size(); ++i) {
    over.push_back({{"parameter", question.names[i]},
                    {"lower", question.box[i].lower.to_string()},
                    {"upper", question.box[i].upper.to_string()}});
    if (i >= summary.minimiser.size()) continue;
    Json value = {{"parameter", question.names[i]}};
    value.update(to_json(summary.minimiser[i]));
    minimiser.push_back(std::move(value));
  }
  Json json = {{"scheme", options.scheme}, {"objective", asked.objective}};
  if (!options.polygon.empty()) json["polygon"] = options.polygon;
  json["norm"] = to_string(question.norm);
  json["over"] = std::move(over);
  json["minimiser"] = std::move(minimiser);
  json["minimum"] = summary.minimiser.empty() ? Json(nullptr) : to_json(summary.minimum);
  for (const Enclosure& zero : summary.zeros) json["zeros"].push_back(to_json(zero));
  json["termination"] = to_string(summary.termination);
  json["method"] = summary.method;
  json["boxes"] = summary.boxes;
  json["message"] = summary.message;
  return json;
}

void print_line(const std::string& name, const std::string& value) {
  constexpr std::size_t name_width = 16;
  std::cout << padded(name, name_width) << value << "\n";
}

std::string value_line(const Enclosure& value) {
  constexpr std::size_t width = 60;
  return value_text(as_record(value), width) + "  (" + to_string(value.rigour) + ")";
}

void print(const OptimizeOptions& options, const Question& asked, const Summary& summary) {
  const Problem& question = asked.problem;
  print_line("scheme", options.scheme);
  print_line("objective", asked.objective + ", norm " + to_string(question.norm));
  if (!options.polygon.empty()) print_line("polygon", options.polygon);
  for (std::size_t i = 0; i < question.names.size(); ++i) {
    print_line("over", question.names[i] + " in [" + question.box[i].lower.to_string() + ", " +
                           question.box[i].upper.to_string() + "]");
  }
  for (std::size_t i = 0; i < summary.minimiser.size(); ++i) {
    print_line("minimiser", question.names[i] + " = " + value_line(summary.minimiser[i]));
  }
  if (!summary.minimiser.empty()) {
    const bool squares = question.norm == Norm::l2 && !asked.one_number;
    print_line(squares ? "sum of squares" : "minimum", value_line(summary.minimum));
  }
  if (summary.zeros.size() > 1) {
    for (const Enclosure& zero : summary.zeros)
      print_line("zero", question.names[0] + " = " + value_line(zero));
  }
  print_line("termination", to_string(summary.termination));
  if (!summary.method.empty()) print_line("method", summary.method);
  if (!summary.message.empty()) print_line("", summary.message);
}

/// Local answers are all that their objectives promise; elsewhere what is not proved is undecided.
int exit_code(const Summary& summary) {
  const bool decided = summary.termination == Termination::proved ||
                       summary.termination == Termination::not_unique ||
                       summary.termination == Termination::local;
  return decided ? ExitCode::done : ExitCode::undecided;
}

/// An objective of the scheme alone.
Summary minimise_scheme(const OptimizeOptions& options, const SchemeDescription& description,
                        Question& asked) {
  const auto known = objectives();
  const std::string name = options.objective.substr(0, options.objective.find(':'));
  const bool of_scheme = std::ranges::any_of(known, [&](const auto& entry) { return entry.name == name; });
  if (!of_scheme && names_polygon_objective(options.objective)) {
    throw InputError("--objective " + options.objective +
                     " is about a given polygon: name its file, --polygon FILE.csv");
  }
  const Objective objective = parse_objective(options.objective);
  if (options.norm.empty()) throw InputError("--norm is required: l1, l2 or linf");
  asked.objective = to_string(objective);
  return minimise(symbolic_scheme(description), objective, asked.problem.norm, asked.problem.box,
                  asked.problem.names);
}

/// An objective of the scheme on a polygon.
Summary minimise_curve(const OptimizeOptions& options, const SchemeDescription& description,
                       Question& asked) {
  const PolygonObjective objective = parse_polygon_objective(options.objective);
  const PointList<Rational> points = read_points<Rational>(options.polygon);
  if (points.closed.has_value() && !*points.closed) {
    throw InputError(options.polygon + ": its line element is open; the objectives need a closed polygon, " +
                     "whose line element returns to its first point");
  }
  asked.objective = to_string(objective);
  asked.one_number = objective.kind == PolygonObjective::Kind::area;
  return minimise_on_polygon(symbolic_scheme(description), objective, asked.problem.norm, points.coordinates,
                             asked.problem.box, asked.problem.names);
}

}  // namespace

int optimize(const OptimizeOptions& options) {
  const SchemeDescription description = parse_scheme(options.scheme);
  Question asked{"",
                 {.residuals = {},
                  .norm = options.norm.empty() ? Norm::linf : parse_norm(options.norm),
                  .box = parse_box(options.over, description.free_parameters),
                  .names = description.free_parameters},
                 false};
  const Summary summary = options.polygon.empty() ? minimise_scheme(options, description, asked)
                                                  : minimise_curve(options, description, asked);
  if (summary.termination == Termination::pole_in_box) {
    throw InputError("--over " + options.over +
                     ": division by zero, the objective has a pole in the box; choose one without it");
  }
  if (options.json) {
    std::cout << summary_json(options, asked, summary).dump(2) << "\n";
  } else {
    print(options, asked, summary);
  }
  return exit_code(summary);
}

}  // namespace subdiv::cli
