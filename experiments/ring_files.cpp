#include "experiments/ring_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "experiments/report/curve_writer.h"
#include "schemes/evaluate/bezier_patch.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

struct PointHash {
  std::size_t operator()(const Point3& p) const {
    std::size_t result = 0;
    for (const double x : p) {
      std::uint64_t bits = 0;
      const double one_zero = x + 0.0;  // -0 and 0 are one number
      std::memcpy(&bits, &one_zero, sizeof(bits));
      constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U;
      constexpr int half = 32;
      result = (result ^ bits) * odd;
      result ^= result >> half;
    }
    return result;
  }
};

/// The vertices along an edge of a patch in ascending order, and which of them stand at k/pieces; elsewhere
/// than at joints there are no others.
struct EdgeVertices {
  std::vector<int> numbers;
  std::vector<std::size_t> nodes;
};

class Tessellation {
 public:
  Tessellation(const RingSurface& surface, int pieces)
      : surface_(surface), last_(static_cast<std::size_t>(pieces)) {
    for (int k = 0; k <= pieces; ++k) weights_.push_back(bernstein(k, pieces));
    for (const RingJoint& joint : surface.joints) joints_.emplace(key(joint.outer, joint.outer_edge), &joint);
    const std::size_t faces = surface.patches.size() * last_ * last_;
    mesh_.faces.begin.reserve(faces + 1);
    mesh_.faces.corners.reserve(4 * faces);
    mesh_.points.reserve(faces);
    places_.reserve(2 * surface.patches.size() * last_);
  }

  void add(std::size_t patch) {
    std::array<EdgeVertices, 4> edges;  // by PatchEdge
    for (const PatchEdge edge : all_edges) edges.at(index(edge)) = edge_vertices(patch, edge);
    const std::size_t side = last_ + 1;
    inner_.assign(side * side, -1);
    for (std::size_t i = 1; i < last_; ++i) {
      for (std::size_t j = 1; j < last_; ++j)
        inner_[i * side + j] = added(patch_point(surface_.patches[patch], weights_[i], weights_[j]));
    }
    for (std::size_t i = 0; i < last_; ++i) {
      for (std::size_t j = 0; j < last_; ++j) add_cell(i, j, edges);
    }
  }

  [[nodiscard]] GroupedMesh take() && {
    mesh_.faces.vertices = mesh_.points.size();
    return std::move(mesh_);
  }

 private:
  static constexpr std::array all_edges{PatchEdge::first_i, PatchEdge::last_i, PatchEdge::first_j,
                                        PatchEdge::last_j};
  static std::size_t index(PatchEdge edge) { return static_cast<std::size_t>(edge); }
  static std::size_t key(std::size_t patch, PatchEdge edge) { return 4 * patch + index(edge); }

  int added(const Point3& point) {
    mesh_.points.push_back(point);
    return static_cast<int>(mesh_.points.size()) - 1;
  }
  int shared(const Point3& point) {
    const auto [place, is_new] = places_.try_emplace(point, static_cast<int>(mesh_.points.size()));
    return is_new ? added(point) : place->second;
  }

  /// The vertices at k/pieces of one edge.
  std::vector<int> own_vertices(std::size_t patch, PatchEdge edge) {
    const std::array<Point3, 4> line = edge_layers(surface_.patches[patch], edge)[0];
    std::vector<int> result;
    for (const auto& weights : weights_) result.push_back(shared(cubic_point(weights, line)));
    return result;
  }
  EdgeVertices edge_vertices(std::size_t patch, PatchEdge edge) {
    EdgeVertices result;
    const auto found = joints_.find(key(patch, edge));
    if (found == joints_.end()) {
      result.numbers = own_vertices(patch, edge);
      for (std::size_t k = 0; k <= last_; ++k) result.nodes.push_back(k);
      return result;
    }
    const RingJoint& joint = *found->second;
    for (const std::size_t inner : joint.inner) {
      std::vector<int> part = own_vertices(inner, joint.inner_edge);
      if (joint.reversed) std::reverse(part.begin(), part.end());
      if (!result.numbers.empty()) part.erase(part.begin());
      result.numbers.insert(result.numbers.end(), part.begin(), part.end());
    }
    // Of the 2 N + 1 vertices those nearest to k/N, in order.
    const auto pieces = static_cast<double>(last_);
    result.nodes.push_back(0);
    for (std::size_t k = 1; k < last_; ++k) {
      const double t = static_cast<double>(k) / pieces;
      const double place = t <= joint.split ? pieces * t / joint.split
                                            : pieces + pieces * (t - joint.split) / (1 - joint.split);
      const auto nearest = static_cast<std::size_t>(std::lround(place));
      result.nodes.push_back(std::clamp(nearest, result.nodes.back() + 1, last_ + k));
    }
    result.nodes.push_back(2 * last_);
    return result;
  }

  void add_cell(std::size_t i, std::size_t j, const std::array<EdgeVertices, 4>& edges) {
    corners_.clear();
    side(i, i + 1, j, j == 0 ? &edges[index(PatchEdge::first_j)] : nullptr, false, edges);
    side(j, j + 1, i + 1, i + 1 == last_ ? &edges[index(PatchEdge::last_i)] : nullptr, true, edges);
    side(i + 1, i, j + 1, j + 1 == last_ ? &edges[index(PatchEdge::last_j)] : nullptr, false, edges);
    side(j + 1, j, i, i == 0 ? &edges[index(PatchEdge::first_i)] : nullptr, true, edges);
    mesh_.faces.add_face(corners_);
  }
  /// The vertices of one side of a cell but its end: along an edge of the patch, or its start alone.
  void side(std::size_t from, std::size_t to, std::size_t fixed, const EdgeVertices* edge, bool along_j,
            const std::array<EdgeVertices, 4>& edges) {
    if (edge == nullptr) {
      corners_.push_back(along_j ? node(fixed, from, edges) : node(from, fixed, edges));
      return;
    }
    for (std::size_t k = edge->nodes[from]; k != edge->nodes[to]; from < to ? ++k : --k)
      corners_.push_back(edge->numbers[k]);
  }
  [[nodiscard]] int node(std::size_t i, std::size_t j, const std::array<EdgeVertices, 4>& edges) const {
    const auto at = [&](PatchEdge edge, std::size_t k) {
      const EdgeVertices& vertices = edges.at(index(edge));
      return vertices.numbers[vertices.nodes[k]];
    };
    if (i == 0) return at(PatchEdge::first_i, j);
    if (i == last_) return at(PatchEdge::last_i, j);
    if (j == 0) return at(PatchEdge::first_j, i);
    if (j == last_) return at(PatchEdge::last_j, i);
    return inner_[i * (last_ + 1) + j];
  }

  const RingSurface& surface_;
  std::size_t last_;
  std::vector<std::array<double, 4>> weights_;
  std::unordered_map<std::size_t, const RingJoint*> joints_;
  std::unordered_map<Point3, int, PointHash> places_;
  std::vector<int> inner_;
  std::vector<long long> corners_;
  GroupedMesh mesh_;
};

void append_coordinates(std::string& text, const Point3& point) {
  for (std::size_t d = 0; d < point.size(); ++d) {
    if (d > 0) text += ' ';
    append_number(text, point[d]);
  }
}

void write_vertex(OutputFile& file, std::string& text, const Point3& point) {
  text = "v ";
  append_coordinates(text, point);
  file.write(text += '\n');
}

/// visit(group, patch) for all patches in their order.
template <class Visit>
void for_each_patch(const RingSurface& surface, const Visit& visit) {
  for (std::size_t g = 0; g < surface.groups(); ++g) {
    for (std::size_t p = surface.begin[g]; p < surface.begin[g + 1]; ++p) visit(g, p);
  }
}

}  // namespace

GroupedMesh tessellated(const RingSurface& surface, int pieces) {
  const auto most = static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4;
  const auto squared = static_cast<std::size_t>(pieces) * static_cast<std::size_t>(pieces);
  if (surface.patches.size() > most / squared) {
    throw InputError(fmt::format("{} patches of {} x {} quads are more than can be numbered; take fewer",
                                 surface.patches.size(), pieces, pieces));
  }
  Tessellation tessellation(surface, pieces);
  for (std::size_t patch = 0; patch < surface.patches.size(); ++patch) tessellation.add(patch);
  GroupedMesh result = std::move(tessellation).take();
  for (const std::size_t first : surface.begin) result.begin.push_back(first * squared);
  return result;
}

std::string group_name(const RingSurface& surface, std::size_t group) {
  if (group == 0) return "regular";
  return group + 1 < surface.groups() ? fmt::format("ring_{}", group) : "cap";
}

void write_grouped_obj(OutputFile& file, const GroupedMesh& mesh, const RingSurface& surface) {
  std::string text;
  for (const Point3& point : mesh.points) write_vertex(file, text, point);
  for (std::size_t g = 0; g + 1 < mesh.begin.size(); ++g) {
    if (mesh.begin[g] == mesh.begin[g + 1]) continue;
    file.write("g " + group_name(surface, g) + "\n");
    for (std::size_t f = mesh.begin[g]; f < mesh.begin[g + 1]; ++f) {
      text = "f";
      for (const long long corner : mesh.faces.face(f)) text += fmt::format(" {}", corner + 1);
      file.write(text += '\n');
    }
  }
}

void write_control_obj(OutputFile& file, const RingSurface& surface) {
  std::string text;
  for (const BezierPatch<Point3>& patch : surface.patches) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 4; ++i) write_vertex(file, text, patch[4 * i + j]);
    }
  }
  file.write("cstype bezier\ndeg 3 3\n");
  for_each_patch(surface, [&](std::size_t group, std::size_t patch) {
    if (patch == surface.begin[group]) file.write("g " + group_name(surface, group) + "\n");
    text = "surf 0 1 0 1";
    for (std::size_t k = 1; k <= 16; ++k) text += fmt::format(" {}", 16 * patch + k);
    file.write(text += "\nparm u 0 1\nparm v 0 1\nend\n");
  });
}

void write_control_bv(OutputFile& file, const RingSurface& surface) {
  std::string text;
  for_each_patch(surface, [&](std::size_t group, std::size_t patch) {
    if (patch == surface.begin[group])
      file.write(fmt::format("Group {} {}\n", group, group_name(surface, group)));
    file.write("5\n3 3\n");
    for (const Point3& point : surface.patches[patch]) {
      text.clear();
      append_coordinates(text, point);
      file.write(text += '\n');
    }
  });
}

}  // namespace subdiv
