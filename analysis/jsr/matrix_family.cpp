#include "analysis/jsr/matrix_family.h"

#include <algorithm>
#include <cmath>
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

/// Whether the matrices with these indices are known to be the same up to sign.
bool same_up_to_sign(const MatrixFamily& family, std::size_t i, std::size_t j) {
  const auto equal = [](const auto& a, const auto& b, auto same) {
    return std::equal(a.data(), a.data() + a.size(), b.data(), same);
  };
  if (!family.exact.empty()) {
    const Matrix<Rational>& a = family.exact[i];
    const Matrix<Rational>& b = family.exact[j];
    return equal(a, b, [](const Rational& x, const Rational& y) { return x == y; }) ||
           equal(a, b, [](const Rational& x, const Rational& y) { return x == -y; });
  }
  const auto equal_points = [](const Interval& x, const Interval& y) {
    return arb_is_exact(x.raw()) != 0 && arb_equal(x.raw(), y.raw()) != 0;
  };
  return equal(family.balls[i], family.balls[j], equal_points) ||
         equal(family.balls[i], family.balls[j],
               [&](const Interval& x, const Interval& y) { return equal_points(x, -y); });
}

/// The least e for which all entries are at most 2^e; 0 when all are 0.
long binary_exponent(const MatrixFamily& family) {
  mag_t largest;
  mag_t entry;
  mag_init(largest);
  mag_init(entry);
  for (const Matrix<Interval>& t : family.balls) {
    for (Eigen::Index i = 0; i < t.size(); ++i) {
      arb_get_mag(entry, t.data()[i].raw());
      mag_max(largest, largest, entry);
    }
  }
  const long exponent =
      mag_is_zero(largest) != 0 ? 0 : static_cast<long>(std::ceil(mag_get_d_log2_approx(largest)));
  mag_clear(largest);
  mag_clear(entry);
  return exponent;
}

}  // namespace

ReducedFamily reduced(const MatrixFamily& family) {
  ReducedFamily result{{{}, {}, family.precision}, binary_exponent(family), {}};
  const Rational scale = Rational::power_of_two(-result.exponent);
  for (std::size_t i = 0; i < family.size(); ++i) {
    const bool known = std::any_of(result.letters.begin(), result.letters.end(), [&](int j) {
      return same_up_to_sign(family, i, static_cast<std::size_t>(j));
    });
    if (known) continue;
    result.letters.push_back(static_cast<int>(i));
    Matrix<Interval> ball = family.balls[i];
    for (Eigen::Index k = 0; k < ball.size(); ++k)
      arb_mul_2exp_si(ball.data()[k].raw(), ball.data()[k].raw(), -result.exponent);
    result.family.balls.push_back(std::move(ball));
    if (!family.exact.empty()) result.family.exact.emplace_back(scale * family.exact[i]);
  }
  return result;
}

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
