#include "schemes/evaluate/indexed_mesh.h"

#include <fmt/format.h>

#include <limits>

#include "schemes/evaluate/refine_mesh.h"
#include "schemes/input_error.h"

namespace subdiv {

IndexedMesh refine_mesh(const MeshTopology& mesh, const std::vector<Point3>& points,
                        const MeshScheme<double>& scheme, int levels, int /*threads*/) {
  if (scheme.split == MeshSplit::triangles && mesh.sides() != 3) {
    for (int f = 0; f < mesh.faces(); ++f) {
      if (mesh.degree(f) == 3) continue;
      throw InputError(fmt::format("face {} has {} corners: {} refines triangles only", f + 1, mesh.degree(f),
                                   scheme.name));
    }
  }
  MeshTopology topology = mesh;
  IndexedMesh result;
  result.points = points;
  for (int level = 0; level < levels; ++level) {
    if (topology.half_edges() > std::numeric_limits<int>::max() / 4)
      throw InputError("more corners than can be numbered: use fewer levels");
    result.points = refined_points(topology, scheme, result.points);
    topology = split(topology, scheme.split);
  }
  result.sides = topology.sides();
  result.corners = topology.origins();
  return result;
}

}  // namespace subdiv
