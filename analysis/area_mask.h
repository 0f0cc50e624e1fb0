#pragma once

#include <span>
#include <utility>

#include "analysis/inner_products.h"

namespace subdiv {

/// The area mask m_k = integral of phi(t) phi'(t - k) dt of a scheme's basis function: a closed control
/// polygon P_i has a limit curve of signed area 1/2 sum over i, k of m_k P_i x P_{i+k}. Antisymmetric; sum of
/// k m_k = 1. The polygon itself (linear subdivision) has m_1 = -m_{-1} = 1/2 (js-report 8, jsplines 8).
template <ExactRing R>
Laurent<R> area_mask(const Scheme<R>& scheme) {
  return inner_products(scheme, scheme, 1);
}

/// The area mask of polygons themselves.
template <class R>
Laurent<R> polygon_area_mask() {
  return Laurent<R>(-1, {fraction<R>(-1, 2), R(0), fraction<R>(1, 2)});
}

/// A_k = sum of P_i x P_{i+k} over a closed polygon of n points (indices modulo n), twice the signed area for
/// k = 1. The areas of all limit curves depend on the polygon through these numbers alone. A_{n+k} = A_k,
/// A_{-k} = -A_k.
template <class R>
R cross_sum(std::span<const std::pair<R, R>> polygon, int k) {
  const int n = static_cast<int>(polygon.size());
  R total(0);
  for (int i = 0; i < n; ++i) {
    const auto& p = polygon[static_cast<std::size_t>(i)];
    const auto& q = polygon[static_cast<std::size_t>(residue(i + k, n))];
    total = total + (p.first * q.second - p.second * q.first);
  }
  return total;
}

/// 1/2 sum of m_k A_k: the area that the mask assigns to a closed polygon.
template <class R>
R area(const Laurent<R>& mask, std::span<const std::pair<R, R>> polygon) {
  R total(0);
  for (int k = mask.first(); k <= mask.last(); ++k) total = total + mask[k] * cross_sum(polygon, k);
  return total * fraction<R>(1, 2);
}

}  // namespace subdiv
