#include "analysis/corner_polytope.h"

#include <cmath>
#include <utility>

#include "analysis/symmetric_gauge.h"

namespace subdiv {
namespace {

/// The entries within 4 roundoff, relatively, or within the smallest positive number.
Eigen::MatrixXd nearby(const Matrix<Rational>& m) {
  return m.unaryExpr([](const Rational& q) { return q.to_double(); });
}

/// An upper bound of the gauge of T v for every T near t in the sense above: sum |c_k| + |T v - sum c_k
/// v_k|_1, because the unit vectors belong to the polytope. An entry of the rest sums up at most 2n products,
/// each with a relative error; the bound of the errors is doubled for the rounding of this very bound and of
/// the sums that follow.
double gauge_bound(const Eigen::MatrixXd& t, const Eigen::VectorXd& v, const SymmetricGauge& gauge,
                   const Combination& c) {
  constexpr double roundoff = 0x1p-53;
  constexpr double underflow = 1e-300;
  Eigen::VectorXd rest = t * v;
  double magnitude = (t.cwiseAbs() * v.cwiseAbs()).sum();
  double sum = 0;
  for (std::size_t k = 0; k < c.basis.size(); ++k) {
    const double coefficient = c.coefficients(static_cast<Eigen::Index>(k));
    const auto vertex = gauge.vertices().col(c.basis[k]);
    rest -= coefficient * vertex;
    magnitude += std::abs(coefficient) * vertex.cwiseAbs().sum();
    sum += std::abs(coefficient);
  }
  const double n = static_cast<double>(v.size());
  const double error = 2 * (2 * n + 8) * roundoff * (magnitude + sum) + underflow;
  return sum + rest.cwiseAbs().sum() + 2 * error;
}

}  // namespace

std::optional<std::size_t> contracting_polytope(const std::vector<Matrix<Rational>>& matrices,
                                                std::size_t most, double margin) {
  const Eigen::Index n = matrices.at(0).rows();
  std::vector<Eigen::MatrixXd> family;
  for (const Matrix<Rational>& m : matrices) family.push_back(nearby(m));
  auto gauge = SymmetricGauge::of(Eigen::MatrixXd::Identity(n, n));
  for (int j = 0; j < gauge->size(); ++j) {
    for (const Eigen::MatrixXd& t : family) {
      const Eigen::VectorXd v = gauge->vertices().col(j);
      const Eigen::VectorXd image = t * v;
      if (!image.allFinite()) return std::nullopt;
      if (gauge_bound(t, v, *gauge, gauge->combine(image, 1 - 2 * margin)) <= 1 - margin) continue;
      if (static_cast<std::size_t>(gauge->size()) >= most) return std::nullopt;
      const double shrunk = 1 - 2 * margin;
      gauge->add_vertex(image / shrunk);
      const Combination own{{gauge->size() - 1}, Eigen::VectorXd::Constant(1, shrunk), shrunk};
      if (!(gauge_bound(t, v, *gauge, own) <= 1 - margin)) return std::nullopt;
    }
  }
  return static_cast<std::size_t>(gauge->size());
}

}  // namespace subdiv
