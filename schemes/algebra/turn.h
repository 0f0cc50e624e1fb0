#pragma once

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// cos(2 pi k/n) in the ring R, n >= 1: exact over the algebraic numbers, an enclosure over intervals,
/// rounded over double. Over the rationals and their polynomials only where it is rational, for n/gcd(k, n) =
/// 1, 2, 3, 4, 6; std::domain_error otherwise.
template <class R>
R cosine_of_turn(int k, int n) {
  const int common = std::gcd(k, n);
  const int numerator = ((k / common) % (n / common) + n / common) % (n / common);
  switch (n / common) {
    case 1:
      return R(1);
    case 2:
      return R(-1);
    case 3:
      return fraction<R>(-1, 2);
    case 4:
      return R(0);
    case 6:
      return fraction<R>(1, 2);
    default:
      throw std::domain_error("the cosine of " + std::to_string(numerator) + "/" +
                              std::to_string(n / common) + " of a turn is irrational");
  }
}

/// In double precision.
template <>
inline double cosine_of_turn<double>(int k, int n) {
  return std::cos(2 * std::numbers::pi * k / n);
}
/// Exact.
template <>
Algebraic cosine_of_turn<Algebraic>(int k, int n);
/// At the default precision.
template <>
Interval cosine_of_turn<Interval>(int k, int n);

}  // namespace subdiv
