#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/file_reader.h"

namespace subdiv {

enum class PlyEncoding { text, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count;  // of a list: the type of the number that stands before its values
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
};

/// Reads up to the line end_header. Throws InputError with the line for unknown types and words, repeated
/// names, elements without properties, and numbers of elements for which the file is too short.
[[nodiscard]] PlyHeader read_ply_header(FileReader& reader);

/// The number of a binary file at the front of these bytes. Coordinates as double are exact for all types;
/// integers must not be given a type of floating point.
[[nodiscard]] double ply_number(std::string_view bytes, PlyType type, PlyEncoding encoding);
[[nodiscard]] long long ply_integer(std::string_view bytes, PlyType type, PlyEncoding encoding);

}  // namespace subdiv
