#pragma once

#include <functional>
#include <string>

#include "schemes/mesh/mesh_topology.h"
#include "schemes/mesh/stencil.h"

namespace subdiv {

/// How a step splits the faces.
enum class MeshSplit {
  quads,      // an n-gon into n quads: new points at vertices, edges and faces
  triangles,  // a triangle into four: new points at vertices and edges
};

/// A subdivision scheme for meshes of any connectivity: the split, and the stencil of each new point over the
/// old ones. A new scheme is its three rules; the traversal (schemes/evaluate/refine_mesh.h) and the
/// analysis (analysis/mesh/) are common to all.
template <class R>
struct MeshScheme {
  std::string name;
  MeshSplit split = MeshSplit::quads;
  /// In regular regions the descendants of a face depend on the corners of the faces up to `reach` rings
  /// around it (1: the face and those that share a corner with it): 1 for cubic splines, 2 for J_s.
  int reach = 1;
  /// The layers of added faces beyond a border on which the rules rely: 0 when they treat the border
  /// themselves (schemes/mesh/border_layers.h adds them).
  int border_layers = 0;
  std::function<Stencil<R>(const MeshTopology&, int vertex)> vertex_rule;
  std::function<Stencil<R>(const MeshTopology&, int half_edge)> edge_rule;
  std::function<Stencil<R>(const MeshTopology&, int face)> face_rule;  // none for triangles
};

}  // namespace subdiv
