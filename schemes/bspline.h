#pragma once

#include <stdexcept>

#include "schemes/mask.h"

namespace subdiv {

/// Uniform B-spline of degree d >= 0: 2 ((1+z)/2)^(d+1), one doubling and d averagings (Lane & Riesenfeld
/// 1980). Indices start at -floor((d+1)/2): odd degrees are centred at 0, even degrees at 1/2. Throws
/// std::domain_error for d < 0.
template <class R>
Mask<R> bspline(int degree) {
  if (degree < 0) throw std::domain_error("a B-spline's degree is at least 0");
  const Laurent<R> average(0, {fraction<R>(1, 2), fraction<R>(1, 2)});
  return {2, shift(Laurent<R>(2) * pow(average, degree + 1), -((degree + 1) / 2))};
}

}  // namespace subdiv
