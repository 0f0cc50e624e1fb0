// Refinement against CGAL and OpenMesh on closed meshes of mixed valences, points matched by position.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "experiments/mesh_file.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "tests/cross/reference/reference.h"

namespace subdiv::cross {
namespace {

MeshFile stored(const char* name) {
  return read_mesh(std::filesystem::path(SUBDIVLAB_SOURCE_DIR) / "experiments/data" / name);
}

/// A bumpy torus of rows x columns squares, each cut in two: all valences are 6.
MeshFile torus(int rows, int columns) {
  MeshFile mesh;
  const auto at = [&](int i, int j) -> long long { return i % rows * columns + j % columns; };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double u = 2 * M_PI * i / rows;
      const double v = 2 * M_PI * j / columns;
      const double r = 3 + (1 + 0.1 * ((7 * i + 3 * j) % 5)) * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v) + 0.05 * (i * j % 3)});
      mesh.faces.add_face(std::vector{at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.faces.add_face(std::vector{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.faces.vertices = mesh.points.size();
  return mesh;
}

double distance(const Point3& p, const Point3& q) {
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/// Every point of one list has one of the other within 1e-12, found among those of similar x.
template <class From, class To>
void expect_all_near(const From& from, const To& to) {
  constexpr double tolerance = 1e-12;
  std::vector<Point3> sorted(to.begin(), to.end());
  std::sort(sorted.begin(), sorted.end());
  for (const Point3& p : from) {
    auto candidate = std::lower_bound(sorted.begin(), sorted.end(), p[0] - tolerance,
                                      [](const Point3& q, double x) { return q[0] < x; });
    while (candidate != sorted.end() && (*candidate)[0] <= p[0] + tolerance &&
           distance(*candidate, p) > tolerance)
      ++candidate;
    ASSERT_TRUE(candidate != sorted.end() && distance(*candidate, p) <= tolerance)
        << "no point at " << p[0] << " " << p[1] << " " << p[2];
  }
}

using Other = Reference (*)(const PolygonFaces&, const std::vector<Point3>&, int);

void expect_same(const MeshFile& mesh, const char* scheme, Other other) {
  for (const int levels : {1, 2, 4}) {
    const Reference theirs = other(mesh.faces, mesh.points, levels);
    const IndexedMesh ours =
        refine_mesh(surface_of(mesh), mesh.points, mesh_scheme<double>(parse_mesh_scheme(scheme)), levels);
    EXPECT_EQ(ours.faces(), theirs.faces);
    ASSERT_EQ(ours.points.size(), theirs.points.size());
    expect_all_near(ours.points, theirs.points);
    expect_all_near(theirs.points, ours.points);
  }
}

constexpr const char* quads = "mesh-handles.obj";  // valences 3 to 8
const std::vector<const char*> triangles{"mesh-tetrahedron.obj", "mesh-valence-8.obj",
                                         "mesh-handles-triangles.obj"};  // 3 to 16

#ifdef SUBDIVLAB_HAS_CGAL
TEST(CrossCgal, CatmullClark) {
  expect_same(stored(quads), "catmull-clark", cgal_catmull_clark);
  expect_same(stored(quads), "jspline-mesh:s=1", cgal_catmull_clark);
  expect_same(stored(quads), "jspline-mesh-literal:s=1", cgal_catmull_clark);
  for (const char* name : triangles) expect_same(stored(name), "catmull-clark", cgal_catmull_clark);
}
TEST(CrossCgal, LoopOf1987) {
  for (const char* name : triangles) expect_same(stored(name), "loop-1987", cgal_loop);
}
TEST(CrossCgal, LoopWithWarrensWeights) {
  for (const char* name : triangles) expect_same(stored(name), "loop", cgal_warren);
}
#endif

#ifdef SUBDIVLAB_HAS_OPENMESH
TEST(CrossOpenMesh, CatmullClark) { expect_same(stored(quads), "catmull-clark", openmesh_catmull_clark); }
TEST(CrossOpenMesh, LoopOf1987) {
  for (const char* name : triangles) expect_same(stored(name), "loop-1987", openmesh_loop);
}
TEST(CrossOpenMesh, ButterflyWhereAllValencesAreSix) {
  expect_same(torus(7, 9), "butterfly", openmesh_butterfly);
  expect_same(torus(3, 4), "butterfly", openmesh_butterfly);
}
#endif

}  // namespace
}  // namespace subdiv::cross
