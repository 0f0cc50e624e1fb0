#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/mesh_scheme.h"
#include "schemes/mesh/mesh_topology.h"
#include "schemes/mesh/stencil.h"

namespace subdiv {

/// A mesh of quads continued beyond its border. Faces and half-edges of the mesh keep their numbers, as do
/// its vertices; the added vertices follow, each with its stencil over the mesh's vertices.
template <class R>
struct BorderLayers {
  MeshTopology mesh;              ///< continued
  std::vector<Stencil<R>> added;  ///< stencils of the added vertices
};

namespace detail {

/// P_0, P_1, P_2 of a border vertex with two faces or more: itself, the mean of its inner neighbours, the
/// mean of the vertices beyond those (the mirror image where the mesh ends there or goes on irregularly).
template <class R>
std::array<Stencil<R>, 3> line_inwards(const MeshTopology& mesh, int v) {
  std::array<Stencil<R>, 3> line{Stencil<R>(v), {}, {}};
  const int inner = mesh.face_count(v) - 1;
  const R share = ratio<R>(1, inner);
  for_each_outgoing(mesh, v, [&](int h) {
    if (mesh.opposite(h) < 0) return;
    const int next = mesh.target(h);
    line[1].add(next, share);
    if (!mesh.is_border(next) && mesh.valence(next) == 4) {
      const int back = mesh.opposite(h);
      line[2].add(mesh.target(mesh.turn_left(mesh.turn_left(back))), share);
    } else {
      line[2].add(next, R(2) * share);
      line[2].add(v, R(0) - share);
    }
  });
  return line;
}

template <class R>
Stencil<R> continued(const std::array<Stencil<R>, 3>& line, const std::array<R, 3>& rule) {
  Stencil<R> result;
  for (std::size_t i = 0; i < 3; ++i) result.add(line[i], rule[i]);
  return result;
}

}  // namespace detail

/// As many layers of quads beyond the border as there are rules (MeshScheme::border_rules). At a vertex of
/// one face, a corner, the continuation is the tensor product of both directions; elsewhere lines of points
/// leave the border vertices. Where the border turns inwards (three faces and more at a vertex), the one line
/// continues the mean of the inner edges. Quads only.
template <class R>
BorderLayers<R> border_layers(const MeshTopology& mesh, const std::vector<std::array<R, 3>>& rules) {
  const auto layers = static_cast<int>(rules.size());
  BorderLayers<R> result;
  PolygonFaces faces;
  for (int f = 0; f < mesh.faces(); ++f) {
    std::vector<long long> corners;
    for (int c = 0; c < mesh.degree(f); ++c) corners.push_back(mesh.origin(mesh.first(f) + c));
    faces.add_face(corners);
  }
  const auto add = [&](const Stencil<R>& stencil) {
    result.added.push_back(stencil);
    return mesh.vertices() + static_cast<int>(result.added.size()) - 1;
  };
  const auto stencil_of = [&](int v) {
    return v < mesh.vertices() ? Stencil<R>(v) : result.added[static_cast<std::size_t>(v - mesh.vertices())];
  };
  // The points beyond each border vertex, nearest first: beside the border edge that leaves it (out), and the
  // one that comes in. The same line but at corners.
  std::map<int, std::vector<int>> out;
  std::map<int, std::vector<int>> in;
  for (int v = 0; v < mesh.vertices(); ++v) {
    const int leaving = mesh.outgoing(v);
    if (leaving < 0 || !mesh.is_border(v)) continue;
    if (mesh.face_count(v) > 1) {
      const auto line = detail::line_inwards<R>(mesh, v);
      for (const auto& rule : rules) out[v].push_back(add(detail::continued(line, rule)));
      in[v] = out[v];
      continue;
    }
    const int ahead = mesh.target(leaving);
    const int behind = mesh.origin(mesh.previous(leaving));
    const std::array<Stencil<R>, 3> backwards{Stencil<R>(v), Stencil<R>(ahead),
                                              border_beyond<R>(mesh, ahead, v)};
    const std::array<Stencil<R>, 3> onwards{Stencil<R>(v), Stencil<R>(behind),
                                            border_beyond<R>(mesh, behind, v)};
    for (const auto& rule : rules) {
      in[v].push_back(add(detail::continued(backwards, rule)));
      out[v].push_back(add(detail::continued(onwards, rule)));
    }
  }
  // Corners: column k beside the incoming border, continued past the corner.
  std::map<int, std::vector<std::vector<int>>> corner;
  for (const auto& [v, beside] : in) {
    if (mesh.face_count(v) > 1) continue;
    const int behind = mesh.origin(mesh.previous(mesh.outgoing(v)));
    for (std::size_t k = 0; k < rules.size(); ++k) {
      // The same line one column out; at the far end of a single face its mirror image.
      std::array<Stencil<R>, 3> line{stencil_of(beside[k]), stencil_of(out.at(behind)[k]), {}};
      if (mesh.face_count(behind) == 2) {
        line[2] = stencil_of(out.at(neighbours(mesh, behind).back())[k]);
      } else {
        line[2].add(line[1], R(2));
        line[2].add(line[0], R(-1));
      }
      corner[v].emplace_back();
      for (const auto& rule : rules) corner[v].back().push_back(add(detail::continued(line, rule)));
    }
  }
  for (int h = 0; h < mesh.half_edges(); ++h) {
    if (mesh.opposite(h) >= 0) continue;
    const int u = mesh.origin(h);
    const int w = mesh.target(h);
    for (int k = 0; k < layers; ++k) {
      const auto at = static_cast<std::size_t>(k);
      faces.add_face(std::array<long long, 4>{k == 0 ? w : in.at(w)[at - 1], k == 0 ? u : out.at(u)[at - 1],
                                              out.at(u)[at], in.at(w)[at]});
    }
  }
  for (const auto& [v, grid] : corner) {
    const auto point = [&, v = v](int k, int l) -> long long {
      if (k == 0 && l == 0) return v;
      if (l == 0) return in.at(v)[static_cast<std::size_t>(k - 1)];
      if (k == 0) return out.at(v)[static_cast<std::size_t>(l - 1)];
      return corner.at(v)[static_cast<std::size_t>(k - 1)][static_cast<std::size_t>(l - 1)];
    };
    for (int k = 1; k <= layers; ++k) {
      for (int l = 1; l <= layers; ++l)
        faces.add_face(
            std::array<long long, 4>{point(k - 1, l - 1), point(k, l - 1), point(k, l), point(k - 1, l)});
    }
  }
  faces.vertices = static_cast<std::size_t>(mesh.vertices()) + result.added.size();
  result.mesh = MeshTopology(faces);
  return result;
}

}  // namespace subdiv
