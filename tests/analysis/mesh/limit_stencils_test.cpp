#include "analysis/mesh/limit_stencils.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "schemes/evaluate/mesh_refinement.h"
#include "schemes/input_error.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/fan.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

constexpr double tolerance = 1e-10;

std::vector<Point3> refined(const MeshTopology& mesh, const std::vector<Point3>& points,
                            const MeshScheme<double>& scheme, int levels, const FinalRule& rule = {}) {
  const MeshRefinement refinement(mesh, scheme, levels, rule);
  std::vector<Point3> result(refinement.vertices());
  refinement.points(points, result);
  return result;
}

TEST(LimitStencils, CatmullClarkHasTheWeightsOfHalsteadKassAndDeRose) {
  // Halstead, Kass, DeRose 1993, section 3.1: (n^2 v + 4 sum e + sum f)/(n (n + 5)).
  for (const int n : {3, 4, 5, 8, 31}) {
    const LimitStencil limit = limit_stencil(catmull_clark<double>(), n);
    ASSERT_EQ(limit.position.size(), 2U);
    EXPECT_NEAR(limit.centre, n / (n + 5.0), tolerance) << n;
    EXPECT_NEAR(limit.position[0], 4 / (n * (n + 5.0)), tolerance);
    EXPECT_NEAR(limit.position[1], 1 / (n * (n + 5.0)), tolerance);
  }
}

TEST(LimitStencils, LoopHasTheWeightsOfItsPaper) {
  // With neighbours of weight b each the limit keeps 1/(1 + n chi) .. chi = 1/(3/(8 b) + n) for each of them.
  for (const int n : {3, 4, 6, 7, 20}) {
    const double b = (n == 3 ? 9.0 / 16 : 3.0 / 8) / n;
    const double chi = 1 / (3 / (8 * b) + n);
    const LimitStencil limit = limit_stencil(loop<double>(), n);
    EXPECT_NEAR(limit.position[0], chi, tolerance) << n;
    EXPECT_NEAR(limit.centre, 1 - n * chi, tolerance) << n;
    // Tangents: neighbour k by cos(2 pi k/n): the same weight at every spoke but for the turn.
    ASSERT_TRUE(limit.tangent.has_value());
    EXPECT_EQ(limit.tangent->size(), 1U);
  }
}

TEST(LimitStencils, InterpolatingSchemesStay) {
  for (const auto& scheme : {kobbelt<double>(), butterfly<double>()}) {
    const LimitStencil limit = limit_stencil(scheme, 5);
    EXPECT_NEAR(limit.centre, 1, tolerance);
    for (const double weight : limit.position) EXPECT_NEAR(weight, 0, tolerance);
  }
}

TEST(LimitStencils, TangentsExistWhereTheDominantPairComesFromModeOne) {
  for (const int n : {4, 5, 6, 7})
    EXPECT_TRUE(limit_stencil(butterfly<double>(), n).tangent.has_value()) << n;
  EXPECT_FALSE(limit_stencil(butterfly<double>(), 3).tangent.has_value()) << "1/4 is multiple (notes 5)";
  EXPECT_TRUE(limit_stencil(jspline_mesh(1.5), 30).tangent.has_value());
  EXPECT_FALSE(limit_stencil(jspline_mesh(1.5), 60).tangent.has_value()) << "mode 0 has overtaken mode 1";
}

TEST(LimitStencils, LimitsDoNotDependOnTheLevelTheyAreTakenAt) {
  const MeshTopology quads(sample::quads_of(sample::joined(sample::bipyramid(5), sample::bipyramid(6))));
  const MeshTopology triangles(sample::joined(sample::bipyramid(5), sample::bipyramid(9)));
  const auto check = [](const MeshTopology& mesh, const MeshScheme<double>& scheme) {
    const std::vector<Point3> points = sample::random_points<double>(mesh.vertices(), 8);
    const LimitRules rules = limit_rules(scheme);
    const std::vector<Point3> early = refined(mesh, points, scheme, 0, rules.position);
    const std::vector<Point3> middle = refined(mesh, points, scheme, 2, rules.position);
    const std::vector<Point3> late = refined(mesh, points, scheme, 5, rules.position);
    for (int v = 0; v < mesh.vertices(); ++v) {
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(early[static_cast<std::size_t>(v)][d], late[static_cast<std::size_t>(v)][d], tolerance)
            << scheme.name;
    }
  };
  for (const auto& scheme : {catmull_clark<double>(), jspline_mesh(0.5), jspline_mesh_literal(1.25)})
    check(quads, scheme);
  for (const auto& scheme : {loop<double>(), loop_1987<double>()}) check(triangles, scheme);
}

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TEST(LimitStencils, NormalsPointOutOfAConvexSolid) {
  // A sphere-like solid around the origin, faces counter-clockwise from outside.
  PolygonFaces faces = sample::bipyramid(7);
  std::vector<Point3> points;
  for (int i = 0; i < 7; ++i) {
    const double angle = 2 * std::numbers::pi * i / 7;
    points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  points.push_back({0, 0, 1});
  points.push_back({0, 0, -1});
  const MeshTopology mesh(faces);
  for (const auto& scheme : {loop<double>(), loop_1987<double>(), butterfly<double>()}) {
    const LimitRules rules = limit_rules(scheme);
    const auto first = refined(mesh, points, scheme, 3, rules.first_tangent);
    const auto second = refined(mesh, points, scheme, 3, rules.second_tangent);
    const auto limits = refined(mesh, points, scheme, 3, rules.position);
    for (std::size_t v = 0; v < limits.size(); ++v) {
      const Point3 normal = cross(second[v], first[v]);
      const double outwards = normal[0] * limits[v][0] + normal[1] * limits[v][1] + normal[2] * limits[v][2];
      EXPECT_GT(outwards, 0) << scheme.name << " " << v;
    }
    // By symmetry the pole's normal is the axis.
    const Point3 axis = cross(second[7], first[7]);
    EXPECT_NEAR(axis[0] / axis[2], 0, tolerance);
    EXPECT_NEAR(axis[1] / axis[2], 0, tolerance);
  }
}

TEST(LimitStencils, TheBordersCurveIsACubicSpline) {
  const MeshTopology sheet(sample::sheet(3, 3));
  const std::vector<Point3> points = sample::random_points<double>(sheet.vertices(), 6);
  const LimitRules rules = limit_rules(catmull_clark<double>());
  const std::vector<Point3> limits = refined(sheet, points, catmull_clark<double>(), 0, rules.position);
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_NEAR(limits[1][d], (points[0][d] + 4 * points[1][d] + points[2][d]) / 6, tolerance);
    EXPECT_NEAR(limits[0][d], points[0][d], tolerance) << "corners stay";
  }
}

TEST(LimitStencils, OtherPolygonsNeedALevel) {
  const MeshTopology pyramid(sample::bipyramid(4));
  const std::vector<Point3> points = sample::random_points<double>(6, 6);
  const LimitRules rules = limit_rules(catmull_clark<double>());
  EXPECT_THROW(refined(pyramid, points, catmull_clark<double>(), 0, rules.position), InputError);
  EXPECT_NO_THROW(refined(pyramid, points, catmull_clark<double>(), 1, rules.position));
}

TEST(LimitStencils, ASchemeWithoutLimitIsRefused) {
  MeshScheme<double> growing = loop<double>();
  growing.vertex_rule = [](const MeshTopology& /*mesh*/, int v) {
    Stencil<double> twice;
    twice.add(v, 2);
    return twice;
  };
  EXPECT_THROW(static_cast<void>(limit_stencil(growing, 6)), std::domain_error);
}

}  // namespace
}  // namespace subdiv
