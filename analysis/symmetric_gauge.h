#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace subdiv {

/// x = sum over k of coefficient_k v_{basis_k}: a way to write a point by n vertices of conv(+-v_1, ..,
/// +-v_N).
struct Combination {
  std::vector<int> basis;        ///< n different vertices
  Eigen::VectorXd coefficients;  ///< one for each of them
  double sum = 0;                ///< of the moduli; the gauge of x when the simplex method came to its end
};

/// The gauge of the symmetric polytope conv(+-v_1, .., +-v_N) in R^n: min sum |c_k| over all V c = x, by the
/// simplex method in floating point. An answer is a proposal; a proof has to check the combination by itself.
class SymmetricGauge {
 public:
  /// One vertex a column; nothing when they do not span R^n (judged in floating point).
  static std::optional<SymmetricGauge> of(Eigen::MatrixXd vertices);

  /// Adds v and -v.
  void add_vertex(const Eigen::VectorXd& v);
  [[nodiscard]] Eigen::Index dimension() const { return vertices_.rows(); }
  [[nodiscard]] int size() const { return static_cast<int>(vertices_.cols()); }
  [[nodiscard]] const Eigen::MatrixXd& vertices() const { return vertices_; }

  /// Starts from an independent set of vertices; once the sum is at most `enough`, stops.
  [[nodiscard]] Combination combine(const Eigen::VectorXd& x, double enough = 0) const;
  /// The gauge; an upper bound of it when that is below `enough`.
  [[nodiscard]] double gauge(const Eigen::VectorXd& x, double enough = 0) const {
    return combine(x, enough).sum;
  }

 private:
  SymmetricGauge() = default;

  Eigen::MatrixXd vertices_;
  std::vector<int> start_;
  Eigen::MatrixXd start_inverse_;
};

}  // namespace subdiv
