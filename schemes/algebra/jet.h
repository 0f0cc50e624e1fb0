#pragma once

#include <ceres/jet.h>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// Ceres Jets (a value with its gradient) as coefficients: any mask formula differentiated automatically.
template <int N>
struct RingTraits<ceres::Jet<double, N>> {
  static constexpr bool exact = false;
  static ceres::Jet<double, N> from_rational(const Rational& q) {
    return ceres::Jet<double, N>(q.to_double());
  }
  static bool is_zero(const ceres::Jet<double, N>& x) { return x.a == 0.0 && x.v.isZero(0.0); }
};

}  // namespace subdiv
