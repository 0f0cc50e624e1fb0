#include "analysis/jsr/leading_eigenpairs.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace subdiv {
namespace {

std::complex<double> to_double(acb_srcptr x) {
  return {arf_get_d(arb_midref(acb_realref(x)), ARF_RND_NEAR),
          arf_get_d(arb_midref(acb_imagref(x)), ARF_RND_NEAR)};
}

void drop_imaginary_parts(BallMatrix& a) {
  for (long i = 0; i < a.rows(); ++i) {
    for (long j = 0; j < a.columns(); ++j) arb_zero(acb_imagref(a.at(i, j)));
  }
}

/// The column scaled so that its largest entry is 1.
BallMatrix normalised_column(const BallMatrix& a, long column, long precision) {
  BallMatrix result(a.rows(), 1);
  long largest = 0;
  for (long i = 0; i < a.rows(); ++i) {
    if (std::abs(to_double(a.at(i, column))) > std::abs(to_double(a.at(largest, column)))) largest = i;
  }
  for (long i = 0; i < a.rows(); ++i)
    acb_div(result.at(i, 0), a.at(i, column), a.at(largest, column), precision);
  acb_one(result.at(largest, 0));
  acb_mat_get_mid(result.raw(), result.raw());
  return result;
}

/// From real approximations, the fixed-point map of the enclosure keeps the real vectors within the balls:
/// the eigenpair that it proves can be taken real, and the imaginary parts of the balls dropped.
bool enclose(const BallMatrix& matrix, const BallMatrix& value, const BallMatrix& vector, bool real,
             long precision, Eigenpair& result) {
  acb_mat_eig_enclosure_rump(result.value.at(0, 0), nullptr, result.vector.raw(), matrix.raw(),
                             value.at(0, 0), vector.raw(), precision);
  if (!result.value.is_finite() || !result.vector.is_finite()) return false;
  if (real) {
    drop_imaginary_parts(result.value);
    drop_imaginary_parts(result.vector);
  }
  return true;
}

}  // namespace

std::vector<Eigenpair> leading_eigenpairs(const BallMatrix& matrix, double tolerance, long precision) {
  const long n = matrix.rows();
  BallMatrix centre(n, n);
  acb_mat_get_mid(centre.raw(), matrix.raw());
  BallMatrix values(n, 1);
  BallMatrix vectors(n, n);
  acb_mat_approx_eig_qr(values.at(0, 0), nullptr, vectors.raw(), centre.raw(), nullptr, 0, precision);

  double largest = 0;
  for (long i = 0; i < n; ++i) largest = std::max(largest, std::abs(to_double(values.at(i, 0))));
  std::vector<Eigenpair> result;
  for (long i = 0; i < n; ++i) {
    const std::complex<double> approximate = to_double(values.at(i, 0));
    if (std::abs(approximate) < largest * (1 - tolerance)) continue;
    const bool real = std::abs(approximate.imag()) <= tolerance * largest;
    if (!real && approximate.imag() < 0) continue;
    BallMatrix value(1, 1);
    acb_get_mid(value.at(0, 0), values.at(i, 0));
    BallMatrix vector = normalised_column(vectors, i, precision);
    if (real) {
      drop_imaginary_parts(value);
      drop_imaginary_parts(vector);
    }
    Eigenpair pair{BallMatrix(1, 1), BallMatrix(n, 1)};
    if (enclose(matrix, value, vector, real, precision, pair)) result.push_back(std::move(pair));
  }
  return result;
}

}  // namespace subdiv
