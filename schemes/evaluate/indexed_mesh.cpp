#include "schemes/evaluate/indexed_mesh.h"

#include <stdexcept>

namespace subdiv {

IndexedMesh refine_mesh(const MeshTopology& mesh, const std::vector<Point3>& points,
                        const MeshScheme<double>& scheme, int levels, int threads,
                        const FinalRule& final_rule) {
  const MeshRefinement refinement(mesh, scheme, levels, final_rule);
  if (refinement.sides() == 0)
    throw std::invalid_argument("faces of one number of corners: at least one level");
  IndexedMesh result;
  result.sides = refinement.sides();
  result.points.resize(refinement.vertices());
  refinement.points(points, result.points, threads);
  result.corners.resize(refinement.faces() * static_cast<std::size_t>(result.sides));
  refinement.corners(result.corners, threads);
  return result;
}

}  // namespace subdiv
