#include "experiments/cli/usage.h"

namespace subdiv::cli {
namespace {

std::string spaced(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : " ") + word;
  return result;
}

/// Text inside a specification of _arguments in single quotes.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// What completes a value: the action of a specification.
std::string action_of(const VerbUsage& verb, const OptionUsage& option) {
  if (!option.choices.empty()) return "(" + spaced(option.choices) + ")";
  switch (completion_of(verb, option)) {
    case Completion::file:
      return "_files";
    case Completion::folder:
      return "_files -/";
    case Completion::scheme:
      return "_subdivlab_schemes curve";
    case Completion::mesh_scheme:
      return "_subdivlab_schemes mesh";
    case Completion::any_scheme:
      return "_subdivlab_schemes curve mesh";
    case Completion::claim:
      return "_subdivlab_claims";
    case Completion::objective:
      return "_subdivlab_objectives";
    case Completion::none:
      break;
  }
  return " ";
}

/// '(--out -o)'{--out,-o}'[text]:DIR:_files -/'
std::string specification(const VerbUsage& verb, const OptionUsage& option) {
  std::string value;
  if (!option.value.empty()) value = ":" + escaped(option.value) + ":" + action_of(verb, option);
  if (option.names.empty()) return "'" + std::string(option.repeated ? "*" : "") + value + "'";
  const std::string rest = "[" + escaped(option.meaning) + "]" + value + "'";
  if (option.names.size() == 1) return "'" + option.names.front() + rest;
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ",") + name;
  return "'(" + spaced(option.names) + ")'{" + names + "}'" + rest;
}

constexpr const char* head =
    R"zsh(#compdef subdivlab
# Completion of subdivlab for zsh, made by 'subdivlab completion zsh': a file _subdivlab in a folder of $fpath, or
#   source <(subdivlab completion zsh)

_subdivlab_schemes() {
  local -a names
  local kind
  for kind in "$@"; do
    case $kind in
      curve) names+=(@CURVES@) ;;
      mesh) names+=(@MESHES@) ;;
    esac
  done
  # Behind the + of a mixed scheme another one begins.
  [[ $PREFIX != *+* ]] || compset -P '*+'
  compadd -S '' -- $names
  _files -g '*.json'
}

_subdivlab_objectives() { compadd -S '' -- @OBJECTIVES@; }

_subdivlab_claims() {
  local -a lines
  lines=(${(M)${(f)"$($program list claims 2>/dev/null)"}:#  *})
  compadd -- ${${lines#  }%% *}
}

_subdivlab() {
  local program=$words[1] context state line
  typeset -A opt_args
  _arguments -C '(- *)'{-h,--help}'[Print this help message and exit]' \
    '(- *)--version[Display program version information and exit]' '1:verb:->verb' '*::argument:->argument'
  case $state in
    verb)
      local -a verbs
      verbs=(
@VERBS@      )
      _describe verb verbs
      ;;
    argument)
      case $line[1] in
)zsh";

constexpr const char* tail = R"zsh(      esac
      ;;
  esac
}

if [[ $funcstack[1] == _subdivlab ]]; then _subdivlab "$@"; else compdef _subdivlab subdivlab; fi
)zsh";

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

std::string zsh_completion(const std::vector<VerbUsage>& verbs) {
  std::string script = head;
  std::string names;
  for (const VerbUsage& verb : verbs)
    names += "        '" + escaped(verb.name) + ":" + escaped(verb.summary) + "'\n";
  replace_all(script, "@VERBS@", names);
  replace_all(script, "@CURVES@", spaced(scheme_beginnings(Completion::scheme)));
  replace_all(script, "@MESHES@", spaced(scheme_beginnings(Completion::mesh_scheme)));
  replace_all(script, "@OBJECTIVES@", spaced(objective_beginnings()));
  for (const VerbUsage& verb : verbs) {
    script += "        " + verb.name + ")\n          _arguments";
    for (const OptionUsage& option : verb.options)
      script += " \\\n            " + specification(verb, option);
    for (const OptionUsage& word : verb.words) script += " \\\n            " + specification(verb, word);
    script += "\n          ;;\n";
  }
  return script + tail;
}

}  // namespace subdiv::cli
