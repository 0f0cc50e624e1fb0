#include "experiments/ring_files.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/mesh/fan.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

/// Two rings of quads around a vertex of valence 5, in space at random, and one step of this speed.
RingSurface surface_of_speed(const Rational& sigma) {
  const MeshTopology mesh = fan_topology(4, 5, 2);
  return ring_surface(mesh, sample::random_points<double>(mesh.vertices(), 3U),
                      SpeedSchedule({Algebraic(sigma)}));
}

using Counts = std::vector<std::size_t>;

/// How many edges of the ring the quads next to it have, outside the ring, patch by patch in both
/// directions; each patch has one joint.
std::map<Counts, int> edges_at_joints(const Rational& sigma, int pieces) {
  const RingSurface surface = surface_of_speed(sigma);
  const GroupedMesh mesh = tessellated(surface, pieces);
  const auto side = static_cast<std::size_t>(pieces);
  std::map<Counts, int> result;
  for (const RingJoint& joint : surface.joints) {
    Counts counts;
    for (std::size_t k = 0; k < side; ++k) {
      std::size_t i = k;
      std::size_t j = k;
      if (joint.outer_edge == PatchEdge::first_i) i = 0;
      if (joint.outer_edge == PatchEdge::last_i) i = side - 1;
      if (joint.outer_edge == PatchEdge::first_j) j = 0;
      if (joint.outer_edge == PatchEdge::last_j) j = side - 1;
      counts.push_back(mesh.faces.face((joint.outer * side + i) * side + j).size() - 3);
    }
    if (joint.reversed) std::reverse(counts.begin(), counts.end());
    ++result[counts];
  }
  return result;
}

// Vertices of the ring stand at sigma k/4 and sigma + (1 - sigma) k/4 of an edge, k = 0 .. 4, or mirrored;
// the quads outside end at those nearest to 1/4, 1/2 and 3/4.
TEST(RingFiles, QuadsOutsideEndAtTheNearestVerticesOfTheRing) {
  EXPECT_EQ(edges_at_joints(Rational(1, 2), 4), (std::map<Counts, int>{{{2, 2, 2, 2}, 10}}));
  // At 0.225, 0.45, 0.675, 0.9, 0.925, ..
  EXPECT_EQ(edges_at_joints(Rational(9, 10), 4), (std::map<Counts, int>{{{1, 1, 1, 5}, 10}}));
  EXPECT_EQ(edges_at_joints(Rational(1, 10), 4), (std::map<Counts, int>{{{5, 1, 1, 1}, 10}}));
  // At 5/32 k: 0.31 and 0.47 of 0.16, 0.31, 0.47, 0.63; then 0.72 of 0.72, 0.81, 0.91.
  EXPECT_EQ(edges_at_joints(Rational(5, 8), 4), (std::map<Counts, int>{{{2, 1, 2, 3}, 10}}));
}

TEST(RingFiles, NamesGroups) {
  const RingSurface surface = surface_of_speed(Rational(1, 2));
  ASSERT_EQ(surface.groups(), 3U);
  EXPECT_EQ(group_name(surface, 0), "regular");
  EXPECT_EQ(group_name(surface, 1), "ring_1");
  EXPECT_EQ(group_name(surface, 2), "cap");
}

}  // namespace
}  // namespace subdiv
