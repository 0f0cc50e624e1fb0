#include "analysis/mesh/strong_components.h"

namespace subdiv {

std::vector<std::vector<Eigen::Index>> strong_components(
    const Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>& edges) {
  // Matrices are small: Warshall's closure.
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> reaches = edges;
  const Eigen::Index n = edges.rows();
  for (Eigen::Index via = 0; via < n; ++via) {
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!reaches(i, via)) continue;
      for (Eigen::Index j = 0; j < n; ++j) reaches(i, j) = reaches(i, j) || reaches(via, j);
    }
  }
  std::vector<std::vector<Eigen::Index>> result;
  std::vector<bool> placed(static_cast<std::size_t>(n), false);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (placed[static_cast<std::size_t>(i)]) continue;
    std::vector<Eigen::Index> component;
    for (Eigen::Index j = i; j < n; ++j) {
      if (j != i && !(reaches(i, j) && reaches(j, i))) continue;
      component.push_back(j);
      placed[static_cast<std::size_t>(j)] = true;
    }
    result.push_back(std::move(component));
  }
  return result;
}

}  // namespace subdiv
