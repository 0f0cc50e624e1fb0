#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "schemes/evaluate/aligned_vector.h"
#include "schemes/evaluate/patch_grid.h"
#include "schemes/mesh/mesh_scheme.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// The faces up to some rings around a face, and their vertices, in an order that depends on nothing but how
/// they hang together: equal signatures mean neighbourhoods that map onto each other, vertex by vertex.
struct Neighbourhood {
  std::vector<int> vertices;  // the face's own corners first
  std::vector<int> faces;     // the face itself first, each entered at the half-edge in `entries`
  std::vector<int> entries;
  std::vector<int> signature;
};

/// A half-edge of a neighbourhood: the i-th face's corner c, counted from its entry.
struct NeighbourhoodCorner {
  std::size_t face = 0;
  int corner = 0;
};

/// Collects neighbourhoods; what it remembers of the last one makes the next cheap. Not for several threads.
class NeighbourhoodFinder {
 public:
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

/// Some steps of a scheme at once on one face: point p of the patch is the sum over k of weight(k, p) times
/// control point k, the control points being some of the neighbourhood's vertices.
struct PatchTable {
  /// Places of the control points in Neighbourhood::vertices.
  std::vector<int> controls;
  std::size_t points = 0;
  /// Lines of patch_line points, the last one padded by zeros: within a line by k, then by p.
  AlignedVector<double> weights;

  [[nodiscard]] std::size_t lines() const;
  [[nodiscard]] double weight(std::size_t k, std::size_t p) const;
};

/// Points that the kernel makes at once.
inline constexpr std::size_t patch_line = 8;

/// What is done to the points of the last level: a stencil over that level's vertices, such as a limit
/// position. Empty: nothing.
using FinalRule = std::function<Stencil<double>(const MeshTopology&, int vertex)>;

/// The neighbourhood, regular as far as `sight` sees, of a face, and its table: found by a fixed walk.
class RegularPatch {
 public:
  RegularPatch(const MeshScheme<double>& scheme, const PatchGrid& grid, const FinalRule& final_rule = {});
  [[nodiscard]] const PatchTable& table() const { return table_; }
  /// The vertices that the table combines for this face, appended; nothing and false where one of the
  /// vertices around it is not regular. regular[v]: v lies inside and has the regular valence.
  bool add_controls(const MeshTopology& mesh, const std::vector<char>& regular, int face,
                    std::vector<int>& controls);

 private:
  PatchTable table_;
  std::vector<NeighbourhoodCorner> steps_;
  std::vector<NeighbourhoodCorner> inner_;
  std::vector<NeighbourhoodCorner> controls_;
  std::vector<int> entries_;  // of the last face
};

/// The table of the neighbourhood's first face: the scheme's rules, and at the end the final rule, applied to
/// each control point alone.
[[nodiscard]] PatchTable patch_table(const MeshTopology& mesh, const Neighbourhood& neighbourhood,
                                     const MeshScheme<double>& scheme, const PatchGrid& grid,
                                     const FinalRule& final_rule = {});

}  // namespace subdiv
