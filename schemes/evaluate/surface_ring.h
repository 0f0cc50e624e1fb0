#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/adjustable_speed/speed_rules.h"
#include "schemes/evaluate/de_casteljau.h"

namespace subdiv {

/// Nested surface rings around an extraordinary vertex (Karciauskas & Peters: Adjustable speed surface
/// subdivision, 2009, figures 4 and 7). A ring lies between the tensor border of a net and that of the
/// refined net, three bicubic patches a sector; rings join C2, whatever the speeds.

/// Bezier coefficients b_(i, j), 0 <= i, j <= 3, at 4 i + j: of the polynomial over a square, (0, 0) at its
/// corner on or nearest to the sector's bisectrix away from the vertex, i along the first spoke towards
/// the next one, j along the next spoke towards the first one.
template <class P>
using BezierPatch = std::array<P, 16>;

/// The rules of one speed in the ring R.
template <class R>
struct RingRules {
  R sigma;                                                 ///< the speed
  std::vector<SectorStencil<R>> refined;                   ///< at sector_places(4, 2)
  std::array<std::optional<SectorStencil<R>>, 16> border;  ///< (3, 3) is none
};
/// The rules of a speed 0 < sigma < 1.
template <class R>
RingRules<R> ring_rules(const R& sigma) {
  std::vector<SectorStencil<R>> refined = refined_places(sigma);
  refined.resize(SectorNet<R>::places);
  return {sigma, std::move(refined), tensor_border(sigma)};
}

/// One step of subdivision.
template <class P, class R>
SectorNet<P> refined_net(const SectorNet<P>& net, const RingRules<R>& rules,
                         const VertexWeights<R>& weights) {
  const int n = net.valence();
  const R edge_share = weights.beta / R(n);
  const R face_share = weights.gamma / R(n);
  std::vector<P> points(net.points().size());
  add_weighted(points[0], R(1) - weights.beta - weights.gamma, net.centre());
  for (int sector = 0; sector < n; ++sector) {
    add_weighted(points[0], edge_share, net.at(sector, sector_place(1, 0).place));
    add_weighted(points[0], face_share, net.at(sector, sector_place(1, 1).place));
    for (std::size_t p = 0; p < SectorNet<P>::places; ++p)
      points[1 + static_cast<std::size_t>(sector) * SectorNet<P>::places + p] =
          apply(rules.refined[p], net, sector);
  }
  return {n, std::move(points)};
}

/// The net over other knots (changed_places).
template <class P, class R>
SectorNet<P> changed_net(const SectorNet<P>& net, const std::vector<SectorStencil<R>>& change) {
  std::vector<P> points(net.points().size());
  points[0] = net.centre();
  for (int sector = 0; sector < net.valence(); ++sector) {
    for (std::size_t p = 0; p < SectorNet<P>::places; ++p)
      points[1 + static_cast<std::size_t>(sector) * SectorNet<P>::places + p] = apply(change[p], net, sector);
  }
  return {net.valence(), std::move(points)};
}

/// The tensor border of one sector: all coefficients but (3, 3), which is left as P{}.
template <class R, class Net>
auto border_points(const Net& net, const RingRules<R>& rules, int sector) {
  BezierPatch<std::decay_t<decltype(net.centre())>> result{};
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (rules.border[k]) result[k] = apply(*rules.border[k], net, sector);
  }
  return result;
}

/// The three patches of a sector between a tensor border and the outermost line b_(0, j), b_(i, 0) of the
/// next one: the corner, the one at the next spoke, the one at the first spoke.
template <class P>
struct RingSector {
  BezierPatch<P> corner;      ///< at the corner of the border
  BezierPatch<P> next_side;   ///< at the next spoke
  BezierPatch<P> first_side;  ///< at the first spoke
};

namespace detail {
/// The four Bezier points of the parts [0, sigma] and [sigma, 1] of a cubic; of the first part's the last,
/// and all of the second's, need all four points.
template <class P, class R>
std::array<std::array<P, 4>, 2> split_cubic(const std::array<P, 4>& b, const R& sigma) {
  const R rest = R(1) - sigma;
  const auto [low, high] = split_bezier(b, [&](const P& from, const P& to) {
    P sum{};
    add_weighted(sum, rest, from);
    add_weighted(sum, sigma, to);
    return sum;
  });
  return {low, high};
}
}  // namespace detail

/// inner is the tensor border of the refined net, or of a net that shares its outermost line.
template <class P, class R>
RingSector<P> ring_sector(const BezierPatch<P>& border, const BezierPatch<P>& inner, const R& sigma) {
  // Layer by layer from outside: the first three are parts of the border, the innermost is the next one's.
  RingSector<P> result{};
  const auto line = [](const BezierPatch<P>& patch, std::size_t i, bool along_j) {
    std::array<P, 4> points{};
    for (std::size_t k = 0; k < 4; ++k) points[k] = along_j ? patch[4 * i + k] : patch[4 * k + i];
    return points;
  };
  for (const bool first : {true, false}) {  // the side at the first spoke: layers are lines along j
    BezierPatch<P> layers{};                // [4 * layer + place along it]
    for (std::size_t k = 0; k < 4; ++k) {
      const std::array<P, 4> across = detail::split_cubic(line(border, k, !first), sigma)[0];
      for (std::size_t layer = 0; layer < 3; ++layer) layers[4 * layer + k] = across[layer];
    }
    for (std::size_t layer = 0; layer < 3; ++layer) {
      const auto parts = detail::split_cubic(line(layers, layer, true), sigma);
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t slot = first ? 4 * layer + k : 4 * k + layer;
        result.corner[slot] = parts[0][k];
        (first ? result.first_side : result.next_side)[slot] = parts[1][k];
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t slot = first ? 12 + k : 4 * k + 3;
      (first ? result.first_side : result.next_side)[slot] = inner[first ? k : 4 * k];
    }
  }
  result.corner[15] = inner[0];
  return result;
}

}  // namespace subdiv
