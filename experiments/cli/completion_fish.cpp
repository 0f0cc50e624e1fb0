#include "experiments/cli/usage.h"

namespace subdiv::cli {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string spaced(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : " ") + word;
  return result;
}

/// What completes a value: arguments of `complete`.
std::string action_of(const VerbUsage& verb, const OptionUsage& option) {
  if (!option.choices.empty()) return " -a " + quoted(spaced(option.choices));
  switch (completion_of(verb, option)) {
    case Completion::file:
      return " -F";
    case Completion::folder:
      return " -a '(__fish_complete_directories)'";
    case Completion::scheme:
      return " -a '(__subdivlab_schemes curve)'";
    case Completion::mesh_scheme:
      return " -a '(__subdivlab_schemes mesh)'";
    case Completion::any_scheme:
      return " -a '(__subdivlab_schemes curve mesh)'";
    case Completion::claim:
      return " -a '(__subdivlab_claims)'";
    case Completion::objective:
      return " -a " + quoted(spaced(objective_beginnings()));
    case Completion::none:
      break;
  }
  return "";
}

std::string line_of(const VerbUsage& verb, const OptionUsage& option) {
  std::string line = "complete -c subdivlab -n '__fish_seen_subcommand_from " + verb.name + "'";
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.names.empty() && !option.value.empty()) line += " -r";
  if (!option.value.empty()) line += action_of(verb, option);
  if (!option.names.empty()) line += " -d " + quoted(option.meaning);
  return line + "\n";
}

}  // namespace

std::string fish_completion(const std::vector<VerbUsage>& verbs) {
  std::string script =
      "# Completion of subdivlab for fish, made by 'subdivlab completion fish'. Load it by\n"
      "#   subdivlab completion fish | source\n\n"
      "function __subdivlab_schemes\n"
      "    # Behind the + of a mixed scheme another one begins.\n"
      "    set -l before (commandline -ct | string match -r '.*\\+')\n"
      "    contains curve $argv; and printf \"$before%s\\n\" " +
      spaced(scheme_beginnings(Completion::scheme)) +
      "\n"
      "    contains mesh $argv; and printf \"$before%s\\n\" " +
      spaced(scheme_beginnings(Completion::mesh_scheme)) +
      "\n"
      "    __fish_complete_suffix .json\n"
      "end\n\n"
      "function __subdivlab_claims\n"
      "    set -l program (commandline -opc)[1]\n"
      "    $program list claims 2>/dev/null | string match -r '^  \\S+' | string trim\n"
      "end\n\n"
      "complete -c subdivlab -f\n"
      "complete -c subdivlab -n __fish_use_subcommand -l version -d 'Display program version information and "
      "exit'\n"
      "complete -c subdivlab -n __fish_use_subcommand -s h -l help -d 'Print this help message and exit'\n";
  for (const VerbUsage& verb : verbs)
    script += "complete -c subdivlab -n __fish_use_subcommand -a " + verb.name + " -d " +
              quoted(verb.summary) + "\n";
  for (const VerbUsage& verb : verbs) {
    script += "\n";
    for (const OptionUsage& option : verb.options) script += line_of(verb, option);
    for (const OptionUsage& word : verb.words) {
      if (!action_of(verb, word).empty()) script += line_of(verb, word);
    }
  }
  return script;
}

}  // namespace subdiv::cli
