#pragma once

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/adjustable_speed/speed_rules.h"

namespace subdiv {

/// The limit of the vertex when steps of one speed follow each other, as a combination of any of their nets:
/// 1 - beta - gamma of the vertex, beta of the mean of its edge neighbours, gamma of the mean of the (1, 1).
/// The left eigenvector to the eigenvalue 1 of the step with the given weights (Karciauskas & Peters:
/// Adjustable speed surface subdivision, 2009, section III, breve beta and breve gamma). `weights` must be
/// such that the steps converge, as those of vertex_weights are.
template <class R>
VertexWeights<R> limit_weights(const VertexWeights<R>& weights, const R& sigma) {
  const R& beta = weights.beta;
  const R& gamma = weights.gamma;
  const R q = R(1) - sigma;
  const R below = (sigma * sigma + R(3) * q) * beta + (R(2) * q * q + q + R(1)) * gamma +
                  sigma * (sigma * sigma + R(2) * q);
  return {(R(2) * q * (beta + gamma) + sigma * beta) / below,
          (q * q * (beta + R(2) * gamma) + sigma * gamma) / below};
}

/// The same for nets over uniform knots: Catmull-Clark's limit, 4/(n + 5) and 1/(n + 5) (Halstead, Kass &
/// DeRose 1993). Nets of any speed with the weights of vertex_weights have it, too.
template <class R>
VertexWeights<R> uniform_limit_weights(int valence) {
  const R below(valence + 5);
  return {R(4) / below, R(1) / below};
}

/// The combination of the net's inner points that such weights say.
template <class P, class R>
P vertex_point(const SectorNet<P>& net, const VertexWeights<R>& weights) {
  const R n(net.valence());
  P edges{};
  P faces{};
  for (int sector = 0; sector < net.valence(); ++sector) {
    add_weighted(edges, R(1) / n, net.at(sector, sector_place(1, 0).place));
    add_weighted(faces, R(1) / n, net.at(sector, sector_place(1, 1).place));
  }
  P sum{};
  add_weighted(sum, R(1) - weights.beta - weights.gamma, net.centre());
  add_weighted(sum, weights.beta, edges);
  add_weighted(sum, weights.gamma, faces);
  return sum;
}

}  // namespace subdiv
