#include "analysis/symmetric_gauge.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace subdiv {
namespace {

constexpr double tolerance = 1e-11;

/// A basis of the simplex method: columns sign_k v_{basis_k}, chosen so that all weights are >= 0.
struct Tableau {
  std::vector<int> basis;
  Eigen::MatrixXd inverse;  // of the matrix of these columns
  Eigen::VectorXd weights;  // inverse * x
  Eigen::VectorXd signs;
};

void orient(Tableau& t) {
  for (Eigen::Index k = 0; k < t.weights.size(); ++k) {
    if (t.weights(k) >= 0) continue;
    t.weights(k) = -t.weights(k);
    t.signs(k) = -t.signs(k);
    t.inverse.row(k) = -t.inverse.row(k);
  }
}

/// The row that leaves when a column with the given image enters; -1 when there is none.
Eigen::Index leaving_row(const Tableau& t, const Eigen::VectorXd& image) {
  Eigen::Index row = -1;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < image.size(); ++k) {
    if (image(k) <= tolerance || t.weights(k) / image(k) >= least) continue;
    least = t.weights(k) / image(k);
    row = k;
  }
  return row;
}

void exchange(Tableau& t, Eigen::Index row, const Eigen::VectorXd& image, int entering, double sign) {
  const double step = t.weights(row) / image(row);
  const Eigen::RowVectorXd pivot = t.inverse.row(row) / image(row);
  t.weights -= step * image;
  t.inverse -= image * pivot;
  t.weights(row) = step;
  t.inverse.row(row) = pivot;
  t.signs(row) = sign;
  t.basis[static_cast<std::size_t>(row)] = entering;
}

}  // namespace

std::optional<SymmetricGauge> SymmetricGauge::of(Eigen::MatrixXd vertices) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(vertices);
  const Eigen::Index n = vertices.rows();
  if (qr.rank() < n) return std::nullopt;
  SymmetricGauge result;
  Eigen::MatrixXd columns(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    result.start_.push_back(static_cast<int>(qr.colsPermutation().indices()(k)));
    columns.col(k) = vertices.col(result.start_.back());
  }
  result.start_inverse_ = columns.inverse();
  result.vertices_ = std::move(vertices);
  return result;
}

void SymmetricGauge::add_vertex(const Eigen::VectorXd& v) {
  vertices_.conservativeResize(Eigen::NoChange, vertices_.cols() + 1);
  vertices_.rightCols<1>() = v;
}

Combination SymmetricGauge::combine(const Eigen::VectorXd& x, double enough) const {
  Tableau t{start_, start_inverse_, start_inverse_ * x, Eigen::VectorXd::Ones(dimension())};
  orient(t);
  // Far more exchanges than a simplex run of this size takes: a bound against cycling.
  const int most_exchanges = 50 * static_cast<int>(dimension()) + 10 * size();
  for (int i = 0; i < most_exchanges && t.weights.sum() > enough; ++i) {
    const Eigen::VectorXd prices = vertices_.transpose() * t.inverse.colwise().sum().transpose();
    Eigen::Index entering = 0;
    if (prices.cwiseAbs().maxCoeff(&entering) <= 1 + tolerance) break;
    const double sign = prices(entering) < 0 ? -1 : 1;
    const Eigen::VectorXd image = sign * (t.inverse * vertices_.col(entering));
    const Eigen::Index row = leaving_row(t, image);
    if (row < 0) break;
    exchange(t, row, image, static_cast<int>(entering), sign);
  }
  return {std::move(t.basis), t.weights.cwiseProduct(t.signs), t.weights.sum()};
}

}  // namespace subdiv
