#pragma once

#include <optional>
#include <vector>

#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// A place around a vertex of valence n: in sector 0 <= sector < n, a steps along its first spoke, then b
/// along the direction of the next one. Quads: a >= 1, 0 <= b, both up to the number of rings. Triangles:
/// a >= 1, b >= 0, a + b up to the number of rings.
struct FanPlace {
  int sector = 0;  ///< from 0
  int a = 0;       ///< along the sector's first spoke
  int b = 0;       ///< along the next one's direction
};

/// The places of one sector, ring by ring, each ring from the spoke on. Ring r is where max(a, b) = r (quads,
/// 2 r places) or a + b = r (triangles, r places).
[[nodiscard]] std::vector<FanPlace> sector_places(int sides, int rings);

/// The mesh of `rings` rings of faces around one vertex of valence n >= 2: all other inner vertices are
/// regular (4 quads, 6 triangles). Vertex 0 is the centre; then ring-wise places, sector after sector: the
/// place p of sector_places in sector k has the number 1 + k * (places a sector) + p.
[[nodiscard]] MeshTopology fan_topology(int sides, int valence, int rings);

/// The vertices around the origin of `spoke` in the order of fan_topology, spoke in sector 0. Nothing when
/// the rings are not complete or not regular but for the centre (that a mesh wraps around is not noticed).
[[nodiscard]] std::optional<std::vector<int>> fan_vertices(const MeshTopology& mesh, int spoke, int rings);

}  // namespace subdiv
