#pragma once

#include "schemes/algebra/turn.h"
#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

namespace detail {

/// Loop's rules but for the weight w(n) of all n neighbours together at a vertex of valence n.
template <class R, class Weight>
MeshScheme<R> loop_with_weight(const char* name, const Weight& weight) {
  MeshScheme<R> scheme;
  scheme.name = name;
  scheme.split = MeshSplit::triangles;
  scheme.reach = 1;
  scheme.edge_rule = [](const MeshTopology& mesh, int h) {
    const int o = mesh.opposite(h);
    if (o < 0) return edge_midpoint<R>(mesh, h);
    Stencil<R> result;
    result.add(mesh.origin(h), ratio<R>(3, 8));
    result.add(mesh.target(h), ratio<R>(3, 8));
    result.add(mesh.origin(mesh.previous(h)), ratio<R>(1, 8));
    result.add(mesh.origin(mesh.previous(o)), ratio<R>(1, 8));
    return result;
  };
  scheme.vertex_rule = [weight](const MeshTopology& mesh, int v) {
    if (mesh.is_border(v)) return cubic_border_vertex<R>(mesh, v);
    const int n = mesh.valence(v);
    const R all = weight(n);
    Stencil<R> result;
    result.add(v, R(1) - all);
    for_each_outgoing(mesh, v, [&](int h) { result.add(mesh.target(h), all * ratio<R>(1, n)); });
    return result;
  };
  return scheme;
}

}  // namespace detail

/// Loop's scheme with Warren's weights (Warren 1995; notes 4): edges 3/8, 3/8, 1/8, 1/8; a vertex of valence
/// n keeps 5/8, its neighbours share 3/8; at valence 3 they get 3/16 each. Borders are cubic B-splines.
template <class R>
MeshScheme<R> loop() {
  return detail::loop_with_weight<R>("loop", [](int n) { return n == 3 ? ratio<R>(9, 16) : ratio<R>(3, 8); });
}

/// The same without the exception at valence 3.
template <class R>
MeshScheme<R> loop_without_exception() {
  return detail::loop_with_weight<R>("loop-without-exception", [](int /*n*/) { return ratio<R>(3, 8); });
}

/// Loop's own weights (Loop: Smooth subdivision surfaces based on triangles, 1987): the neighbours share
/// 5/8 - (3/8 + cos(2 pi/n)/4)^2. cosine(n) is cos(2 pi/n): a value, or an indeterminate that stands for it.
template <class R, class Cosine>
MeshScheme<R> loop_1987(const Cosine& cosine) {
  return detail::loop_with_weight<R>("loop-1987", [cosine](int n) {
    const R root = ratio<R>(3, 8) + ratio<R>(1, 4) * cosine(n);
    return ratio<R>(5, 8) - root * root;
  });
}

/// Loop's scheme with the weights of his thesis.
template <class R>
MeshScheme<R> loop_1987() {
  return loop_1987<R>([](int n) { return cosine_of_turn<R>(1, n); });
}

}  // namespace subdiv
