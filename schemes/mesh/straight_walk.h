#pragma once

#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

// Walking over a mesh as over a grid of quads, or of triangles in pairs: cell (a, b) is the quad, or the
// triangle, with the half-edge from grid point (a, b) to (a + 1, b). Through irregular vertices the walk goes
// on all the same: the callers see to it that the grid has none inside.

/// The half-edge of cell (a + 1, b), given that of cell (a, b); -1 past the border.
inline int cell_to_the_right(const MeshTopology& mesh, int h) {
  const int across = mesh.opposite(mesh.next(h));
  if (mesh.sides() == 4 || across < 0) return across < 0 ? -1 : mesh.next(across);
  const int beyond = mesh.opposite(mesh.next(across));
  return beyond < 0 ? -1 : mesh.next(beyond);
}

/// The half-edge of cell (a, b + 1), given that of cell (a, b); -1 past the border.
inline int cell_above(const MeshTopology& mesh, int h) {
  const int side = mesh.sides() == 4 ? mesh.next(h) : mesh.opposite(mesh.next(h));
  if (side < 0) return -1;
  return mesh.opposite(mesh.sides() == 4 ? mesh.next(side) : mesh.previous(side));
}

}  // namespace subdiv
