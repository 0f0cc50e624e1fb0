#pragma once

// Stands in for the header of the same name in the browser, where there are no intervals: exact fields only.

#include "schemes/algebra/matrix.h"

namespace subdiv {

template <ExactRing R>
std::optional<Vector<R>> solve_linear(const Matrix<R>& a, const Vector<R>& b) {
  return solve(a, b);
}

}  // namespace subdiv
