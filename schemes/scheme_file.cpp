#include "schemes/scheme_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <span>
#include <system_error>

#include "schemes/json_document.h"
#include "schemes/symbol_expression.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

constexpr std::size_t largest_file = 1'000'000;

/// NaN and infinities, as languages print them.
bool is_no_finite_number(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

/// Reads the members of one JSON object and complains in its place.
class SchemeReader {
 public:
  explicit SchemeReader(std::string path) : path_(std::move(path)) {}

  SchemeFile read(const JsonValue& root) {
    require_kind(root, JsonValue::Kind::object, "a scheme file");
    require_known_members(
        root, "a scheme file",
        std::array<std::string, 6>{"name", "arity", "parameters", "mask", "symbol", "source"});
    SchemeFile file;
    file.path = path_;
    file.name = read_name(member(root, "name", "a name in quotes, such as \"name\": \"my scheme\""));
    file.arity = read_arity(member(root, "arity", "\"arity\": 2, or 3 for a ternary scheme"));
    if (const JsonValue* source = root.find("source")) {
      require_kind(*source, JsonValue::Kind::string, "\"source\"");
      file.source = source->text;
    }
    if (const JsonValue* parameters = root.find("parameters")) file.parameters = read_parameters(*parameters);
    const JsonValue* mask = root.find("mask");
    const JsonValue* symbol = root.find("symbol");
    if ((mask != nullptr) == (symbol != nullptr)) {
      fail(root.line,
           mask != nullptr
               ? "\"mask\" and \"symbol\" both given; keep one of them"
               : "neither \"mask\" nor \"symbol\" given; write, for example, \"mask\": {\"first\": -1, "
                 "\"coefficients\": [\"1/2\", \"1\", \"1/2\"]} or \"symbol\": \"2*((1+z)/2)^4\"");
    }
    if (mask != nullptr) {
      read_mask(*mask, file);
    } else {
      file.symbol = read_value(*symbol, "\"symbol\"");
      require_bound(*file.symbol, file, true, file.symbol_place());
    }
    return file;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& what) const {
    throw InputError(path_ + ":" + std::to_string(line) + ": " + what);
  }

  void require_kind(const JsonValue& value, JsonValue::Kind kind, const std::string& what) const {
    if (value.kind != kind)
      fail(value.line, what + " must be " + describe(kind) + ", not " + describe(value.kind));
  }

  void require_known_members(const JsonValue& object, const std::string& what,
                             std::span<const std::string> known) const {
    for (const auto& [name, value] : object.members) {
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        fail(value.line, "unknown key " + in_quotes(name) + suggestion(name, known) + " The keys of " + what +
                             " are " + joined(known, "and"));
      }
    }
  }

  const JsonValue& member(const JsonValue& object, const std::string& name, const std::string& remedy) const {
    const JsonValue* found = object.find(name);
    if (found == nullptr) fail(object.line, "\"" + name + "\" is missing; write " + remedy);
    return *found;
  }

  [[nodiscard]] std::string read_name(const JsonValue& value) const {
    constexpr std::size_t longest = 200;
    require_kind(value, JsonValue::Kind::string, "\"name\"");
    if (trimmed(value.text).empty()) fail(value.line, "\"name\" is empty; give the scheme a name");
    if (value.text.size() > longest) fail(value.line, "\"name\" has more than 200 characters; shorten it");
    return std::string(trimmed(value.text));
  }

  /// A JSON number without point and exponent.
  [[nodiscard]] long read_whole(const JsonValue& value, const std::string& what, long limit) const {
    require_kind(value, JsonValue::Kind::number, what);
    const std::string expected =
        what + " must be a whole number from " + std::to_string(-limit) + " to " + std::to_string(limit);
    if (value.text.find_first_of(".eE") != std::string::npos)
      fail(value.line, expected + ", not " + in_quotes(value.text));
    const Rational number = Rational::parse(value.text);
    if (abs(number) > Rational(limit)) fail(value.line, expected + ", not " + in_quotes(value.text));
    return number.to_integer();
  }

  [[nodiscard]] int read_arity(const JsonValue& value) const {
    constexpr long limit = 1000;
    const long arity = read_whole(value, "\"arity\"", limit);
    if (arity != 2 && arity != 3) {
      fail(value.line, "arity " + std::to_string(arity) + " is not supported; it must be 2 or 3");
    }
    return static_cast<int>(arity);
  }

  [[nodiscard]] SchemeFile::Value read_value(const JsonValue& value, const std::string& what) const {
    if (value.kind != JsonValue::Kind::string && value.kind != JsonValue::Kind::number) {
      fail(value.line, what + " must be a number or an expression in quotes, such as \"1/16\", not " +
                           describe(value.kind));
    }
    try {
      return {Expression::parse(value.text), value.line};
    } catch (const InputError& error) {
      fail(value.line, what + ": " + error.what());
    }
  }

  [[nodiscard]] std::vector<SchemeFile::Parameter> read_parameters(const JsonValue& object) const {
    require_kind(object, JsonValue::Kind::object, "\"parameters\"");
    std::vector<SchemeFile::Parameter> result;
    for (const auto& [name, value] : object.members) {
      require_parameter_name(name, path_ + ":" + std::to_string(value.line));
      result.push_back({name, read_value(value, "parameter " + name)});
      const Expression& number = result.back().default_value.expression;
      if (const auto names = number.names(); !names.empty()) {
        fail(value.line, "parameter " + name + ": a default value is a number, without names such as " +
                             in_quotes(names.front()));
      }
    }
    return result;
  }

  void read_mask(const JsonValue& object, SchemeFile& file) const {
    constexpr long farthest = 10'000;
    require_kind(object, JsonValue::Kind::object, "\"mask\"");
    require_known_members(object, "\"mask\"", std::array<std::string, 2>{"first", "coefficients"});
    file.first = static_cast<int>(
        read_whole(member(object, "first", "the index of the first coefficient, such as \"first\": -3"),
                   "\"first\"", farthest));
    const JsonValue& list =
        member(object, "coefficients", "a list, such as \"coefficients\": [\"1/2\", \"1\", \"1/2\"]");
    require_kind(list, JsonValue::Kind::array, "\"coefficients\"");
    if (list.elements.empty())
      fail(list.line, "\"coefficients\" is empty; a mask has at least one coefficient");
    if (list.elements.size() > static_cast<std::size_t>(most_taps)) {
      fail(list.line, "the mask has " + std::to_string(list.elements.size()) + " coefficients; at most " +
                          std::to_string(most_taps) + " are supported");
    }
    for (std::size_t i = 0; i < list.elements.size(); ++i) {
      const std::string what = "coefficient " + std::to_string(i + 1);
      file.coefficients.push_back(read_value(list.elements[i], what));
      require_bound(file.coefficients.back(), file, false, file.coefficient_place(i));
    }
  }

  /// Every name in the value must be a parameter, or z in a symbol.
  static void require_bound(const SchemeFile::Value& value, const SchemeFile& file, bool in_symbol,
                            const std::string& place) {
    std::vector<std::string> known;
    if (in_symbol) known.emplace_back(symbol_name);
    for (const SchemeFile::Parameter& p : file.parameters) known.push_back(p.name);
    for (const Expression::Node& node : value.expression.nodes()) {
      if (node.kind != Expression::Kind::name) continue;
      if (std::find(known.begin(), known.end(), node.name) != known.end()) continue;
      if (is_no_finite_number(node.name)) {
        throw InputError(place + ": " + in_quotes(node.name) +
                         " is no finite number; write one, such as 1/16");
      }
      std::string what = "unknown name " + in_quotes(node.name) + suggestion(node.name, known);
      what += known.empty()
                  ? " Write a number, or declare the name under \"parameters\""
                  : " Known here: " + joined(known, "and") + "; others are declared under \"parameters\"";
      throw InputError(place + ": " + value.expression.locate(node, what));
    }
  }

  std::string path_;
};

std::string read_text(const std::filesystem::path& path) {
  const std::string place = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw InputError(place + ": no such file; give the path of a scheme file, from the current folder");
  if (std::filesystem::is_directory(status))
    throw InputError(place + ": is a folder; expected a scheme file");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(place + ": is no regular file; expected a scheme file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(place + ": cannot be opened for reading; check its permissions");
  std::string text(largest_file + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InputError(place + ": cannot be read");
  if (static_cast<std::size_t>(stream.gcount()) > largest_file) {
    throw InputError(place + ": larger than 1 MB; a scheme file holds at most " + std::to_string(most_taps) +
                     " coefficients and is read up to 1 MB");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace

std::string SchemeFile::coefficient_place(std::size_t i) const {
  return path + ":" + std::to_string(coefficients[i].line) + ": coefficient " + std::to_string(i + 1) +
         " (of z^" + std::to_string(first + static_cast<int>(i)) + ")";
}

std::string SchemeFile::symbol_place() const {
  return path + ":" + std::to_string(symbol->line) + ": symbol";
}

bool SchemeFile::has_decimals() const {
  return (symbol && symbol->expression.has_decimals()) ||
         std::any_of(coefficients.begin(), coefficients.end(),
                     [](const Value& value) { return value.expression.has_decimals(); });
}

SchemeFile read_scheme_file(const std::filesystem::path& path) {
  return parse_scheme_file(read_text(path), path.string());
}

SchemeFile parse_scheme_file(std::string_view text, const std::string& path) {
  if (trimmed(text).empty())
    throw InputError(path + ": the file is empty; expected a scheme as a JSON object");
  return SchemeReader(path).read(parse_json(text, path));
}

void require_parameter_name(std::string_view name, const std::string& place) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool well_formed =
      !name.empty() && is_letter(name.front()) &&
      std::all_of(name.begin(), name.end(), [&](char c) { return is_letter(c) || is_digit(c); });
  if (!well_formed) {
    throw InputError(place + ": " + in_quotes(name) +
                     " cannot name a parameter; a name is a letter followed by letters, digits and _");
  }
  if (is_no_finite_number(name)) {
    throw InputError(place + ": " + in_quotes(name) +
                     " is neither a finite number nor a name for a parameter");
  }
  if (name == symbol_name)
    throw InputError(place + ": 'z' is the symbol's indeterminate; choose another name");
  if (name == "sqrt") throw InputError(place + ": 'sqrt' is the square root; choose another name");
}

}  // namespace subdiv
