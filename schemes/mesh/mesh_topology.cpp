#include "schemes/mesh/mesh_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

/// Counted from 1; negative ones as they are.
std::string vertex_name(long long v) {
  return v < 0 ? fmt::format("vertex {} from 0", v)
               : fmt::format("vertex {}", static_cast<unsigned long long>(v) + 1);
}
std::string face_name(std::size_t f) { return fmt::format("face {}", f + 1); }

/// The faults that a face has by itself.
std::optional<MeshFault> fault_of_face(const PolygonFaces& faces, std::size_t f,
                                       std::vector<long long>& sorted) {
  const auto corners = faces.face(f);
  for (const long long v : corners) {
    if (v >= 0 && static_cast<std::size_t>(v) < faces.vertices) continue;
    return MeshFault{.face = f,
                     .other_face = {},
                     .what = fmt::format("has {} as a corner, but the mesh has {} vertices", vertex_name(v),
                                         faces.vertices),
                     .remedy = "corners are numbers of vertices that the file lists"};
  }
  if (corners.size() < 3) {
    return MeshFault{.face = f,
                     .other_face = {},
                     .what = fmt::format("has {} corner{}", corners.size(), corners.size() == 1 ? "" : "s"),
                     .remedy = "a face has at least 3"};
  }
  sorted.assign(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return std::nullopt;
  return MeshFault{.face = f,
                   .other_face = {},
                   .what = fmt::format("meets {} more than once", vertex_name(*twice)),
                   .remedy = "the corners of a face are different vertices"};
}

/// Half-edges that join the same two vertices stand side by side, in the order of their numbers.
struct SortedHalfEdges {
  std::vector<std::size_t> face;   // of each half-edge
  std::vector<std::size_t> order;  // half-edges, by (smaller end, larger end, number)
  std::vector<std::size_t> begin;  // where each group begins, and the end
};

long long end_of(const PolygonFaces& faces, const std::vector<std::size_t>& face, std::size_t h) {
  const std::size_t f = face[h];
  return faces.corners[h + 1 < faces.begin[f + 1] ? h + 1 : faces.begin[f]];
}

SortedHalfEdges sorted_half_edges(const PolygonFaces& faces) {
  const std::size_t count = faces.corners.size();
  SortedHalfEdges result;
  result.face.resize(count);
  for (std::size_t f = 0; f < faces.faces(); ++f)
    std::fill(result.face.begin() + static_cast<std::ptrdiff_t>(faces.begin[f]),
              result.face.begin() + static_cast<std::ptrdiff_t>(faces.begin[f + 1]), f);
  // A counting sort by the smaller end: linear in the size of the mesh.
  std::vector<std::size_t> place(faces.vertices + 1, 0);
  std::vector<long long> smaller(count);
  std::vector<long long> larger(count);
  for (std::size_t h = 0; h < count; ++h) {
    const long long end = end_of(faces, result.face, h);
    smaller[h] = std::min(faces.corners[h], end);
    larger[h] = std::max(faces.corners[h], end);
    ++place[static_cast<std::size_t>(smaller[h]) + 1];
  }
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<std::size_t> next(place.begin(), place.end());
  result.order.resize(count);
  for (std::size_t h = 0; h < count; ++h) result.order[next[static_cast<std::size_t>(smaller[h])]++] = h;
  for (std::size_t v = 0; v < faces.vertices; ++v) {
    const auto from = result.order.begin() + static_cast<std::ptrdiff_t>(place[v]);
    const auto to = result.order.begin() + static_cast<std::ptrdiff_t>(place[v + 1]);
    std::sort(from, to, [&](std::size_t a, std::size_t b) {
      return larger[a] != larger[b] ? larger[a] < larger[b] : a < b;
    });
    for (auto it = from; it != to; ++it) {
      if (it == from || larger[*it] != larger[*(it - 1)])
        result.begin.push_back(static_cast<std::size_t>(it - result.order.begin()));
    }
  }
  result.begin.push_back(count);
  return result;
}

bool same_corners(const PolygonFaces& faces, std::size_t f, std::size_t g) {
  std::vector<long long> a(faces.face(f).begin(), faces.face(f).end());
  std::vector<long long> b(faces.face(g).begin(), faces.face(g).end());
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

std::optional<MeshFault> fault_of_edge(const PolygonFaces& faces, const SortedHalfEdges& sorted,
                                       std::size_t group) {
  const std::size_t begin = sorted.begin[group];
  const std::size_t size = sorted.begin[group + 1] - begin;
  if (size < 2) return std::nullopt;
  const auto at = [&](std::size_t i) { return sorted.order[begin + i]; };
  const std::size_t f = sorted.face[at(1)];
  const std::size_t g = sorted.face[at(0)];
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j < std::min(size, i + 3); ++j) {
      if (!same_corners(faces, sorted.face[at(i)], sorted.face[at(j)])) continue;
      return MeshFault{.face = sorted.face[at(j)],
                       .other_face = sorted.face[at(i)],
                       .what = fmt::format("has the same corners as {}", face_name(sorted.face[at(i)])),
                       .remedy = "leave one of them out"};
    }
  }
  const std::string edge = fmt::format("the edge of {} and {}", vertex_name(faces.corners[at(0)]),
                                       vertex_name(end_of(faces, sorted.face, at(0))));
  if (size > 2) {
    return MeshFault{.face = sorted.face[at(2)],
                     .other_face = g,
                     .what = fmt::format("is face number 3 of {} at {}", size, edge),
                     .remedy = "an edge of a surface belongs to one or two faces"};
  }
  if (faces.corners[at(0)] != faces.corners[at(1)]) return std::nullopt;
  return MeshFault{
      .face = f,
      .other_face = g,
      .what = fmt::format("runs through {} in the same direction as {}", edge, face_name(g)),
      .remedy = "list the corners of every face counter-clockwise, seen from the same side of the surface"};
}

/// Per half-edge, the one that runs the other way, or -1.
std::vector<int> opposites_of(const SortedHalfEdges& sorted) {
  std::vector<int> opposite(sorted.order.size(), -1);
  for (std::size_t group = 0; group + 1 < sorted.begin.size(); ++group) {
    if (sorted.begin[group + 1] - sorted.begin[group] != 2) continue;
    const std::size_t a = sorted.order[sorted.begin[group]];
    const std::size_t b = sorted.order[sorted.begin[group] + 1];
    opposite[a] = static_cast<int>(b);
    opposite[b] = static_cast<int>(a);
  }
  return opposite;
}

/// A vertex whose faces form more than one fan: half-edges that leave it and are not reached by turning.
std::optional<MeshFault> fault_of_vertex(const PolygonFaces& faces, const SortedHalfEdges& sorted,
                                         const std::vector<int>& opposite) {
  const std::size_t count = faces.corners.size();
  const auto previous = [&](std::size_t h) {
    const std::size_t f = sorted.face[h];
    return h > faces.begin[f] ? h - 1 : faces.begin[f + 1] - 1;
  };
  const auto next = [&](std::size_t h) {
    const std::size_t f = sorted.face[h];
    return h + 1 < faces.begin[f + 1] ? h + 1 : faces.begin[f];
  };
  std::vector<char> reached(count, 0);
  std::vector<std::size_t> fan_of(faces.vertices, count);  // a half-edge of the first fan
  for (std::size_t h = 0; h < count; ++h) {
    if (reached[h] != 0) continue;
    const auto v = static_cast<std::size_t>(faces.corners[h]);
    if (fan_of[v] != count) {
      return MeshFault{
          .face = sorted.face[h],
          .other_face = sorted.face[fan_of[v]],
          .what = fmt::format("meets {} only at {}: they share no edge there, nor do the faces between them",
                              face_name(sorted.face[fan_of[v]]), vertex_name(faces.corners[h])),
          .remedy = "the faces around a vertex form one fan; give each fan a vertex of its own"};
    }
    fan_of[v] = h;
    for (std::size_t g = h; reached[g] == 0;) {  // counter-clockwise
      reached[g] = 1;
      const int o = opposite[previous(g)];
      if (o < 0) break;
      g = static_cast<std::size_t>(o);
    }
    for (int o = opposite[h]; o >= 0;) {  // clockwise, for a fan at the border
      const std::size_t g = next(static_cast<std::size_t>(o));
      if (reached[g] != 0) break;
      reached[g] = 1;
      o = opposite[g];
    }
  }
  return std::nullopt;
}

struct Examined {
  std::optional<MeshFault> fault;
  std::vector<int> opposite;
};

Examined examined(const PolygonFaces& faces) {
  std::vector<long long> scratch;
  // One split makes four half-edges of one, and their numbers are ints too.
  constexpr std::size_t most = std::numeric_limits<int>::max() / 4;
  if (faces.corners.size() > most || faces.vertices > most) {
    return {MeshFault{.face = faces.faces() == 0 ? 0 : faces.faces() - 1,
                      .other_face = {},
                      .what = fmt::format("ends a mesh of {} vertices and {} corners", faces.vertices,
                                          faces.corners.size()),
                      .remedy = fmt::format("at most {} of either can be numbered", most)},
            {}};
  }
  for (std::size_t f = 0; f < faces.faces(); ++f) {
    if (auto fault = fault_of_face(faces, f, scratch)) return {std::move(fault), {}};
  }
  const SortedHalfEdges sorted = sorted_half_edges(faces);
  std::optional<MeshFault> first;
  for (std::size_t group = 0; group + 1 < sorted.begin.size(); ++group) {
    auto fault = fault_of_edge(faces, sorted, group);
    if (fault && (!first || fault->face < first->face)) first = std::move(fault);
  }
  if (first) return {std::move(first), {}};
  std::vector<int> opposite = opposites_of(sorted);
  first = fault_of_vertex(faces, sorted, opposite);
  return {std::move(first), std::move(opposite)};
}

}  // namespace

std::optional<MeshFault> find_fault(const PolygonFaces& faces) { return examined(faces).fault; }

MeshTopology::MeshTopology(const PolygonFaces& faces) {
  Examined result = examined(faces);
  if (result.fault) {
    throw InputError(
        fmt::format("{} {}: {}", face_name(result.fault->face), result.fault->what, result.fault->remedy));
  }
  vertices_ = static_cast<int>(faces.vertices);
  opposite_ = std::move(result.opposite);
  origin_.reserve(faces.corners.size());
  for (const long long v : faces.corners) origin_.push_back(static_cast<int>(v));
  for (std::size_t f = 0; f < faces.faces(); ++f) {
    const int degree = static_cast<int>(faces.face(f).size());
    sides_ = f == 0 || sides_ == degree ? degree : 0;
    if (sides_ == 0) break;
  }
  if (has_arrays()) {
    begin_.assign(faces.begin.begin(), faces.begin.end());
    for (std::size_t f = 0; f < faces.faces(); ++f)
      face_.insert(face_.end(), faces.face(f).size(), static_cast<int>(f));
  }
  number_edges_and_vertices();
}

MeshTopology::MeshTopology(int sides, int vertices, std::vector<int> origin, std::vector<int> opposite)
    : sides_(sides), vertices_(vertices), origin_(std::move(origin)), opposite_(std::move(opposite)) {
  number_edges_and_vertices();
}

void MeshTopology::number_edges_and_vertices() {
  edge_.assign(origin_.size(), -1);
  edge_half_edge_.clear();
  outgoing_.assign(static_cast<std::size_t>(vertices_), -1);
  closed_ = true;
  for (int h = 0; h < half_edges(); ++h) {
    const int o = opposite(h);
    if (o < 0) closed_ = false;
    if (o < 0 || h < o) {
      edge_[static_cast<std::size_t>(h)] = static_cast<int>(edge_half_edge_.size());
      edge_half_edge_.push_back(h);
    } else {
      edge_[static_cast<std::size_t>(h)] = edge_[static_cast<std::size_t>(o)];
    }
    int& out = outgoing_[static_cast<std::size_t>(origin(h))];
    if (out < 0 || o < 0) out = h;
  }
  edges_ = static_cast<int>(edge_half_edge_.size());
}

int MeshTopology::face_count(int v) const {
  int count = 0;
  for_each_outgoing(*this, v, [&](int /*h*/) { ++count; });
  return count;
}

int MeshTopology::valence(int v) const { return face_count(v) + (outgoing(v) >= 0 && is_border(v) ? 1 : 0); }

std::vector<int> neighbours(const MeshTopology& mesh, int v) {
  std::vector<int> result;
  int last = -1;
  for_each_outgoing(mesh, v, [&](int h) {
    result.push_back(mesh.target(h));
    last = h;
  });
  if (last >= 0 && mesh.is_border(v)) result.push_back(mesh.origin(mesh.previous(last)));
  return result;
}

MeshTopology split_into_quads(const MeshTopology& mesh) {
  const auto count = static_cast<std::size_t>(mesh.half_edges());
  std::vector<int> origin(4 * count);
  std::vector<int> opposite(4 * count);
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const int previous = mesh.previous(h);
    const int next = mesh.next(h);
    const int right = mesh.turn_right(h);
    const int left = mesh.turn_left(h);
    const std::size_t i = 4 * static_cast<std::size_t>(h);
    origin[i] = mesh.origin(h);
    origin[i + 1] = mesh.vertices() + mesh.edge(h);
    origin[i + 2] = mesh.vertices() + mesh.edges() + mesh.face(h);
    origin[i + 3] = mesh.vertices() + mesh.edge(previous);
    opposite[i] = right < 0 ? -1 : 4 * right + 3;
    opposite[i + 1] = 4 * next + 2;
    opposite[i + 2] = 4 * previous + 1;
    opposite[i + 3] = left < 0 ? -1 : 4 * left;
  }
  return {4, mesh.vertices() + mesh.edges() + mesh.faces(), std::move(origin), std::move(opposite)};
}

MeshTopology split_into_triangles(const MeshTopology& mesh) {
  if (mesh.half_edges() > 0 && mesh.sides() != 3)
    throw std::invalid_argument("only triangles are split into triangles");
  const auto count = static_cast<std::size_t>(mesh.half_edges());
  std::vector<int> origin(4 * count);
  std::vector<int> opposite(4 * count);
  // Triangle of the corner at half-edge h.
  const auto corner = [](int h) { return 3 * (4 * (h / 3) + h % 3); };
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const int previous = mesh.previous(h);
    const int right = mesh.turn_right(h);
    const int left = mesh.turn_left(h);
    const auto i = static_cast<std::size_t>(corner(h));
    const int middle = 3 * (4 * (h / 3) + 3);
    origin[i] = mesh.origin(h);
    origin[i + 1] = mesh.vertices() + mesh.edge(h);
    origin[i + 2] = mesh.vertices() + mesh.edge(previous);
    opposite[i] = right < 0 ? -1 : corner(right) + 2;
    opposite[i + 1] = middle + previous % 3;
    opposite[i + 2] = left < 0 ? -1 : corner(left);
    const int inner = middle + h % 3;  // from this edge's point to the next one's
    const auto m = static_cast<std::size_t>(inner);
    origin[m] = mesh.vertices() + mesh.edge(h);
    opposite[m] = corner(mesh.next(h)) + 1;
  }
  return {3, mesh.vertices() + mesh.edges(), std::move(origin), std::move(opposite)};
}

}  // namespace subdiv
