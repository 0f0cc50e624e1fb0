#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "schemes/algebra/matrix.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/mesh/fan.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// The subdivision matrix of a scheme on some rings around a vertex of valence n, all else regular. It
/// commutes with the rotation by one sector, so one sector's rows say it all: with P_0 the vertex, P_{k,p}
/// the point at place p (sector_places) of sector k,
///
///   P'_0     = centre P_0 + sum over k, p of spread_p P_{k,p}
///   P'_{j,p} = pull_p P_0 + sum over k, q of blocks[k](p, q) P_{j+k,q},   0 <= k < n, sectors modulo n.
template <class R>
struct FanMatrix {
  int sides = 4;                  ///< of the faces: 3 or 4
  int valence = 0;                ///< n
  int rings = 0;                  ///< of faces around the vertex that are taken
  R centre = R(0);                ///< weight of P_0 in P'_0
  Vector<R> spread;               ///< by the place p
  Vector<R> pull;                 ///< by the place p
  std::vector<Matrix<R>> blocks;  ///< blocks[k](p, q)

  [[nodiscard]] Eigen::Index places() const { return pull.size(); }
};

/// The rings on which the eigenvalues live: every further ring adds only zeros. A curve scheme with the mask
/// indices -L .. L brings L rings of its points around a vertex under itself: 2 for cubic and box splines,
/// 3 for J_s, Kobbelt and Butterfly.
template <class R>
int eigenvalue_rings(const MeshScheme<R>& scheme) {
  return scheme.reach + 1;
}

/// Throws std::invalid_argument when a rule reaches out of the rings: they are too few to be closed under it.
template <class R>
FanMatrix<R> fan_matrix(const MeshScheme<R>& scheme, int valence, int rings) {
  const int sides = scheme.split == MeshSplit::quads ? 4 : 3;
  const MeshTopology coarse = fan_topology(sides, valence, rings + 2);
  const MeshTopology fine = split(coarse, scheme.split);
  // fan_topology numbers ring after ring within a sector: the places of the inner rings come first.
  const auto places = static_cast<Eigen::Index>(sector_places(sides, rings).size());
  const auto all_places = static_cast<int>(sector_places(sides, rings + 2).size());
  int spoke = -1;  // to the place that follows the centre's first spoke
  for_each_outgoing(fine, 0, [&](int h) {
    if (fine.target(h) == coarse.vertices() + coarse.edge(coarse.outgoing(0))) spoke = h;
  });
  const int first_sector = (coarse.target(coarse.outgoing(0)) - 1) / all_places;
  const std::optional<std::vector<int>> order = fan_vertices(fine, spoke, rings);
  if (!order) throw std::logic_error("a refined fan is a fan");
  std::map<int, Eigen::Index> row;  // of the vertex, and of the places of the first sector
  for (Eigen::Index i = 0; i <= places; ++i) row[(*order)[static_cast<std::size_t>(i)]] = i;

  FanMatrix<R> result;
  result.sides = sides;
  result.valence = valence;
  result.rings = rings;
  result.spread = Vector<R>::Constant(places, R(0));
  result.pull = Vector<R>::Constant(places, R(0));
  result.blocks.assign(static_cast<std::size_t>(valence), zero_matrix<R>(places, places));
  for (const auto& [number, i] : row) {
    const Stencil<R> stencil = stencil_of(coarse, scheme, number);
    for (const auto& [vertex, weight] : stencil.terms()) {
      if (is_zero(weight)) continue;
      if (vertex == 0) {
        (i == 0 ? result.centre : result.pull(i - 1)) = weight;
        continue;
      }
      const int sector = ((vertex - 1) / all_places - first_sector + valence) % valence;
      const Eigen::Index place = (vertex - 1) % all_places;
      if (place >= places) throw std::invalid_argument("the rings are not closed under the scheme's rules");
      if (i > 0) {
        result.blocks[static_cast<std::size_t>(sector)](i - 1, place) = weight;
      } else if (sector == 0) {
        result.spread(place) = weight;
      }
    }
  }
  return result;
}

/// The rotation-invariant part: n copies of one value per place, (1 + places) square, the vertex first.
template <class R>
Matrix<R> invariant_block(const FanMatrix<R>& fan) {
  Matrix<R> result = zero_matrix<R>(fan.places() + 1, fan.places() + 1);
  result(0, 0) = fan.centre;
  for (Eigen::Index p = 0; p < fan.places(); ++p) {
    result(0, p + 1) = R(fan.valence) * fan.spread(p);
    result(p + 1, 0) = fan.pull(p);
    for (const Matrix<R>& block : fan.blocks) {
      for (Eigen::Index q = 0; q < fan.places(); ++q)
        result(p + 1, q + 1) = result(p + 1, q + 1) + block(p, q);
    }
  }
  return result;
}

}  // namespace subdiv
