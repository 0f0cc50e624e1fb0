#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/mesh_scheme.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// The next level's connectivity.
[[nodiscard]] inline MeshTopology split(const MeshTopology& mesh, MeshSplit by) {
  return by == MeshSplit::quads ? split_into_quads(mesh) : split_into_triangles(mesh);
}

/// Do Catmull-Clark's rules take the place of the scheme's own on this mesh? Where a scheme for quads meets
/// other polygons, which it splits into quads once for all.
template <class R>
bool needs_catmull_clark(const MeshTopology& mesh, const MeshScheme<R>& scheme) {
  return scheme.split == MeshSplit::quads && mesh.sides() != 4;
}

/// The rules of a step on this mesh.
template <class R>
MeshScheme<R> rules_on(const MeshTopology& mesh, const MeshScheme<R>& scheme) {
  return needs_catmull_clark(mesh, scheme) ? catmull_clark<R>() : scheme;
}

/// One step, stencil by stencil: visit(number, stencil) for every vertex of split(mesh), in the order of the
/// numbers: old vertices, edges, faces.
template <class R, class Visit>
void for_each_stencil(const MeshTopology& mesh, const MeshScheme<R>& scheme, Visit&& visit) {
  const MeshScheme<R> rules = rules_on(mesh, scheme);
  int number = 0;
  for (int v = 0; v < mesh.vertices(); ++v) visit(number++, rules.vertex_rule(mesh, v));
  for (int e = 0; e < mesh.edges(); ++e) visit(number++, rules.edge_rule(mesh, mesh.half_edge(e)));
  if (rules.split != MeshSplit::quads) return;
  for (int f = 0; f < mesh.faces(); ++f) visit(number++, rules.face_rule(mesh, f));
}

/// The stencil of one vertex of split(mesh) by these very rules, without a copy of them.
template <class R>
Stencil<R> stencil_by(const MeshTopology& mesh, const MeshScheme<R>& rules, int number) {
  if (number < mesh.vertices()) return rules.vertex_rule(mesh, number);
  number -= mesh.vertices();
  if (number < mesh.edges()) return rules.edge_rule(mesh, mesh.half_edge(number));
  return rules.face_rule(mesh, number - mesh.edges());
}

/// One of the stencils of a step alone.
template <class R>
Stencil<R> stencil_of(const MeshTopology& mesh, const MeshScheme<R>& scheme, int number) {
  return needs_catmull_clark(mesh, scheme) ? stencil_by(mesh, catmull_clark<R>(), number)
                                           : stencil_by(mesh, scheme, number);
}

/// The combination of points (arrays of coordinates) that a stencil says.
template <class R, class T, std::size_t D>
std::array<T, D> combine(const Stencil<R>& stencil, const std::vector<std::array<T, D>>& points) {
  std::array<T, D> result;
  result.fill(T(0));
  for (const auto& [vertex, weight] : stencil.terms()) {
    const auto& point = points[static_cast<std::size_t>(vertex)];
    for (std::size_t d = 0; d < D; ++d) result[d] = result[d] + weight * point[d];
  }
  return result;
}

/// The points of split(mesh, scheme.split): one step of the scheme.
template <class R, class T, std::size_t D>
std::vector<std::array<T, D>> refined_points(const MeshTopology& mesh, const MeshScheme<R>& scheme,
                                             const std::vector<std::array<T, D>>& points) {
  std::vector<std::array<T, D>> result;
  result.reserve(static_cast<std::size_t>(mesh.vertices()) + static_cast<std::size_t>(mesh.edges()) +
                 static_cast<std::size_t>(mesh.faces()));
  for_each_stencil(mesh, scheme, [&](int /*number*/, const Stencil<R>& stencil) {
    result.push_back(combine(stencil, points));
  });
  return result;
}

}  // namespace subdiv
