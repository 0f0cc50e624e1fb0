#include <chrono>
#include <utility>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>

#include "tests/cross/reference/reference.h"

namespace subdiv::cross {
namespace {

struct InDouble : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Polygons = OpenMesh::PolyMesh_ArrayKernelT<InDouble>;
using Triangles = OpenMesh::TriMesh_ArrayKernelT<InDouble>;

template <class Mesh, class Subdivider>
Reference refined(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  Mesh mesh;
  std::vector<typename Mesh::VertexHandle> vertices;
  for (const Point3& p : points) vertices.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for (std::size_t f = 0; f < faces.faces(); ++f) {
    std::vector<typename Mesh::VertexHandle> corners;
    for (const long long v : faces.face(f)) corners.push_back(vertices[static_cast<std::size_t>(v)]);
    mesh.add_face(corners);
  }
  Subdivider subdivider;
  subdivider.attach(mesh);
  const auto start = std::chrono::steady_clock::now();
  subdivider(static_cast<std::size_t>(levels));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  subdivider.detach();
  Reference result{{}, mesh.n_faces(), taken.count()};
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.points.push_back({p[0], p[1], p[2]});
  }
  return result;
}

}  // namespace

Reference openmesh_catmull_clark(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  return refined<Polygons, OpenMesh::Subdivider::Uniform::CatmullClarkT<Polygons, double>>(faces, points,
                                                                                           levels);
}

Reference openmesh_loop(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  return refined<Triangles, OpenMesh::Subdivider::Uniform::LoopT<Triangles, double>>(faces, points, levels);
}

Reference openmesh_butterfly(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  return refined<Triangles, OpenMesh::Subdivider::Uniform::ModifiedButterflyT<Triangles, double>>(
      faces, points, levels);
}

}  // namespace subdiv::cross
