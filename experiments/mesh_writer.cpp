#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "experiments/mesh_file.h"
#include "experiments/report/curve_writer.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY files are written as numbers lie in memory");

void append_integer(std::string& text, long long x) {
  std::array<char, 24> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x);
  text.append(digits.data(), end);
}

template <class T>
void append_bytes(std::string& text, T x) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &x, sizeof(T));
  text.append(bytes.data(), bytes.size());
}

/// Points and faces: degree(f) and corner(f, i) of `count` faces.
template <class Degree, class Corner>
struct Faces {
  std::size_t count = 0;
  Degree degree;
  Corner corner;
};

template <class F>
void write_text(OutputFile& file, MeshFormat format, std::span<const Point3> points, const F& faces) {
  const bool obj = format == MeshFormat::obj;
  if (!obj) file.write(fmt::format("OFF\n{} {} 0\n", points.size(), faces.count));
  std::string text;
  for (const Point3& point : points) {
    text = obj ? "v " : "";
    for (std::size_t c = 0; c < point.size(); ++c) {
      if (c > 0) text += ' ';
      append_number(text, point[c]);
    }
    file.write(text += '\n');
  }
  for (std::size_t f = 0; f < faces.count; ++f) {
    const std::size_t degree = faces.degree(f);
    text = obj ? "f" : std::to_string(degree);
    for (std::size_t i = 0; i < degree; ++i) {
      text += ' ';
      append_integer(text, faces.corner(f, i) + (obj ? 1 : 0));
    }
    file.write(text += '\n');
  }
}

template <class F>
void write_ply(OutputFile& file, std::span<const Point3> points, const F& faces) {
  if (points.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError("a .ply file numbers fewer vertices; write an .obj or .off file");
  std::size_t longest = 0;
  for (std::size_t f = 0; f < faces.count; ++f) longest = std::max(longest, faces.degree(f));
  const bool small = longest <= std::numeric_limits<std::uint8_t>::max();
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\n"
                  "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
                  "element face {}\nproperty list {} int vertex_indices\nend_header\n",
                  points.size(), faces.count, small ? "uchar" : "uint"));
  std::string bytes;
  for (const Point3& point : points) {
    bytes.clear();
    for (const double x : point) {
      if (!std::isfinite(x)) append_number(bytes, x);  // says so
      append_bytes(bytes, x);
    }
    file.write(bytes);
  }
  for (std::size_t f = 0; f < faces.count; ++f) {
    const std::size_t degree = faces.degree(f);
    bytes.clear();
    if (small) {
      append_bytes(bytes, static_cast<std::uint8_t>(degree));
    } else {
      append_bytes(bytes, static_cast<std::uint32_t>(degree));
    }
    for (std::size_t i = 0; i < degree; ++i)
      append_bytes(bytes, static_cast<std::int32_t>(faces.corner(f, i)));
    file.write(bytes);
  }
}

template <class F>
void write(OutputFile& file, MeshFormat format, std::span<const Point3> points, const F& faces) {
  if (format == MeshFormat::ply) {
    write_ply(file, points, faces);
  } else {
    write_text(file, format, points, faces);
  }
}

}  // namespace

void write_mesh(OutputFile& file, MeshFormat format, const IndexedMesh& mesh) {
  const auto sides = static_cast<std::size_t>(mesh.sides);
  const Faces faces{mesh.faces(), [sides](std::size_t /*f*/) { return sides; },
                    [&mesh, sides](std::size_t f, std::size_t i) {
                      return static_cast<long long>(mesh.corners[f * sides + i]);
                    }};
  write(file, format, mesh.points, faces);
}

void write_mesh(OutputFile& file, MeshFormat format, const PolygonFaces& polygons,
                std::span<const Point3> points) {
  const Faces faces{polygons.faces(), [&](std::size_t f) { return polygons.face(f).size(); },
                    [&](std::size_t f, std::size_t i) { return polygons.face(f)[i]; }};
  write(file, format, points, faces);
}

}  // namespace subdiv
