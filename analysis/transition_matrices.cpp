#include "analysis/transition_matrices.h"

#include "analysis/jsr/ball_matrix.h"

namespace subdiv {
namespace {

/// C with C b = sigma^factors b for polynomials b of the given number of coefficients.
Matrix<Interval> convolution(int arity, int factors, int columns) {
  const Laurent<Interval> sigma = pow(smoothing_factor<Interval>(arity), factors);
  Matrix<Interval> result = zero_matrix<Interval>(columns + sigma.size() - 1, columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (int i = 0; i < sigma.size(); ++i) result(i + j, j) = sigma[i];
  }
  return result;
}

Interval real_part(const BallMatrix& column, long i, long precision) {
  Interval result = Interval(0).with_precision(precision);
  arb_set(result.raw(), acb_realref(column.at(i, 0)));
  return result;
}

}  // namespace

NormalForm<Interval> normal_form(const Mask<Interval>& mask, int factors) {
  const auto refuse = [] { throw std::domain_error("the coefficients contradict the assumed sum rules"); };
  const int length = mask.symbol.size() - factors * (mask.arity - 1);
  if (length < 1) throw std::domain_error("so many sum rules force the symbol to be zero");
  if (factors == 0) return normal_form(mask.arity, 0, mask.symbol);
  // b = (C^T C)^-1 C^T a: of all left inverses of C, the least squares spread the errors of a little.
  constexpr long bits_per_factor = 8;  // what the conditioning of C^T C may cost
  const long precision = Interval::default_precision + bits_per_factor * factors;
  const Matrix<Interval> c = convolution(mask.arity, factors, length);
  const Matrix<Interval> transposed = c.transpose();
  const std::optional<BallMatrix> inverse =
      solve(multiply(BallMatrix(transposed), BallMatrix(c), precision), BallMatrix(transposed), precision);
  if (!inverse) throw std::domain_error("so many sum rules are beyond the working precision");
  Matrix<Interval> values(mask.symbol.size(), 1);
  for (int i = 0; i < mask.symbol.size(); ++i)
    values(i, 0) = mask.symbol.coefficients()[static_cast<std::size_t>(i)];
  const BallMatrix a(values);
  // a - C b vanishes for the masks in question: C (C^T C)^-1 C^T projects onto them.
  BallMatrix projector = multiply(BallMatrix(c), *inverse, precision);
  for (long i = 0; i < projector.rows(); ++i)
    acb_sub_si(projector.at(i, i), projector.at(i, i), 1, precision);
  const BallMatrix rest = multiply(projector, a, precision);
  for (long i = 0; i < rest.rows(); ++i) {
    if (!real_part(rest, i, precision).contains_zero()) refuse();
  }
  const BallMatrix b = multiply(*inverse, a, precision);
  std::vector<Interval> cofactor;
  for (long i = 0; i < b.rows(); ++i) cofactor.push_back(real_part(b, i, Interval::default_precision));
  return normal_form(mask.arity, factors, Laurent<Interval>(mask.symbol.first(), std::move(cofactor)));
}

}  // namespace subdiv
