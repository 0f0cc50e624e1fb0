#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/algebra/rational.h"

namespace subdiv::sample {

/// Numbers k/64, |k| <= 640, at all places of two rings.
template <class P>
SectorNet<P> random_net(int valence, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<P> points;
  for (std::size_t i = 0; i < 1 + static_cast<std::size_t>(valence) * SectorNet<P>::places; ++i)
    points.push_back(P(static_cast<int>(random() % 1281U) - 640) / P(64));
  return {valence, std::move(points)};
}

}  // namespace subdiv::sample
