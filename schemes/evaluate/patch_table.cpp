#include "schemes/evaluate/patch_table.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include "schemes/evaluate/refine_mesh.h"
#include "schemes/mesh/straight_walk.h"

namespace subdiv {
namespace {

/// The half-edges of the cells of the patch that `steps` splits make of face 0, row by row: half-edge 0 stays
/// the first, since every split numbers the child at a corner first.
std::vector<int> patch_cells(const MeshTopology& mesh, int steps) {
  std::vector<int> cells;
  int left = 0;
  for (int j = 0; j < steps; ++j) {
    int h = left;
    for (int i = 0; i < (mesh.sides() == 4 ? steps : steps - j); ++i) {
      cells.push_back(h);
      if (i + 1 < (mesh.sides() == 4 ? steps : steps - j)) h = cell_to_the_right(mesh, h);
    }
    if (j + 1 < steps) left = cell_above(mesh, left);
  }
  return cells;
}

/// Rows of weights over the control points, one a vertex.
using Rows = std::vector<std::vector<double>>;

std::vector<double> combined(const Stencil<double>& stencil, const Rows& rows) {
  std::vector<double> sum(rows.front().size(), 0.0);
  for (const auto& [vertex, weight] : stencil.terms()) {
    const auto& row = rows[static_cast<std::size_t>(vertex)];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * row[k];
  }
  return sum;
}

struct LocalMesh {
  MeshTopology topology;
  Rows rows;
};

/// One step, and then only the faces within `rings` of the patch.
LocalMesh refined(const LocalMesh& local, const MeshScheme<double>& scheme, int steps, int rings) {
  LocalMesh fine;
  const MeshTopology whole = split(local.topology, scheme.split);
  std::vector<char> wanted_face(static_cast<std::size_t>(whole.faces()), 0);
  std::vector<char> wanted_vertex(static_cast<std::size_t>(whole.vertices()), 0);
  std::vector<int> faces;
  const auto want = [&](int face) {
    if (std::exchange(wanted_face[static_cast<std::size_t>(face)], 1) == 0) faces.push_back(face);
  };
  want(0);
  for (const int h : patch_cells(whole, steps)) {
    want(whole.face(h));
    if (whole.sides() == 3 && whole.opposite(whole.next(h)) >= 0)
      want(whole.face(whole.opposite(whole.next(h))));
  }
  std::vector<int> vertices;
  for (std::size_t begin = 0, ring = 0; ring <= static_cast<std::size_t>(rings); ++ring) {
    const std::size_t first_new = vertices.size();
    for (; begin < faces.size(); ++begin) {
      for (int c = 0; c < whole.sides(); ++c) {
        const int v = whole.origin(whole.first(faces[begin]) + c);
        if (std::exchange(wanted_vertex[static_cast<std::size_t>(v)], 1) == 0) vertices.push_back(v);
      }
    }
    if (ring == static_cast<std::size_t>(rings)) break;
    for (std::size_t i = first_new; i < vertices.size(); ++i)
      for_each_outgoing(whole, vertices[i], [&](int h) { want(whole.face(h)); });
  }
  std::vector<int> entries;
  for (const int f : faces) entries.push_back(whole.first(f));
  fine.topology = part_of(whole, entries, vertices);

  for (const int number : vertices)
    fine.rows.push_back(combined(stencil_of(local.topology, scheme, number), local.rows));
  return fine;
}

/// A torus of n x n quads, or of twice as many triangles: regular, and wider than any rule sees.
MeshTopology regular_torus(int sides, int n) {
  PolygonFaces faces;
  faces.vertices = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  const auto at = [n](int i, int j) -> long long { return (i % n) * n + j % n; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (sides == 4) {
        faces.add_face(std::array<long long, 4>{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      } else {
        faces.add_face(std::array<long long, 3>{at(i, j), at(i + 1, j), at(i, j + 1)});
        faces.add_face(std::array<long long, 3>{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return MeshTopology(faces);
}

}  // namespace

RegularPatch::RegularPatch(const MeshScheme<double>& scheme, const PatchGrid& grid,
                           const FinalRule& final_rule) {
  const MeshTopology torus = regular_torus(grid.sides, 2 * scheme.sight + 4);
  NeighbourhoodFinder finder(torus);
  Neighbourhood neighbourhood;
  finder.find(0, scheme.sight, neighbourhood);
  table_ = patch_table(torus, neighbourhood, scheme, grid, final_rule);
  steps_ = finder.steps();
  const auto& corners = finder.vertex_corners();
  inner_.assign(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(finder.inner_vertices()));
  for (const int k : table_.controls) controls_.push_back(corners[static_cast<std::size_t>(k)]);
}

bool RegularPatch::add_controls(const MeshTopology& mesh, const std::vector<char>& regular, int face,
                                std::vector<int>& controls) {
  const int sides = mesh.sides();
  const auto half_edge = [&](const NeighbourhoodCorner& place) {
    const int entry = entries_[place.face];
    const int first = mesh.first(mesh.face(entry));
    const int corner = entry - first + place.corner;
    return first + (corner < sides ? corner : corner - sides);
  };
  const auto is_regular = [&](const NeighbourhoodCorner& place) {
    return regular[static_cast<std::size_t>(mesh.origin(half_edge(place)))] != 0;
  };
  entries_.assign(1, mesh.first(face));
  std::size_t checked = 0;
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    for (; checked < inner_.size() && inner_[checked].face < i; ++checked) {
      if (!is_regular(inner_[checked])) return false;
    }
    entries_.push_back(mesh.turn_left(half_edge(steps_[i])));
  }
  for (; checked < inner_.size(); ++checked) {
    if (!is_regular(inner_[checked])) return false;
  }
  for (const NeighbourhoodCorner& place : controls_) controls.push_back(mesh.origin(half_edge(place)));
  return true;
}

std::size_t PatchTable::lines() const { return (points + patch_line - 1) / patch_line; }

double PatchTable::weight(std::size_t k, std::size_t p) const {
  return weights[(p / patch_line * controls.size() + k) * patch_line + p % patch_line];
}

PatchTable patch_table(const MeshTopology& mesh, const Neighbourhood& neighbourhood,
                       const MeshScheme<double>& scheme, const PatchGrid& grid, const FinalRule& final_rule) {
  const std::size_t width = neighbourhood.vertices.size();
  LocalMesh local;
  local.topology = part_of(mesh, neighbourhood.entries, neighbourhood.vertices);
  local.rows.assign(width, std::vector<double>(width, 0.0));
  for (std::size_t k = 0; k < width; ++k) local.rows[k][k] = 1;
  for (int steps = 2; steps <= grid.steps; steps *= 2) local = refined(local, scheme, steps, scheme.sight);

  // The rows of the grid's points: origins of the cells' half-edges, and the far ends of the last ones.
  const int n = grid.steps;
  std::map<std::array<int, 2>, int> vertex_at;
  const std::vector<int> cells = patch_cells(local.topology, n);
  std::size_t next = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < (grid.sides == 4 ? n : n - j); ++i) {
      const int h = cells[next++];
      vertex_at[{i, j}] = local.topology.origin(h);
      vertex_at[{i + 1, j}] = local.topology.target(h);
      vertex_at[{i, j + 1}] = local.topology.origin(local.topology.previous(h));
      if (grid.sides == 4) vertex_at[{i + 1, j + 1}] = local.topology.target(local.topology.next(h));
    }
  }

  Rows rows;  // of the grid's points
  const auto rule = final_rule ? final_rule(local.topology) : nullptr;
  for (const auto& p : grid.points) {
    const int v = vertex_at.at(p);
    rows.push_back(rule ? combined(rule(v), local.rows) : local.rows[static_cast<std::size_t>(v)]);
  }

  PatchTable table;
  table.points = grid.size();
  for (std::size_t k = 0; k < width; ++k) {
    const bool used = std::any_of(rows.begin(), rows.end(), [k](const auto& row) { return row[k] != 0; });
    if (used) table.controls.push_back(static_cast<int>(k));
  }
  table.weights.assign(table.lines() * table.controls.size() * patch_line, 0.0);
  for (std::size_t p = 0; p < grid.size(); ++p) {
    for (std::size_t k = 0; k < table.controls.size(); ++k) {
      table.weights[(p / patch_line * table.controls.size() + k) * patch_line + p % patch_line] =
          rows[p][static_cast<std::size_t>(table.controls[k])];
    }
  }
  return table;
}

}  // namespace subdiv
