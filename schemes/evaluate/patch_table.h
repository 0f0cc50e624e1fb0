#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "schemes/evaluate/aligned_vector.h"
#include "schemes/evaluate/patch_grid.h"
#include "schemes/mesh/mesh_scheme.h"
#include "schemes/mesh/mesh_topology.h"
#include "schemes/mesh/neighbourhood.h"

namespace subdiv {

/// Some steps of a scheme at once on one face: point p of the patch is the sum over k of weight(k, p) times
/// control point k, the control points being some of the neighbourhood's vertices.
struct PatchTable {
  /// Places of the control points in Neighbourhood::vertices.
  std::vector<int> controls;
  std::size_t points = 0;  ///< that the table makes
  /// Lines of patch_line points, the last one padded by zeros: within a line by k, then by p.
  AlignedVector<double> weights;

  /// The number of lines: points divided by patch_line, rounded up.
  [[nodiscard]] std::size_t lines() const;
  /// The weight of control point k in point p.
  [[nodiscard]] double weight(std::size_t k, std::size_t p) const;
};

/// Points that the kernel makes at once.
inline constexpr std::size_t patch_line = 8;

/// What is done to the points of the last level, given its mesh: a stencil over its vertices for each vertex,
/// such as a limit position. Empty: nothing.
using FinalRule = std::function<std::function<Stencil<double>(int vertex)>(const MeshTopology&)>;

/// The neighbourhood, regular as far as `sight` sees, of a face, and its table: found by a fixed walk.
class RegularPatch {
 public:
  /// For a scheme, the points wanted of a face, and what is done to them at last.
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
