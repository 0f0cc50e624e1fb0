#include "analysis/mesh/mode_matrix.h"

#include <cmath>
#include <complex>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace subdiv {
namespace {

/// The unknowns (v, lambda) in one vector, lambda last.
Vector<Interval> residual(const Matrix<Interval>& a, const Vector<Interval>& x, Eigen::Index fixed) {
  const Eigen::Index n = a.rows();
  Vector<Interval> result = Vector<Interval>::Constant(n + 1, Interval(0));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) add_product(result(i), a(i, j), x(j));
    result(i) -= x(n) * x(i);
  }
  result(n) = x(fixed) - Interval(1);
  return result;
}

Matrix<Interval> jacobian(const Matrix<Interval>& a, const Vector<Interval>& x, Eigen::Index fixed) {
  const Eigen::Index n = a.rows();
  Matrix<Interval> result = zero_matrix<Interval>(n + 1, n + 1);
  result.topLeftCorner(n, n) = a;
  for (Eigen::Index i = 0; i < n; ++i) {
    result(i, i) -= x(n);
    result(i, n) = -x(i);
  }
  result(n, fixed) = Interval(1);
  return result;
}

/// Krawczyk's operator over the box x: where it lies inside, it encloses the one zero in x.
Vector<Interval> krawczyk(const Matrix<Interval>& a, const Vector<Interval>& x, Eigen::Index fixed,
                          const Matrix<double>& inverse) {
  const Eigen::Index n = x.size();
  const Vector<Interval> centre = x.unaryExpr([](const Interval& c) { return c.center(); });
  const Vector<Interval> value = residual(a, centre, fixed);
  const Matrix<Interval> slope = jacobian(a, x, fixed);
  Vector<Interval> result = centre;
  Matrix<Interval> contraction = identity_matrix<Interval>(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const Interval factor(-inverse(i, k));
      add_product(result(i), factor, value(k));
      for (Eigen::Index j = 0; j < n; ++j) {
        if (!slope(k, j).is_exactly_zero()) add_product(contraction(i, j), factor, slope(k, j));
      }
    }
    for (Eigen::Index j = 0; j < n; ++j) add_product(result(i), contraction(i, j), x(j) - centre(j));
  }
  return result;
}

}  // namespace

RealEigenpair<double> dominant_eigenpair(const Matrix<double>& matrix) {
  constexpr double half_the_digits = 1e-7;
  RealEigenpair<double> result;
  const Eigen::EigenSolver<Matrix<double>> solver(matrix);
  Eigen::Index best = 0;
  solver.eigenvalues().cwiseAbs().maxCoeff(&best);
  const std::complex<double> value = solver.eigenvalues()(best);
  result.value = std::abs(value);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    if (i != best && std::abs(solver.eigenvalues()(i) - value) < half_the_digits)
      result.missing = "the eigenvalue is not simple in its mode";
  }
  if (result.missing.empty() && value.imag() != 0) result.missing = "the eigenvalue is complex";
  if (!result.missing.empty()) return result;
  result.value = value.real();
  result.vector = solver.eigenvectors().col(best).real();
  Eigen::Index largest = 0;
  result.vector.cwiseAbs().maxCoeff(&largest);
  result.vector /= double{result.vector(largest)};
  return result;
}

RealEigenpair<Interval> enclosed_eigenpair(const Matrix<Interval>& matrix,
                                           const RealEigenpair<double>& computed) {
  RealEigenpair<Interval> result;
  result.missing = "the eigenvalue could not be enclosed and proved simple";
  const Eigen::Index n = matrix.rows();
  Eigen::Index fixed = 0;
  computed.vector.cwiseAbs().maxCoeff(&fixed);
  Vector<Interval> x(n + 1);
  constexpr double width = 1e-9;  // far above the rounding errors of double
  const Interval around = Interval::hull(Rational(-1), Rational(1)) * Interval(width);
  for (Eigen::Index i = 0; i <= n; ++i) x(i) = Interval(i < n ? computed.vector(i) : computed.value) + around;
  const Matrix<double> inverse = jacobian(matrix, x, fixed)
                                     .unaryExpr([](const Interval& c) { return c.to_double(); })
                                     .fullPivLu()
                                     .inverse();
  if (!inverse.allFinite()) return result;
  // Each application gains the ten digits and more that the computed inverse is right in.
  constexpr int applications = 4;
  for (int k = 0; k < applications; ++k) {
    Vector<Interval> next = krawczyk(matrix, x, fixed, inverse);
    if (k == 0) {
      for (Eigen::Index i = 0; i <= n; ++i) {
        if (!x(i).contains_strictly(next(i))) return result;
      }
    }
    x = std::move(next);
  }
  result.missing.clear();
  result.value = x(n);
  result.vector = x.head(n);
  return result;
}

}  // namespace subdiv
