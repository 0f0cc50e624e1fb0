#pragma once

#include <cstddef>

#include "analysis/mesh/fan_matrix.h"
#include "schemes/adjustable_speed/speed_rules.h"

namespace subdiv {

/// The subdivision matrix of adjustable speed on its net of two rings around a vertex of valence n >= 3, for
/// any weights of the vertex (Karciauskas & Peters, section III; there the vertex is replaced by n copies of
/// itself, which adds the eigenvalue 0 to every mode k != 0).
template <class R>
FanMatrix<R> speed_matrix(const R& sigma, int valence, const VertexWeights<R>& weights) {
  const std::vector<SectorStencil<R>> stencils = refined_places(sigma);
  const auto places = static_cast<Eigen::Index>(sector_places(4, 2).size());
  FanMatrix<R> result;
  result.valence = valence;
  result.rings = 2;
  result.centre = R(1) - weights.beta - weights.gamma;
  result.spread = Vector<R>::Constant(places, R(0));
  result.spread(sector_place(1, 0).place) = weights.beta / R(valence);
  result.spread(sector_place(1, 1).place) = weights.gamma / R(valence);
  result.pull = Vector<R>::Constant(places, R(0));
  result.blocks.assign(static_cast<std::size_t>(valence), zero_matrix<R>(places, places));
  for (Eigen::Index p = 0; p < places; ++p) {
    const SectorStencil<R>& stencil = stencils[static_cast<std::size_t>(p)];
    result.pull(p) = stencil.centre;
    for (const auto& term : stencil.terms) {
      const int sector = (term.sector + valence) % valence;
      R& entry = result.blocks[static_cast<std::size_t>(sector)](p, term.place);
      entry = entry + term.weight;
    }
  }
  return result;
}

/// With the paper's own weights (1).
template <class R>
FanMatrix<R> speed_matrix(const R& sigma, int valence) {
  return speed_matrix(sigma, valence, vertex_weights(sigma, valence));
}

}  // namespace subdiv
