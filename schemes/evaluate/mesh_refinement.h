#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "schemes/evaluate/patch_grid.h"
#include "schemes/evaluate/patch_table.h"
#include "schemes/mesh/mesh_scheme.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// A point in space.
using Point3 = std::array<double, 3>;

/// Points as combinations of other points, row by row.
struct StencilRows {
  std::vector<std::size_t> begin{0};  ///< of each row, and the end
  std::vector<int> vertices;          ///< of all rows, one row after the other
  std::vector<double> weights;        ///< of the vertices, in the same order

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  /// Adds a row.
  void add(const Stencil<double>& stencil);
  /// The combination that a row says.
  [[nodiscard]] Point3 point(std::size_t row, std::span<const Point3> points) const;
};

/// Several steps at once, face by face of a mesh whose irregular vertices are isolated: few kinds of
/// neighbourhoods, a table for each.
struct PatchStage {
  MeshTopology mesh;               ///< whose faces are refined; controls may lie beyond its border
  PatchGrid grid;                  ///< the points of one face
  std::vector<PatchTable> tables;  ///< one for each kind of neighbourhood
  std::vector<int> table_of_face;  ///< which of the tables
  std::vector<int> controls;       ///< of each face, the vertices that its table combines
  std::vector<std::size_t> controls_begin{0};  ///< of each face, and the end
};

/// Which number a vertex or corner of the refined mesh has: vertices of the coarse mesh keep theirs; then
/// come the points inside the edges, N - 1 an edge in the direction of MeshTopology::half_edge, then those
/// inside the faces, in the order of PatchGrid. The small faces of face f are N^2 f and on, in the order of
/// PatchGrid.
class PatchNumbering {
 public:
  /// For a mesh and a grid, both of which must outlive it.
  PatchNumbering(const MeshTopology& mesh, const PatchGrid& grid) : mesh_(&mesh), grid_(&grid) {}
  /// Of the refined mesh.
  [[nodiscard]] std::size_t vertices() const;
  /// Of the refined mesh.
  [[nodiscard]] std::size_t faces() const;
  /// The number of the first point inside a face.
  [[nodiscard]] int first_inner(int face) const;
  /// The first point inside the edge of h, in the edge's direction.
  [[nodiscard]] int first_on_edge(int h) const;
  /// Is h the half-edge whose direction the edge's points follow, and whose face writes them?
  [[nodiscard]] bool owns_edge(int h) const { return mesh_->half_edge(mesh_->edge(h)) == h; }
  /// Is h the half-edge whose face writes its origin?
  [[nodiscard]] bool owns_origin(int h) const { return mesh_->outgoing(mesh_->origin(h)) == h; }
  /// The corners of all small faces, and the opposite of each of their half-edges.
  void corners(std::span<int> out, int threads) const;
  /// The opposite of every half-edge of the refined mesh; -1 at the border.
  void opposites(std::span<int> out, int threads) const;

 private:
  const MeshTopology* mesh_;
  const PatchGrid* grid_;
};

/// Some levels of a scheme on a mesh of fixed connectivity, prepared once and applied to any points: the
/// first levels, on which neighbourhoods differ from face to face, stencil by stencil; the others in patches.
/// Vertices of the control mesh keep their numbers.
class MeshRefinement {
 public:
  /// levels >= 0; the final rule is applied to the points of the last level. Throws InputError for a scheme
  /// of triangles on a mesh with other faces (naming the first), and for more half-edges than an int counts;
  /// std::invalid_argument for levels < 0.
  MeshRefinement(const MeshTopology& mesh, const MeshScheme<double>& scheme, int levels,
                 const FinalRule& final_rule = {});

  [[nodiscard]] std::size_t control_vertices() const { return control_vertices_; }
  /// Of the refined mesh.
  [[nodiscard]] std::size_t vertices() const;
  /// Of the refined mesh.
  [[nodiscard]] std::size_t faces() const;
  /// The number of corners of every face; 0 where they differ, which only the control mesh itself can have.
  [[nodiscard]] int sides() const { return sides_; }

  /// The refined points: control_vertices() points in, vertices() out. Throws std::invalid_argument for other
  /// sizes. The same bits on every instruction set and for any number of threads.
  void points(std::span<const Point3> control, std::span<Point3> out, int threads = 1) const;
  /// The corners of every face, counter-clockwise: faces() times sides() vertex numbers; sides() > 0.
  void corners(std::span<int> out, int threads = 1) const;
  /// Of each half-edge (a place in corners()) the opposite one, -1 at the border.
  void opposites(std::span<int> out, int threads = 1) const;

 private:
  /// The last step, when it is one of patches.
  [[nodiscard]] const PatchStage* last_stage() const;

  int sides_ = 4;
  std::size_t control_vertices_ = 0;
  std::vector<std::variant<StencilRows, PatchStage>> steps_;  // patches last, if there are any
  MeshTopology result_;  // before the last patches; where there are none, the refined mesh
};

}  // namespace subdiv
