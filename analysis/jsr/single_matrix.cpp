#include "analysis/jsr/single_matrix.h"

#include <algorithm>
#include <optional>

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

/// |tr P| / n <= rho^k <= |P| for the powers P = T^k.
Interval by_squaring(const BallMatrix& matrix, long precision) {
  Interval lower = Interval(0).with_precision(precision);
  Interval upper = one_norm(matrix, precision);
  BallMatrix power = matrix;
  acb_t trace;
  acb_init(trace);
  constexpr ulong squarings = 56;
  for (ulong k = 0; k <= squarings; ++k) {
    const auto root = [&](Interval x) {
      arb_root_ui(x.raw(), x.raw(), ulong{1} << k, precision);
      return x;
    };
    const Interval above = root(one_norm(power, precision));
    if (above.is_finite() && above.upper() < upper.upper()) upper = above;
    acb_mat_trace(trace, power.raw(), precision);
    const Interval below = root(modulus(trace, precision) / Interval(power.rows()));
    if (below.is_finite() && below.lower() > lower.lower()) lower = below;
    power = multiply(power, power, precision);
  }
  acb_clear(trace);
  return Interval::hull(std::max(lower.lower(), Rational(0)), upper.upper());
}

}  // namespace

BlockRadius single_matrix_radius(const MatrixFamily& family) {
  const BallMatrix matrix(family.balls[0]);
  const std::optional<BallMatrix> values = eigenvalues(matrix, family.precision);
  BlockRadius result;
  result.lower = Interval(0).with_precision(family.precision);
  if (values) {
    for (long i = 0; i < values->rows(); ++i)
      result.lower = max(result.lower, modulus(values->at(i, 0), family.precision));
  } else {
    result.lower = by_squaring(matrix, family.precision);
  }
  result.upper = result.lower;
  result.closed = true;
  if (values && certainly_positive(result.lower) &&
      leading_ones_are_simple(*values, result.lower, family.precision)) {
    result.bounded = Decision::yes;
  }
  result.words.push_back({0});
  return result;
}

}  // namespace subdiv
