#pragma once

#include <vector>

#include <Eigen/Core>

namespace subdiv {

/// Lower triangular B such that the matrices B^-1 T B of the family have Euclidean norms near its joint
/// spectral radius, given approximately: B B^T is the sum of the ellipsoids G_{k+1} = sum of T G_k T^T / (m
/// radius^2), which solves the family's Lyapunov equation in the mean. A heuristic that improves the
/// conditioning of polytopes; nothing depends on it.
[[nodiscard]] Eigen::MatrixXd adapted_basis(const std::vector<Eigen::MatrixXd>& family, double radius);

/// B C with C C^T the mean of v v^T over the columns v of `points`, which are given in the coordinates of B:
/// in the new coordinates the points are spread alike in all directions.
[[nodiscard]] Eigen::MatrixXd adapted_basis(const Eigen::MatrixXd& basis, const Eigen::MatrixXcd& points);

}  // namespace subdiv
