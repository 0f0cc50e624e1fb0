#include "experiments/speed_rings.h"

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/mesh_file.h"
#include "experiments/ring_shapes.h"
#include "experiments/speed_connectivity.h"
#include "schemes/evaluate/bezier_patch.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_speed_rings();
  return once;
}

RingModel blend() {
  const MeshFile file =
      read_mesh(std::filesystem::path(SUBDIVLAB_SOURCE_DIR) / "experiments/data/speed-blend.obj");
  return {surface_of(file), file.points};
}

TEST(SpeedRings, WhatIsPrintedHolds) {
  EXPECT_EQ(results().claims.size(), speed_ring_heads().size());
  for (const Claim& claim : results().claims) {
    const bool tendency = claim.head.kind == ClaimKind::tendency;
    EXPECT_EQ(claim.verdict, tendency             ? Verdict::consistent
                             : claim.head.printed ? Verdict::reproduced
                                                  : Verdict::established)
        << claim.head.id;
  }
}

// What does not join is told: the refined net of another speed ends elsewhere, at its own border.
TEST(SpeedRings, JointsWithANetOfAnotherSpeedFail) {
  using Function = RationalFunction;
  const Function s = Function::variable(0);
  const VertexWeights<Function> weights{Function::variable(1), Function::variable(2)};
  const RingJoints right = ring_joints(s, step_of_speed(s, weights));
  EXPECT_TRUE(right.inside);
  EXPECT_TRUE(right.sectors);
  EXPECT_TRUE(right.inwards);
  EXPECT_TRUE(right.all());
  const RingJoints wrong = ring_joints(s, step_of_speed(Function::variable(3), weights));
  EXPECT_FALSE(wrong.inwards);
  EXPECT_FALSE(wrong.all());
  for (const RingJoints& joints : {RingJoints{false, true, true}, {true, false, true}, {true, true, false}})
    EXPECT_FALSE(joints.all());
}

// Points that are no Catmull-Clark points by their places, or by what they read, are told.
TEST(SpeedRings, PlacesOfOtherPointsDoNotMimicCatmullClark) {
  std::vector<SectorStencil<RationalFunction>> rules = refined_places(RationalFunction::variable(0));
  for (const int n : {3, 4, 5, 8}) EXPECT_TRUE(mimics_catmull_clark(n, rules)) << n;
  std::swap(rules[0], rules[1]);  // an edge point and a face point
  EXPECT_FALSE(mimics_catmull_clark(5, rules));
}

// The exact angles at the vertex against normals of the patches in double, from points close to it.
TEST(SpeedRings, AnglesAtTheVertexByDifferences) {
  for (const auto& [id, sigma] :
       {std::pair{"figure.speed.1.half", Rational(1, 2)}, {"figure.speed.1.high", Rational(3, 4)}}) {
    const RingSurface surface = blend().surface({sigma, sigma}, true);
    const std::size_t first = surface.begin[surface.groups() - 1];
    double worst = 0;
    const auto normal = [&](std::size_t patch) {
      const auto at = [&](double u, double v) -> Eigen::Vector3d {
        const Point3 p = patch_point(surface.patches[first + patch], bernstein(u, 1), bernstein(v, 1));
        return {p[0], p[1], p[2]};
      };
      constexpr double h = 1e-6;
      const Eigen::Vector3d du = at(1, 1) - at(1 - h, 1);
      const Eigen::Vector3d dv = at(1, 1) - at(1, 1 - h);
      return Eigen::Vector3d(du.y() * dv.z() - du.z() * dv.y(), du.z() * dv.x() - du.x() * dv.z(),
                             du.x() * dv.y() - du.y() * dv.x())
          .normalized();
    };
    for (std::size_t k = 0; k < 5; ++k)
      worst = std::max(worst, std::acos(normal(k).dot(normal((k + 1) % 5))));
    const double exact = std::atan(std::sqrt(test::value_of(results().claims, id)));
    EXPECT_NEAR(worst, exact, 1e-4 * exact);
  }
}

// Karciauskas & Peters, (8): holes shrink by lambda(5, sigma) a step in the end.
TEST(SpeedRings, HolesShrinkByTheSubdominantEigenvalue) {
  const double c = std::cos(2 * 3.14159265358979324 / 5);
  for (const double sigma : {0.25, 0.5, 0.75}) {
    const double q = 1 - sigma;
    const double d = (1 + c) * sigma * sigma;
    const double lambda = q / 2 * (d + 2 * q + sigma * std::sqrt((1 + c) * (d + 4 * q)));
    const auto size = [&](std::size_t steps) {
      return blend()
          .surface(std::vector<Rational>(steps, Rational::from_double(sigma)), false)
          .holes.front()
          .size;
    };
    EXPECT_NEAR(size(13) / size(12), lambda, 1e-3) << sigma;
  }
}

TEST(SpeedRings, FaultsOfTheFlatNetVanish) {
  RingModel model = blend();
  for (Point3& p : model.points) p[2] = 0;
  EXPECT_EQ(cap_fault(model.surface({Rational(1, 2)}, true)), 0);
  EXPECT_EQ(curvature_spread(model.surface({Rational(1, 2)}, true)), 0);
}

}  // namespace
}  // namespace subdiv
