#pragma once

#include <optional>

#include <Eigen/Core>

#include <acb_mat.h>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// A matrix of complex balls (pairs of real intervals): a value over Arb's acb_mat. Every operation is
/// outward-rounded at the precision it is given: the result encloses the result for all matrices in the
/// operands. Real entries have the imaginary part exactly 0, and stay so under +, - and *.
class BallMatrix {
 public:
  BallMatrix() : BallMatrix(0, 0) {}
  /// A zero matrix.
  BallMatrix(long rows, long columns) { acb_mat_init(value_, rows, columns); }
  explicit BallMatrix(const Matrix<Interval>& real);  ///< of intervals, real
  /// The exact values of finite doubles.
  explicit BallMatrix(const Eigen::MatrixXcd& values);

  BallMatrix(const BallMatrix& o) : BallMatrix(o.rows(), o.columns()) { acb_mat_set(value_, o.value_); }
  BallMatrix(BallMatrix&& o) noexcept : BallMatrix(0, 0) { acb_mat_swap(value_, o.value_); }
  BallMatrix& operator=(BallMatrix o) noexcept {
    acb_mat_swap(value_, o.value_);
    return *this;
  }
  ~BallMatrix() { acb_mat_clear(value_); }

  [[nodiscard]] long rows() const { return acb_mat_nrows(value_); }
  [[nodiscard]] long columns() const { return acb_mat_ncols(value_); }
  [[nodiscard]] acb_ptr at(long i, long j) { return acb_mat_entry(value_, i, j); }
  [[nodiscard]] acb_srcptr at(long i, long j) const { return acb_mat_entry(value_, i, j); }
  [[nodiscard]] const acb_mat_struct* raw() const { return value_; }
  [[nodiscard]] acb_mat_struct* raw() { return value_; }

  /// The midpoints of the balls, rounded to double.
  [[nodiscard]] Eigen::MatrixXcd midpoints() const;
  [[nodiscard]] bool is_finite() const { return acb_mat_is_finite(value_) != 0; }
  /// The complex conjugate, entry by entry.
  [[nodiscard]] BallMatrix conjugate() const;

 private:
  acb_mat_t value_;
};

/// The product, rounded outwards at the precision in bits.
[[nodiscard]] BallMatrix multiply(const BallMatrix& a, const BallMatrix& b, long precision);
/// Each entry divided by a real number.
[[nodiscard]] BallMatrix divide(const BallMatrix& a, const Interval& by);
/// The x with a x = b for square a; nothing when a is not known to be invertible.
[[nodiscard]] std::optional<BallMatrix> solve(const BallMatrix& a, const BallMatrix& b, long precision);

/// The absolute value of a complex ball.
[[nodiscard]] Interval modulus(acb_srcptr x, long precision);
/// Operator norms: the largest column sum and row sum of moduli.
[[nodiscard]] Interval one_norm(const BallMatrix& a, long precision);
/// The largest row sum of absolute values, which is the norm induced by the largest component.
[[nodiscard]] Interval infinity_norm(const BallMatrix& a, long precision);
/// An upper bound of the Euclidean operator norm, from traces of powers of A^* A: |A|^(2k) <= tr (A^* A)^k.
[[nodiscard]] Interval euclidean_norm_bound(const BallMatrix& a, long precision);

}  // namespace subdiv
