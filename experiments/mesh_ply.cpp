#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "experiments/mesh_formats.h"
#include "experiments/ply_header.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// One element after the other. Integers are exact in double: those that count have at most 32 bits.
class ElementReader {
 public:
  ElementReader(FileReader& reader, PlyEncoding encoding) : reader_(reader), encoding_(encoding) {}

  /// The line of the next element, or its first byte.
  [[nodiscard]] std::size_t place() const {
    return encoding_ == PlyEncoding::text ? reader_.line() + 1 : reader_.offset();
  }

  /// Reads the numbers of the wanted properties, each one or a list; others are passed over.
  void read(const PlyElement& element, long long number, const std::vector<std::size_t>& wanted) {
    values_.resize(element.properties.size());
    wanted_.assign(element.properties.size(), 0);
    for (const std::size_t i : wanted) wanted_[i] = 1;
    at_ = reader_.offset();
    if (encoding_ == PlyEncoding::text) {
      std::string_view line;
      if (!reader_.next_line(line)) {
        reader_.reject(fmt::format("the file ends after {} of {} elements {}", number, element.count,
                                   in_quotes(element.name)));
      }
      read_text(element, line);
    } else {
      read_binary(element);
    }
  }
  [[nodiscard]] const std::vector<double>& values(std::size_t property) const { return values_[property]; }

  [[noreturn]] void reject(const std::string& what) const {
    if (encoding_ == PlyEncoding::text) reader_.reject(what);
    reader_.reject_byte(at_, what);
  }

 private:
  void read_text(const PlyElement& element, std::string_view line) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const auto word = [&] {
        const std::string_view found = next_word(line);
        if (found.empty())
          reader_.reject(
              fmt::format("{} of element {} is missing", in_quotes(property.name), in_quotes(element.name)));
        return found;
      };
      values_[i].clear();
      const bool real = property.type == PlyType::float32 || property.type == PlyType::float64;
      const bool wanted = wanted_[i] != 0;
      const auto value = [&] {
        const std::string_view found = word();
        if (!wanted) return 0.0;
        return real ? to_coordinate(reader_, found) : static_cast<double>(to_integer(reader_, found));
      };
      if (!property.count) {
        values_[i].push_back(value());
        continue;
      }
      const long long count = to_integer(reader_, word());
      if (count < 0) reader_.reject(in_quotes(property.name) + " has a negative length");
      for (long long k = 0; k < count; ++k) {
        const double x = value();
        if (wanted) values_[i].push_back(x);
      }
    }
    if (!next_word(line).empty())
      reader_.reject("more numbers than element " + in_quotes(element.name) + " has properties");
  }

  void read_binary(const PlyElement& element) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const std::size_t size = size_of(property.type);
      std::size_t count = 1;
      if (property.count) {
        const long long length =
            ply_integer(reader_.next_bytes(size_of(*property.count)), *property.count, encoding_);
        if (length < 0) reject(in_quotes(property.name) + " has a negative length");
        count = static_cast<std::size_t>(length);
      }
      const std::string_view bytes = reader_.next_bytes(count * size);
      if (wanted_[i] == 0) continue;
      values_[i].resize(count);
      for (std::size_t k = 0; k < count; ++k)
        values_[i][k] = ply_number(bytes.substr(k * size), property.type, encoding_);
    }
  }

  FileReader& reader_;
  PlyEncoding encoding_;
  std::size_t at_ = 0;
  std::vector<char> wanted_;
  std::vector<std::vector<double>> values_;
};

void read_vertices(ElementReader& elements, const PlyElement& element, FileReader& reader, MeshFile& mesh) {
  std::array<std::size_t, 3> place{};
  for (std::size_t c = 0; c < place.size(); ++c) {
    const std::string name(1, static_cast<char>('x' + c));
    const auto found = element.find(name);
    if (!found || element.properties[*found].count)
      reader.reject("element vertex has no property " + name + "; expected three numbers x, y and z");
    place[c] = *found;
  }
  const std::vector<std::size_t> wanted(place.begin(), place.end());
  mesh.points.reserve(
      static_cast<std::size_t>(element.count));  // the header was compared with the file's size
  for (long long v = 0; v < element.count; ++v) {
    elements.read(element, v, wanted);
    Point3 point{};
    for (std::size_t c = 0; c < place.size(); ++c) {
      point[c] = elements.values(place[c]).front();
      if (!std::isfinite(point[c])) elements.reject(fmt::format("vertex {} is not finite", v + 1));
    }
    mesh.points.push_back(point);
  }
}

void read_faces(ElementReader& elements, const PlyElement& element, FileReader& reader, MeshFile& mesh) {
  auto list = element.find("vertex_indices");
  if (!list) list = element.find("vertex_index");
  if (!list || !element.properties[*list].count)
    reader.reject("element face has no list vertex_indices, nor vertex_index");
  const PlyType type = element.properties[*list].type;
  if (type == PlyType::float32 || type == PlyType::float64)
    reader.reject("the corners of faces are integers, not floats");
  std::vector<long long> corners;
  for (long long f = 0; f < element.count; ++f) {
    mesh.places.push_back(elements.place());
    elements.read(element, f, {*list});
    corners.clear();
    for (const double corner : elements.values(*list)) {
      constexpr double most = 4294967295.0;  // of the widest type; text may claim more
      if (std::abs(corner) > most) elements.reject(fmt::format("a corner is {}: no such vertex", corner));
      corners.push_back(static_cast<long long>(corner));
    }
    mesh.faces.add_face(corners);
  }
}

/// Elements that do not count; those of a fixed size in one leap.
void skip(ElementReader& elements, const PlyElement& element, const PlyHeader& header, FileReader& reader) {
  const bool fixed = std::none_of(element.properties.begin(), element.properties.end(),
                                  [](const PlyProperty& p) { return p.count.has_value(); });
  if (header.encoding == PlyEncoding::text || !fixed) {
    for (long long i = 0; i < element.count; ++i) elements.read(element, i, {});
    return;
  }
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) size += size_of(p.type);
  reader.skip_bytes(size * static_cast<std::size_t>(element.count));
}

}  // namespace

void read_ply(FileReader& reader, MeshFile& mesh) {
  const PlyHeader header = read_ply_header(reader);
  mesh.binary = header.encoding != PlyEncoding::text;
  ElementReader elements(reader, header.encoding);
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(elements, element, reader, mesh);
    } else if (element.name == "face") {
      read_faces(elements, element, reader, mesh);
    } else if (element.name == "tristrips" && element.count > 0) {
      reader.reject("the surface is given by strips of triangles (element tristrips); expected element face");
    } else {
      skip(elements, element, header, reader);
    }
  }
  if (mesh.binary) {
    if (reader.left() > 0)
      reader.reject_byte(reader.offset(), "more bytes than the elements of the header take");
    return;
  }
  for (std::string_view line; reader.next_line(line);) {
    if (!trimmed(line).empty()) reader.reject("more lines than the elements of the header take");
  }
}

}  // namespace subdiv
