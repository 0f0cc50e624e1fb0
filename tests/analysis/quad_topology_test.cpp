#include "analysis/quad_topology.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using Quads = std::vector<std::array<std::size_t, 4>>;

const Quads cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

TEST(QuadTopology, ACubeIsASphere) {
  const QuadTopology t = quad_topology(8, cube);
  EXPECT_EQ(t.edges, 12U);
  EXPECT_EQ(t.euler_characteristic(), 2);
  EXPECT_EQ(t.genus(), 0);
  EXPECT_EQ(t.borders, 0U);
  EXPECT_EQ(t.components, 1U);
  EXPECT_TRUE(t.manifold);
  EXPECT_TRUE(t.oriented);
}

TEST(QuadTopology, ACubeWithoutTwoFacesHasBorders) {
  const QuadTopology tube = quad_topology(8, Quads(cube.begin() + 2, cube.end()));  // opposite faces
  EXPECT_EQ(tube.borders, 2U);
  EXPECT_EQ(tube.euler_characteristic(), 0);
  EXPECT_TRUE(tube.manifold);
  const QuadTopology cup = quad_topology(8, Quads(cube.begin() + 1, cube.end()));
  EXPECT_EQ(cup.borders, 1U);
  EXPECT_EQ(cup.euler_characteristic(), 1);
  EXPECT_EQ(cup.genus(), 0);
}

TEST(QuadTopology, AMoebiusStripIsNotOriented) {
  // Three quads around, joined with a twist: vertices 0..2 above, 3..5 below.
  const QuadTopology t = quad_topology(6, Quads{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}});
  EXPECT_TRUE(t.manifold);
  EXPECT_FALSE(t.oriented);
  EXPECT_EQ(t.borders, 1U);
  EXPECT_EQ(t.euler_characteristic(), 0);
}

TEST(QuadTopology, WhatIsNoSurface) {
  const QuadTopology fins = quad_topology(8, Quads{{0, 1, 2, 3}, {0, 1, 4, 5}, {1, 0, 6, 7}});
  EXPECT_FALSE(fins.manifold);  // three quads at an edge
  const QuadTopology touching = quad_topology(7, Quads{{0, 1, 2, 3}, {0, 4, 5, 6}});
  EXPECT_FALSE(touching.manifold);  // two fans at vertex 0
  EXPECT_EQ(touching.components, 1U);
  const QuadTopology folded = quad_topology(2, Quads{{0, 1, 0, 1}});
  EXPECT_FALSE(folded.manifold);
  EXPECT_EQ(quad_topology(9, cube).components, 2U);
  EXPECT_THROW((void)quad_topology(7, cube), std::out_of_range);
}

}  // namespace
}  // namespace subdiv
