#pragma once

#include <cstddef>
#include <vector>

#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// The faces up to some rings around a face, and their vertices, in an order that depends on nothing but how
/// they hang together: equal signatures mean neighbourhoods that map onto each other, vertex by vertex.
struct Neighbourhood {
  std::vector<int> vertices;   ///< the face's own corners first
  std::vector<int> faces;      ///< the face itself first, each entered at the half-edge in `entries`
  std::vector<int> entries;    ///< the half-edge by which each face is entered
  std::vector<int> signature;  ///< how the faces hang together
};

/// A half-edge of a neighbourhood: the i-th face's corner c, counted from its entry.
struct NeighbourhoodCorner {
  std::size_t face = 0;  ///< from 0, in the neighbourhood's order
  int corner = 0;        ///< from 0, the entry
};

/// Collects neighbourhoods; what it remembers of the last one makes the next cheap. Not for several threads.
class NeighbourhoodFinder {
 public:
  /// For a mesh that must outlive it.
  explicit NeighbourhoodFinder(const MeshTopology& mesh);
  /// Ring 1 are the faces that share a corner with the face, ring 2 those that share one with ring 1.
  void find(int face, int rings, Neighbourhood& result);

  /// How the last neighbourhood was walked: the i-th face (i >= 1) lies across the edge that comes in before
  /// this corner's; a corner at which each vertex stands; the vertices whose faces were all entered are the
  /// first ones.
  [[nodiscard]] const std::vector<NeighbourhoodCorner>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<NeighbourhoodCorner>& vertex_corners() const { return vertex_corners_; }
  [[nodiscard]] std::size_t inner_vertices() const { return inner_vertices_; }

 private:
  [[nodiscard]] NeighbourhoodCorner corner_of(int h, const Neighbourhood& result) const;

  const MeshTopology& mesh_;
  int time_ = 0;
  std::vector<int> vertex_time_, vertex_number_;
  std::vector<int> face_time_, face_number_;
  std::vector<NeighbourhoodCorner> steps_, vertex_corners_;
  std::size_t inner_vertices_ = 0;
};

/// A part of a mesh of triangles or quads: the faces of these entries in their order, with the places in
/// `vertices` as numbers.
[[nodiscard]] MeshTopology part_of(const MeshTopology& mesh, const std::vector<int>& entries,
                                   const std::vector<int>& vertices);

}  // namespace subdiv
