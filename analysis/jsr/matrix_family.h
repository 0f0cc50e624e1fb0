#pragma once

#include <vector>

#include <Eigen/Core>

#include "analysis/jsr/ball_matrix.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// The square matrices T_0 .. T_{m-1} of one size whose joint spectral radius is asked for: balls that
/// contain them, and the matrices themselves when they are rational (else none).
struct MatrixFamily {
  std::vector<Matrix<Interval>> balls;
  std::vector<Matrix<Rational>> exact;
  long precision = Interval::default_precision;

  [[nodiscard]] Eigen::Index dimension() const { return balls.front().rows(); }
  [[nodiscard]] std::size_t size() const { return balls.size(); }
};

[[nodiscard]] MatrixFamily matrix_family(std::vector<Matrix<Rational>> matrices, long precision);
[[nodiscard]] MatrixFamily matrix_family(std::vector<Matrix<Interval>> matrices, long precision);
[[nodiscard]] std::vector<Eigen::MatrixXd> to_double(const std::vector<Matrix<Interval>>& matrices);

/// 2^-exponent T over the distinct matrices T of a family, with entries of moderate size.
struct ReducedFamily {
  MatrixFamily family;
  long exponent = 0;
  std::vector<int> letters;  // the places of the matrices kept in the given family
};

/// Matrices that are the same up to sign are kept once: neither matters to the joint spectral radius. So that
/// floating point can be used on matrices of any size, the largest entry is brought near 1.
[[nodiscard]] ReducedFamily reduced(const MatrixFamily& family);

/// A family in the coordinates of a basis B of doubles, taken as exact numbers: balls of B^-1 T B, and their
/// midpoints.
struct AdaptedFamily {
  Eigen::MatrixXd basis;
  std::vector<BallMatrix> balls;
  std::vector<Eigen::MatrixXd> approximate;
  long precision = Interval::default_precision;

  [[nodiscard]] Eigen::Index dimension() const { return basis.rows(); }
  [[nodiscard]] std::size_t size() const { return balls.size(); }
};

/// Throws std::domain_error when the basis is not known to be one.
[[nodiscard]] AdaptedFamily adapt(const MatrixFamily& family, const Eigen::MatrixXd& basis);

}  // namespace subdiv
