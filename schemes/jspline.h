#pragma once

#include <vector>

#include "schemes/mask.h"

namespace subdiv {

/// J_{a,b} (Rossignac & Schaefer, J-splines, section 1): even points (a, 8-2a, a)/8 of P(j-1), P(j), P(j+1);
/// odd points (b-1, 9-b, 9-b, b-1)/16 of P(j-1) .. P(j+2). Mask indices -3 .. 3.
template <class R>
Mask<R> jspline(const R& a, const R& b) {
  const R outer = (b - R(1)) * fraction<R>(1, 16);
  const R side = a * fraction<R>(1, 8);
  const R inner = (R(9) - b) * fraction<R>(1, 16);
  const R centre = R(1) - a * fraction<R>(1, 4);
  return {2, Laurent<R>(-3, {outer, side, inner, centre, inner, side, outer})};
}

/// J_s = J_{s,s}: (1 - s) times the four-point scheme plus s times the cubic B-spline scheme.
template <class R>
Mask<R> jspline(const R& s) {
  return jspline(s, s);
}

}  // namespace subdiv
