#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "schemes/algebra/matrix.h"

namespace subdiv {

/// How well x serves as a pivot: a lower bound of |x| as a double, 0 where a division by x is not known to be
/// possible.
template <class R>
double pivot_quality(const R& x) {
  if constexpr (ExactRing<R>) {
    return is_zero(x) ? 0.0 : 1.0;
  } else if constexpr (requires { x.a; }) {
    return std::abs(static_cast<double>(x.a));  // a Jet's value
  } else {
    return std::abs(static_cast<double>(x));
  }
}

/// The least absolute value in the ball: 0 when it contains 0.
inline double pivot_quality(const Interval& x) {
  mag_t bound;
  mag_init(bound);
  arb_get_mag_lower(bound, x.raw());
  const double result = mag_get_d(bound);
  mag_clear(bound);
  return result;
}

namespace detail {

/// Pivots of a floating-point elimination below this share of the largest entry count as rounding errors.
template <class R>
double pivot_threshold(const Matrix<R>& a) {
  if constexpr (std::is_same_v<R, Interval>) {
    return 0;
  } else {
    double largest = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) largest = std::max(largest, pivot_quality(a.data()[i]));
    constexpr double rounding_errors = 64;
    return rounding_errors * std::numeric_limits<double>::epsilon() * largest;
  }
}

/// Elimination with the best pivot of each column, for inexact fields.
template <class R>
std::optional<Vector<R>> solve_by_best_pivots(Matrix<R> a, Vector<R> b) {
  const double threshold = pivot_threshold(a);
  for (Eigen::Index column = 0; column < a.cols(); ++column) {
    Eigen::Index pivot = column;
    for (Eigen::Index i = column + 1; i < a.rows(); ++i) {
      if (pivot_quality(a(i, column)) > pivot_quality(a(pivot, column))) pivot = i;
    }
    if (pivot >= a.rows() || !(pivot_quality(a(pivot, column)) > threshold)) return std::nullopt;
    for (Eigen::Index j = 0; j < a.cols(); ++j) std::swap(a(column, j), a(pivot, j));
    std::swap(b(column), b(pivot));
    for (Eigen::Index i = column + 1; i < a.rows(); ++i) {
      const R factor = a(i, column) / a(column, column);
      for (Eigen::Index j = column + 1; j < a.cols(); ++j) a(i, j) = a(i, j) - factor * a(column, j);
      b(i) = b(i) - factor * b(column);
    }
  }
  Vector<R> x = Vector<R>::Constant(a.cols(), R(0));
  for (Eigen::Index i = a.cols(); i-- > 0;) {
    R value = b(i);
    for (Eigen::Index j = i + 1; j < a.cols(); ++j) value = value - a(i, j) * x(j);
    x(i) = value / a(i, i);
  }
  return x;
}

}  // namespace detail

/// The x with a x = b over any field, when a has full column rank; nothing otherwise. a may have more rows
/// than columns. Over an exact field, nothing too when the equations contradict each other. Over an inexact
/// one the rows with the best pivots are solved and the rest is taken on trust: intervals then enclose x
/// wherever a x = b has a solution.
template <class R>
std::optional<Vector<R>> solve_linear(const Matrix<R>& a, const Vector<R>& b) {
  if constexpr (ExactRing<R>) {
    return solve(a, b);
  } else {
    return detail::solve_by_best_pivots<R>(a, b);
  }
}

/// The same over Q, by FLINT's multimodular elimination: fast for large systems.
[[nodiscard]] std::optional<Vector<Rational>> solve_linear(const Matrix<Rational>& a,
                                                           const Vector<Rational>& b);

}  // namespace subdiv
