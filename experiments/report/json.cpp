#include "experiments/report/json.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* remedy = "; write it anew with 'subdivlab reproduce'";

std::string position_in(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto last_break = std::find(std::make_reverse_iterator(end), text.rend(), '\n');
  const auto column = 1 + (end - last_break.base());
  return std::to_string(line) + ":" + std::to_string(column);
}

Json parse(const std::string& text, const std::string& file) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    // The library's message is "[json.exception.parse_error.101] parse error at line 3, column 5: what is
    // wrong".
    std::string what = error.what();
    if (const auto colon = what.find(": "); colon != std::string::npos) what = what.substr(colon + 2);
    throw InputError(file + ":" + position_in(text, error.byte) + ": not valid JSON: " + what + remedy);
  }
}

/// A JSON object with the name under which messages speak of it.
class Object {
 public:
  Object(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) throw InputError(place_ + ": expected an object {...}" + remedy);
  }

  [[nodiscard]] std::string text(const char* key) const {
    const Json& value = member(key);
    if (!value.is_string()) reject(key, "must be a string");
    return value.get<std::string>();
  }
  [[nodiscard]] std::optional<std::string> text_or_null(const char* key) const {
    const Json& value = member(key);
    if (value.is_null()) return std::nullopt;
    if (!value.is_string()) reject(key, "must be a string or null");
    return value.get<std::string>();
  }
  [[nodiscard]] std::optional<std::string> optional_text(const char* key) const {
    return json_.contains(key) ? text_or_null(key) : std::nullopt;
  }
  [[nodiscard]] std::optional<std::string> number_or_null(const char* key) const {
    auto value = text_or_null(key);
    if (!value) return value;
    try {
      (void)Rational::parse(*value);
    } catch (const std::invalid_argument&) {
      reject(key, "must be a decimal string or null");
    }
    return value;
  }
  [[nodiscard]] const Json& array(const char* key) const {
    const Json& value = member(key);
    if (!value.is_array()) reject(key, "must be an array [...]");
    return value;
  }
  /// The strings of an array; none where the key is missing.
  [[nodiscard]] std::vector<std::string> optional_texts(const char* key) const {
    std::vector<std::string> result;
    if (!json_.contains(key)) return result;
    for (const Json& value : array(key)) {
      if (!value.is_string()) reject(key, "must hold strings");
      result.push_back(value.get<std::string>());
    }
    return result;
  }
  [[nodiscard]] Object object(const char* key) const { return {member(key), place_ + ", key '" + key + "'"}; }
  [[noreturn]] void reject(const char* key, const std::string& what) const {
    throw InputError(place_ + ": key '" + key + "' " + what + remedy);
  }

 private:
  [[nodiscard]] const Json& member(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) reject(key, "is missing");
    return *found;
  }

  const Json& json_;
  std::string place_;
};

/// Checks that a word of the file is one that the program writes.
template <class Enum>
void expect_word(const Object& object, const char* key, const std::string& word,
                 std::span<const Enum> values) {
  std::string known;
  for (const Enum value : values) {
    if (to_string(value) == word) return;
    known += (known.empty() ? "" : ", ") + to_string(value);
  }
  object.reject(key, "must be one of " + known);
}

ClaimRecord claim_from_json(const Object& object) {
  constexpr ClaimKind kinds[] = {ClaimKind::exact, ClaimKind::rounded, ClaimKind::bound, ClaimKind::tendency,
                                 ClaimKind::not_reproducible};
  constexpr Rigour rigours[] = {Rigour::exact, Rigour::certified, Rigour::approximate};
  constexpr Verdict verdicts[] = {Verdict::reproduced,      Verdict::refuted,      Verdict::undecided,
                                  Verdict::consistent,      Verdict::inconsistent, Verdict::established,
                                  Verdict::not_reproducible};
  ClaimRecord record;
  record.id = object.text("id");
  record.document = object.text("document");
  record.section = object.text("section");
  record.printed = object.text_or_null("printed");
  record.kind = object.text("kind");
  record.definition = object.text("definition");
  const Object value = object.object("value");
  record.exact = value.optional_text("exact");
  record.lower = value.number_or_null("lower");
  record.upper = value.number_or_null("upper");
  if (record.lower.has_value() != record.upper.has_value())
    value.reject("upper", "must be null when 'lower' is");
  record.rigour = object.text("rigour");
  record.verdict = object.text("verdict");
  record.note = object.text("note");
  expect_word<ClaimKind>(object, "kind", record.kind, kinds);
  expect_word<Rigour>(object, "rigour", record.rigour, rigours);
  expect_word<Verdict>(object, "verdict", record.verdict, verdicts);
  return record;
}

Json or_null(const std::optional<std::string>& text) { return text ? Json(*text) : Json(nullptr); }

Json claim_to_json(const ClaimRecord& claim) {
  Json value = Json::object();
  if (claim.exact) value["exact"] = *claim.exact;
  value["lower"] = or_null(claim.lower);
  value["upper"] = or_null(claim.upper);
  Json result = Json::object();
  result["id"] = claim.id;
  result["document"] = claim.document;
  result["section"] = claim.section;
  result["printed"] = or_null(claim.printed);
  result["kind"] = claim.kind;
  result["definition"] = claim.definition;
  result["value"] = std::move(value);
  result["rigour"] = claim.rigour;
  result["verdict"] = claim.verdict;
  result["note"] = claim.note;
  return result;
}

Json entries_to_json(std::span<const FileEntry> entries) {
  Json result = Json::array();
  for (const FileEntry& entry : entries) {
    Json item = {{"name", entry.name}, {"experiment", entry.experiment}};
    if (!entry.title.empty()) item["title"] = entry.title;
    if (!entry.shows.empty()) item["shows"] = entry.shows;
    if (!entry.claims.empty()) item["claims"] = entry.claims;
    result.push_back(std::move(item));
  }
  return result;
}

std::vector<FileEntry> entries_from_json(const Json& entries, const std::string& place) {
  std::vector<FileEntry> result;
  for (const Json& item : entries) {
    const Object entry(item, place + ", entry " + std::to_string(result.size() + 1));
    const std::string name = entry.text("name");
    if (!is_file_name(name)) entry.reject("name", "must be letters, digits, '-', '_' and '.'");
    result.push_back({name, entry.text("experiment"), entry.optional_text("title").value_or(""),
                      entry.optional_text("shows").value_or(""), entry.optional_texts("claims")});
  }
  return result;
}

}  // namespace

bool is_file_name(const std::string& name) {
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  return !name.empty() && name.front() != '.' && name.find_first_not_of(allowed) == std::string::npos;
}

std::string claims_to_json(std::span<const ClaimRecord> claims) {
  Json list = Json::array();
  for (const ClaimRecord& claim : claims) list.push_back(claim_to_json(claim));
  Json root = Json::object();
  root["claims"] = std::move(list);
  return root.dump(2) + "\n";
}

std::vector<ClaimRecord> claims_from_json(const std::string& text, const std::string& file) {
  const Json json = parse(text, file);
  std::vector<ClaimRecord> result;
  std::set<std::string> ids;
  for (const Json& item : Object(json, file).array("claims")) {
    std::string place = file + ": claim " + std::to_string(result.size() + 1);
    if (item.is_object() && item.contains("id") && item["id"].is_string()) {
      place += " ('" + item["id"].get<std::string>() + "')";
    }
    const Object object(item, place);
    ClaimRecord record = claim_from_json(object);
    if (!ids.insert(record.id).second) object.reject("id", "occurs twice");
    result.push_back(std::move(record));
  }
  return result;
}

std::string manifest_to_json(const Manifest& manifest) {
  Json root = Json::object();
  root["series"] = entries_to_json(manifest.series);
  root["figures"] = entries_to_json(manifest.figures);
  if (!manifest.certificates.empty()) root["certificates"] = manifest.certificates;
  if (!manifest.pages.empty()) root["pages"] = manifest.pages;
  return root.dump(2) + "\n";
}

Manifest manifest_from_json(const std::string& text, const std::string& file) {
  const Json json = parse(text, file);
  const Object root(json, file);
  return {entries_from_json(root.array("series"), file + ": series"),
          entries_from_json(root.array("figures"), file + ": figures"), root.optional_texts("certificates"),
          root.optional_texts("pages")};
}

}  // namespace subdiv
