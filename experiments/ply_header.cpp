#include "experiments/ply_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "schemes/text.h"

namespace subdiv {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

PlyType type_of(const FileReader& reader, std::string_view word) {
  for (const auto& [name, type] : type_names) {
    if (name == word) return type;
  }
  reader.reject(in_quotes(word) +
                " is no type; expected char, uchar, short, ushort, int, uint, float or double");
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

PlyProperty property(const FileReader& reader, std::string_view rest) {
  PlyProperty result;
  std::string_view word = next_word(rest);
  if (word == "list") {
    result.count = type_of(reader, next_word(rest));
    if (!is_integer(*result.count)) reader.reject("the length of a list is an integer, not a float");
    word = next_word(rest);
  }
  result.type = type_of(reader, word);
  result.name = next_word(rest);
  if (result.name.empty()) reader.reject("a property without a name; expected property TYPE NAME");
  return result;
}

PlyElement element(const FileReader& reader, std::string_view rest) {
  PlyElement result;
  result.name = next_word(rest);
  const std::string_view count = next_word(rest);
  if (count.empty()) reader.reject("expected element NAME COUNT");
  result.count = to_integer(reader, count);
  if (result.count < 0) reader.reject(in_quotes(count) + " is no number of elements");
  return result;
}

PlyEncoding encoding(const FileReader& reader, std::string_view rest) {
  const std::string_view name = next_word(rest);
  const std::string_view version = next_word(rest);
  if (version != "1.0") reader.reject("expected version 1.0, found " + in_quotes(version));
  if (name == "ascii") return PlyEncoding::text;
  if (name == "binary_little_endian") return PlyEncoding::little_endian;
  if (name == "binary_big_endian") return PlyEncoding::big_endian;
  reader.reject(in_quotes(name) + " is no format; expected ascii, binary_little_endian or binary_big_endian");
}

/// The least number of bytes that an element takes: in text a digit and a space for each property.
std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties)
    size += encoding == PlyEncoding::text ? 2 : size_of(p.count.value_or(p.type));
  return size;
}

/// The counts are claims: without this a small file could ask for any memory or time.
void require_size(const FileReader& reader, const PlyHeader& header) {
  for (const PlyElement& e : header.elements) {
    if (e.count == 0) continue;
    if (e.properties.empty()) reader.reject("element " + in_quotes(e.name) + " has no properties");
    const std::size_t most = (reader.left() + 1) / least_size(e, header.encoding);  // 1: no end of line
    if (static_cast<std::size_t>(e.count) > most) {
      reader.reject(fmt::format("the header claims {} elements {}, but the file ends {} bytes below it",
                                e.count, in_quotes(e.name), reader.left()));
    }
  }
}

template <class T>
T number_at(std::string_view bytes, PlyEncoding encoding) {
  std::array<char, sizeof(T)> own{};
  std::copy_n(bytes.begin(), sizeof(T), own.begin());
  if ((encoding == PlyEncoding::little_endian) != (std::endian::native == std::endian::little))
    std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  throw std::logic_error("a type of PLY files");
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return i;
  }
  return std::nullopt;
}

PlyHeader read_ply_header(FileReader& reader) {
  PlyHeader header;
  std::string_view line;
  if (!reader.next_line(line) || trimmed(line) != "ply")
    reader.reject("a .ply file begins with a line that says ply");
  bool has_encoding = false;
  while (true) {
    if (!reader.next_line(line)) reader.reject("the file ends before end_header");
    const std::string_view word = next_word(line);
    if (word == "end_header") break;
    if (word == "format") {
      header.encoding = encoding(reader, line);
      has_encoding = true;
    } else if (word == "element") {
      header.elements.push_back(element(reader, line));
      const auto& last = header.elements.back();
      if (std::count_if(header.elements.begin(), header.elements.end(),
                        [&](const PlyElement& e) { return e.name == last.name; }) > 1)
        reader.reject("a second element " + in_quotes(last.name));
    } else if (word == "property") {
      if (header.elements.empty()) reader.reject("a property before the first element");
      PlyElement& last = header.elements.back();
      PlyProperty added = property(reader, line);
      if (last.find(added.name)) reader.reject("a second property " + in_quotes(added.name));
      last.properties.push_back(std::move(added));
    } else if (!word.empty() && word != "comment" && word != "obj_info") {
      reader.reject(in_quotes(word) +
                    " is no word of a header; expected format, element, property, comment "
                    "or end_header");
    }
  }
  if (!has_encoding) reader.reject("the header says no format; expected a line format ascii 1.0");
  require_size(reader, header);
  return header;
}

double ply_number(std::string_view bytes, PlyType type, PlyEncoding encoding) {
  if (type == PlyType::float32) return static_cast<double>(number_at<float>(bytes, encoding));
  if (type == PlyType::float64) return number_at<double>(bytes, encoding);
  return static_cast<double>(ply_integer(bytes, type, encoding));
}

long long ply_integer(std::string_view bytes, PlyType type, PlyEncoding encoding) {
  switch (type) {
    case PlyType::int8:
      return number_at<std::int8_t>(bytes, encoding);
    case PlyType::uint8:
      return number_at<std::uint8_t>(bytes, encoding);
    case PlyType::int16:
      return number_at<std::int16_t>(bytes, encoding);
    case PlyType::uint16:
      return number_at<std::uint16_t>(bytes, encoding);
    case PlyType::int32:
      return number_at<std::int32_t>(bytes, encoding);
    case PlyType::uint32:
      return number_at<std::uint32_t>(bytes, encoding);
    case PlyType::float32:
    case PlyType::float64:
      break;
  }
  throw std::logic_error("an integer type of PLY files");
}

}  // namespace subdiv
