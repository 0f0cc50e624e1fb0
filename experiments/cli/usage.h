#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

namespace subdiv::cli {

/// An option of a verb, or one of its words without a name, as the command line knows it.
struct OptionUsage {
  std::vector<std::string> names;  // "--out", "-o"; empty for a word
  std::string value;               // what stands for its value: "DIR"; empty for flags
  std::string meaning;
  std::vector<std::string> choices;  // all values that are allowed, where they are few
  std::string limits;                // "1 to 1024", "positive"; empty without
  std::string default_value;
  bool required = false;
  bool repeated = false;  // may have several values
};

struct VerbUsage {
  std::string name;
  std::string summary;
  std::vector<OptionUsage> words;  // in the order in which they are given
  std::vector<OptionUsage> options;
  std::vector<std::string> notes;  // what its help says besides
  std::vector<std::string> examples;
};

/// Every verb of the program: manual and completions are made from this, and so agree with it.
[[nodiscard]] std::vector<VerbUsage> usage_of(CLI::App& app);

/// How the values of an option or word are completed.
enum class Completion { none, file, folder, scheme, mesh_scheme, any_scheme, claim, objective };
[[nodiscard]] Completion completion_of(const VerbUsage& verb, const OptionUsage& option);

/// The beginnings of SCHEME values: "jspline:s=", "four-point", "four-point:w=".
[[nodiscard]] std::vector<std::string> scheme_beginnings(Completion kind);
/// Those of --objective: "vertex", "fit-bspline:degree=".
[[nodiscard]] std::vector<std::string> objective_beginnings();

/// Scripts that teach a shell the verbs, options and values.
[[nodiscard]] std::string bash_completion(const std::vector<VerbUsage>& verbs);
[[nodiscard]] std::string zsh_completion(const std::vector<VerbUsage>& verbs);
[[nodiscard]] std::string fish_completion(const std::vector<VerbUsage>& verbs);

/// The manual page, in mdoc.
[[nodiscard]] std::string manual_page(const std::vector<VerbUsage>& verbs);

}  // namespace subdiv::cli
