#include "analysis/jsr/balanced_scales.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>

#include <Eigen/Eigenvalues>

namespace subdiv {
namespace {

/// About so many words are tried.
constexpr double most_words = 4096;
/// A left and a right eigenvector as good as orthogonal belong to a defective eigenvalue.
constexpr double orthogonal = 1e-6;
/// Shares s between 2^-2 and 2^6 are looked for.
constexpr double least_octave = -2;
constexpr double most_octaves = 6;
constexpr int bisections = 30;

std::complex<double> approximate(acb_srcptr x) {
  return {arf_get_d(arb_midref(acb_realref(x)), ARF_RND_NEAR),
          arf_get_d(arb_midref(acb_imagref(x)), ARF_RND_NEAR)};
}

/// u with u^T P = lambda u^T and u^T v = 1.
std::optional<Eigen::VectorXcd> left_vector(const AdaptedFamily& family, const LeadingVector& leading) {
  const Eigen::MatrixXd transposed = product(family.approximate, leading.word).transpose();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(transposed);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const std::complex<double> value = approximate(leading.eigenvalue.at(0, 0));
  Eigen::Index nearest = 0;
  (solver.eigenvalues().array() - value).abs().minCoeff(&nearest);
  const Eigen::VectorXcd u = solver.eigenvectors().col(nearest);
  const Eigen::VectorXcd v = leading.vector.midpoints().col(0);
  const std::complex<double> inner = (u.transpose() * v)(0);
  if (!(std::abs(inner) > orthogonal * u.norm() * v.norm())) return std::nullopt;
  return u / inner;
}

/// reach(i, j): the largest |<u_j, T_w v_i>| / r^|w| met.
Eigen::MatrixXd reaches(const AdaptedFamily& family, const Eigen::MatrixXcd& left,
                        const Eigen::MatrixXcd& right, double radius) {
  const auto letters = static_cast<double>(family.size());
  Eigen::MatrixXd reach = Eigen::MatrixXd::Identity(left.cols(), left.cols());
  std::vector<Eigen::MatrixXcd> level{right};
  for (double words = letters; words <= most_words; words *= std::max(letters, 2.0)) {
    std::vector<Eigen::MatrixXcd> next;
    for (const Eigen::MatrixXcd& points : level) {
      for (const Eigen::MatrixXd& t : family.approximate) next.emplace_back(t * points / radius);
    }
    for (const Eigen::MatrixXcd& points : next) {
      reach = reach.cwiseMax((points.transpose() * left).cwiseAbs());
      reach = reach.cwiseMax((points.adjoint() * left).cwiseAbs());  // the conjugate vectors
    }
    level = std::move(next);
  }
  return reach;
}

/// The largest products of weights along paths from i to j; 1 for the empty path.
Eigen::MatrixXd longest_paths(Eigen::MatrixXd weights) {
  weights.diagonal().setOnes();
  for (Eigen::Index k = 0; k < weights.rows(); ++k) {
    const Eigen::VectorXd to = weights.col(k);
    const Eigen::RowVectorXd from = weights.row(k);
    weights = weights.cwiseMax(to * from).eval();
  }
  return weights;
}

}  // namespace

std::vector<Rational> balanced_scales(const AdaptedFamily& family,
                                      const std::vector<LeadingVector>& vectors) {
  const auto count = static_cast<Eigen::Index>(vectors.size());
  std::vector<Rational> result(vectors.size(), Rational(1));
  Eigen::MatrixXcd left(family.dimension(), count);
  Eigen::MatrixXcd right(family.dimension(), count);
  double radius = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const LeadingVector& leading = vectors[static_cast<std::size_t>(i)];
    const std::optional<Eigen::VectorXcd> u = left_vector(family, leading);
    if (!u) return result;
    left.col(i) = *u;
    right.col(i) = leading.vector.midpoints().col(0);
    radius = std::max(radius, leading.radius.to_double());
  }
  const Eigen::MatrixXd reach = reaches(family, left, right, radius);
  if (!reach.allFinite()) return result;
  // The smallest share s with a solution of a_i reach(i, j) <= s a_j, by bisection in powers of two.
  double low = least_octave;
  double high = most_octaves;
  for (int step = 0; step < bisections; ++step) {
    const double middle = (low + high) / 2;
    (longest_paths(reach / std::exp2(middle)).diagonal().maxCoeff() > 1 ? low : high) = middle;
  }
  const Eigen::MatrixXd path = longest_paths(reach / std::exp2(high));
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto scale = static_cast<float>(path.col(j).maxCoeff());
    if (std::isfinite(scale)) result[static_cast<std::size_t>(j)] = Rational::from_double(scale);
  }
  return result;
}

}  // namespace subdiv
