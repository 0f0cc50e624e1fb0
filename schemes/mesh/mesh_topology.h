#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace subdiv {

/// Faces as a file lists them: the numbers, from 0, of each face's corners, counter-clockwise seen from
/// outside. Not yet known to be a surface.
struct PolygonFaces {
  std::size_t vertices = 0;  ///< how many there are
  /// The first corner of each face, and the end.
  std::vector<std::size_t> begin{
      0};                          // face f has the corners begin[f] .. begin[f + 1] - 1; faces + 1 numbers
  std::vector<long long> corners;  ///< of all faces, one after the other

  [[nodiscard]] std::size_t faces() const { return begin.size() - 1; }
  /// The corners of a face.
  [[nodiscard]] std::span<const long long> face(std::size_t f) const {
    return {corners.data() + begin[f], begin[f + 1] - begin[f]};
  }
  /// Adds a face with these corners.
  void add_face(std::span<const long long> face_corners) {
    corners.insert(corners.end(), face_corners.begin(), face_corners.end());
    begin.push_back(corners.size());
  }
};

/// Why faces are no oriented surface: the face to look at (and another that contradicts it), numbered from 0.
struct MeshFault {
  std::size_t face = 0;                   ///< the one to look at
  std::optional<std::size_t> other_face;  ///< the one that it contradicts, if any
  std::string what;    ///< "runs from vertex 3 to vertex 7 as face 12 does"; vertices and faces count from 1
  std::string remedy;  ///< "turn one of the two around"
};

/// The first fault, if any: a corner that is no vertex, fewer than 3 corners, a vertex twice in one face, two
/// faces with the same corners, an edge with more than two faces, neighbours of opposite orientation, a
/// vertex at which several fans of faces meet, more half-edges than an int counts.
[[nodiscard]] std::optional<MeshFault> find_fault(const PolygonFaces& faces);

/// The connectivity of an oriented surface with or without border, of polygons: half-edges numbered face by
/// face, each face's counter-clockwise from the one that leaves its first corner. A vertex without faces is
/// allowed. Indices are 0-based ints; -1 stands for "none".
class MeshTopology {
 public:
  MeshTopology() = default;
  /// Throws InputError with the first fault.
  explicit MeshTopology(const PolygonFaces& faces);
  /// Triangles (sides = 3) or quads (4), known to be a surface: the origin and the opposite of every
  /// half-edge.
  MeshTopology(int sides, int vertices, std::vector<int> origin, std::vector<int> opposite);

  [[nodiscard]] int vertices() const { return vertices_; }
  [[nodiscard]] int edges() const { return edges_; }
  /// The number of faces.
  [[nodiscard]] int faces() const {
    return has_arrays() ? static_cast<int>(begin_.size()) - 1 : half_edges() / sides_;
  }
  [[nodiscard]] int half_edges() const { return static_cast<int>(origin_.size()); }
  /// The number of corners of every face; 0 when it differs from face to face. 4 for a mesh without faces
  /// made from PolygonFaces.
  [[nodiscard]] int sides() const { return sides_; }
  [[nodiscard]] bool is_empty() const { return vertices_ == 0; }
  /// Does every edge belong to two faces?
  [[nodiscard]] bool is_closed() const { return closed_; }

  /// The half-edge that leaves the face's first corner.
  [[nodiscard]] int first(int face) const {
    if (sides_ == quad) return quad * face;
    return sides_ == triangle ? triangle * face : begin_[static_cast<std::size_t>(face)];
  }
  [[nodiscard]] int degree(int face) const { return sides_ > 0 ? sides_ : first(face + 1) - first(face); }
  /// The face of a half-edge.
  [[nodiscard]] int face(int h) const {
    if (sides_ == quad) return h / quad;
    return sides_ == triangle ? h / triangle : face_[static_cast<std::size_t>(h)];
  }
  /// The next half-edge of the same face, counter-clockwise.
  [[nodiscard]] int next(int h) const {
    const int f = face(h);
    return h + 1 < first(f) + degree(f) ? h + 1 : first(f);
  }
  /// The one before.
  [[nodiscard]] int previous(int h) const {
    const int f = face(h);
    return h > first(f) ? h - 1 : first(f) + degree(f) - 1;
  }
  [[nodiscard]] int origin(int h) const { return origin_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int target(int h) const { return origin(next(h)); }
  /// The half-edge of the neighbouring face that runs the other way; -1 at the border.
  [[nodiscard]] int opposite(int h) const { return opposite_[static_cast<std::size_t>(h)]; }
  /// Edges are numbered in the order of their first half-edges.
  [[nodiscard]] int edge(int h) const { return edge_[static_cast<std::size_t>(h)]; }
  /// A half-edge of the edge.
  [[nodiscard]] int half_edge(int edge) const { return edge_half_edge_[static_cast<std::size_t>(edge)]; }
  /// A half-edge that leaves v; at the border the one without a face to its right, from which the others
  /// follow counter-clockwise. -1 when v has no face.
  [[nodiscard]] int outgoing(int v) const { return outgoing_[static_cast<std::size_t>(v)]; }
  /// The next half-edge counter-clockwise with the same origin; -1 past the last face at the border.
  [[nodiscard]] int turn_left(int h) const { return opposite(previous(h)); }
  /// The next half-edge clockwise with the same origin; -1 when h has no face to its right.
  [[nodiscard]] int turn_right(int h) const {
    const int o = opposite(h);
    return o < 0 ? -1 : next(o);
  }
  /// Whether the vertex has no face, or lies on the border.
  [[nodiscard]] bool is_border(int v) const {
    const int h = outgoing(v);
    return h < 0 || opposite(h) < 0;
  }
  /// The number of edges at v, and of faces.
  [[nodiscard]] int valence(int v) const;
  /// The number of faces at v.
  [[nodiscard]] int face_count(int v) const;

  [[nodiscard]] const std::vector<int>& origins() const { return origin_; }
  [[nodiscard]] const std::vector<int>& opposites() const { return opposite_; }

 private:
  // Of these, the faces' numbers follow from the half-edges': by far the most frequent meshes.
  static constexpr int triangle = 3;
  static constexpr int quad = 4;
  [[nodiscard]] bool has_arrays() const { return sides_ != triangle && sides_ != quad; }
  void number_edges_and_vertices();

  int sides_ = quad;
  int vertices_ = 0;
  int edges_ = 0;
  bool closed_ = true;
  std::vector<int> begin_{0};  // of each face, and one more; unless all are triangles or quads
  std::vector<int> face_;      // of each half-edge; likewise
  std::vector<int> origin_;
  std::vector<int> opposite_;
  std::vector<int> edge_;
  std::vector<int> edge_half_edge_;
  std::vector<int> outgoing_;
};

/// Calls visit(h) for every half-edge that leaves v, counter-clockwise, from outgoing(v) on.
template <class Visit>
void for_each_outgoing(const MeshTopology& mesh, int v, Visit&& visit) {
  const int begin = mesh.outgoing(v);
  for (int h = begin; h >= 0;) {
    visit(h);
    h = mesh.turn_left(h);
    if (h == begin) return;
  }
}

/// The edge-neighbours of v in counter-clockwise order, at a border from one border edge to the other.
[[nodiscard]] std::vector<int> neighbours(const MeshTopology& mesh, int v);

/// Every n-gon split into n quads: vertices keep their numbers; then one vertex an edge (V + edge), one a
/// face (V + E + face). The quad of the corner at half-edge h has the number h and the corners: origin of h,
/// point of h's edge, face point, point of the edge before.
[[nodiscard]] MeshTopology split_into_quads(const MeshTopology& mesh);

/// Every triangle split into four: vertices keep their numbers; then one vertex an edge (V + edge). Of face
/// f, triangle 4 f + i has the corner at f's i-th half-edge, that edge's point, the point of the edge before;
/// 4 f + 3 has the three edge points. Throws std::invalid_argument when a face is no triangle.
[[nodiscard]] MeshTopology split_into_triangles(const MeshTopology& mesh);

}  // namespace subdiv
