#include "optimize/dual_weights.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace subdiv {
namespace {

/// The simplex method on: maximise c . v, A v = (1, 0 .. 0), v >= 0. Columns: one a piece, (1, slope) at cost
/// constant; then for each parameter the two parts of the absolute value, (0, -+e_j) at cost -1.
class Simplex {
 public:
  explicit Simplex(std::span<const AffinePiece> pieces)
      : pieces_(pieces), parameters_(pieces.front().slope.size()), basis_(parameters_ + 1) {
    basis_[0] = 0;
    for (std::size_t j = 0; j < parameters_; ++j) {
      basis_[j + 1] = pieces_.size() + 2 * j + (pieces_[0].slope[j] > 0 ? 0U : 1U);
    }
  }

  LeastMaximum run() {
    constexpr int most_pivots = 200;
    for (int k = 0; k < most_pivots && pivot(); ++k) {
    }
    LeastMaximum result;
    result.weights.assign(pieces_.size(), 0);
    const Eigen::VectorXd v = matrix().partialPivLu().solve(unit());
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      if (basis_[i] < pieces_.size())
        result.weights[basis_[i]] = std::max(0.0, v(static_cast<Eigen::Index>(i)));
    }
    const Eigen::VectorXd prices = dual();
    result.value = prices(0);
    for (std::size_t j = 0; j < parameters_; ++j) {
      result.point.push_back(std::clamp(-prices(static_cast<Eigen::Index>(j + 1)), -1.0, 1.0));
    }
    return result;
  }

 private:
  [[nodiscard]] Eigen::VectorXd column(std::size_t k) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters_ + 1));
    if (k < pieces_.size()) {
      result(0) = 1;
      for (std::size_t j = 0; j < parameters_; ++j)
        result(static_cast<Eigen::Index>(j + 1)) = pieces_[k].slope[j];
    } else {
      const std::size_t j = (k - pieces_.size()) / 2;
      result(static_cast<Eigen::Index>(j + 1)) = (k - pieces_.size()) % 2 == 0 ? -1 : 1;
    }
    return result;
  }
  [[nodiscard]] double cost(std::size_t k) const { return k < pieces_.size() ? pieces_[k].constant : -1; }
  [[nodiscard]] Eigen::VectorXd unit() const {
    return Eigen::VectorXd::Unit(static_cast<Eigen::Index>(parameters_ + 1), 0);
  }
  [[nodiscard]] Eigen::MatrixXd matrix() const {
    const auto n = static_cast<Eigen::Index>(basis_.size());
    Eigen::MatrixXd result(n, n);
    for (Eigen::Index i = 0; i < n; ++i) result.col(i) = column(basis_[static_cast<std::size_t>(i)]);
    return result;
  }
  [[nodiscard]] Eigen::VectorXd dual() const {
    Eigen::VectorXd costs(static_cast<Eigen::Index>(basis_.size()));
    for (Eigen::Index i = 0; i < costs.size(); ++i) costs(i) = cost(basis_[static_cast<std::size_t>(i)]);
    return matrix().transpose().partialPivLu().solve(costs);
  }

  /// One exchange of the column with the largest reduced cost; false at the optimum.
  bool pivot() {
    const Eigen::VectorXd prices = dual();
    const std::size_t columns = pieces_.size() + 2 * parameters_;
    std::size_t entering = columns;
    double best = 1e-12 * (1 + std::abs(prices(0)));
    for (std::size_t k = 0; k < columns; ++k) {
      const double reduced = cost(k) - prices.dot(column(k));
      if (reduced > best) {
        best = reduced;
        entering = k;
      }
    }
    if (entering == columns) return false;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix());
    const Eigen::VectorXd v = lu.solve(unit());
    const Eigen::VectorXd direction = lu.solve(column(entering));
    std::size_t leaving = basis_.size();
    double ratio = INFINITY;
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (direction(row) > 1e-14 && v(row) / direction(row) < ratio) {
        ratio = v(row) / direction(row);
        leaving = i;
      }
    }
    if (leaving == basis_.size()) return false;
    basis_[leaving] = entering;
    return true;
  }

  std::span<const AffinePiece> pieces_;
  std::size_t parameters_;
  std::vector<std::size_t> basis_;
};

double at(const AffinePiece& piece, const std::vector<double>& y) {
  double value = piece.constant;
  for (std::size_t j = 0; j < y.size(); ++j) value += piece.slope[j] * y[j];
  return value;
}

/// The weights of the norm's affine piece that is active at y.
std::vector<double> active_weights(Norm norm, std::span<const AffinePiece> residuals,
                                   const std::vector<double>& y) {
  std::vector<double> weights(residuals.size(), 0);
  std::size_t largest = 0;
  double magnitude = -1;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double value = at(residuals[i], y);
    if (norm == Norm::l1) {
      weights[i] = value < 0 ? -1 : 1;
    } else if (std::abs(value) > magnitude) {
      magnitude = std::abs(value);
      largest = i;
    }
  }
  if (norm != Norm::l1) weights[largest] = at(residuals[largest], y) < 0 ? -1 : 1;
  return weights;
}

AffinePiece combination(std::span<const AffinePiece> residuals, const std::vector<double>& weights,
                        AffinePiece total) {
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (weights[i] == 0) continue;
    total.constant += weights[i] * residuals[i].constant;
    for (std::size_t j = 0; j < total.slope.size(); ++j) total.slope[j] += weights[i] * residuals[i].slope[j];
  }
  return total;
}

}  // namespace

LeastMaximum least_maximum(std::span<const AffinePiece> pieces) {
  // The tolerances of the simplex method are for numbers of order 1.
  double scale = 0;
  for (const AffinePiece& piece : pieces) {
    scale = std::max(scale, std::abs(piece.constant));
    for (const double slope : piece.slope) scale = std::max(scale, std::abs(slope));
  }
  if (!(scale > 0) || !std::isfinite(scale)) scale = 1;
  std::vector<AffinePiece> scaled(pieces.begin(), pieces.end());
  for (AffinePiece& piece : scaled) {
    piece.constant /= scale;
    for (double& slope : piece.slope) slope /= scale;
  }
  LeastMaximum result = Simplex(scaled).run();
  result.value *= scale;
  return result;
}

std::vector<double> dual_weights(Norm norm, std::span<const AffinePiece> residuals,
                                 const AffinePiece& offset) {
  if (norm == Norm::l2) return std::vector<double>(residuals.size(), 1.0);
  constexpr int most_cuts = 12;
  std::vector<std::vector<double>> patterns;
  std::vector<AffinePiece> pieces;
  LeastMaximum model;
  std::vector<double> y(offset.slope.size(), 0);
  for (int k = 0; k < most_cuts; ++k) {
    std::vector<double> pattern = active_weights(norm, residuals, y);
    AffinePiece piece = combination(residuals, pattern, offset);
    const double tolerance = 1e-9 * (std::abs(model.value) + std::abs(piece.constant));
    if (k > 0 && at(piece, y) <= model.value + tolerance) break;
    patterns.push_back(std::move(pattern));
    pieces.push_back(std::move(piece));
    model = least_maximum(pieces);
    y = model.point;
  }
  std::vector<double> weights(residuals.size(), 0);
  for (std::size_t p = 0; p < model.weights.size(); ++p) {
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += model.weights[p] * patterns[p][i];
  }
  return weights;
}

}  // namespace subdiv
