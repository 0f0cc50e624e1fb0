#pragma once

#include "schemes/adjustable_speed/speed_rules.h"

namespace subdiv {

/// Where the vertex of an adjustable speed net tends to: 1 - beta - gamma of itself, beta of the mean of the
/// points (1, 0) of all sectors, gamma of the mean of the (1, 1); beta and gamma returned, the left
/// eigenvector to the eigenvalue 1 for the vertex's rule `weights` (Karciauskas & Peters, section III).
template <class R>
VertexWeights<R> limit_weights(const R& sigma, const VertexWeights<R>& weights) {
  const R q = R(1) - sigma;
  const auto& [beta, gamma] = weights;
  const R square = sigma * sigma;
  const R below =
      (square + R(3) * q) * beta + (R(2) * q * q + q + R(1)) * gamma + sigma * (square + R(2) * q);
  return {(R(2) * q * (beta + gamma) + sigma * beta) / below,
          (q * q * (beta + R(2) * gamma) + sigma * gamma) / below};
}

}  // namespace subdiv
