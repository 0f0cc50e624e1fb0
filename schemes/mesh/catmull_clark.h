#pragma once

#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// result += factor times the centroid of a face.
template <class R>
void add_face_centroid(Stencil<R>& result, const MeshTopology& mesh, int face, const R& factor) {
  const R share = factor * ratio<R>(1, mesh.degree(face));
  for (int i = 0; i < mesh.degree(face); ++i) result.add(mesh.origin(mesh.first(face) + i), share);
}

/// The mean of an edge's ends.
template <class R>
Stencil<R> edge_midpoint(const MeshTopology& mesh, int half_edge) {
  Stencil<R> result;
  result.add(mesh.origin(half_edge), ratio<R>(1, 2));
  result.add(mesh.target(half_edge), ratio<R>(1, 2));
  return result;
}

/// The cubic B-spline rule of the border curve, (1, 6, 1)/8; a vertex of a single face is a corner and stays.
template <class R>
Stencil<R> cubic_border_vertex(const MeshTopology& mesh, int vertex) {
  if (mesh.outgoing(vertex) < 0 || mesh.face_count(vertex) == 1) return Stencil<R>(vertex);
  const std::vector<int> around = neighbours(mesh, vertex);
  Stencil<R> result;
  result.add(vertex, ratio<R>(3, 4));
  result.add(around.front(), ratio<R>(1, 8));
  result.add(around.back(), ratio<R>(1, 8));
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
  scheme.face_rule = [](const MeshTopology& mesh, int face) {
    Stencil<R> result;
    add_face_centroid(result, mesh, face, R(1));
    return result;
  };
  scheme.edge_rule = [](const MeshTopology& mesh, int h) {
    Stencil<R> result = edge_midpoint<R>(mesh, h);
    const int o = mesh.opposite(h);
    if (o < 0) return result;
    result.add(mesh.origin(h), ratio<R>(-1, 4));
    result.add(mesh.target(h), ratio<R>(-1, 4));
    add_face_centroid(result, mesh, mesh.face(h), ratio<R>(1, 4));
    add_face_centroid(result, mesh, mesh.face(o), ratio<R>(1, 4));
    return result;
  };
  scheme.vertex_rule = [](const MeshTopology& mesh, int v) {
    if (mesh.is_border(v)) return cubic_border_vertex<R>(mesh, v);
    const long n = mesh.valence(v);
    Stencil<R> result;
    result.add(v, ratio<R>(n - 2, n));
    for_each_outgoing(mesh, v, [&](int h) {
      result.add(mesh.target(h), ratio<R>(1, n * n));
      add_face_centroid(result, mesh, mesh.face(h), ratio<R>(1, n * n));
    });
    return result;
  };
  return scheme;
}

}  // namespace subdiv
