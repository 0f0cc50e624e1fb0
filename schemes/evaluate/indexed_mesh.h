#pragma once

#include <cstddef>
#include <vector>

#include "schemes/evaluate/fresh_memory.h"
#include "schemes/evaluate/mesh_refinement.h"
#include "schemes/mesh/mesh_scheme.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// Points and faces of one number of corners, ready to be written or drawn: face f has the corners
/// corners[sides f] .. corners[sides f + sides - 1], counter-clockwise.
struct IndexedMesh {
  int sides = 4;               ///< of every face
  FreshVector<Point3> points;  ///< the vertices
  /// Of each point a unit vector, or 0 where there is none; empty when normals were not asked for.
  FreshVector<Point3> normals;
  FreshVector<int> corners;  ///< vertices, from 0

  [[nodiscard]] std::size_t faces() const { return corners.size() / static_cast<std::size_t>(sides); }
};

/// The control points after some levels of a scheme, the final rule applied to the last one's. Vertices keep
/// their numbers through all levels. No levels only where all faces are triangles, or quads
/// (std::invalid_argument). Throws InputError for a scheme of triangles on a mesh with other faces (naming
/// the first), and for more vertices or half-edges than an int counts.
[[nodiscard]] IndexedMesh refine_mesh(const MeshTopology& mesh, const std::vector<Point3>& points,
                                      const MeshScheme<double>& scheme, int levels, int threads = 1,
                                      const FinalRule& final_rule = {});

}  // namespace subdiv
