#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>

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

void append_point(std::string& text, const Point3& point) {
  for (const double x : point) {
    if (!text.empty()) text += ' ';
    append_number(text, x);
  }
}

/// Points, and their normals where there are any.
struct Vertices {
  std::span<const Point3> points;
  std::span<const Point3> normals = {};
};

template <class F>
void write_obj(OutputFile& file, const Vertices& vertices, const F& faces) {
  std::string text;
  const auto write_points = [&](const char* keyword, std::span<const Point3> points) {
    for (const Point3& point : points) {
      text = keyword;
      append_point(text, point);
      file.write(text += '\n');
    }
  };
  write_points("v", vertices.points);
  write_points("vn", vertices.normals);
  for (std::size_t f = 0; f < faces.count; ++f) {
    text = "f";
    for (std::size_t i = 0; i < faces.degree(f); ++i) {
      text += ' ';
      append_integer(text, faces.corner(f, i) + 1);
      if (vertices.normals.empty()) continue;
      text += "//";
      append_integer(text, faces.corner(f, i) + 1);
    }
    file.write(text += '\n');
  }
}

template <class F>
void write_off(OutputFile& file, const Vertices& vertices, const F& faces) {
  const bool normals = !vertices.normals.empty();
  file.write(fmt::format("{}OFF\n{} {} 0\n", normals ? "N" : "", vertices.points.size(), faces.count));
  std::string text;
  for (std::size_t v = 0; v < vertices.points.size(); ++v) {
    text.clear();
    append_point(text, vertices.points[v]);
    if (normals) append_point(text, vertices.normals[v]);
    file.write(text += '\n');
  }
  for (std::size_t f = 0; f < faces.count; ++f) {
    text = std::to_string(faces.degree(f));
    for (std::size_t i = 0; i < faces.degree(f); ++i) {
      text += ' ';
      append_integer(text, faces.corner(f, i));
    }
    file.write(text += '\n');
  }
}

void append_bytes(std::string& bytes, const Point3& point) {
  for (const double x : point) {
    if (!std::isfinite(x)) append_number(bytes, x);  // says so
    append_bytes(bytes, x);
  }
}

template <class F>
void write_ply(OutputFile& file, const Vertices& vertices, const F& faces) {
  const std::size_t count = vertices.points.size();
  if (count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError("a .ply file numbers fewer vertices; write an .obj or .off file");
  std::size_t longest = 0;
  for (std::size_t f = 0; f < faces.count; ++f) longest = std::max(longest, faces.degree(f));
  const bool small = longest <= std::numeric_limits<std::uint8_t>::max();
  const bool normals = !vertices.normals.empty();
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\n"
                  "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}"
                  "element face {}\nproperty list {} int vertex_indices\nend_header\n",
                  count, normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "",
                  faces.count, small ? "uchar" : "uint"));
  std::string bytes;
  for (std::size_t v = 0; v < count; ++v) {
    bytes.clear();
    append_bytes(bytes, vertices.points[v]);
    if (normals) append_bytes(bytes, vertices.normals[v]);
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
void write(OutputFile& file, MeshFormat format, const Vertices& vertices, const F& faces) {
  switch (format) {
    case MeshFormat::obj:
      write_obj(file, vertices, faces);
      return;
    case MeshFormat::off:
      write_off(file, vertices, faces);
      return;
    case MeshFormat::ply:
      write_ply(file, vertices, faces);
      return;
  }
}

}  // namespace

void write_mesh(OutputFile& file, MeshFormat format, const IndexedMesh& mesh) {
  const auto sides = static_cast<std::size_t>(mesh.sides);
  const Faces faces{mesh.faces(), [sides](std::size_t /*f*/) { return sides; },
                    [&mesh, sides](std::size_t f, std::size_t i) {
                      return static_cast<long long>(mesh.corners[f * sides + i]);
                    }};
  write(file, format, {mesh.points, mesh.normals}, faces);
}

void write_mesh(OutputFile& file, MeshFormat format, const PolygonFaces& polygons,
                std::span<const Point3> points) {
  const Faces faces{polygons.faces(), [&](std::size_t f) { return polygons.face(f).size(); },
                    [&](std::size_t f, std::size_t i) { return polygons.face(f)[i]; }};
  write(file, format, {points}, faces);
}

}  // namespace subdiv
