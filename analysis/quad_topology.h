#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace subdiv {

/// The topology of quads that share vertices by index, whatever their shape.
struct QuadTopology {
  std::size_t vertices = 0;    ///< as given; those of no quad count as components of their own
  std::size_t edges = 0;       ///< pairs of vertices that follow each other around some quad, each once
  std::size_t quads = 0;       ///< as many as were given
  std::size_t borders = 0;     ///< loops of edges that belong to one quad
  std::size_t components = 0;  ///< of vertices joined by edges
  /// Is it a surface: each edge belongs to one or two quads, and the quads around each vertex form one fan?
  bool manifold = false;
  /// Do the two quads of each inner edge run through it in opposite directions?
  bool oriented = false;

  /// Vertices - edges + faces: 0 for a torus, 2 for a sphere.
  [[nodiscard]] long long euler_characteristic() const {
    return static_cast<long long>(vertices) - static_cast<long long>(edges) + static_cast<long long>(quads);
  }
  /// The genus g of a connected oriented surface: V - E + F = 2 - 2 g - borders. Only for such.
  [[nodiscard]] long long genus() const {
    return (2 - euler_characteristic() - static_cast<long long>(borders)) / 2;
  }
};

/// Throws std::out_of_range for a corner that is no vertex. A quad that meets the same vertex or the same
/// edge twice is not manifold.
[[nodiscard]] QuadTopology quad_topology(std::size_t vertices,
                                         std::span<const std::array<std::size_t, 4>> quads);

}  // namespace subdiv
