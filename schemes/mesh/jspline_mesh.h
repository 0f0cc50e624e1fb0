#pragma once

#include <array>
#include <vector>

#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// The weights of Kobbelt's construction carried over to J_s: the odd rule (b, a, a, b), a = (9 - s)/16,
/// b = (s - 1)/16, and the weight g = -b/a = (1 - s)/(9 - s) of the diagonal points in the virtual point at
/// an irregular vertex: with it, and with no other, face points computed in either direction agree. Kobbelt
/// (Interpolatory subdivision on open quadrilateral nets with arbitrary topology, 1996): s = 0, g = 1/9.
template <class R>
struct OddRule {
  /// For s != 9, where the denominator of g vanishes.
  explicit OddRule(const R& s)
      : inner((R(9) - s) * ratio<R>(1, 16)),
        outer((s - R(1)) * ratio<R>(1, 16)),
        diagonal((R(1) - s) / (R(9) - s)) {}
  R inner;     ///< a
  R outer;     ///< b
  R diagonal;  ///< g
};

/// The point that continues the line from a neighbour to the border vertex p, one step beyond p: along a
/// border the next border vertex; where the border turns (a vertex of one face, or of three and more) or the
/// line crosses it, the mirror image 2 p - neighbour.
template <class R>
Stencil<R> border_beyond(const MeshTopology& mesh, int p, int neighbour) {
  if (mesh.face_count(p) == 2) {
    const std::vector<int> around = neighbours(mesh, p);
    if (neighbour == around.front()) return Stencil<R>(around.back());
    if (neighbour == around.back()) return Stencil<R>(around.front());
  }
  Stencil<R> result;
  result.add(p, R(2));
  result.add(neighbour, R(-1));
  return result;
}

/// The point that continues the line from the target of h through its origin p, one step beyond p. At valence
/// 4 it is the vertex opposite. Else, with l_i and k_i the edge and diagonal neighbours of p, k_i between l_i
/// and l_{i+1}, and h leading to l_i, it is virtual:
///   (4/n) sum l - (l_{i-1} + l_i + l_{i+1}) + g (k_{i-2} + k_{i-1} + k_i + k_{i+1} - (4/n) sum k).
/// At the border it is border_beyond. Quads only.
template <class R>
Stencil<R> point_beyond(const MeshTopology& mesh, int h, const R& g) {
  const int p = mesh.origin(h);
  if (mesh.is_border(p)) return border_beyond<R>(mesh, p, mesh.target(h));
  Stencil<R> result;
  const int n = mesh.valence(p);
  if (n == 4) return Stencil<R>(mesh.target(mesh.turn_left(mesh.turn_left(h))));
  const R share = ratio<R>(4, n);
  const R diagonal_share = R(0) - share * g;
  int spoke = h;
  for (int j = 0; j < n; ++j, spoke = mesh.turn_left(spoke)) {
    const int diagonal = mesh.target(mesh.next(spoke));
    result.add(mesh.target(spoke), share);
    result.add(diagonal, diagonal_share);
    // In this order j counts from l_i and k_i; modulo n. At valence 3 k_{i-2} is k_{i+1}: both count.
    for (const int i : {0, 1, n - 1}) {
      if (j == i) result.add(mesh.target(spoke), R(-1));
    }
    for (const int i : {0, 1, n - 1, n - 2}) {
      if (j == i) result.add(diagonal, g);
    }
  }
  return result;
}

/// The odd rule along the edge of h.
template <class R>
Stencil<R> odd_point(const MeshTopology& mesh, int h, const OddRule<R>& rule) {
  const int o = mesh.opposite(h);
  Stencil<R> result;
  result.add(mesh.origin(h), rule.inner);
  result.add(mesh.target(h), rule.inner);
  result.add(point_beyond(mesh, h, rule.diagonal), rule.outer);
  result.add(
      o < 0 ? border_beyond<R>(mesh, mesh.target(h), mesh.origin(h)) : point_beyond(mesh, o, rule.diagonal),
      rule.outer);
  return result;
}

/// The edge of the same quad opposite to that of h.
inline int across(const MeshTopology& mesh, int h) { return mesh.next(mesh.next(h)); }

/// The odd rule across the odd points of parallel edges, in both directions, averaged: a tensor product at
/// regular vertices; near irregular ones the two may differ, and eigenvalues do not change by the average.
template <class R>
Stencil<R> odd_face_point(const MeshTopology& mesh, int face, const OddRule<R>& rule) {
  const R half = ratio<R>(1, 2);
  Stencil<R> result;
  const auto add_side = [&](int h) {  // an edge, and the parallel one in the face beyond
    const Stencil<R> edge = odd_point(mesh, h, rule);
    result.add(edge, half * rule.inner);
    const int o = mesh.opposite(h);
    if (o >= 0) {
      result.add(odd_point(mesh, across(mesh, o), rule), half * rule.outer);
    } else {
      result.add(edge, rule.outer);
      result.add(odd_point(mesh, across(mesh, h), rule), R(0) - half * rule.outer);
    }
  };
  for (int i = 0; i < mesh.degree(face); ++i) add_side(mesh.first(face) + i);
  return result;
}

/// How J_s continues beyond a border (MeshScheme::border_rules): the clamped ends of curves (J-splines,
/// section 9), line by line.
template <class R>
std::vector<std::array<R, 3>> clamped_border_rules(const R& s) {
  const R half = ratio<R>(1, 2);
  return {{(R(9) - s) * half * half, (s - R(3)) * half, (R(1) - s) * half * half},
          {(R(12) - s) * half, s - R(8), (R(6) - s) * half}};
}

/// The directional extension of J_s to quad meshes: exactly J_s x J_s in regular regions, Catmull-Clark at
/// s = 1, Kobbelt at s = 0 (Rossignac, Schaefer: J-splines, section 10, announces such a scheme; its formula,
/// linear in s, is jspline_mesh_literal). Edges: the odd point E along the edge, moved by the even rule
/// across: E + (s/8)(E_left - 2 E + E_right). Faces: odd_face_point. Vertices of valence n:
///   V + (4/n) (((1 - s/4)^2 - 1) V + (s/2)(1 - s/4) A + (s^2/16) B),
/// A and B the means of the edge and of the diagonal neighbours. Borders: two layers of faces are added
/// beyond them. s = 9 is excluded (the virtual points have a pole: RingTraits' division by zero).
template <class R>
MeshScheme<R> jspline_mesh(const R& s) {
  const OddRule<R> rule(s);
  const R eighth = s * ratio<R>(1, 8);
  MeshScheme<R> scheme;
  scheme.name = "jspline-mesh";
  scheme.split = MeshSplit::quads;
  scheme.reach = 2;
  scheme.sight = 4;
  scheme.border_rules = clamped_border_rules(s);
  scheme.face_rule = [rule](const MeshTopology& mesh, int f) { return odd_face_point(mesh, f, rule); };
  scheme.edge_rule = [rule, eighth](const MeshTopology& mesh, int h) {
    Stencil<R> result = odd_point(mesh, h, rule);
    const int o = mesh.opposite(h);
    if (o < 0 || is_zero(eighth)) return result;
    Stencil<R> moved;
    moved.add(result, R(1) - R(2) * eighth);
    moved.add(odd_point(mesh, across(mesh, h), rule), eighth);
    moved.add(odd_point(mesh, across(mesh, o), rule), eighth);
    return moved;
  };
  const R centre = R(1) - R(2) * eighth;
  scheme.vertex_rule = [centre, eighth](const MeshTopology& mesh, int v) {
    Stencil<R> result(v);
    if (mesh.outgoing(v) < 0 || is_zero(eighth)) return result;
    if (mesh.is_border(v)) {  // the even rule along the border; a corner stays
      if (mesh.face_count(v) == 1) return result;
      const std::vector<int> around = neighbours(mesh, v);
      result.add(v, R(-2) * eighth);
      result.add(around.front(), eighth);
      result.add(around.back(), eighth);
      return result;
    }
    const int n = mesh.valence(v);
    const R share = ratio<R>(4, n);
    result.add(v, share * (centre * centre - R(1)));
    const R edge = ratio<R>(16, static_cast<long>(n) * n) * eighth * centre;
    const R diagonal = ratio<R>(16, static_cast<long>(n) * n) * eighth * eighth;
    for_each_outgoing(mesh, v, [&](int h) {
      result.add(mesh.target(h), edge);
      result.add(mesh.target(mesh.next(h)), diagonal);
    });
    return result;
  };
  return scheme;
}

/// Kobbelt's interpolating scheme (1996), with the virtual points' weight 1/9.
template <class R>
MeshScheme<R> kobbelt() {
  MeshScheme<R> scheme = jspline_mesh(R(0));
  scheme.name = "kobbelt";
  return scheme;
}

/// The formula of J-splines, section 10, with its two operands put right: (1 - s) Kobbelt + s Catmull-Clark.
/// In regular regions it is J_s x J_s only for s = 0 and s = 1.
template <class R>
MeshScheme<R> jspline_mesh_literal(const R& s) {
  MeshScheme<R> scheme = jspline_mesh(R(0));
  scheme.name = "jspline-mesh-literal";
  scheme.border_rules = clamped_border_rules(s);
  const auto blend = [s](const auto& interpolating, const auto& spline) {
    return [s, interpolating, spline](const MeshTopology& mesh, int element) {
      Stencil<R> result;
      result.add(interpolating(mesh, element), R(1) - s);
      result.add(spline(mesh, element), s);
      return result;
    };
  };
  const MeshScheme<R> spline = catmull_clark<R>();
  scheme.vertex_rule = blend(scheme.vertex_rule, spline.vertex_rule);
  scheme.edge_rule = blend(scheme.edge_rule, spline.edge_rule);
  scheme.face_rule = blend(scheme.face_rule, spline.face_rule);
  return scheme;
}

}  // namespace subdiv
