#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "schemes/evaluate/speed_steps.h"
#include "schemes/evaluate/surface_ring.h"

namespace subdiv {

/// The surface rings around one vertex and what they leave open: n tensor borders, one a sector.
template <class P>
struct NestedRings {
  std::vector<std::vector<RingSector<P>>> rings;  ///< outermost first, sector by sector
  std::vector<BezierPatch<P>> hole;               ///< without (3, 3), which is P{}
};

/// The tensor borders of all sectors. Neighbours share the points of their common spoke, also where R rounds.
template <class P, class R>
std::vector<BezierPatch<P>> border_patches(const SectorNet<P>& net, const RingRules<R>& rules) {
  std::vector<BezierPatch<P>> borders;
  for (int sector = 0; sector < net.valence(); ++sector) borders.push_back(border_points(net, rules, sector));
  for (std::size_t sector = 0; sector < borders.size(); ++sector) {
    BezierPatch<P>& next = borders[(sector + 1) % borders.size()];
    for (std::size_t k = 0; k < 3; ++k) next[4 * k + 3] = borders[sector][12 + k];
  }
  return borders;
}

/// The rings of a net over uniform knots, one a step, of at least one step; weights(k) are those of the
/// vertex in step k. Where R rounds, `first` gives the first borders their outermost lines (b_(0, j) and
/// b_(i, 0)), so that the rings share them with the surface around; it may be empty.
template <class P, class R, class Weights>
NestedRings<P> nested_rings(SectorNet<P> net, std::span<const SpeedStep<R>> steps, const Weights& weights,
                            std::span<const BezierPatch<P>> first = {}) {
  NestedRings<P> result;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const SpeedStep<R>& step = steps[k];
    if (!step.change.empty()) net = changed_net(net, step.change);
    if (k == 0) {
      result.hole = border_patches(net, step.rules);
      for (std::size_t sector = 0; sector < first.size(); ++sector) {
        for (std::size_t i = 0; i < 4; ++i) {
          result.hole[sector][i] = first[sector][i];
          result.hole[sector][4 * i] = first[sector][4 * i];
        }
      }
    }
    net = refined_net(net, step.rules, weights(k));
    std::vector<BezierPatch<P>> inner = border_patches(net, step.rules);
    std::vector<RingSector<P>>& ring = result.rings.emplace_back();
    for (std::size_t sector = 0; sector < inner.size(); ++sector)
      ring.push_back(ring_sector(result.hole[sector], inner[sector], step.rules.sigma));
    result.hole = std::move(inner);
  }
  return result;
}

}  // namespace subdiv
