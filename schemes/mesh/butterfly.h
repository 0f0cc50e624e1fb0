#pragma once

#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// The butterfly scheme (Dyn, Levin, Gregory: A butterfly subdivision scheme for surface interpolation with
/// tension control, 1990; notes 5): vertices stay; a new point on an edge is 1/2 of each end, 1/8 of each of
/// the two opposite vertices, -1/16 of each of the four wings beyond. The same eight places at any valence.
/// At the border the edges follow the four-point scheme; a wing that the mesh lacks is the mirror image of
/// the vertex opposite to it: a + b - c for the edge (a, b) of the triangle (a, b, c).
template <class R>
MeshScheme<R> butterfly() {
  MeshScheme<R> scheme;
  scheme.name = "butterfly";
  scheme.split = MeshSplit::triangles;
  scheme.reach = 2;
  scheme.sight = 2;
  scheme.vertex_rule = [](const MeshTopology& /*mesh*/, int v) { return Stencil<R>(v); };
  scheme.edge_rule = [](const MeshTopology& mesh, int h) {
    Stencil<R> result;
    const R wing = ratio<R>(-1, 16);
    if (mesh.opposite(h) < 0) {
      result.add(mesh.origin(h), ratio<R>(9, 16));
      result.add(mesh.target(h), ratio<R>(9, 16));
      // The border runs on with the border edge that leaves the target, and comes in at the origin. A corner
      // (a vertex of one face) ends it: there the point beyond is the mirror image.
      const auto beyond = [&](int corner, int inner, int neighbour) {
        if (mesh.face_count(corner) > 1) {
          result.add(neighbour, wing);
        } else {
          result.add(corner, R(2) * wing);
          result.add(inner, R(0) - wing);
        }
      };
      beyond(mesh.target(h), mesh.origin(h), neighbours(mesh, mesh.target(h)).front());
      beyond(mesh.origin(h), mesh.target(h), neighbours(mesh, mesh.origin(h)).back());
      return result;
    }
    result.add(mesh.origin(h), ratio<R>(1, 2));
    result.add(mesh.target(h), ratio<R>(1, 2));
    for (const int side : {h, mesh.opposite(h)}) {
      result.add(mesh.origin(mesh.previous(side)), ratio<R>(1, 8));
      for (const int leg : {mesh.next(side), mesh.previous(side)}) {
        const int o = mesh.opposite(leg);
        if (o >= 0) {
          result.add(mesh.origin(mesh.previous(o)), wing);
        } else {
          result.add(mesh.origin(leg), wing);
          result.add(mesh.target(leg), wing);
          result.add(mesh.origin(mesh.previous(leg)), R(0) - wing);
        }
      }
    }
    return result;
  };
  return scheme;
}

}  // namespace subdiv
