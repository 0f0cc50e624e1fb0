#pragma once

#include <vector>

#include "schemes/algebra/matrix.h"

namespace subdiv {

/// The strongly connected components of the graph with an edge i -> j for every entry (i, j) that is not
/// zero: ordered by components the matrix is block triangular, and its eigenvalues are those of the diagonal
/// blocks. Indices within a component ascend.
[[nodiscard]] std::vector<std::vector<Eigen::Index>> strong_components(
    const Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>& edges);

/// Rows and columns of a component.
template <class R>
Matrix<R> diagonal_block(const Matrix<R>& matrix, const std::vector<Eigen::Index>& component) {
  return matrix(component, component);
}

}  // namespace subdiv
