#include "experiments/mesh_pictures.h"

#include <cstddef>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

Eigen::Vector3d vector_of(const Point3& p) { return {p[0], p[1], p[2]}; }

/// Adds the face whose i-th corner of `degree` is the point with the number corner(i).
template <class Corner>
void add_face(std::vector<SpaceQuad>& quads, std::span<const Point3> points, std::size_t degree,
              const Corner& corner) {
  const auto at = [&](std::size_t i) { return vector_of(points[static_cast<std::size_t>(corner(i))]); };
  if (degree == 4) {
    quads.push_back({{at(0), at(1), at(2), at(3)}, quads.size(), 0});
    return;
  }
  for (std::size_t i = 1; i + 1 < degree; ++i)
    quads.push_back({{at(0), at(i), at(i + 1), at(i + 1)}, quads.size(), 0});
}

}  // namespace

std::vector<SpaceQuad> mesh_quads(const IndexedMesh& mesh) {
  std::vector<SpaceQuad> quads;
  const auto sides = static_cast<std::size_t>(mesh.sides);
  for (std::size_t f = 0; f < mesh.faces(); ++f)
    add_face(quads, mesh.points, sides, [&](std::size_t i) { return mesh.corners[f * sides + i]; });
  return quads;
}

std::vector<SpaceQuad> mesh_quads(const PolygonFaces& faces, std::span<const Point3> points) {
  std::vector<SpaceQuad> quads;
  for (std::size_t f = 0; f < faces.faces(); ++f)
    add_face(quads, points, faces.face(f).size(), [&](std::size_t i) { return faces.face(f)[i]; });
  return quads;
}

void write_picture(OutputFile& file, std::vector<SpaceQuad> quads, bool closed) {
  constexpr double pixels = 800;
  constexpr double margin = 20;
  constexpr unsigned colour_of_mesh = style::lit_orange;
  const View view = view_from({2, -5, 4});
  Eigen::AlignedBox2d frame;
  for (const SpaceQuad& quad : quads) {
    for (const Eigen::Vector3d& corner : quad.corners) frame.extend(view.project(corner));
  }
  if (quads.empty()) frame.extend(Eigen::Vector2d(0, 0));
  const double extent = frame.sizes().maxCoeff();
  if (!frame.sizes().allFinite()) throw InputError("a coordinate leaves the range of doubles");
  const double scale = extent > 0 ? (pixels - 2 * margin) / extent : 1;
  // Pictures of figures have y upwards, SVG files downwards: the highest point is at y = -margin.
  const Eigen::Vector2d shift(margin - frame.min().x() * scale, -margin - frame.max().y() * scale);
  Series series = polygons("mesh");
  add_quads(series, std::move(quads), closed, {view, scale, shift}, Paint::shaded, colour_of_mesh);
  const Eigen::Vector2d size = frame.sizes() * scale + Eigen::Vector2d(2 * margin, 2 * margin);
  file.write(
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6g}\" height=\"{1:.6g}\" "
                  "viewBox=\"0 0 {0:.6g} {1:.6g}\" stroke-width=\"0.3\">\n",
                  size.x(), size.y()));
  std::string path;
  unsigned colour = 0;
  for (const std::vector<std::string>& row : series.rows) {
    if (!row[0].empty()) {
      const std::string y = row[1].starts_with('-') ? row[1].substr(1) : "-" + row[1];
      path += (path.empty() ? "M" : " ") + row[0] + " " + y;
      colour = static_cast<unsigned>(std::stoul(row[2]));
      continue;
    }
    file.write(fmt::format("<path fill=\"#{0:06x}\" stroke=\"#{0:06x}\" d=\"{1}Z\"/>\n", colour, path));
    path.clear();
  }
  file.write("</svg>\n");
}

}  // namespace subdiv
