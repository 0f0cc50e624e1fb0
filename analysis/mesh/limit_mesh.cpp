#include "analysis/mesh/limit_mesh.h"

#include <cmath>
#include <cstddef>

#include "analysis/mesh/limit_stencils.h"

namespace subdiv {
namespace {

/// The unit vector along a x b; 0 where they do not span a plane.
Point3 unit_normal(const Point3& a, const Point3& b) {
  const Point3 cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double length = std::hypot(cross[0], cross[1], cross[2]);
  const double scale = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
  constexpr double rounding = 1e-12;
  if (!(length > rounding * scale)) return {0, 0, 0};
  return {cross[0] / length, cross[1] / length, cross[2] / length};
}

}  // namespace

IndexedMesh limit_mesh(const MeshTopology& mesh, const std::vector<Point3>& points,
                       const MeshScheme<double>& scheme, int levels, int threads) {
  const LimitRules rules = limit_rules(scheme);
  IndexedMesh result = refine_mesh(mesh, points, scheme, levels, threads, rules.position);
  const auto tangents = [&](const FinalRule& rule) {
    const MeshRefinement refinement(mesh, scheme, levels, rule);
    FreshVector<Point3> vectors(refinement.vertices());
    refinement.points(points, vectors, threads);
    return vectors;
  };
  const FreshVector<Point3> first = tangents(rules.first_tangent);
  result.normals = tangents(rules.second_tangent);
  for (std::size_t v = 0; v < result.normals.size(); ++v)
    result.normals[v] = unit_normal(result.normals[v], first[v]);
  return result;
}

}  // namespace subdiv
