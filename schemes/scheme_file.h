#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/expression.h"

namespace subdiv {

/// A scheme file as written, unevaluated: a JSON object with
///
///     name        a string
///     arity       2 or 3
///     parameters  optional: names with default values, for example { "w": "1/16" }
///     mask        { "first": i, "coefficients": [..] }: the coefficients of z^i, z^(i+1), ..;
///                 the refined point i of a unit impulse takes coefficient i
///     symbol      instead of mask: an expression in z and the parameters
///     source      optional: where the scheme comes from
///
/// Values are strings that hold exact expressions, or JSON numbers, which are taken as the exact decimals
/// they show.
struct SchemeFile {
  /// A number or an expression, with its place.
  struct Value {
    Expression expression;  ///< unevaluated
    int line;               ///< of the file, from 1
  };
  /// A declared parameter.
  struct Parameter {
    std::string name;     ///< as it is written
    Value default_value;  ///< a number
  };

  std::string path;                   ///< of the file, for messages
  std::string name;                   ///< of the scheme
  std::string source;                 ///< where it comes from; may be empty
  int arity = 2;                      ///< m
  std::vector<Parameter> parameters;  ///< in the order of the file
  int first = 0;                      ///< power of z of the first coefficient
  std::vector<Value> coefficients;    ///< empty when the file gives a symbol
  std::optional<Value> symbol;        ///< in z and the parameters; none when the file gives a mask

  /// "FILE:4: coefficient 3 (of z^-1)" and "FILE:4: symbol", for messages.
  [[nodiscard]] std::string coefficient_place(std::size_t i) const;
  /// "FILE:4: symbol".
  [[nodiscard]] std::string symbol_place() const;
  /// Whether a decimal occurs in the mask or symbol.
  [[nodiscard]] bool has_decimals() const;
};

/// Masks have at most this many coefficients, from first to last.
inline constexpr int most_taps = 1000;

/// Reads a scheme file. Throws InputError, with the file, line and remedy, for a file that is missing, no
/// regular file, unreadable or larger than 1 MB, for malformed JSON, and for anything that is not as
/// described above.
[[nodiscard]] SchemeFile read_scheme_file(const std::filesystem::path& path);

/// The same for a text; `path` opens the messages.
[[nodiscard]] SchemeFile parse_scheme_file(std::string_view text, const std::string& path);

/// Throws InputError when the name cannot be a parameter's: not a letter followed by letters, digits and _,
/// or one of z, sqrt, nan, inf and infinity. `place` opens the message.
void require_parameter_name(std::string_view name, const std::string& place);

}  // namespace subdiv
