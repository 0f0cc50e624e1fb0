#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/algebra/ring.h"

// The one place where Eigen is told about the coefficient rings.
namespace subdiv::detail {
template <class R>
struct RingNumTraits : Eigen::GenericNumTraits<R> {
  using Real = R;
  using NonInteger = R;
  using Nested = R;
  using Literal = R;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = Eigen::HugeCost,
    AddCost = Eigen::HugeCost,
    MulCost = Eigen::HugeCost
  };
  static int digits10() { return 0; }
};
}  // namespace subdiv::detail

namespace Eigen {
template <>
struct NumTraits<subdiv::Rational> : subdiv::detail::RingNumTraits<subdiv::Rational> {};
template <>
struct NumTraits<subdiv::Polynomial> : subdiv::detail::RingNumTraits<subdiv::Polynomial> {};
template <>
struct NumTraits<subdiv::RationalFunction> : subdiv::detail::RingNumTraits<subdiv::RationalFunction> {};
template <>
struct NumTraits<subdiv::Algebraic> : subdiv::detail::RingNumTraits<subdiv::Algebraic> {};
template <>
struct NumTraits<subdiv::Interval> : subdiv::detail::RingNumTraits<subdiv::Interval> {};
}  // namespace Eigen

namespace subdiv {

/// A matrix over a ring, of any size.
template <class R>
using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;
/// A column over a ring, of any size.
template <class R>
using Vector = Eigen::Matrix<R, Eigen::Dynamic, 1>;

/// The zero matrix over any ring.
template <class R>
Matrix<R> zero_matrix(Eigen::Index rows, Eigen::Index columns) {
  return Matrix<R>::Constant(rows, columns, R(0));
}

/// The identity matrix of n rows.
template <class R>
Matrix<R> identity_matrix(Eigen::Index n) {
  Matrix<R> result = zero_matrix<R>(n, n);
  for (Eigen::Index i = 0; i < n; ++i) result(i, i) = R(1);
  return result;
}

/// The reduced row echelon form over an exact field, with the pivot columns.
template <ExactRing R>
std::pair<Matrix<R>, std::vector<Eigen::Index>> row_reduce(Matrix<R> a) {
  std::vector<Eigen::Index> pivots;
  Eigen::Index row = 0;
  for (Eigen::Index column = 0; column < a.cols() && row < a.rows(); ++column) {
    Eigen::Index pivot = row;
    while (pivot < a.rows() && is_zero(a(pivot, column))) ++pivot;
    if (pivot == a.rows()) continue;
    if (pivot != row) {
      for (Eigen::Index j = 0; j < a.cols(); ++j) std::swap(a(row, j), a(pivot, j));
    }
    const R inverse = R(1) / a(row, column);
    for (Eigen::Index j = column; j < a.cols(); ++j) a(row, j) = a(row, j) * inverse;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      if (i == row || is_zero(a(i, column))) continue;
      const R factor = a(i, column);
      for (Eigen::Index j = column; j < a.cols(); ++j) a(i, j) = a(i, j) - factor * a(row, j);
    }
    pivots.push_back(column);
    ++row;
  }
  return {std::move(a), std::move(pivots)};
}

/// A basis of { x : a x = 0 }, one vector a free column.
template <ExactRing R>
std::vector<Vector<R>> null_space(const Matrix<R>& a) {
  const auto [reduced, pivots] = row_reduce(a);
  std::vector<Vector<R>> basis;
  std::size_t next = 0;
  for (Eigen::Index column = 0; column < a.cols(); ++column) {
    if (next < pivots.size() && pivots[next] == column) {
      ++next;
      continue;
    }
    Vector<R> x = Vector<R>::Constant(a.cols(), R(0));
    x(column) = R(1);
    for (std::size_t i = 0; i < pivots.size(); ++i)
      x(pivots[i]) = -reduced(static_cast<Eigen::Index>(i), column);
    basis.push_back(std::move(x));
  }
  return basis;
}

/// The unique x with a x = b; nothing when there is none or more than one. a may have more rows than columns.
template <ExactRing R>
std::optional<Vector<R>> solve(const Matrix<R>& a, const Vector<R>& b) {
  Matrix<R> augmented(a.rows(), a.cols() + 1);
  augmented.leftCols(a.cols()) = a;
  augmented.col(a.cols()) = b;
  const auto [reduced, pivots] = row_reduce(std::move(augmented));
  if (static_cast<Eigen::Index>(pivots.size()) != a.cols() ||
      (!pivots.empty() && pivots.back() == a.cols())) {
    return std::nullopt;
  }
  return Vector<R>(reduced.col(a.cols()).head(a.cols()));
}

/// Coefficients c_0 .. c_n of det(x I - a) = sum c_i x^i, by Berkowitz' division-free recursion over leading
/// blocks (Faddeev-LeVerrier would divide by 2 .. n).
template <class R>
std::vector<R> characteristic_polynomial(const Matrix<R>& a) {
  std::vector<R> previous{R(1)};  // highest power first
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    // Toeplitz column of step k: 1, -a_kk, -r c, -r A c, -r A^2 c, ... with A the leading k x k block.
    std::vector<R> toeplitz{R(1), R(0) - a(k, k)};
    Vector<R> power = a.col(k).head(k);
    for (Eigen::Index i = 0; i < k; ++i) {
      R value(0);
      for (Eigen::Index j = 0; j < k; ++j) value = value + a(k, j) * power(j);
      toeplitz.push_back(R(0) - value);
      Vector<R> next = Vector<R>::Constant(k, R(0));
      for (Eigen::Index r = 0; r < k; ++r) {
        for (Eigen::Index c = 0; c < k; ++c) next(r) = next(r) + a(r, c) * power(c);
      }
      power = std::move(next);
    }
    std::vector<R> current(previous.size() + 1, R(0));
    for (std::size_t i = 0; i < current.size(); ++i) {
      for (std::size_t j = 0; j <= i && j < previous.size(); ++j) {
        current[i] = current[i] + toeplitz[i - j] * previous[j];
      }
    }
    previous = std::move(current);
  }
  return {previous.rbegin(), previous.rend()};
}

}  // namespace subdiv
