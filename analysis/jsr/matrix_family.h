#pragma once

#include <vector>

#include <Eigen/Core>

#include "analysis/jsr/ball_matrix.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// The square matrices T_0 .. T_{m-1} of one size whose joint spectral radius is asked for: balls that
/// contain them, and the matrices themselves when they are rational (else none).
struct MatrixFamily {
  std::vector<Matrix<Interval>> balls;           ///< contain the matrices
  std::vector<Matrix<Rational>> exact;           ///< the matrices when they are rational; else empty
  long precision = Interval::default_precision;  ///< of the balls, in bits

  [[nodiscard]] Eigen::Index dimension() const { return balls.front().rows(); }
  [[nodiscard]] std::size_t size() const { return balls.size(); }
};

/// A family of rational matrices, with balls of the precision in bits.
[[nodiscard]] MatrixFamily matrix_family(std::vector<Matrix<Rational>> matrices, long precision);
/// A family that is known as intervals alone.
[[nodiscard]] MatrixFamily matrix_family(std::vector<Matrix<Interval>> matrices, long precision);
/// The midpoints, rounded to double.
[[nodiscard]] std::vector<Eigen::MatrixXd> to_double(const std::vector<Matrix<Interval>>& matrices);

/// 2^-exponent T over the distinct matrices T of a family, with entries of moderate size.
struct ReducedFamily {
  MatrixFamily family;       ///< the scaled family
  long exponent = 0;         ///< of the power of two divided by
  std::vector<int> letters;  ///< the places of the matrices kept in the given family
};

/// Matrices that are the same up to sign are kept once: neither matters to the joint spectral radius. So that
/// floating point can be used on matrices of any size, the largest entry is brought near 1.
[[nodiscard]] ReducedFamily reduced(const MatrixFamily& family);

/// A family in the coordinates of a basis B of doubles, taken as exact numbers: balls of B^-1 T B, and their
/// midpoints.
struct AdaptedFamily {
  Eigen::MatrixXd basis;                         ///< B
  std::vector<BallMatrix> balls;                 ///< contain B^-1 T B
  std::vector<Eigen::MatrixXd> approximate;      ///< the midpoints of the balls
  long precision = Interval::default_precision;  ///< of the balls, in bits

  [[nodiscard]] Eigen::Index dimension() const { return basis.rows(); }
  [[nodiscard]] std::size_t size() const { return balls.size(); }
};

/// Throws std::domain_error when the basis is not known to be one.
[[nodiscard]] AdaptedFamily adapt(const MatrixFamily& family, const Eigen::MatrixXd& basis);

}  // namespace subdiv
