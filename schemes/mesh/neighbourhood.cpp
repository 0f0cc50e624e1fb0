#include "schemes/mesh/neighbourhood.h"

#include <map>
#include <utility>

namespace subdiv {

MeshTopology part_of(const MeshTopology& mesh, const std::vector<int>& entries,
                     const std::vector<int>& vertices) {
  const int sides = mesh.sides();
  std::map<int, int> vertex_number;
  for (std::size_t i = 0; i < vertices.size(); ++i) vertex_number[vertices[i]] = static_cast<int>(i);
  std::map<int, int> half_edge_number;
  std::vector<int> half_edges;
  for (const int entry : entries) {
    int h = entry;
    for (int c = 0; c < sides; ++c, h = mesh.next(h)) {
      half_edge_number[h] = static_cast<int>(half_edges.size());
      half_edges.push_back(h);
    }
  }
  std::vector<int> origin;
  std::vector<int> opposite;
  for (const int h : half_edges) {
    origin.push_back(vertex_number.at(mesh.origin(h)));
    const auto found = half_edge_number.find(mesh.opposite(h));
    opposite.push_back(found == half_edge_number.end() ? -1 : found->second);
  }
  return {sides, static_cast<int>(vertices.size()), std::move(origin), std::move(opposite)};
}

NeighbourhoodFinder::NeighbourhoodFinder(const MeshTopology& mesh)
    : mesh_(mesh),
      vertex_time_(static_cast<std::size_t>(mesh.vertices()), 0),
      vertex_number_(static_cast<std::size_t>(mesh.vertices()), 0),
      face_time_(static_cast<std::size_t>(mesh.faces()), 0),
      face_number_(static_cast<std::size_t>(mesh.faces()), 0) {}

NeighbourhoodCorner NeighbourhoodFinder::corner_of(int h, const Neighbourhood& result) const {
  const auto i = static_cast<std::size_t>(face_number_[static_cast<std::size_t>(mesh_.face(h))]);
  const int sides = mesh_.degree(mesh_.face(h));
  return {i, (h - result.entries[i] + sides) % sides};
}

void NeighbourhoodFinder::find(int face, int rings, Neighbourhood& result) {
  ++time_;
  steps_.assign(1, {});
  vertex_corners_.clear();
  result.vertices.clear();
  result.faces.clear();
  result.entries.clear();
  result.signature.clear();
  std::vector<int> discovery;  // of each vertex, a half-edge that leaves it
  const auto enter = [&](int entry) {
    const int f = mesh_.face(entry);
    const auto i = static_cast<std::size_t>(f);
    if (face_time_[i] == time_) {
      result.signature.push_back(-2 - face_number_[i]);
      return;
    }
    face_time_[i] = time_;
    face_number_[i] = static_cast<int>(result.faces.size());
    result.faces.push_back(f);
    result.entries.push_back(entry);
    int h = entry;
    for (int c = 0; c < mesh_.degree(f); ++c, h = mesh_.next(h)) {
      const auto v = static_cast<std::size_t>(mesh_.origin(h));
      if (vertex_time_[v] != time_) {
        vertex_time_[v] = time_;
        vertex_number_[v] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh_.origin(h));
        discovery.push_back(h);
        vertex_corners_.push_back({result.entries.size() - 1, c});
      }
      result.signature.push_back(vertex_number_[v]);
    }
  };
  enter(mesh_.first(face));
  std::size_t turned = 0;  // vertices whose faces have all been entered
  for (int ring = 0; ring < rings; ++ring) {
    for (const std::size_t known = result.vertices.size(); turned < known; ++turned) {
      const int begin = discovery[turned];
      NeighbourhoodCorner from;
      int h = begin;
      do {  // counter-clockwise, and at a border on from the other side
        const std::size_t known_faces = result.faces.size();
        enter(h);
        if (result.faces.size() > known_faces && known_faces > 0) steps_.push_back(from);
        from = corner_of(h, result);
        h = mesh_.turn_left(h);
        if (h < 0) {
          result.signature.push_back(-1);
          h = mesh_.outgoing(mesh_.origin(begin));
        }
      } while (h != begin);
    }
  }
  inner_vertices_ = turned;
}

}  // namespace subdiv
