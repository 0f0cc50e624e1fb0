#include "analysis/jsr/ball_matrix.h"

namespace subdiv {

BallMatrix::BallMatrix(const Matrix<Interval>& real) : BallMatrix(real.rows(), real.cols()) {
  for (long i = 0; i < rows(); ++i) {
    for (long j = 0; j < columns(); ++j) acb_set_arb(at(i, j), real(i, j).raw());
  }
}

BallMatrix::BallMatrix(const Eigen::MatrixXcd& values) : BallMatrix(values.rows(), values.cols()) {
  for (long i = 0; i < rows(); ++i) {
    for (long j = 0; j < columns(); ++j) acb_set_d_d(at(i, j), values(i, j).real(), values(i, j).imag());
  }
}

Eigen::MatrixXcd BallMatrix::midpoints() const {
  Eigen::MatrixXcd result(rows(), columns());
  for (long i = 0; i < rows(); ++i) {
    for (long j = 0; j < columns(); ++j) {
      result(i, j) = {arf_get_d(arb_midref(acb_realref(at(i, j))), ARF_RND_NEAR),
                      arf_get_d(arb_midref(acb_imagref(at(i, j))), ARF_RND_NEAR)};
    }
  }
  return result;
}

BallMatrix BallMatrix::conjugate() const {
  BallMatrix result(rows(), columns());
  for (long i = 0; i < rows(); ++i) {
    for (long j = 0; j < columns(); ++j) acb_conj(result.at(i, j), at(i, j));
  }
  return result;
}

BallMatrix multiply(const BallMatrix& a, const BallMatrix& b, long precision) {
  BallMatrix result(a.rows(), b.columns());
  acb_mat_mul(result.raw(), a.raw(), b.raw(), precision);
  return result;
}

BallMatrix divide(const BallMatrix& a, const Interval& by) {
  BallMatrix result(a.rows(), a.columns());
  for (long i = 0; i < a.rows(); ++i) {
    for (long j = 0; j < a.columns(); ++j) {
      acb_div_arb(result.at(i, j), a.at(i, j), by.raw(), by.working_precision());
    }
  }
  return result;
}

std::optional<BallMatrix> solve(const BallMatrix& a, const BallMatrix& b, long precision) {
  BallMatrix result(a.columns(), b.columns());
  if (acb_mat_solve(result.raw(), a.raw(), b.raw(), precision) == 0 || !result.is_finite())
    return std::nullopt;
  return result;
}

Interval modulus(acb_srcptr x, long precision) {
  Interval result = Interval(0).with_precision(precision);
  acb_abs(result.raw(), x, precision);
  return result;
}

Interval one_norm(const BallMatrix& a, long precision) {
  Interval largest = Interval(0).with_precision(precision);
  for (long j = 0; j < a.columns(); ++j) {
    Interval sum = Interval(0).with_precision(precision);
    for (long i = 0; i < a.rows(); ++i) sum += modulus(a.at(i, j), precision);
    largest = max(largest, sum);
  }
  return largest;
}

Interval infinity_norm(const BallMatrix& a, long precision) {
  Interval largest = Interval(0).with_precision(precision);
  for (long i = 0; i < a.rows(); ++i) {
    Interval sum = Interval(0).with_precision(precision);
    for (long j = 0; j < a.columns(); ++j) sum += modulus(a.at(i, j), precision);
    largest = max(largest, sum);
  }
  return largest;
}

Interval euclidean_norm_bound(const BallMatrix& a, long precision) {
  BallMatrix adjoint(a.columns(), a.rows());
  acb_mat_transpose(adjoint.raw(), a.conjugate().raw());
  BallMatrix power = multiply(adjoint, a, precision);
  Interval best = infinity_norm(power, precision);  // its root bounds the norm: the product is Hermitian
  acb_t trace;
  acb_init(trace);
  constexpr ulong squarings = 30;
  for (ulong k = 0; k <= squarings; ++k) {
    acb_mat_trace(trace, power.raw(), precision);
    Interval bound = modulus(trace, precision);
    arb_root_ui(bound.raw(), bound.raw(), ulong{1} << k, precision);
    if (!bound.is_finite()) break;
    if (bound.upper() < best.upper()) best = bound;
    power = multiply(power, power, precision);
  }
  acb_clear(trace);
  return sqrt(best);
}

}  // namespace subdiv
