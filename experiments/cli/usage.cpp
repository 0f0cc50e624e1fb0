#include "experiments/cli/usage.h"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

#include "optimize/objectives.h"
#include "optimize/polygon_objectives.h"
#include "schemes/catalogue.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

/// What the validators of an option say of themselves, in order.
std::vector<std::string> descriptions_of_validators(CLI::Option& option) {
  std::vector<std::string> result;
  try {
    // CLI11 does not tell how many there are.
    for (int i = 0;; ++i) result.push_back(option.get_validator(i)->get_description());
  } catch (const CLI::OptionNotFound&) {
    return result;
  }
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// "INT in [1 - 1024]" as "1 to 1024", "POSITIVE" as "positive".
std::string limits_in_words(std::string text) {
  const auto open = text.find(" in [");
  const auto dash = text.find(" - ");
  if (open != std::string::npos && dash != std::string::npos && text.ends_with(']')) {
    const std::string low = text.substr(open + 5, dash - open - 5);
    return low + " to " + text.substr(dash + 3, text.size() - dash - 4);
  }
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

OptionUsage usage_of(CLI::Option& option) {
  OptionUsage usage;
  for (const std::string& name : option.get_lnames()) usage.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) usage.names.push_back("-" + name);
  usage.meaning = option.get_description();
  usage.default_value = option.get_default_str();
  usage.required = option.get_required();
  usage.repeated = option.get_items_expected_max() > 1;
  std::string type = option.get_type_name();
  const std::vector<std::string> validators = descriptions_of_validators(option);
  for (auto v = validators.rbegin(); v != validators.rend(); ++v) {
    if (v->empty()) continue;
    if (type.ends_with(":" + *v)) type.erase(type.size() - v->size() - 1);
    if (v->starts_with('{') && v->ends_with('}')) {
      usage.choices = split(v->substr(1, v->size() - 2), ',');
    } else {
      usage.limits = limits_in_words(*v);
    }
  }
  if (usage.names.empty()) {
    usage.value = option.get_name(true);
  } else if (option.get_items_expected_max() > 0) {
    usage.value = type;
  }
  return usage;
}

/// A verb's footer: notes; examples from "Example(s):" on, one a line, to the next empty line; the exit
/// codes, which the manual says once.
void read_footer(const std::string& footer, VerbUsage& usage) {
  bool in_examples = false;
  for (std::string line : split(footer, '\n')) {
    if (line.starts_with("Exit codes:")) return;
    for (const std::string heading : {"Examples:", "Example:"}) {
      if (!line.starts_with(heading)) continue;
      line.erase(0, heading.size());
      in_examples = true;
    }
    const std::string text(trimmed(line));
    if (text.empty()) {
      in_examples = false;
    } else {
      (in_examples ? usage.examples : usage.notes).push_back(text);
    }
  }
}

void append_beginnings(const std::string& name, const std::vector<Parameter>& parameters,
                       std::vector<std::string>& result) {
  const bool complete =
      std::none_of(parameters.begin(), parameters.end(), [](const Parameter& p) { return p.is_required(); });
  if (complete) result.push_back(name);
  if (!parameters.empty()) result.push_back(name + ":" + parameters.front().name + "=");
}

}  // namespace

std::vector<VerbUsage> usage_of(CLI::App& app) {
  std::vector<VerbUsage> verbs;
  for (CLI::App* verb : app.get_subcommands(nullptr)) {
    VerbUsage usage;
    usage.name = verb->get_name();
    usage.summary = verb->get_description();
    for (CLI::Option* option : verb->get_options([](const CLI::Option*) { return true; })) {
      OptionUsage one = usage_of(*option);
      (one.names.empty() ? usage.words : usage.options).push_back(std::move(one));
    }
    read_footer(verb->get_footer(), usage);
    verbs.push_back(std::move(usage));
  }
  return verbs;
}

Completion completion_of(const VerbUsage& verb, const OptionUsage& option) {
  const std::string& value = option.value;
  for (const char* file : {"FILE", "FIGURE", "INPUT", "OUTPUT", "PATH", "REPORT"}) {
    if (value.starts_with(file)) return Completion::file;
  }
  if (value == "DIR") return Completion::folder;
  if (value == "PATTERN") return Completion::claim;
  if (value.starts_with("NAME[:option")) return Completion::objective;
  if (value != "SCHEME") return Completion::none;
  if (verb.name == "eigen") return Completion::mesh_scheme;
  return verb.name == "refine" ? Completion::any_scheme : Completion::scheme;
}

std::vector<std::string> scheme_beginnings(Completion kind) {
  std::vector<std::string> result;
  if (kind != Completion::mesh_scheme) {
    for (const Family& family : catalogue()) {
      std::vector<std::string> names{family.name};
      names.insert(names.end(), family.aliases.begin(), family.aliases.end());
      for (const std::string& name : names) {
        for (const FamilyForm& form : family.forms) append_beginnings(name, form.parameters, result);
      }
    }
  }
  if (kind != Completion::scheme) {
    for (const MeshFamily& family : mesh_catalogue())
      append_beginnings(family.name, family.parameters, result);
  }
  return result;
}

std::vector<std::string> objective_beginnings() {
  std::vector<std::string> result;
  const auto append = [&](std::span<const ObjectiveDescription> objectives) {
    for (const ObjectiveDescription& objective : objectives) {
      result.push_back(objective.name);
      for (const ObjectiveOption& option : objective.options) {  // "level=K" or "continuum"
        const auto equals = option.name.find('=');
        result.push_back(objective.name + ":" +
                         option.name.substr(0, equals == std::string::npos ? equals : equals + 1));
      }
    }
  };
  append(objectives());
  append(polygon_objectives());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace subdiv::cli
