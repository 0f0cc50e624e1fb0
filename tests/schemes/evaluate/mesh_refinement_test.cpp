#include "schemes/evaluate/mesh_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "schemes/evaluate/indexed_mesh.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/input_error.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

constexpr double tolerance = 1e-12;

MeshTopology connectivity(const MeshRefinement& refinement) {
  std::vector<int> corners(refinement.faces() * static_cast<std::size_t>(refinement.sides()));
  std::vector<int> opposites(corners.size());
  refinement.corners(corners);
  refinement.opposites(opposites);
  return {refinement.sides(), static_cast<int>(refinement.vertices()), std::move(corners),
          std::move(opposites)};
}

std::vector<Point3> points_of(const MeshRefinement& refinement, const std::vector<Point3>& control,
                              int threads = 1) {
  std::vector<Point3> points(refinement.vertices());
  refinement.points(control, points, threads);
  return points;
}

/// The half-edge that leaves control vertex v in the direction of control vertex u, 2^levels steps away.
int towards(const MeshTopology& mesh, int v, int u, int levels) {
  int result = -1;
  for_each_outgoing(mesh, v, [&](int spoke) {
    int h = spoke;
    for (int step = 1; step < 1 << levels; ++step) {
      h = mesh.opposite(h);
      for (int turn = 0; turn < (mesh.sides() == 4 ? 2 : 3); ++turn) h = mesh.turn_left(h);
    }
    if (mesh.target(h) == u) result = spoke;
  });
  return result;
}

/// Both are the same closed mesh with the same points, though numbered differently: walked side by side.
void expect_same_mesh(const MeshTopology& control, int levels, const MeshTopology& a,
                      const std::vector<Point3>& p, const MeshTopology& b, const std::vector<Point3>& q,
                      const std::string& name) {
  ASSERT_EQ(a.vertices(), b.vertices()) << name;
  ASSERT_EQ(a.half_edges(), b.half_edges()) << name;
  std::vector<int> twin(static_cast<std::size_t>(a.half_edges()), -1);
  double largest = 0;
  for (int e = 0; e < control.edges(); ++e) {  // at least one edge of every component
    const int v = control.origin(control.half_edge(e));
    const int u = control.target(control.half_edge(e));
    const int h = towards(a, v, u, levels);
    const int g = towards(b, v, u, levels);
    ASSERT_TRUE(h >= 0 && g >= 0) << name;
    std::vector<std::pair<int, int>> open{{h, g}};
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      if (twin[static_cast<std::size_t>(x)] >= 0) {
        ASSERT_EQ(twin[static_cast<std::size_t>(x)], y) << name;
        continue;
      }
      twin[static_cast<std::size_t>(x)] = y;
      for (std::size_t d = 0; d < 3; ++d) {
        largest = std::max(largest, std::abs(p[static_cast<std::size_t>(a.origin(x))][d] -
                                             q[static_cast<std::size_t>(b.origin(y))][d]));
      }
      open.emplace_back(a.next(x), b.next(y));
      open.emplace_back(a.opposite(x), b.opposite(y));
    }
  }
  EXPECT_EQ(std::count(twin.begin(), twin.end(), -1), 0) << name;
  EXPECT_LT(largest, tolerance) << name;
}

void expect_levels_agree(const PolygonFaces& faces, const MeshScheme<double>& scheme, int levels) {
  const MeshTopology control(faces);
  const std::vector<Point3> points = sample::random_points<double>(control.vertices(), 11);
  MeshTopology mesh = control;
  std::vector<Point3> level = points;
  for (int k = 1; k <= levels; ++k) {
    level = refined_points(mesh, scheme, level);
    mesh = split(mesh, scheme.split);
    const MeshRefinement refinement(control, scheme, k);
    expect_same_mesh(control, k, connectivity(refinement), points_of(refinement, points), mesh, level,
                     scheme.name + ", level " + std::to_string(k));
  }
}

TEST(MeshRefinement, PatchesOfQuadsAreLevelByLevelRefinement) {
  const PolygonFaces mixed = sample::joined(sample::quads_of(sample::bipyramid(5)), sample::cube());
  for (const auto& scheme : {catmull_clark<double>(), kobbelt<double>(), jspline_mesh(0.7), jspline_mesh(1.5),
                             jspline_mesh_literal(-0.25)}) {
    expect_levels_agree(mixed, scheme, 5);
    expect_levels_agree(sample::torus(4, 5, 4), scheme, 4);
  }
}

TEST(MeshRefinement, PatchesOfTrianglesAreLevelByLevelRefinement) {
  const PolygonFaces mixed = sample::joined(sample::bipyramid(5), sample::tetrahedron());
  for (const auto& scheme : {loop<double>(), loop_1987<double>(), butterfly<double>()}) {
    expect_levels_agree(mixed, scheme, 5);
    expect_levels_agree(sample::torus(4, 5, 3), scheme, 4);
  }
}

TEST(MeshRefinement, DeepLevelsGoThroughSeveralStages) {
  expect_levels_agree(sample::cube(), catmull_clark<double>(), 7);
  expect_levels_agree(sample::tetrahedron(), loop<double>(), 7);
}

TEST(MeshRefinement, OtherPolygonsAreSplitOnceByCatmullClark) {
  expect_levels_agree(sample::bipyramid(3), catmull_clark<double>(), 3);
  expect_levels_agree(sample::joined(sample::bipyramid(5), sample::cube()), jspline_mesh(0.5), 4);
}

TEST(MeshRefinement, ValencesOfTwoHundredAndThree) {
  expect_levels_agree(sample::bipyramid(200), loop<double>(), 3);
  expect_levels_agree(sample::quads_of(sample::bipyramid(100)), catmull_clark<double>(), 3);
  expect_levels_agree(sample::quads_of(sample::bipyramid(40)), jspline_mesh(0.5), 3);
}

TEST(MeshRefinement, BordersOfRulesOfTheirOwnAgreeWithLevelByLevelRefinement) {
  const auto sorted = [](std::vector<Point3> points) {
    std::sort(points.begin(), points.end());
    return points;
  };
  const auto check = [&](const PolygonFaces& faces, const MeshScheme<double>& scheme) {
    MeshTopology mesh(faces);
    const std::vector<Point3> control = sample::random_points<double>(mesh.vertices(), 2);
    const MeshRefinement refinement(mesh, scheme, 4);
    std::vector<Point3> level = control;
    for (int k = 0; k < 4; ++k) {
      level = refined_points(mesh, scheme, level);
      mesh = split(mesh, scheme.split);
    }
    const std::vector<Point3> expected = sorted(level);
    const std::vector<Point3> points = sorted(points_of(refinement, control));
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(points[i][0], expected[i][0], tolerance);
    const MeshTopology refined = connectivity(refinement);
    EXPECT_EQ(std::count(refined.opposites().begin(), refined.opposites().end(), -1),
              std::count(mesh.opposites().begin(), mesh.opposites().end(), -1));
  };
  check(sample::sheet(1, 1), catmull_clark<double>());
  check(sample::sheet(3, 2), catmull_clark<double>());
  const PolygonFaces open = sample::polygons(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {1, 6, 2}});
  check(open, loop<double>());
  check(open, butterfly<double>());
}

TEST(MeshRefinement, ThreadsGiveTheSameBits) {
  const MeshTopology control(sample::quads_of(sample::bipyramid(9)));
  const std::vector<Point3> points = sample::random_points<double>(control.vertices(), 4);
  const MeshRefinement refinement(control, catmull_clark<double>(), 5);
  const std::vector<Point3> one = points_of(refinement, points, 1);
  const std::vector<Point3> many = points_of(refinement, points, 5);
  EXPECT_EQ(std::memcmp(one.data(), many.data(), one.size() * sizeof(Point3)), 0);
}

TEST(MeshRefinement, EmptyAndLooseAndNoLevels) {
  const MeshRefinement empty(MeshTopology{PolygonFaces{}}, catmull_clark<double>(), 5);
  EXPECT_EQ(empty.vertices(), 0U);
  EXPECT_EQ(empty.faces(), 0U);
  EXPECT_TRUE(points_of(empty, {}).empty());
  EXPECT_EQ(MeshRefinement(MeshTopology{PolygonFaces{}}, loop<double>(), 2).faces(), 0U);
  PolygonFaces loose = sample::cube();
  loose.vertices = 9;
  const MeshTopology mesh(loose);
  const std::vector<Point3> points = sample::random_points<double>(9, 1);
  for (const int levels : {0, 1, 4}) {
    const MeshRefinement refinement(mesh, catmull_clark<double>(), levels);
    EXPECT_EQ(points_of(refinement, points)[8], points[8]) << levels;
  }
  EXPECT_EQ(points_of(MeshRefinement(mesh, kobbelt<double>(), 0), points), points);
}

TEST(MeshRefinement, RefusesWhatItCannotDo) {
  const MeshTopology cube(sample::cube());
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(message([&] { MeshRefinement(cube, loop<double>(), 1); }),
            "face 1 has 4 corners: loop refines triangles only");
  EXPECT_EQ(message([&] { MeshRefinement(cube, catmull_clark<double>(), 14); }),
            "14 levels make 1.61e+09 faces of 6: this mesh can be refined by 0 to 13 levels");
  const MeshRefinement refinement(cube, catmull_clark<double>(), 1);
  std::vector<Point3> out(3);
  EXPECT_THROW(refinement.points(std::vector<Point3>(8), out), std::invalid_argument);
}

}  // namespace
}  // namespace subdiv
