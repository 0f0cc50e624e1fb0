#pragma once

#include <stdexcept>
#include <string>

#include "schemes/algebra/matrix.h"
#include "schemes/index_window.h"
#include "schemes/mask.h"

namespace subdiv {

/// The control points whose basis functions' closed supports contain the parameter 0: -last/(m-1) ..
/// -first/(m-1). The refined points of these indices depend on no other control points, and every eigenvalue
/// other than 0 of any larger such window is an eigenvalue of this one, with the same multiplicity. `padding`
/// adds points at both ends: the 9 x 9 matrix of js-report 3 for seven coefficients is this window (7 points)
/// padded by 1. Throws std::domain_error for an arity below 2 or when no basis function reaches 0.
template <class R>
IndexWindow vertex_window(const Mask<R>& mask, int padding = 0) {
  if (mask.arity < 2) throw std::domain_error("a subdivision matrix needs an arity of at least 2");
  const IndexWindow window{-floor_divide(mask.symbol.last(), mask.arity - 1),
                           floor_divide(-mask.symbol.first(), mask.arity - 1)};
  if (mask.symbol.is_zero() || window.size() < 1)
    throw std::domain_error("no control point reaches the parameter 0");
  return {window.first - padding, window.last + padding};
}

/// The square matrix B_ij = a_{i - m j}, i and j in the window: one step of the scheme near the parameter 0,
/// P' = B P. Row and column 0 belong to index window.first. Throws std::domain_error when refined points of
/// the window depend on control points outside it.
template <class R>
Matrix<R> subdivision_matrix(const Mask<R>& mask, const IndexWindow& window) {
  const int m = mask.arity;
  const int lowest = -floor_divide(mask.symbol.last() - window.first, m);
  const int highest = floor_divide(window.last - mask.symbol.first(), m);
  if (lowest < window.first || highest > window.last) {
    throw std::domain_error("the indices " + std::to_string(window.first) + " .. " +
                            std::to_string(window.last) + " are not closed under refinement");
  }
  Matrix<R> result = zero_matrix<R>(window.size(), window.size());
  for (int i = window.first; i <= window.last; ++i) {
    for (int j = window.first; j <= window.last; ++j) {
      result(i - window.first, j - window.first) = mask.symbol[i - m * j];
    }
  }
  return result;
}

/// The matrix of the smallest window that carries the whole spectrum.
template <class R>
Matrix<R> subdivision_matrix(const Mask<R>& mask) {
  return subdivision_matrix(mask, vertex_window(mask));
}

}  // namespace subdiv
