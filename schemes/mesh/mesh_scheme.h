#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "schemes/mesh/mesh_topology.h"
#include "schemes/mesh/stencil.h"

namespace subdiv {

/// How a step splits the faces.
enum class MeshSplit {
  quads,      ///< an n-gon into n quads: new points at vertices, edges and faces
  triangles,  ///< a triangle into four: new points at vertices and edges
};

/// A subdivision scheme for meshes of any connectivity: the split, and the stencil of each new point over the
/// old ones. A new scheme is its three rules; the traversal (schemes/evaluate/refine_mesh.h) and the
/// analysis (analysis/mesh/) are common to all.
template <class R>
struct MeshScheme {
  std::string name;                    ///< for messages and titles
  MeshSplit split = MeshSplit::quads;  ///< which faces it makes
  /// In regular regions the descendants of a face depend on the corners of the faces up to `reach` rings
  /// around it (1: the face and those that share a corner with it): 1 for cubic splines, 2 for J_s.
  int reach = 1;
  /// With irregular vertices about: descendants of a face depend on nothing beyond `sight` rings of faces, on
  /// the connectivity there included, and descendants of those rings' own points within `sight` rings of the
  /// descendants neither (so that a neighbourhood refines to a neighbourhood). At least reach.
  int sight = 1;
  /// How the border continues outwards, for rules that rely on layers of faces beyond it
  /// (schemes/mesh/border_layers.h adds them): layer k + 1 has the points w_0 P_0 + w_1 P_1 + w_2 P_2 with
  /// w = border_rules[k], P_0 on the border and P_1, P_2 on the line inwards. None when the rules treat the
  /// border themselves.
  std::vector<std::array<R, 3>> border_rules;
  std::function<Stencil<R>(const MeshTopology&, int vertex)> vertex_rule;   ///< the new place of a vertex
  std::function<Stencil<R>(const MeshTopology&, int half_edge)> edge_rule;  ///< the new point on an edge
  std::function<Stencil<R>(const MeshTopology&, int face)> face_rule;       ///< none for triangles
};

}  // namespace subdiv
