#include "analysis/jsr/matrix_family.h"

#include <stdexcept>
#include <utility>

namespace subdiv {
namespace {

template <class R>
void require_family(const std::vector<Matrix<R>>& matrices) {
  if (matrices.empty()) throw std::domain_error("a family of matrices must not be empty");
  for (const Matrix<R>& t : matrices) {
    if (t.rows() == 0 || t.rows() != t.cols() || t.rows() != matrices[0].rows()) {
      throw std::domain_error("the matrices of a family must be square and of one size");
    }
  }
}

}  // namespace

MatrixFamily matrix_family(std::vector<Matrix<Rational>> matrices, long precision) {
  require_family(matrices);
  MatrixFamily result{{}, std::move(matrices), precision};
  for (const Matrix<Rational>& t : result.exact) {
    Matrix<Interval> ball(t.rows(), t.cols());
    for (Eigen::Index i = 0; i < t.size(); ++i) ball.data()[i] = Interval(t.data()[i], precision);
    result.balls.push_back(std::move(ball));
  }
  return result;
}

MatrixFamily matrix_family(std::vector<Matrix<Interval>> matrices, long precision) {
  require_family(matrices);
  for (const Matrix<Interval>& t : matrices) {
    for (Eigen::Index i = 0; i < t.size(); ++i) {
      if (!t.data()[i].is_finite()) throw std::domain_error("a matrix has an unbounded entry");
    }
  }
  return {std::move(matrices), {}, precision};
}

std::vector<Eigen::MatrixXd> to_double(const std::vector<Matrix<Interval>>& matrices) {
  std::vector<Eigen::MatrixXd> result;
  for (const Matrix<Interval>& t : matrices) {
    result.emplace_back(t.unaryExpr([](const Interval& x) { return x.to_double(); }));
  }
  return result;
}

AdaptedFamily adapt(const MatrixFamily& family, const Eigen::MatrixXd& basis) {
  AdaptedFamily result{basis, {}, {}, family.precision};
  const BallMatrix b(Eigen::MatrixXcd(basis.cast<std::complex<double>>()));
  for (const Matrix<Interval>& t : family.balls) {
    std::optional<BallMatrix> similar =
        solve(b, multiply(BallMatrix(t), b, family.precision), family.precision);
    if (!similar) throw std::domain_error("the basis is singular to working precision");
    result.approximate.emplace_back(similar->midpoints().real());
    result.balls.push_back(std::move(*similar));
  }
  return result;
}

}  // namespace subdiv
