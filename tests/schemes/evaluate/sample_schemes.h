#pragma once

#include <cstddef>
#include <vector>

#include "schemes/algebra/rational.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "schemes/mask.h"

namespace subdiv::testing {

using Rationals = std::vector<Rational>;

inline Rational q(long p, long denominator = 1) { return {p, denominator}; }

inline Scheme<Rational> j(const Rational& s) { return stationary("J", jspline(s)); }

/// The control points 2^i: no value arises from another index.
inline Rationals powers(int n) {
  Rationals points;
  for (int i = 0; i < n; ++i) points.push_back(pow(q(2), i));
  return points;
}

/// Primal and dual, interpolating and not, mixed, shifted, of one tap a rule and of many.
inline std::vector<Scheme<Rational>> binary_and_ternary_schemes() {
  return {
      j(q(0)),
      j(q(1, 2)),
      j(q(3, 2)),
      mixed(j(q(-33, 26)), j(q(3, 2))),
      mixed(stationary("J", jspline(q(-7, 4), q(59, 52))), j(q(3, 2))),
      mixed(mixed(j(q(1)), stationary("B1", bspline<Rational>(1))), stationary("B6", bspline<Rational>(6))),
      stationary("B0", bspline<Rational>(0)),
      stationary("B2", bspline<Rational>(2)),
      stationary("B9", bspline<Rational>(9)),
      stationary("four-point", four_point(q(1, 16))),
      stationary("8 points", deslauriers_dubuc<Rational>(8)),
      stationary("late", Mask<Rational>{2, Laurent<Rational>(3, {q(1, 2), q(1), q(1, 2)})}),
      stationary("early", Mask<Rational>{2, Laurent<Rational>(-9, {q(1, 4), q(3, 4), q(3, 4), q(1, 4)})}),
      stationary("ternary", Mask<Rational>{3, Laurent<Rational>(-4, {q(1, 9), q(1, 3), q(5, 9), q(1), q(5, 9),
                                                                     q(1, 3), q(1, 9)})})};
}

}  // namespace subdiv::testing
