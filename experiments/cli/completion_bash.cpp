#include "experiments/cli/usage.h"

#include "schemes/text.h"

namespace subdiv::cli {
namespace {

std::string spaced(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : " ") + word;
  return result;
}

/// What completes a value: a word for `case $kind` in the script; choices follow "choice".
std::string kind_of(const VerbUsage& verb, const OptionUsage& option) {
  if (!option.choices.empty()) return "choice " + spaced(option.choices);
  switch (completion_of(verb, option)) {
    case Completion::file:
      return "file";
    case Completion::folder:
      return "folder";
    case Completion::scheme:
      return "scheme";
    case Completion::mesh_scheme:
      return "mesh_scheme";
    case Completion::any_scheme:
      return "any_scheme";
    case Completion::claim:
      return "claim";
    case Completion::objective:
      return "objective";
    case Completion::none:
      break;
  }
  return "none";
}

/// The arms of a verb: its options, those with a value, and what completes each value and word.
std::string arms(const VerbUsage& verb) {
  std::vector<std::string> names;
  std::vector<std::string> valued;
  std::string kinds;
  for (const OptionUsage& option : verb.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (option.value.empty()) continue;
    valued.insert(valued.end(), option.names.begin(), option.names.end());
    for (const std::string& name : option.names)
      kinds += "        " + name + ") kind='" + kind_of(verb, option) + "' ;;\n";
  }
  int place = 0;
  for (const OptionUsage& word : verb.words)
    kinds += "        " + (word.repeated ? "[0-9]*" : std::to_string(place++)) + ") kind='" +
             kind_of(verb, word) + "' ;;\n";
  return "    " + verb.name + ")\n      options='" + spaced(names) + "'\n      valued='" + spaced(valued) +
         "'\n      _subdivlab_place\n      case $place in\n" + kinds + "      esac\n      ;;\n";
}

constexpr const char* head =
    R"(# Completion of subdivlab for bash, made by 'subdivlab completion bash'. Load it, for example in ~/.bashrc, by
#   source <(subdivlab completion bash)

# Where the word to complete stands: `place` is the option whose value it is, or the number of words before it.
_subdivlab_place() {
  local i
  place=0
  for ((i = 2; i < ${#words[@]} - 1; ++i)); do
    if [[ " $valued " == *" ${words[i]} "* ]]; then
      if ((i + 1 == ${#words[@]} - 1)); then
        place=${words[i]}
        return
      fi
      ((++i))
    elif [[ ${words[i]} != -?* ]]; then
      ((++place))
    fi
  done
  if [[ $word == --*=* && " $valued " == *" ${word%%=*} "* ]]; then
    place=${word%%=*}
    word=${word#*=}
  fi
}

# The candidates that go on from the word; without a space behind those that end in =.
_subdivlab_words() {
  local candidate
  for candidate in "$@"; do
    [[ $candidate != "$word"* ]] || COMPREPLY+=("$candidate")
  done
  if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]]; then compopt -o nospace 2>/dev/null; fi
}

# Beginnings of SCHEME, behind the last + of a mixed scheme, and scheme files.
_subdivlab_schemes() {
  local before='' candidate
  [[ $word != *+* ]] || before=${word%+*}+
  local -a candidates=()
  for candidate in "$@"; do candidates+=("$before$candidate"); done
  while IFS= read -r candidate; do
    [[ -d $candidate ]] && candidates+=("$candidate/")
    [[ $candidate == *.json ]] && candidates+=("$candidate")
  done < <(compgen -f -- "$word")
  _subdivlab_words "${candidates[@]}"
  if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == */ ]]; then compopt -o nospace 2>/dev/null; fi
}

_subdivlab_claims() {
  local line
  while IFS= read -r line; do
    [[ $line != '  '* ]] || echo "${line:2}"
  done < <("${words[0]}" list claims 2>/dev/null) | while read -r line _; do echo "$line"; done
}

_subdivlab() {
  # bash parts words at = and :, which belong to SCHEME: the word is taken from the line itself.
  local line=${COMP_LINE:0:COMP_POINT}
  local -a words
  read -ra words <<<"$line"
  [[ $line != *[[:space:]] ]] || words+=('')
  local word=${words[${#words[@]} - 1]} typed options='' valued='' place=0 kind=none candidate
  typed=$word
  COMPREPLY=()
)";

constexpr const char* tail =
    R"(  esac
  if [[ ${#words[@]} -le 2 ]]; then
    kind='choice @VERBS@'
  elif [[ $word == -* && $place =~ ^[0-9]+$ ]]; then
    kind="choice $options"
  fi
  # shellcheck disable=SC2046,SC2086
  case $kind in
    choice*) _subdivlab_words ${kind#choice} ;;
    file)
      compopt -o filenames 2>/dev/null
      while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -f -- "$word")
      ;;
    folder)
      compopt -o filenames 2>/dev/null
      while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -d -- "$word")
      ;;
    scheme) _subdivlab_schemes @CURVES@ ;;
    mesh_scheme) _subdivlab_schemes @MESHES@ ;;
    any_scheme)
      _subdivlab_schemes @CURVES@ @MESHES@
      # Behind --scheme, the first word is a file.
      while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -f -X '*.json' -- "$word")
      ;;
    objective) _subdivlab_words @OBJECTIVES@ ;;
    claim) _subdivlab_words $(_subdivlab_claims) ;;
  esac
  # What bash has parted off must not stand in the answers.
  local parted=''
  [[ $COMP_WORDBREAKS != *=* || $typed != *=* ]] || parted=${typed%"${typed##*=}"}
  if [[ $COMP_WORDBREAKS == *:* && $typed == *:* ]]; then
    local until_colon=${typed%"${typed##*:}"}
    ((${#until_colon} <= ${#parted})) || parted=$until_colon
  fi
  parted=${parted#"${typed%"$word"}"}
  COMPREPLY=("${COMPREPLY[@]#"$parted"}")
}

complete -F _subdivlab subdivlab
)";

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

std::string bash_completion(const std::vector<VerbUsage>& verbs) {
  std::string script = head;
  std::string names;
  script += "  case ${words[1]} in\n";
  for (const VerbUsage& verb : verbs) {
    script += arms(verb);
    names += verb.name + " ";
  }
  std::string rest = tail;
  replace_all(rest, "@VERBS@", names + "--help --version");
  replace_all(rest, "@CURVES@", spaced(scheme_beginnings(Completion::scheme)));
  replace_all(rest, "@MESHES@", spaced(scheme_beginnings(Completion::mesh_scheme)));
  replace_all(rest, "@OBJECTIVES@", spaced(objective_beginnings()));
  return script + rest;
}

}  // namespace subdiv::cli
