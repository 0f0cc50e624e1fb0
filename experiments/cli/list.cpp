#include <algorithm>
#include <iostream>

#include <nlohmann/json.hpp>

#include "experiments/cli/verbs.h"
#include "experiments/definitions.h"
#include "experiments/experiment.h"
#include "experiments/report/utf8.h"
#include "optimize/objectives.h"
#include "optimize/polygon_objectives.h"
#include "schemes/catalogue.h"
#include "schemes/mesh/mesh_catalogue.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t page_width = 100;

std::string faces_of(const MeshFamily& family) {
  return family.split == MeshSplit::quads ? "quads" : "triangles";
}

void print_parameters(const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    std::cout << "    " << padded(parameter.name, 8) << parameter.range() << ": " << parameter.meaning
              << "\n";
  }
}

void print_schemes() {
  for (const Family& family : catalogue()) {
    std::cout << family.name;
    for (const std::string& alias : family.aliases) std::cout << " (also " << alias << ")";
    std::cout << ": " << family.summary << "\n  " << usage(family) << "\n";
    for (const FamilyForm& form : family.forms) print_parameters(form.parameters);
    std::cout << "  " << family.source << "\n";
  }
  for (const MeshFamily& family : mesh_catalogue()) {
    std::cout << family.name << " (meshes of " << faces_of(family) << "): " << family.summary << "\n  "
              << usage(family) << "\n";
    print_parameters(family.parameters);
    std::cout << "  " << family.source << "\n";
  }
}

Json parameters_json(const std::vector<Parameter>& parameters) {
  Json list = Json::array();
  for (const Parameter& parameter : parameters) {
    list.push_back({{"name", parameter.name},
                    {"meaning", parameter.meaning},
                    {"range", parameter.range()},
                    {"default", parameter.is_required() ? Json(nullptr) : Json(parameter.default_value)}});
  }
  return list;
}

Json schemes_json() {
  Json list = Json::array();
  for (const Family& family : catalogue()) {
    Json forms = Json::array();
    for (const FamilyForm& form : family.forms)
      forms.push_back({{"parameters", parameters_json(form.parameters)}});
    list.push_back({{"name", family.name},
                    {"aliases", family.aliases},
                    {"kind", "curve"},
                    {"summary", family.summary},
                    {"source", family.source},
                    {"forms", std::move(forms)}});
  }
  for (const MeshFamily& family : mesh_catalogue()) {
    list.push_back({{"name", family.name},
                    {"aliases", Json::array()},
                    {"kind", "mesh"},
                    {"faces", faces_of(family)},
                    {"summary", family.summary},
                    {"source", family.source},
                    {"forms", {{{"parameters", parameters_json(family.parameters)}}}}});
  }
  return list;
}

void print_claims() {
  std::size_t id_width = 0;
  for (const Experiment& experiment : experiments()) {
    for (const ClaimHead& head : experiment.heads()) id_width = std::max(id_width, display_width(head.id));
  }
  constexpr std::size_t kind_width = 18;
  constexpr std::size_t least = 20;
  const std::size_t used = 2 + id_width + 2 + kind_width;
  const std::size_t left = used + least < page_width ? page_width - used : least;
  for (const Experiment& experiment : experiments()) {
    std::cout << experiment.title << "\n";
    for (const ClaimHead& head : experiment.heads()) {
      std::cout << "  " << padded(head.id, id_width + 2) << padded(to_string(head.kind), kind_width)
                << clipped(head.printed.value_or("(finding) " + head.definition), left) << "\n";
    }
  }
}

Json claims_json() {
  Json list = Json::array();
  for (const Experiment& experiment : experiments()) {
    for (const ClaimHead& head : experiment.heads()) {
      list.push_back({{"id", head.id},
                      {"experiment", experiment.name},
                      {"document", head.document},
                      {"section", head.section},
                      {"printed", head.printed ? Json(*head.printed) : Json(nullptr)},
                      {"kind", to_string(head.kind)},
                      {"definition", head.definition}});
    }
  }
  return list;
}

/// Those of a scheme alone, then those of its curve on a polygon.
std::vector<ObjectiveDescription> all_objectives() {
  std::vector<ObjectiveDescription> all(objectives().begin(), objectives().end());
  all.insert(all.end(), polygon_objectives().begin(), polygon_objectives().end());
  return all;
}

void print_objectives() {
  for (const ObjectiveDescription& objective : all_objectives()) {
    std::cout << objective.name << ": " << objective.description << "\n  norms: " << objective.norms << "\n";
    for (const ObjectiveOption& option : objective.options) {
      std::cout << "  " << padded(option.name, 12) << option.description << "\n";
    }
    std::cout << "  example: " << objective.example << "\n";
  }
}

Json objectives_json() {
  Json list = Json::array();
  for (const ObjectiveDescription& objective : all_objectives()) {
    Json options = Json::array();
    for (const ObjectiveOption& option : objective.options) {
      options.push_back({{"name", option.name}, {"description", option.description}});
    }
    list.push_back({{"name", objective.name},
                    {"description", objective.description},
                    {"norms", objective.norms},
                    {"options", std::move(options)},
                    {"example", objective.example}});
  }
  return list;
}

void print_definitions() {
  for (const Definition& definition : definitions()) {
    std::cout << definition.name << ": " << definition.summary << "\n";
    for (const DefinitionArgument& argument : definition.arguments) {
      std::cout << "  " << padded(argument.name, 12) << argument.range() << ": " << argument.meaning
                << (argument.required                ? ""
                    : argument.default_value.empty() ? " (may be left out)"
                                                     : " (" + argument.default_value + " when not given)")
                << "\n";
    }
    std::cout << "  example: " << definition.example << "\n";
  }
}

Json definitions_json() {
  Json list = Json::array();
  for (const Definition& definition : definitions()) {
    Json arguments = Json::array();
    for (const DefinitionArgument& argument : definition.arguments) {
      arguments.push_back(
          {{"name", argument.name},
           {"meaning", argument.meaning},
           {"range", argument.range()},
           {"required", argument.required},
           {"default", argument.default_value.empty() ? Json(nullptr) : Json(argument.default_value)}});
    }
    list.push_back({{"name", definition.name},
                    {"summary", definition.summary},
                    {"arguments", std::move(arguments)},
                    {"example", Json::parse(definition.example)}});
  }
  return list;
}

struct Section {
  const char* name;
  void (*print)();
  Json (*json)();
};

}  // namespace

int list(const ListOptions& options) {
  constexpr Section sections[] = {{"schemes", print_schemes, schemes_json},
                                  {"claims", print_claims, claims_json},
                                  {"objectives", print_objectives, objectives_json},
                                  {"definitions", print_definitions, definitions_json}};
  Json all = Json::object();
  bool first = true;
  for (const Section& section : sections) {
    if (!options.what.empty() && options.what != section.name) continue;
    if (options.json) {
      all[section.name] = section.json();
      continue;
    }
    if (options.what.empty()) std::cout << (first ? "" : "\n") << "== " << section.name << "\n";
    section.print();
    first = false;
  }
  if (options.json) std::cout << all.dump(2) << "\n";
  return ExitCode::done;
}

}  // namespace subdiv::cli
