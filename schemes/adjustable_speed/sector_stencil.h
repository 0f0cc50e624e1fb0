#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "schemes/adjustable_speed/knot_line.h"
#include "schemes/algebra/ring.h"
#include "schemes/mesh/fan.h"

namespace subdiv {

/// A point near an extraordinary vertex as a combination of those of the net, two rings around it, the same
/// in every sector: the vertex, and places (sector_places(4, 2)) of the sector `sector` steps
/// counter-clockwise from the own one, -1 <= sector <= 2, to be taken modulo the valence.
template <class R>
struct SectorStencil {
  /// A point of a sector with its weight.
  struct Term {
    int sector = 0;  ///< counter-clockwise from the own one
    int place = 0;   ///< of sector_places(4, 2)
    R weight;        ///< of the point
  };
  R centre = R(0);          ///< the weight of the vertex
  std::vector<Term> terms;  ///< of the other points

  /// The sum of all weights: 1 for an affine combination.
  [[nodiscard]] R sum() const {
    R result = centre;
    for (const Term& term : terms) result = result + term.weight;
    return result;
  }
};

/// Where (i, j) lies, i steps along a sector's first spoke and j along the next one, both from -1 to 2 and
/// not both negative: across a spoke it is a place of the neighbouring sector. place = -1 at the vertex.
struct SectorPlace {
  int sector = 0;  ///< counter-clockwise from the own one
  int place = -1;  ///< of sector_places(4, 2); -1 for the vertex
};
/// The place of (i, j).
[[nodiscard]] inline SectorPlace sector_place(int i, int j) {
  const auto place = [](int a, int b) {
    const std::vector<FanPlace> places = sector_places(4, 2);
    for (std::size_t p = 0; p < places.size(); ++p) {
      if (places[p].a == a && places[p].b == b) return static_cast<int>(p);
    }
    throw std::logic_error("no place of the sector");
  };
  if (i == 0 && j == 0) return {};
  if (i > 0 && j >= 0) return {0, place(i, j)};
  if (i == 0) return {j > 0 ? 1 : -1, place(j > 0 ? j : -j, 0)};
  if (i > 0) return {-1, place(-j, i)};  // across the first spoke
  if (j > 0) return {1, place(j, -i)};   // across the next one
  if (j == 0) return {2, place(-i, 0)};
  throw std::logic_error("no place beyond the vertex");
}

/// The tensor product: the sum of along[i + 1] across[j + 1] P_(i, j). Weights that are exactly 0 leave no
/// term.
template <class R>
SectorStencil<R> tensor_stencil(const LineWeights<R>& along, const LineWeights<R>& across) {
  SectorStencil<R> result;
  for (std::size_t i = 0; i < along.size(); ++i) {
    for (std::size_t j = 0; j < across.size(); ++j) {
      const R& x = along[i];
      const R& y = across[j];
      if (is_zero(x) || is_zero(y)) continue;
      const auto [sector, place] = sector_place(static_cast<int>(i) - 1, static_cast<int>(j) - 1);
      if (place < 0) {
        result.centre = result.centre + x * y;
      } else {
        result.terms.push_back({sector, place, x * y});
      }
    }
  }
  return result;
}

}  // namespace subdiv
