#pragma once

#include <vector>

#include "schemes/evaluate/indexed_mesh.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// Where the vertices of some level tend to, and the unit normals of the limit surface there (0 at vertices
/// without tangent plane, and at borders), joined by that level's faces. Throws as refine_mesh and
/// limit_stencil do.
[[nodiscard]] IndexedMesh limit_mesh(const MeshTopology& mesh, const std::vector<Point3>& points,
                                     const MeshScheme<double>& scheme, int levels, int threads = 1);

}  // namespace subdiv
