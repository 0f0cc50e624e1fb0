#include <chrono>
#include <utility>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "tests/cross/reference/reference.h"

namespace subdiv::cross {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh mesh_of(const PolygonFaces& faces, const std::vector<Point3>& points) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point3& p : points) vertices.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for (std::size_t f = 0; f < faces.faces(); ++f) {
    std::vector<Mesh::Vertex_index> corners;
    for (const long long v : faces.face(f)) corners.push_back(vertices[static_cast<std::size_t>(v)]);
    mesh.add_face(corners);
  }
  return mesh;
}

template <class Refine>
Reference measured(Mesh mesh, const Refine& refine) {
  const auto start = std::chrono::steady_clock::now();
  refine(mesh);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  Reference result{{}, mesh.number_of_faces(), taken.count()};
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.points.push_back({p.x(), p.y(), p.z()});
  }
  return result;
}

/// 5/8 and 3/(8n); at valence 3 7/16 and 3/16.
template <class M>
class WarrenMask : public CGAL::Loop_mask_3<M> {
 public:
  using Base = CGAL::Loop_mask_3<M>;
  using typename Base::Point;
  using typename Base::vertex_descriptor;
  explicit WarrenMask(M* mesh) : Base(mesh, get(CGAL::vertex_point, *mesh)), mesh_(mesh) {}

  void vertex_node(vertex_descriptor vertex, Point& point) {
    double sum[3] = {0, 0, 0};
    int n = 0;
    for (const auto h : CGAL::halfedges_around_target(vertex, *mesh_)) {
      const auto& q = mesh_->point(CGAL::source(h, *mesh_));
      for (int d = 0; d < 3; ++d) sum[d] += q[d];
      ++n;
    }
    const double share = n == 3 ? 3.0 / 16 : 3.0 / (8 * n);
    const double kept = 1 - n * share;
    const auto& p = mesh_->point(vertex);
    point =
        Point(kept * p.x() + share * sum[0], kept * p.y() + share * sum[1], kept * p.z() + share * sum[2]);
  }

 private:
  M* mesh_;
};

}  // namespace

Reference cgal_catmull_clark(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  return measured(mesh_of(faces, points), [&](Mesh& mesh) {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh,
                                                         CGAL::parameters::number_of_iterations(levels));
  });
}

Reference cgal_loop(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  return measured(mesh_of(faces, points), [&](Mesh& mesh) {
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(levels));
  });
}

Reference cgal_warren(const PolygonFaces& faces, const std::vector<Point3>& points, int levels) {
  return measured(mesh_of(faces, points), [&](Mesh& mesh) {
    CGAL::Subdivision_method_3::PTQ(mesh, WarrenMask<Mesh>(&mesh),
                                    CGAL::parameters::number_of_iterations(levels));
  });
}

}  // namespace subdiv::cross
