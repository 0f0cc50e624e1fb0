#pragma once

#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// The centroid of a face.
template <class R>
Stencil<R> face_centroid(const MeshTopology& mesh, int face) {
  Stencil<R> result;
  const R share = fraction<R>(1, mesh.degree(face));
  for (int i = 0; i < mesh.degree(face); ++i) result.add(mesh.origin(mesh.first(face) + i), share);
  return result;
}

template <class R>
Stencil<R> edge_midpoint(const MeshTopology& mesh, int half_edge) {
  Stencil<R> result;
  result.add(mesh.origin(half_edge), fraction<R>(1, 2));
  result.add(mesh.target(half_edge), fraction<R>(1, 2));
  return result;
}

/// The cubic B-spline rule of the border curve, (1, 6, 1)/8; a vertex of a single face is a corner and stays.
template <class R>
Stencil<R> cubic_border_vertex(const MeshTopology& mesh, int vertex) {
  if (mesh.outgoing(vertex) < 0 || mesh.face_count(vertex) == 1) return Stencil<R>(vertex);
  const std::vector<int> around = neighbours(mesh, vertex);
  Stencil<R> result;
  result.add(vertex, fraction<R>(3, 4));
  result.add(around.front(), fraction<R>(1, 8));
  result.add(around.back(), fraction<R>(1, 8));
  return result;
}

/// Catmull-Clark (Catmull, Clark: Recursively generated B-spline surfaces on arbitrary topological meshes,
/// 1978) on faces of any degree. Face points: centroids. Edge points: the mean of the ends and the two face
/// points. Vertices of valence n: (F + 2 E + (n - 3) V)/n, F the mean of the face points and E of the edges'
/// midpoints; among quads that is V (1 - 7/(4n)) and 3/2 and 1/4 of the neighbours' means over n. Borders are
/// cubic B-splines.
template <class R>
MeshScheme<R> catmull_clark() {
  MeshScheme<R> scheme;
  scheme.name = "catmull-clark";
  scheme.split = MeshSplit::quads;
  scheme.reach = 1;
  scheme.face_rule = face_centroid<R>;
  scheme.edge_rule = [](const MeshTopology& mesh, int h) {
    Stencil<R> result = edge_midpoint<R>(mesh, h);
    if (mesh.opposite(h) < 0) return result;
    const R quarter = fraction<R>(1, 4);
    Stencil<R> inner;
    inner.add(result, fraction<R>(1, 2));
    inner.add(face_centroid<R>(mesh, mesh.face(h)), quarter);
    inner.add(face_centroid<R>(mesh, mesh.face(mesh.opposite(h))), quarter);
    return inner;
  };
  scheme.vertex_rule = [](const MeshTopology& mesh, int v) {
    if (mesh.is_border(v)) return cubic_border_vertex<R>(mesh, v);
    const int n = mesh.valence(v);
    const R share = fraction<R>(1, n) * fraction<R>(1, n);
    Stencil<R> result;
    result.add(v, fraction<R>(n - 3, n));
    for_each_outgoing(mesh, v, [&](int h) {
      result.add(face_centroid<R>(mesh, mesh.face(h)), share);
      result.add(edge_midpoint<R>(mesh, h), R(2) * share);
    });
    return result;
  };
  return scheme;
}

}  // namespace subdiv
