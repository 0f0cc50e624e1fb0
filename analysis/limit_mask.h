#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/subdivision_matrix.h"
#include "schemes/algebra/elimination.h"

namespace subdiv {

/// Limit and derivative masks: coefficients L_j, j the offset of a control point, with f^(d)(t) = sum of L_j
/// P_j for the limit f of the control points P_j. Index i after k steps stands at t = i / m^k and control
/// points are a unit apart, so that L_j = phi^(d)(t - j). The data P_j = j have f' = 1 and f(t) = t - tau,
/// tau the parametric shift: 0 for masks symmetric about index 0, an odd multiple of 1/2 for binary dual
/// ones, where t = 0 lies midway between two control points' parameters.

namespace detail {

/// Why m^-d has no left eigenvector v with v (j^e / e!) = 0 for e < d and = 1 for e = d; `shifted` is B -
/// m^-d I.
template <class R>
std::string missing_mask_reason(const Matrix<R>& shifted, int arity, int derivative) {
  const std::string name = derivative == 0   ? "limit mask"
                           : derivative == 1 ? "tangent mask"
                                             : "mask of derivative " + std::to_string(derivative);
  const std::string eigenvalue = pow(Rational(arity), -derivative).to_string();
  constexpr Eigen::Index long_mask = 64;  // beyond, a characteristic polynomial for a message is too slow
  if (shifted.rows() > long_mask) {
    return name + ": no eigenvector for the eigenvalue " + eigenvalue + ", or no unique one";
  }
  if constexpr (ExactRing<R>) {
    const std::vector<R> characteristic = characteristic_polynomial(shifted);
    std::size_t multiplicity = 0;
    while (is_zero(characteristic[multiplicity])) ++multiplicity;
    if (multiplicity == 0) return name + ": " + eigenvalue + " is no eigenvalue of the subdivision matrix";
    if (multiplicity > 1) {
      return name + ": " + eigenvalue +
             " is not a simple eigenvalue of the subdivision matrix (multiplicity " +
             std::to_string(multiplicity) + ")";
    }
    return name + ": too few sum rules hold for a derivative of this order";
  }
  return name + ": the eigenvector for " + eigenvalue + " is not determined in this arithmetic";
}

}  // namespace detail

/// The mask of f^(d)(0) of a stationary scheme, over any field, exact or not: the left eigenvector of the
/// subdivision matrix for m^-d, normalised so that the data j^e / e! give 0 for e < d and 1 for e = d
/// (Halstead, Kass & DeRose 1993; js-report 5, 11). It exists when m^-d is a simple eigenvalue and d + 1 sum
/// rules hold, as for schemes that converge to C^d limits and have linearly independent basis functions; when
/// the equations have no or more than one solution, std::domain_error says what fails (J_s at s = -6: 1 is a
/// double eigenvalue). Convergence itself is not examined. Over floating-point numbers a failure can go
/// unnoticed where rounding hides it; intervals never lie.
template <class R>
Laurent<R> derivative_mask(const Mask<R>& mask, int derivative) {
  const IndexWindow window = vertex_window(mask);
  const Eigen::Index n = window.size();
  const R eigenvalue = from_rational<R>(pow(Rational(mask.arity), -derivative));
  Matrix<R> shifted = subdivision_matrix(mask, window);
  for (Eigen::Index i = 0; i < n; ++i) shifted(i, i) = shifted(i, i) - eigenvalue;
  Matrix<R> system = zero_matrix<R>(n + derivative + 1, n);
  system.topRows(n) = shifted.transpose();
  for (Eigen::Index j = 0; j < n; ++j) {
    Rational power(1);
    for (int e = 0; e <= derivative; ++e) {
      system(n + e, j) = from_rational<R>(power);
      power *= Rational(window.first + j, e + 1);
    }
  }
  Vector<R> right = Vector<R>::Constant(n + derivative + 1, R(0));
  right(n + derivative) = R(1);
  const auto values = solve_linear(system, right);
  if (!values) throw std::domain_error(detail::missing_mask_reason(shifted, mask.arity, derivative));
  return Laurent<R>(window.first, std::vector<R>(values->data(), values->data() + n));
}

/// The mask of f(0) of a stationary scheme; coefficients add up to 1.
template <class R>
Laurent<R> limit_mask(const Mask<R>& mask) {
  return derivative_mask(mask, 0);
}

/// The mask of f'(0) of a stationary scheme: the data P_j = j give 1.
template <class R>
Laurent<R> tangent_mask(const Mask<R>& mask) {
  return derivative_mask(mask, 1);
}

/// The mask of f^(d)(index / m^level) of any scheme: refined point `index` after `level` steps of a primal
/// scheme. Steps before the repeating one pull the mask back, L_j = m^d sum over i of L'_i a_{i - m j}
/// (jsplines 6: products of symbols). Throws std::domain_error where the repeating step has no such mask.
template <class R>
Laurent<R> point_mask(const Scheme<R>& scheme, int level, int index, int derivative = 0) {
  const int m = scheme.arity();
  const int steps = std::max(level, static_cast<int>(scheme.steps.size()) - 1);
  for (int k = level; k < steps; ++k) index *= m;
  const R factor = from_rational<R>(pow(Rational(m), derivative));
  Laurent<R> mask = shift(derivative_mask(scheme.last(), derivative), index);
  for (int k = steps; k-- > 0;) {
    const Laurent<R>& symbol = scheme.step(static_cast<std::size_t>(k)).symbol;
    mask = factor * residue_class(mask * reverse(symbol), 0, m);
  }
  return mask;
}

/// Where control vertex 0 goes, as a combination of the control points.
template <class R>
Laurent<R> vertex_limit_mask(const Scheme<R>& scheme) {
  return point_mask(scheme, 0, 0);
}

/// The tangent at control vertex 0, d/dt at unit spacing of control points.
template <class R>
Laurent<R> vertex_tangent_mask(const Scheme<R>& scheme) {
  return point_mask(scheme, 0, 0, 1);
}

/// Where the first new point on the edge from control vertex 0 to 1 goes (t = 1/m), the mid-edge point of a
/// binary primal scheme.
template <class R>
Laurent<R> edge_limit_mask(const Scheme<R>& scheme) {
  return point_mask(scheme, 1, 1);
}

}  // namespace subdiv
