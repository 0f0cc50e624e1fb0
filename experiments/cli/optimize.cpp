#include <iostream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "experiments/cli/over.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/record.h"
#include "experiments/report/utf8.h"
#include "optimize/objectives.h"
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

Json summary_json(const OptimizeOptions& options, const Objective& objective, const Problem& question,
                  const Summary& summary) {
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
  return {{"scheme", options.scheme},
          {"objective", to_string(objective)},
          {"norm", options.norm},
          {"over", std::move(over)},
          {"minimiser", std::move(minimiser)},
          {"minimum", summary.minimiser.empty() ? Json(nullptr) : to_json(summary.minimum)},
          {"termination", to_string(summary.termination)},
          {"method", summary.method},
          {"boxes", summary.boxes},
          {"message", summary.message}};
}

void print_line(const std::string& name, const std::string& value) {
  constexpr std::size_t name_width = 16;
  std::cout << padded(name, name_width) << value << "\n";
}

std::string value_line(const Enclosure& value) {
  constexpr std::size_t width = 60;
  return value_text(as_record(value), width) + "  (" + to_string(value.rigour) + ")";
}

void print(const OptimizeOptions& options, const Objective& objective, const Problem& question,
           const Summary& summary) {
  print_line("scheme", options.scheme);
  print_line("objective", to_string(objective) + ", norm " + options.norm);
  for (std::size_t i = 0; i < question.names.size(); ++i) {
    print_line("over", question.names[i] + " in [" + question.box[i].lower.to_string() + ", " +
                           question.box[i].upper.to_string() + "]");
  }
  for (std::size_t i = 0; i < summary.minimiser.size(); ++i) {
    print_line("minimiser", question.names[i] + " = " + value_line(summary.minimiser[i]));
  }
  if (!summary.minimiser.empty()) {
    print_line(question.norm == Norm::l2 ? "sum of squares" : "minimum", value_line(summary.minimum));
  }
  print_line("termination", to_string(summary.termination));
  if (!summary.method.empty()) print_line("method", summary.method);
  if (!summary.message.empty()) print_line("", summary.message);
}

int exit_code(const Summary& summary) {
  const bool decided =
      summary.termination == Termination::proved || summary.termination == Termination::not_unique;
  return decided ? ExitCode::done : ExitCode::undecided;
}

}  // namespace

int optimize(const OptimizeOptions& options) {
  const SchemeDescription description = parse_scheme(options.scheme);
  const Objective objective = parse_objective(options.objective);
  const Problem question{.residuals = {},
                         .norm = parse_norm(options.norm),
                         .box = parse_box(options.over, description.free_parameters),
                         .names = description.free_parameters};
  const Summary summary =
      minimise(symbolic_scheme(description), objective, question.norm, question.box, question.names);
  if (summary.termination == Termination::pole_in_box) {
    throw InputError("--over " + options.over +
                     ": division by zero, the objective has a pole in the box; choose one without it");
  }
  if (options.json) {
    std::cout << summary_json(options, objective, question, summary).dump(2) << "\n";
  } else {
    print(options, objective, question, summary);
  }
  return exit_code(summary);
}

}  // namespace subdiv::cli
