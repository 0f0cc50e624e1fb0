#include "schemes/evaluate/nested_rings.h"

#include <gtest/gtest.h>

#include <array>
#include <tuple>
#include <vector>

#include "schemes/evaluate/bezier_patch.h"
#include "tests/schemes/evaluate/random_nets.h"

namespace subdiv {
namespace {

using sample::random_net;
using Rings = NestedRings<Rational>;

Rings rings_of(const SectorNet<Rational>& net, const std::vector<Rational>& speeds) {
  const auto steps = speed_steps<Rational>(speeds);
  return nested_rings<Rational, Rational>(
      net, steps, [&](std::size_t k) { return vertex_weights(speeds[k], net.valence()); });
}

/// The part [from, to] of a cubic, from polar values: de Casteljau with mixed arguments.
Rational blossom(const std::array<Rational, 4>& b, const std::array<Rational, 3>& arguments) {
  std::array<Rational, 4> level = b;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t i = 0; i + r + 1 < 4; ++i)
      level[i] = (Rational(1) - arguments[r]) * level[i] + arguments[r] * level[i + 1];
  }
  return level[0];
}
BezierPatch<Rational> part(const BezierPatch<Rational>& patch, const std::array<Rational, 2>& i_range,
                           const std::array<Rational, 2>& j_range) {
  const auto arguments = [](const std::array<Rational, 2>& range, std::size_t k) {
    return std::array{range[k > 0 ? 1 : 0], range[k > 1 ? 1 : 0], range[k > 2 ? 1 : 0]};
  };
  BezierPatch<Rational> result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      std::array<Rational, 4> column;
      for (std::size_t k = 0; k < 4; ++k)
        column[k] = blossom({patch[4 * k], patch[4 * k + 1], patch[4 * k + 2], patch[4 * k + 3]},
                            arguments(j_range, j));
      result[4 * i + j] = blossom(column, arguments(i_range, i));
    }
  }
  return result;
}

using Parameters = std::tuple<int, std::vector<Rational>>;
class NestedRingsOf : public testing::TestWithParam<Parameters> {};

TEST_P(NestedRingsOf, JoinTwiceDifferentiably) {
  const auto& [n, speeds] = GetParam();
  const Rings result = rings_of(random_net<Rational>(n, 3U), speeds);
  ASSERT_EQ(result.rings.size(), speeds.size());
  const auto layers = [](const BezierPatch<Rational>& patch, PatchEdge edge) {
    return edge_layers(patch, edge);
  };
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const Rational& s = speeds[k];
    const Rational q = Rational(1) - s;
    const auto& ring = result.rings[k];
    for (std::size_t l = 0; l < ring.size(); ++l) {
      const auto& [corner, next_side, first_side] = ring[l];
      EXPECT_TRUE(joins_c2(layers(corner, PatchEdge::last_j), s, layers(first_side, PatchEdge::first_j), q));
      EXPECT_TRUE(joins_c2(layers(corner, PatchEdge::last_i), s, layers(next_side, PatchEdge::first_i), q));
      // Across the spoke between this sector and the next one.
      const auto& beyond = ring[(l + 1) % ring.size()].first_side;
      EXPECT_TRUE(joins_c2(layers(next_side, PatchEdge::last_i), q, layers(beyond, PatchEdge::last_j), q));
      if (k + 1 == speeds.size()) {
        // The hole: b_(3, 3) is out of the layers' sight but for the last column.
        auto hole = result.hole[l];
        auto outside = layers(first_side, PatchEdge::last_i);
        auto inside = layers(hole, PatchEdge::first_i);
        EXPECT_TRUE(joins_c2(outside, s, inside, q));
        continue;
      }
      const Rational& t = speeds[k + 1];
      const auto& inner = result.rings[k + 1][l];
      const std::array<Rational, 2> whole{Rational(0), Rational(1)};
      const auto outer_part = [&](const Rational& from, const Rational& to) {
        return layers(part(first_side, whole, {from, to}), PatchEdge::last_i);
      };
      EXPECT_TRUE(joins_c2(outer_part(Rational(0), t), s, layers(inner.corner, PatchEdge::first_i), q * t));
      EXPECT_TRUE(
          joins_c2(outer_part(t, Rational(1)), s, layers(inner.first_side, PatchEdge::first_i), q * t));
      const auto other_part = [&](const Rational& from, const Rational& to) {
        return layers(part(next_side, {from, to}, whole), PatchEdge::last_j);
      };
      EXPECT_TRUE(joins_c2(other_part(Rational(0), t), s, layers(inner.corner, PatchEdge::first_j), q * t));
      EXPECT_TRUE(
          joins_c2(other_part(t, Rational(1)), s, layers(inner.next_side, PatchEdge::first_j), q * t));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Speeds, NestedRingsOf,
    testing::Combine(testing::Values(3, 4, 5, 7),
                     testing::Values(std::vector<Rational>{Rational(1, 2)},
                                     std::vector<Rational>{Rational(1, 2), Rational(3, 4)},
                                     std::vector<Rational>{Rational(3, 4), Rational(3, 4), Rational(1, 5)})));

// At a regular vertex every speed gives parts of the uniform spline itself.
TEST(NestedRings, AtARegularVertexAreTheSpline) {
  const SectorNet<Rational> net = random_net<Rational>(4, 5U);
  // Bezier points of the uniform spline on the face of sector l, b_(0, 0) at the far corner: products of
  // these rows over the places -1 .. 2 along both spokes.
  const std::array<std::array<Rational, 4>, 4> rows{
      {{Rational(0), Rational(1, 6), Rational(2, 3), Rational(1, 6)},
       {Rational(0), Rational(1, 3), Rational(2, 3), Rational(0)},
       {Rational(0), Rational(2, 3), Rational(1, 3), Rational(0)},
       {Rational(1, 6), Rational(2, 3), Rational(1, 6), Rational(0)}}};
  const auto point = [&](int sector, int i, int j) {
    if (i < 0 && j < 0) return net.at(sector + 2, sector_place(1, 1).place);
    const SectorPlace place = sector_place(i, j);
    return place.place < 0 ? net.centre() : net.at(sector + place.sector, place.place);
  };
  const std::vector<Rational> speeds{Rational(2, 3), Rational(1, 2), Rational(4, 5)};
  const Rings result = rings_of(net, speeds);
  for (std::size_t l = 0; l < 4; ++l) {
    BezierPatch<Rational> face;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        for (int a = -1; a <= 2; ++a) {
          for (int b = -1; b <= 2; ++b) {
            face[4 * i + j] += rows[i][static_cast<std::size_t>(a + 1)] *
                               rows[j][static_cast<std::size_t>(b + 1)] * point(static_cast<int>(l), a, b);
          }
        }
      }
    }
    Rational from(0);
    const Rational end(1);
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      const Rational middle = from + (end - from) * speeds[k];
      EXPECT_EQ(result.rings[k][l].corner, part(face, {from, middle}, {from, middle}));
      EXPECT_EQ(result.rings[k][l].next_side, part(face, {middle, end}, {from, middle}));
      EXPECT_EQ(result.rings[k][l].first_side, part(face, {from, middle}, {middle, end}));
      from = middle;
    }
  }
}

}  // namespace
}  // namespace subdiv
