#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/decision.h"
#include "analysis/enclosure.h"

namespace subdiv {

/// What a claim of a user's own may be about: named definitions with arguments, each of them a question that
/// the analysis or the optimisation answers with proof.

/// An argument of a definition. Its value is text, as on the command line.
struct DefinitionArgument {
  /// How the value is read: a scheme; ranges "w=LO..HI"; a whole number; one of some words; an objective; a
  /// positive number of seconds; a file.
  enum class Kind { scheme, over, whole, word, objective, seconds, file };
  std::string name;                     ///< "continuity"
  Kind kind = Kind::word;               ///< of its values
  std::string meaning;                  ///< half a sentence
  bool required = true;                 ///< or else left out, or with the default value
  std::string default_value = {};       ///< of an optional argument; empty for none
  long least = 0;                       ///< of a whole number
  long greatest = 0;                    ///< of a whole number
  std::vector<std::string> words = {};  ///< those that are allowed

  /// "a whole number from 0 to 20", "limits or scheme", for messages and lists.
  [[nodiscard]] std::string range() const;
};

struct Definition;

/// A definition with values for its arguments, defaults filled in.
struct DefinitionCall {
  const Definition* definition = nullptr;        ///< of the list
  std::map<std::string, std::string> arguments;  ///< only those that are given or have a default
  std::filesystem::path folder;                  ///< at which relative names of files start; may be empty

  [[nodiscard]] bool has(const std::string& name) const { return arguments.contains(name); }
  [[nodiscard]] const std::string& text(const std::string& name) const { return arguments.at(name); }
  [[nodiscard]] long whole(const std::string& name) const { return std::stol(arguments.at(name)); }
};

/// What a definition is, for the given arguments.
struct Answer {
  std::optional<Enclosure> number;  ///< of a definition that is a number
  std::optional<Decision> holds;    ///< of one that holds or does not
  std::string text;                 ///< of all others: a set, a list, a function of the parameters
  /// Whether the text is what a document prints, decided exactly.
  std::function<bool(std::string_view printed)> is_printed;
  Rigour rigour = Rigour::exact;  ///< of holds and text
  std::string note;               ///< what a reader should know, in full sentences
};

/// What an answer is, known before anything runs.
enum class AnswerKind { number, property, text };

/// A named definition.
struct Definition {
  std::string name;                           ///< "smooth-range"
  std::string summary;                        ///< what it is, a sentence without its full stop
  std::vector<DefinitionArgument> arguments;  ///< in the order in which they are listed
  AnswerKind (*kind)(const DefinitionCall&);  ///< some depend on the arguments
  void (*check)(const DefinitionCall&);       ///< what can be found wrong without computing: InputError
  std::string (*read_printed)(
      const std::string&);  ///< the number in what documents print ("C2"); may be null
  void (*check_printed)(const DefinitionCall&, const std::string&);  ///< of texts; may be null
  Answer (*answer)(const DefinitionCall&);                           ///< InputError where there is no answer
  std::string example;                                               ///< the arguments, as JSON
};

/// All of them, in the order in which they are listed.
[[nodiscard]] std::span<const Definition> definitions();

/// Throws InputError that names the nearest ones.
[[nodiscard]] const Definition& find_definition(std::string_view name);

/// Fills in defaults and checks every argument. Returns what is wrong, one message for each mistake.
[[nodiscard]] std::vector<std::string> complete(DefinitionCall& call);

/// The definition in words, with its arguments, precise enough to redo the computation.
[[nodiscard]] std::string sentence(const DefinitionCall& call);

/// The definitions of schemes, of ranges of a parameter, and of optimal parameters; definitions() joins them.
[[nodiscard]] std::vector<Definition> scheme_definitions();
[[nodiscard]] std::vector<Definition> range_definitions();

}  // namespace subdiv
