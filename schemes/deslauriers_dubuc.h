#pragma once

#include <stdexcept>
#include <vector>

#include "schemes/mask.h"

namespace subdiv {

/// The interpolatory scheme of Deslauriers & Dubuc (1989) with an even number 2n of points: odd points are
/// the value at 1/2 of the polynomial of degree 2n-1 through the points at 1-n .. n. 4 points give the
/// four-point scheme. Throws std::domain_error unless `points` is even and at least 2.
template <class R>
Mask<R> deslauriers_dubuc(int points) {
  if (points < 2 || points % 2 != 0)
    throw std::domain_error("the number of points must be even and at least 2");
  const int n = points / 2;
  std::vector<R> mask(static_cast<std::size_t>(4 * n - 1), R(0));
  const int centre = 2 * n - 1;
  mask[static_cast<std::size_t>(centre)] = R(1);
  for (int j = 1 - n; j <= n; ++j) {
    Rational weight(1);  // the Lagrange polynomial of node j at 1/2
    for (int i = 1 - n; i <= n; ++i) {
      if (i != j) weight *= Rational(1 - 2 * i, 2 * (j - i));
    }
    // Point 1 of the refined sequence takes a_{1 - 2j} of P_j.
    mask[static_cast<std::size_t>(centre + 1 - 2 * j)] = from_rational<R>(weight);
  }
  return {2, Laurent<R>(-centre, std::move(mask))};
}

}  // namespace subdiv
