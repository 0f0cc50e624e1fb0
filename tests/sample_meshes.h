#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <vector>

#include "schemes/algebra/rational.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv::sample {

inline PolygonFaces polygons(std::size_t vertices, const std::vector<std::vector<long long>>& faces) {
  PolygonFaces result;
  result.vertices = vertices;
  for (const auto& face : faces) result.add_face(face);
  return result;
}

inline PolygonFaces tetrahedron() { return polygons(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}); }

inline PolygonFaces cube() {
  return polygons(8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// rows x columns quads, or twice as many triangles, closed in both directions.
inline PolygonFaces torus(int rows, int columns, int sides) {
  PolygonFaces result;
  result.vertices = static_cast<std::size_t>(rows * columns);
  const auto at = [&](int i, int j) -> long long { return (i % rows) * columns + j % columns; };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      if (sides == 4) {
        result.add_face(std::array<long long, 4>{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      } else {
        result.add_face(std::array<long long, 3>{at(i, j), at(i + 1, j), at(i, j + 1)});
        result.add_face(std::array<long long, 3>{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return result;
}

/// rows x columns quads with a border.
inline PolygonFaces sheet(int rows, int columns) {
  PolygonFaces result;
  result.vertices = static_cast<std::size_t>((rows + 1) * (columns + 1));
  const auto at = [&](int i, int j) -> long long { return i * (columns + 1) + j; };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j)
      result.add_face(std::array<long long, 4>{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
  }
  return result;
}

/// Two poles of valence n and a belt of n vertices: triangles whose belt has valence 4.
inline PolygonFaces bipyramid(int n) {
  PolygonFaces result;
  result.vertices = static_cast<std::size_t>(n) + 2;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    result.add_face(std::array<long long, 3>{i, j, n});
    result.add_face(std::array<long long, 3>{j, i, n + 1});
  }
  return result;
}

/// The triangles of the other mesh split into quads at their centres: poles of valence n next to vertices of
/// valence 3 and 4.
inline PolygonFaces quads_of(const PolygonFaces& faces) {
  const MeshTopology split = split_into_quads(MeshTopology(faces));
  PolygonFaces result;
  result.vertices = static_cast<std::size_t>(split.vertices());
  for (int f = 0; f < split.faces(); ++f) {
    std::array<long long, 4> corners{};
    for (int c = 0; c < 4; ++c) corners[static_cast<std::size_t>(c)] = split.origin(4 * f + c);
    result.add_face(corners);
  }
  return result;
}

/// Both meshes as one of two components.
inline PolygonFaces joined(PolygonFaces a, const PolygonFaces& b) {
  for (std::size_t f = 0; f < b.faces(); ++f) {
    std::vector<long long> corners(b.face(f).begin(), b.face(f).end());
    for (long long& c : corners) c += static_cast<long long>(a.vertices);
    a.add_face(corners);
  }
  a.vertices += b.vertices;
  return a;
}

/// Points with coordinates k/64, |k| <= 640: exact in double too.
template <class T>
std::vector<std::array<T, 3>> random_points(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::array<T, 3>> points;
  for (int i = 0; i < count; ++i) {
    std::array<T, 3> point;
    for (T& x : point) x = T(static_cast<int>(random() % 1281U) - 640) / T(64);
    points.push_back(point);
  }
  return points;
}

}  // namespace subdiv::sample
