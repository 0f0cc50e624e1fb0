#pragma once

#include <algorithm>
#include <vector>

#include "analysis/area_mask.h"
#include "schemes/jspline.h"

namespace subdiv {

/// *J_s.
template <class R>
Scheme<R> repeated_jspline(const R& s) {
  return stationary<R>("*J", jspline(s));
}

/// {J_{a,b}, *J_s}: one anticipation step.
template <class R>
Scheme<R> anticipated_jspline(const R& a, const R& b, const R& s) {
  return mixed(stationary<R>("J", jspline(a, b)), repeated_jspline(s));
}

/// m_k for k = 1 .. 5 minus those of the polygon itself, (1/2, 0, 0, 0, 0): masks are antisymmetric, and
/// J-splines' end there.
template <class R>
std::vector<R> area_residuals(const Scheme<R>& scheme) {
  const Laurent<R> difference = area_mask(scheme) - polygon_area_mask<R>();
  std::vector<R> result;
  for (int k = 1; k <= 5; ++k) result.push_back(difference[k]);
  return result;
}

/// The documents' objective: the largest |m_k - polygon's m_k|.
inline Rational largest_area_residual(const Scheme<Rational>& scheme) {
  Rational largest;
  for (const Rational& r : area_residuals(scheme)) largest = std::max(largest, abs(r));
  return largest;
}

}  // namespace subdiv
