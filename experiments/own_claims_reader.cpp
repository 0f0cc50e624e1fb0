#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "experiments/cli/over.h"
#include "experiments/definition_parts.h"
#include "experiments/own_claims.h"
#include "experiments/report/files.h"
#include "experiments/report/json.h"
#include "schemes/expression.h"
#include "schemes/input_error.h"
#include "schemes/json_document.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

using Kind = JsonValue::Kind;

constexpr std::array<const char*, 4> kind_names{"exact", "rounded", "at_most", "at_least"};

/// Reads the file, and goes on after a mistake as far as the rest makes sense.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path) {}

  OwnClaims read(const JsonValue& root) {
    if (root.kind != Kind::object) {
      wrong(root.line, "the file must hold an object such as {\"claims\": [..]}, not " + describe(root.kind));
    } else {
      require_known(root, "the file", {"$schema", "document", "section", "claims", "figures"});
      read_members(root);
    }
    if (!mistakes_.empty()) throw InputError(joined_lines());
    return std::move(own_);
  }

 private:
  void wrong(int line, const std::string& what) {
    mistakes_.push_back(fmt::format("{}:{}: {}", path_.string(), line, what));
  }

  [[nodiscard]] std::string joined_lines() const {
    std::string text;
    for (const std::string& mistake : mistakes_) text += (text.empty() ? "" : "\nsubdivlab: ") + mistake;
    return text;
  }

  void require_known(const JsonValue& object, const std::string& what,
                     const std::vector<std::string>& known) {
    for (const auto& [name, value] : object.members) {
      if (std::ranges::find(known, name) != known.end()) continue;
      wrong(value.line, fmt::format("{} has no member {}{} It may have {}", what, in_quotes(name),
                                    suggestion(name, known), joined(known, "and")));
    }
  }

  /// The member as text; strings alone, or numbers too.
  std::optional<std::string> text(const JsonValue& object, const char* name, bool numbers = false) {
    const JsonValue* value = object.find(name);
    if (value == nullptr) return std::nullopt;
    if (value->kind == Kind::string || (numbers && value->kind == Kind::number)) return value->text;
    wrong(value->line, fmt::format("\"{}\" must be a text in quotes, not {}", name, describe(value->kind)));
    return std::nullopt;
  }

  void read_members(const JsonValue& root) {
    document_ = text(root, "document").value_or("own");
    section_ = text(root, "section").value_or("");
    const JsonValue* claims = root.find("claims");
    const JsonValue* figures = root.find("figures");
    if (claims == nullptr && figures == nullptr)
      wrong(root.line, "\"claims\" is missing: a list such as [{\"id\": \"mine.1\", \"definition\": {..}}]");
    if (claims != nullptr) read_list(*claims, "claims", [&](const JsonValue& item) { read_claim(item); });
    if (figures != nullptr) read_list(*figures, "figures", [&](const JsonValue& item) { read_figure(item); });
  }

  template <class Read>
  void read_list(const JsonValue& list, const std::string& name, Read read) {
    if (list.kind != Kind::array) {
      wrong(list.line, fmt::format("\"{}\" must be a list [..], not {}", name, describe(list.kind)));
      return;
    }
    for (const JsonValue& item : list.elements) {
      if (item.kind == Kind::object)
        read(item);
      else
        wrong(item.line, fmt::format("an element of \"{}\" must be an object {{..}}, not {}", name,
                                     describe(item.kind)));
    }
  }

  /// A name that a file could have and that no other has.
  std::string name(const JsonValue& object, const char* member, std::set<std::string>& taken) {
    const JsonValue* value = object.find(member);
    if (value == nullptr) {
      wrong(object.line,
            fmt::format("\"{}\" is missing: letters, digits, '-', '_' and '.', such as \"mine.1\"", member));
      return "";
    }
    std::string name = text(object, member).value_or("");
    if (value->kind != Kind::string) return "";
    if (!is_file_name(name)) {
      wrong(value->line,
            fmt::format("the {} {} must consist of letters, digits, '-', '_' and '.', and not begin with '.'",
                        member, in_quotes(name)));
    } else if (!taken.insert(name).second) {
      wrong(value->line,
            fmt::format("the {} {} is taken already; each needs one of its own", member, in_quotes(name)));
    }
    return name;
  }

  void read_claim(const JsonValue& object) {
    const std::size_t before = mistakes_.size();
    require_known(object, "a claim", {"id", "printed", "kind", "definition", "document", "section"});
    OwnClaim claim;
    claim.head.id = name(object, "id", ids_);
    claim.head.document = text(object, "document").value_or(document_);
    claim.head.section = text(object, "section").value_or(section_);
    const JsonValue* printed = object.find("printed");
    if (printed != nullptr && printed->kind != Kind::null) claim.head.printed = text(object, "printed", true);
    read_definition(object, claim);
    if (claim.call.definition == nullptr) return;
    if (mistakes_.size() > before) return;  // what follows depends on all of it
    claim.head.definition = sentence(claim.call);
    read_kind(object, claim);
    if (mistakes_.size() == before) own_.claims.push_back(std::move(claim));
  }

  void read_definition(const JsonValue& object, OwnClaim& claim) {
    const JsonValue* definition = object.find("definition");
    if (definition == nullptr) {
      wrong(object.line, "\"definition\" is missing: what is claimed, such as " +
                             definitions().front().example + "; 'subdivlab list definitions' has all");
      return;
    }
    if (definition->kind != Kind::object) {
      wrong(definition->line, "\"definition\" must be an object such as " + definitions().front().example +
                                  ", not " + describe(definition->kind));
      return;
    }
    const JsonValue* name = definition->find("name");
    if (name == nullptr || name->kind != Kind::string) {
      wrong(definition->line, "a definition needs a \"name\"; 'subdivlab list definitions' has all");
      return;
    }
    try {
      claim.call.definition = &find_definition(name->text);
    } catch (const InputError& error) {
      wrong(name->line, error.what());
      return;
    }
    claim.call.folder = path_.parent_path();
    for (const auto& [argument, value] : definition->members) {
      if (argument == "name") continue;
      if (value.kind == Kind::string || value.kind == Kind::number)
        claim.call.arguments[argument] = value.text;
      else
        wrong(value.line, fmt::format("\"{}\" must be a text in quotes or a number, not {}", argument,
                                      describe(value.kind)));
    }
    for (const std::string& mistake : complete(claim.call)) wrong(line_of(*definition, mistake), mistake);
  }

  /// The line of the argument that a message begins with, or speaks of in quotes; else that of the
  /// definition.
  static int line_of(const JsonValue& definition, const std::string& mistake) {
    for (const auto& [argument, value] : definition.members) {
      if (mistake.starts_with("\"" + argument + "\"") ||
          mistake.find("argument '" + argument + "'") != std::string::npos)
        return value.line;
    }
    const JsonValue* scheme = definition.find("scheme");
    return scheme != nullptr && mistake.find("needs the argument") == std::string::npos ? scheme->line
                                                                                        : definition.line;
  }

  void read_kind(const JsonValue& object, OwnClaim& claim) {
    const JsonValue* given = object.find("kind");
    const int line = given != nullptr                    ? given->line
                     : object.find("printed") != nullptr ? object.find("printed")->line
                                                         : object.line;
    const std::string kind = text(object, "kind").value_or("");
    const auto known = std::ranges::find(kind_names, kind);
    if (given != nullptr && known == kind_names.end()) {
      if (given->kind == Kind::string) {
        const std::vector<std::string> names(kind_names.begin(), kind_names.end());
        wrong(line, fmt::format("there is no kind {}{} The kinds are {}", in_quotes(kind),
                                suggestion(kind, names), joined(names, "and")));
      }
      return;
    }
    if (!claim.head.printed) {
      if (given != nullptr)
        wrong(line, "a kind compares with what is printed, and nothing is; give \"printed\", too");
      return;
    }
    if (given != nullptr) claim.kind = static_cast<OwnKind>(known - kind_names.begin());
    if (claim.call.definition->kind(claim.call) == AnswerKind::number) {
      read_number_kind(given != nullptr, line, claim);
    } else if (claim.kind != OwnKind::exact) {
      wrong(line,
            fmt::format("{} is no number here: its kind can only be exact{}", claim.call.definition->name,
                        claim.call.definition->check_printed == check_set
                            ? "; \"end\": \"lower\" or \"upper\" makes one end of the set a number"
                            : ""));
    } else if (claim.call.definition->check_printed != nullptr) {
      try {
        claim.call.definition->check_printed(claim.call, *claim.head.printed);
      } catch (const InputError& error) {
        wrong(line, error.what());
      }
    }
  }

  /// Without a kind, decimals are rounded and all else is exact.
  void read_number_kind(bool given, int line, OwnClaim& claim) {
    const auto read = claim.call.definition->read_printed;
    const std::string number = read == nullptr ? *claim.head.printed : read(*claim.head.printed);
    bool plain = true;
    try {
      (void)printed_value(number);
    } catch (const std::logic_error&) {
      plain = false;
    }
    if (!given && plain && number.find_first_of(".%") != std::string::npos) claim.kind = OwnKind::rounded;
    if (claim.kind == OwnKind::rounded) claim.head.kind = ClaimKind::rounded;
    if (claim.kind == OwnKind::at_most || claim.kind == OwnKind::at_least) claim.head.kind = ClaimKind::bound;
    if (plain) return;
    if (claim.kind != OwnKind::exact) {
      wrong(line, fmt::format("the printed text {} is no number; of this kind it must be one such as "
                              "0.46415, 1/15, -2 or 12%",
                              in_quotes(*claim.head.printed)));
      return;
    }
    if (number.starts_with("log"))
      return;  // compared as text: "3-log2(73/100)" begins otherwise and is checked below
    try {
      const Expression expression = Expression::parse(number);
      if (!expression.names().empty() && number.find("log") == std::string::npos)
        throw InputError("unknown name " + in_quotes(expression.names().front()));
    } catch (const InputError& error) {
      if (number.find("log") != std::string::npos) return;
      wrong(line,
            fmt::format(
                "the printed text {} is no number; expected one such as 0.46415, 1/15, (1+sqrt(5))/4 or "
                "log3(11) ({})",
                in_quotes(*claim.head.printed), error.what()));
    }
  }

  void read_figure(const JsonValue& object) {
    require_known(object, "a figure", {"name", "scheme", "over"});
    OwnFigure figure;
    figure.name = name(object, "name", figures_);
    figure.over = text(object, "over").value_or("");
    const JsonValue* scheme = object.find("scheme");
    if (scheme == nullptr) {
      wrong(object.line,
            "\"scheme\" is missing: the scheme that the figure shows, such as \"four-point:w=w\"");
      return;
    }
    const std::string written = text(object, "scheme").value_or("");
    if (scheme->kind != Kind::string) return;
    try {
      figure.scheme = located_scheme(written, path_.parent_path());
      const SchemeDescription description = parse_scheme(figure.scheme);
      if (!figure.over.empty())
        (void)cli::parse_over(figure.over, description.free_parameters, cli::RangeEnds::differ, "\"over\"");
      else if (!description.free_parameters.empty())
        throw InputError("the scheme " + in_quotes(written) + " leaves " +
                         joined(description.free_parameters, "and") +
                         " free; give \"over\", a range, or a value");
    } catch (const InputError& error) {
      wrong(scheme->line, error.what());
      return;
    }
    own_.figures.push_back(std::move(figure));
  }

  std::filesystem::path path_;
  std::string document_;
  std::string section_;
  std::set<std::string> ids_;
  std::set<std::string> figures_;
  std::vector<std::string> mistakes_;
  OwnClaims own_;
};

}  // namespace

OwnClaims parse_own_claims(std::string_view text, const std::filesystem::path& path) {
  if (trimmed(text).empty()) {
    throw InputError(path.string() + ": the file is empty; expected an object such as {\"claims\": [..]}");
  }
  return Reader(path).read(parse_json(text, path.string()));
}

OwnClaims read_own_claims(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw InputError(path.string() +
                     ": no such file; --claims takes a JSON file of claims, from the current folder");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(path.string() + ": is no regular file; --claims takes a JSON file of claims");
  return parse_own_claims(read_file(path), path);
}

}  // namespace subdiv
