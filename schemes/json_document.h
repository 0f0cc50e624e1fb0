#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace subdiv {

/// A value of a JSON text, read without loss: numbers are kept as they are written (0.1 is not rounded to a
/// double), and every value knows its line for messages.
struct JsonValue {
  /// What JSON knows.
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;             ///< which of them
  int line = 1;                       ///< from 1
  std::string text{};                 ///< of a number as written, of a string decoded, "true" or "false"
  std::vector<JsonValue> elements{};  ///< of an array
  std::vector<std::pair<std::string, JsonValue>> members{};  ///< in the order of the text; names are distinct

  /// The member with this name; null when there is none.
  [[nodiscard]] const JsonValue* find(std::string_view name) const;
};

/// Parses a JSON text. `place` (a file's name) opens every message. Throws InputError with line and column
/// for text that is no JSON, names that occur twice in an object, objects of
/// more than 1000 members and more than 20 nested levels.
[[nodiscard]] JsonValue parse_json(std::string_view text, const std::string& place);

/// "a string", "a number", .. for messages.
[[nodiscard]] std::string describe(JsonValue::Kind kind);

}  // namespace subdiv
