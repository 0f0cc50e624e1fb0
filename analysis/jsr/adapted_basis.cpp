#include "analysis/jsr/adapted_basis.h"

#include <Eigen/Cholesky>

namespace subdiv {
namespace {

constexpr int iterations = 60;
constexpr double regularisation = 1e-11;

/// The Cholesky factor of g plus a small multiple of the identity, g scaled to trace n.
Eigen::MatrixXd factor(const Eigen::MatrixXd& g) {
  const auto n = static_cast<double>(g.rows());
  Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(g.rows(), g.rows());
  const Eigen::LLT<Eigen::MatrixXd> cholesky(g * (n / g.trace()) + regularisation * unit);
  if (cholesky.info() != Eigen::Success) return unit;
  return cholesky.matrixL();
}

}  // namespace

Eigen::MatrixXd adapted_basis(const std::vector<Eigen::MatrixXd>& family, double radius) {
  const Eigen::Index n = family[0].rows();
  Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n);
  if (!(radius > 0)) return unit;
  Eigen::MatrixXd g = unit;
  for (int i = 0; i < iterations; ++i) {
    Eigen::MatrixXd next = regularisation * g.trace() / static_cast<double>(n) * unit;
    for (const Eigen::MatrixXd& t : family) {
      next += t * g * t.transpose() / (static_cast<double>(family.size()) * radius * radius);
    }
    if (!next.allFinite() || !(next.trace() > 0)) return unit;
    g = next / next.trace();
  }
  return factor(g);
}

Eigen::MatrixXd adapted_basis(const Eigen::MatrixXd& basis, const Eigen::MatrixXcd& points) {
  return basis * factor((points * points.adjoint()).real());
}

}  // namespace subdiv
