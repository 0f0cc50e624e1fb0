#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/real_set.h"
#include "schemes/algebra/matrix.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/mask.h"

namespace subdiv {

/// Retrofitting: control points P whose limit points L P are given points C (js-report 5; jsplines 5), by the
/// iteration P <- P + (C - L P), P = C at first, with L the rows of limit masks. The error is multiplied by I
/// - L, a convolution, whose eigenvalues are 1 - L(e^{iw}): w in [0, 2 pi) for bounded data of infinite
/// length, w = 2 pi k / n, k = 0 .. n-1, for closed loops of n points. The iteration converges for all data
/// exactly when every one is below 1 in modulus. Sets are those of a single free parameter; poles of the
/// limit mask do not belong to them.

/// L(e^{iw}) at cos w = c for a symmetric mask, over any ring: a polynomial in c, by Chebyshev's recursion.
/// The iteration's eigenvalue is 1 minus it. Throws std::domain_error when the mask is not symmetric about
/// index 0.
template <class R>
R symbol_at_cosine(const Laurent<R>& mask, const R& c) {
  if (!(mask == reverse(mask))) throw std::domain_error("the mask is not symmetric about index 0");
  R value = mask[0];
  R before(1);
  R cosine = c;  // cos k w
  for (int k = 1; k <= mask.last(); ++k) {
    value = value + R(2) * mask[k] * cosine;
    R next = R(2) * c * cosine - before;
    before = std::move(cosine);
    cosine = std::move(next);
  }
  return value;
}

/// The parameter values for which the iteration converges for bounded infinite data at a geometric rate: the
/// spectral radius of I - L over the infinite matrix is below 1.
[[nodiscard]] RealSet retrofit_range(const Laurent<RationalFunction>& limit_mask, int parameter = 0);

/// The same for closed loops of n >= 1 points (std::domain_error for fewer), shorter than the mask or not.
[[nodiscard]] RealSet retrofit_range_of_loops(const Laurent<RationalFunction>& limit_mask, int n,
                                              int parameter = 0);

/// The parameter values for which L is invertible on bounded infinite data: L(e^{iw}) never vanishes.
[[nodiscard]] RealSet solvable_range(const Laurent<RationalFunction>& limit_mask, int parameter = 0);

/// The parameter values, ascending, for which the direct solve L P = C of closed loops of n points is
/// singular.
[[nodiscard]] std::vector<Algebraic> singular_for_loops(const Laurent<RationalFunction>& limit_mask, int n,
                                                        int parameter = 0);

/// The parameter values for which alternating data P_i = (-1)^i, cos w = -1, shrink most slowly or grow
/// fastest: |1 - L|^2 at every other frequency is smaller, by at least a positive multiple of 1 + cos w.
/// There the spectral radius is |1 - L(-1)|, a function of the parameter in closed form.
[[nodiscard]] RealSet alternation_dominates(const Laurent<RationalFunction>& limit_mask, int parameter = 0);

/// The exact spectral radius of I - L over the infinite matrix: the factor by which errors shrink (or grow) a
/// step.
[[nodiscard]] Algebraic contraction_rate(const Laurent<Rational>& limit_mask);

/// The same for closed loops of n points.
[[nodiscard]] Algebraic contraction_rate_of_loops(const Laurent<Rational>& limit_mask, int n);

/// The limit points of a closed loop: element i is the sum of L_j P_{i+j}, indices modulo the number of
/// points.
template <class R>
std::vector<R> apply_to_loop(const Laurent<R>& mask, const std::vector<R>& loop) {
  const int n = static_cast<int>(loop.size());
  std::vector<R> result;
  for (int i = 0; i < n; ++i) {
    R value(0);
    for (int j = mask.first(); j <= mask.last(); ++j) {
      value = value + mask[j] * loop[static_cast<std::size_t>(residue(i + j, n))];
    }
    result.push_back(std::move(value));
  }
  return result;
}

/// One step P + (C - L P) for one coordinate of a closed loop; both have the same size (std::domain_error).
template <class R>
std::vector<R> retrofit_step(const Laurent<R>& limit_mask, const std::vector<R>& current,
                             const std::vector<R>& target) {
  if (current.size() != target.size()) throw std::domain_error("retrofitting needs loops of the same size");
  std::vector<R> result = apply_to_loop(limit_mask, current);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = current[i] + (target[i] - result[i]);
  return result;
}

/// The loop whose limit points are the target, one coordinate; std::domain_error where the system is
/// singular.
template <ExactRing R>
std::vector<R> retrofit_directly(const Laurent<R>& limit_mask, const std::vector<R>& target) {
  const int n = static_cast<int>(target.size());
  Matrix<R> system = zero_matrix<R>(n, n);
  Vector<R> right(n);
  for (int i = 0; i < n; ++i) {
    for (int j = limit_mask.first(); j <= limit_mask.last(); ++j) {
      R& entry = system(i, residue(i + j, n));
      entry = entry + limit_mask[j];
    }
    right(i) = target[static_cast<std::size_t>(i)];
  }
  const auto solution = solve(system, right);
  if (!solution) throw std::domain_error("retrofitting: the limit masks of this loop are linearly dependent");
  return std::vector<R>(solution->data(), solution->data() + n);
}

}  // namespace subdiv
