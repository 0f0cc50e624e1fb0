#include "analysis/jsr/single_matrix.h"

#include "analysis/jsr/ball_matrix.h"

namespace subdiv {
namespace {

/// Balls that contain the eigenvalues, n x 1; nothing when that failed.
std::optional<BallMatrix> eigenvalues(const BallMatrix& matrix, long precision) {
  const long n = matrix.rows();
  BallMatrix approximate(n, 1);
  BallMatrix vectors(n, n);
  BallMatrix result(n, 1);
  acb_mat_approx_eig_qr(approximate.at(0, 0), nullptr, vectors.raw(), matrix.raw(), nullptr, 0, precision);
  const int success =
      acb_mat_eig_multiple(result.at(0, 0), matrix.raw(), approximate.at(0, 0), vectors.raw(), precision);
  if (success == 0 || !result.is_finite()) return std::nullopt;
  return result;
}

/// Whether the eigenvalues that may have the largest modulus are simple.
bool leading_ones_are_simple(const BallMatrix& values, const Interval& radius, long precision) {
  for (long i = 0; i < values.rows(); ++i) {
    if (!modulus(values.at(i, 0), precision).overlaps(radius)) continue;
    for (long j = 0; j < values.rows(); ++j) {
      if (i != j && acb_overlaps(values.at(i, 0), values.at(j, 0)) != 0) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<BlockRadius> single_matrix_radius(const MatrixFamily& family) {
  const std::optional<BallMatrix> values = eigenvalues(BallMatrix(family.balls[0]), family.precision);
  if (!values) return std::nullopt;
  BlockRadius result;
  result.lower = Interval(0).with_precision(family.precision);
  for (long i = 0; i < values->rows(); ++i)
    result.lower = max(result.lower, modulus(values->at(i, 0), family.precision));
  result.upper = result.lower;
  result.closed = true;
  const bool positive = certainly_positive(result.lower);
  if (positive && leading_ones_are_simple(*values, result.lower, family.precision))
    result.bounded = Decision::yes;
  result.words.push_back({0});
  return result;
}

}  // namespace subdiv
