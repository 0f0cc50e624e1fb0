#include "schemes/evaluate/ring_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "schemes/evaluate/bezier_patch.h"
#include "schemes/evaluate/nested_rings.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/input_error.h"
#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/fan.h"
#include "tests/sample_meshes.h"
#include "tests/schemes/evaluate/random_nets.h"

namespace subdiv {
namespace {

using Points = std::vector<Point3>;

SpeedSchedule schedule(const std::vector<Rational>& speeds) {
  return SpeedSchedule(std::vector<Algebraic>(speeds.begin(), speeds.end()));
}

struct Mesh {
  MeshTopology topology;
  Points points;
};
Mesh random_mesh(const PolygonFaces& faces, unsigned seed) {
  MeshTopology topology(faces);
  Points points = sample::random_points<double>(topology.vertices(), seed);
  return {std::move(topology), std::move(points)};
}
Mesh refined(const Mesh& mesh) {
  return {split_into_quads(mesh.topology),
          refined_points(mesh.topology, catmull_clark<double>(), mesh.points)};
}

Point3 difference(const Point3& a, const Point3& b, double factor) {
  return {factor * (a[0] - b[0]), factor * (a[1] - b[1]), factor * (a[2] - b[2])};
}

/// Layers of two patches next to a common edge: first and second derivatives by the widths across it.
void expect_c2(const std::array<std::array<Point3, 4>, 3>& a, double width_a,
               const std::array<std::array<Point3, 4>, 3>& b, double width_b) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3 da = difference(a[0][k], a[1][k], 1 / width_a);
    const Point3 db = difference(b[1][k], b[0][k], 1 / width_b);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_EQ(a[0][k][d], b[0][k][d]);
      EXPECT_NEAR(da[d], db[d], 1e-10);
      const double second_a = (a[0][k][d] - 2 * a[1][k][d] + a[2][k][d]) / (width_a * width_a);
      const double second_b = (b[0][k][d] - 2 * b[1][k][d] + b[2][k][d]) / (width_b * width_b);
      EXPECT_NEAR(second_a, second_b, 1e-9);
    }
  }
}

/// The part [from, to] of layers along their edge, [0, 1] into [0, at] and [at, 1].
std::array<std::array<std::array<Point3, 4>, 3>, 2> parts(const std::array<std::array<Point3, 4>, 3>& layers,
                                                          double at) {
  std::array<std::array<std::array<Point3, 4>, 3>, 2> result{};
  for (std::size_t l = 0; l < 3; ++l) {
    const auto split = detail::split_cubic(layers[l], at);
    result[0][l] = split[0];
    result[1][l] = split[1];
  }
  return result;
}

std::array<std::array<Point3, 4>, 3> turned(std::array<std::array<Point3, 4>, 3> layers) {
  for (auto& layer : layers) std::reverse(layer.begin(), layer.end());
  return layers;
}

// Vertices of valence 3 and others, after one step two edges apart: rings share edges with rings.
TEST(RingSurface, JoinsC2AtEveryJoint) {
  for (const PolygonFaces& faces : {sample::cube(), sample::quads_of(sample::bipyramid(5))}) {
    const Mesh mesh = refined(random_mesh(faces, 5U));
    const std::vector<Rational> speeds{Rational(2, 3), Rational(1, 4)};
    const RingSurface surface = ring_surface(mesh.topology, mesh.points, schedule(speeds));
    ASSERT_FALSE(surface.joints.empty());
    for (const RingJoint& joint : surface.joints) {
      auto outer = edge_layers(surface.patches[joint.outer], joint.outer_edge);
      std::array<std::size_t, 2> inner = joint.inner;
      double at = joint.split;
      if (joint.reversed) {
        outer = turned(outer);
        std::swap(inner[0], inner[1]);
        at = 1 - at;
      }
      const bool outside = joint.outer < surface.begin[1];
      const double s = 2.0 / 3;
      const double width_out = outside ? 1 : s;
      const double width_in = outside ? s : (1 - s) / 4;
      const auto outer_parts = parts(outer, at);
      for (std::size_t k = 0; k < 2; ++k) {
        auto layers = edge_layers(surface.patches[inner[k]], joint.inner_edge);
        auto wanted = outer_parts[k];
        for (std::size_t i = 0; i < 4; ++i) {
          for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(layers[0][i][d], wanted[0][i][d], 1e-12);
        }
        wanted[0] = layers[0];
        expect_c2(wanted, width_out, layers, width_in);
      }
    }
  }
}

// The cube after one step: the faces around its corners touch, and so do their rings.
TEST(RingSurface, JoinsC2BetweenRingsOfTwoVertices) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 6U));
  const RingSurface surface = ring_surface(mesh.topology, mesh.points, schedule({Rational(3, 5)}));
  EXPECT_EQ(surface.begin[1], 0U);  // all faces are in rings
  int pairs = 0;
  for (std::size_t a = 0; a < surface.patches.size(); ++a) {
    for (std::size_t b = 0; b < surface.patches.size(); ++b) {
      if (a / 9 == b / 9) continue;  // rings of one vertex: 3 sectors of 3 patches
      for (const PatchEdge edge : {PatchEdge::first_i, PatchEdge::first_j}) {
        for (const PatchEdge other : {PatchEdge::first_i, PatchEdge::first_j}) {
          const auto one = edge_layers(surface.patches[a], edge);
          const auto two = edge_layers(surface.patches[b], other);
          if (one[0] != two[0]) continue;
          ++pairs;
          expect_c2(one, 1, two, 1);
        }
      }
    }
  }
  EXPECT_EQ(pairs, 2 * 2 * 24);  // 24 edges between faces of two corners, two patches each, from both sides
}

// What is rounded stays within the bound that the schedule promises.
TEST(RingSurface, RoundingIsBounded) {
  for (const std::vector<Rational>& speeds :
       {std::vector<Rational>{Rational(1, 3), Rational(1, 3)},
        std::vector<Rational>{Rational(9999, 10000), Rational(1, 7)},
        std::vector<Rational>{Rational(1, 1000), Rational(999999, 1000000)}}) {
    for (const int n : {3, 5, 9}) {
      const SectorNet<Rational> exact_net = sample::random_net<Rational>(n, 4U);
      std::vector<double> points;
      for (const Rational& x : exact_net.points()) points.push_back(x.to_double());
      const auto steps = speed_steps<Rational>(speeds);
      const auto exact = nested_rings<Rational, Rational>(
          exact_net, steps, [&](std::size_t k) { return vertex_weights(speeds[k], n); });
      const SpeedSchedule rounded = schedule(speeds);
      const auto weights = rounded.weights(n);
      const auto rings = nested_rings<double, double>(SectorNet<double>(n, points), rounded.steps(),
                                                      [&](std::size_t k) { return weights[k]; });
      const double bound = rounded.rounding(n).of(10);  // coordinates up to 10
      EXPECT_LT(bound, 1e-9);
      for (std::size_t k = 0; k < speeds.size(); ++k) {
        for (std::size_t l = 0; l < static_cast<std::size_t>(n); ++l) {
          for (const auto part : {&RingSector<double>::corner, &RingSector<double>::next_side,
                                  &RingSector<double>::first_side}) {
            const auto& patch = rings.rings[k][l].*part;
            const auto& wanted = part == &RingSector<double>::corner      ? exact.rings[k][l].corner
                                 : part == &RingSector<double>::next_side ? exact.rings[k][l].next_side
                                                                          : exact.rings[k][l].first_side;
            for (std::size_t i = 0; i < 16; ++i)
              EXPECT_LE(abs(Rational::from_double(patch[i]) - wanted[i]), Rational::from_double(bound));
          }
        }
      }
    }
  }
}

TEST(RingSurface, CountsPatches) {
  const Mesh mesh = refined(random_mesh(sample::quads_of(sample::bipyramid(7)), 7U));
  int faces_in_rings = 0;
  for (int v = 0; v < mesh.topology.vertices(); ++v)
    faces_in_rings += mesh.topology.valence(v) == 4 ? 0 : mesh.topology.valence(v);
  const auto n = static_cast<std::size_t>(faces_in_rings);
  const RingSurface surface =
      ring_surface(mesh.topology, mesh.points, schedule({Rational(1, 2), Rational(3, 4)}), {true, true});
  EXPECT_EQ(surface.begin,
            (std::vector<std::size_t>{0, static_cast<std::size_t>(mesh.topology.faces()) - n,
                                      static_cast<std::size_t>(mesh.topology.faces()) + 2 * n,
                                      static_cast<std::size_t>(mesh.topology.faces()) + 5 * n,
                                      static_cast<std::size_t>(mesh.topology.faces()) + 6 * n}));
}

TEST(RingSurface, WithoutStepsIsTheBorderAndTheLimitPoint) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 8U));
  const RingSurface none = ring_surface(mesh.topology, mesh.points, schedule({}), {true, true});
  // Speeds do not matter to the tensor border: a ring of nearly the whole width ends in the same cap.
  ASSERT_EQ(none.patches.size(), 24U);
  const RingSurface wide = ring_surface(mesh.topology, mesh.points, schedule({Rational(1, 1000000)}));
  for (std::size_t p = 0; p < 24; ++p) {
    for (const std::size_t corner : {0U, 3U, 12U}) {
      for (std::size_t d = 0; d < 3; ++d) {
        const BezierPatch<Point3>& other = wide.patches[3 * p + (corner == 0 ? 0 : corner == 3 ? 2 : 1)];
        EXPECT_EQ(none.patches[p][corner][d], other[corner][d]);
      }
    }
  }
}

TEST(RingSurface, NamesFaults) {
  const auto fault = [](const PolygonFaces& faces) { return find_ring_fault(MeshTopology(faces)); };
  EXPECT_FALSE(fault(sample::sheet(2, 3)));
  EXPECT_FALSE(fault(sample::torus(3, 5, 4)));
  const auto cube = fault(sample::cube());
  ASSERT_TRUE(cube);
  EXPECT_TRUE(cube->step_helps);
  EXPECT_EQ(cube->vertex, 0);
  // A vertex of valence 5 next to the border, in one step apart from it.
  const MeshTopology fan = fan_topology(4, 5, 1);
  ASSERT_TRUE(find_ring_fault(fan));
  EXPECT_TRUE(find_ring_fault(fan)->step_helps);
  EXPECT_FALSE(find_ring_fault(split_into_quads(fan)));
  EXPECT_FALSE(find_ring_fault(fan_topology(4, 5, 2)));
  // At the border itself no step helps.
  const PolygonFaces ell = sample::polygons(8, {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}});
  ASSERT_TRUE(fault(ell));
  EXPECT_FALSE(fault(ell)->step_helps);
  EXPECT_EQ(fault(ell)->vertex, 4);
  const auto stepped = find_ring_fault(split_into_quads(MeshTopology(ell)));
  ASSERT_TRUE(stepped);
  EXPECT_FALSE(stepped->step_helps);
  // Two quads with three corners in common meet at a vertex of valence 2.
  const auto pillow = fault(sample::polygons(6, {{0, 1, 2, 3}, {0, 3, 4, 1}, {1, 4, 5, 2}, {3, 2, 5, 4}}));
  ASSERT_TRUE(pillow);
  EXPECT_EQ(pillow->what, "vertex 1 has valence 2");
  EXPECT_FALSE(pillow->step_helps);
}

TEST(RingSurface, RefusesStepsThatLeaveNoDigits) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 9U));
  EXPECT_THROW(static_cast<void>(ring_surface(mesh.topology, mesh.points,
                                              schedule(std::vector<Rational>(30, Rational(9, 10))))),
               InputError);
  EXPECT_NO_THROW(static_cast<void>(
      ring_surface(mesh.topology, mesh.points, schedule(std::vector<Rational>(24, Rational(1, 2))))));
  EXPECT_THROW(schedule({Rational(0)}), InputError);
  EXPECT_THROW(schedule({Rational(1)}), InputError);
  EXPECT_THROW(schedule({Rational(1) - Rational::power_of_two(-65)}), InputError);
}

// The bound follows the coordinates.
TEST(RingSurface, RoundingScalesWithTheMesh) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 9U));
  const SpeedSchedule speeds = schedule({Rational(1, 3), Rational(3, 4)});
  double expected = 0;  // the greatest coordinate around any corner
  for (const Point3& p : mesh.points) {
    for (const double x : p) expected = std::max(expected, std::abs(x));
  }
  EXPECT_EQ(ring_surface(mesh.topology, mesh.points, speeds).rounding, speeds.rounding(3).of(expected));
  for (const int exponent : {-500, 20, 500}) {
    Points scaled = mesh.points;
    for (Point3& p : scaled) {
      for (double& x : p) x = std::ldexp(x, exponent);
    }
    EXPECT_EQ(ring_surface(mesh.topology, scaled, speeds).rounding,
              speeds.rounding(3).of(std::ldexp(expected, exponent)));
  }
}

// Neither more nor fewer steps than leave three digits.
TEST(RingSurface, StepsStopWhereThreeDigitsAreLeft) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 9U));
  for (const Rational& sigma : {Rational(1, 2), Rational(3, 4)}) {
    double left = 0;  // of the last steps that are taken: the hole in units of the bound
    bool refused = false;
    for (std::size_t steps = 1; steps < 60 && !refused; ++steps) {
      const SpeedSchedule speeds = schedule(std::vector<Rational>(steps, sigma));
      try {
        const RingSurface surface = ring_surface(mesh.topology, mesh.points, speeds);
        left = std::numeric_limits<double>::infinity();
        for (const RingHole& hole : surface.holes)
          left = std::min({left, hole.size / surface.rounding,
                           speeds.least_width() * hole.first_size / surface.rounding});
      } catch (const InputError& error) {
        refused = true;
        EXPECT_NE(std::string(error.what()).find("fewer steps"), std::string::npos);
      }
    }
    EXPECT_TRUE(refused);
    EXPECT_GE(left, 1000 * (1 - 0.5));  // bounds of single vertices are at most that of the surface
    EXPECT_LE(left, 1000 * 16);
  }
}

// A narrow ring is refused although the hole is wide.
TEST(RingSurface, RefusesARingWithoutDigits) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 9U));
  EXPECT_NO_THROW(
      static_cast<void>(ring_surface(mesh.topology, mesh.points, schedule({Rational(1, 1000000)}))));
  EXPECT_THROW(static_cast<void>(
                   ring_surface(mesh.topology, mesh.points, schedule({Rational(1) / pow(Rational(10), 14)}))),
               InputError);
}

TEST(RingSurface, NamesTheCauseOfLostDigits) {
  const Mesh mesh = refined(random_mesh(sample::cube(), 9U));
  const auto message = [&](double scale, double offset) -> std::string {
    Points points = mesh.points;
    for (Point3& p : points) {
      for (double& x : p) x = scale * x + offset;
    }
    try {
      static_cast<void>(ring_surface(mesh.topology, points, schedule({Rational(1, 2)})));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(1, 0), "");
  EXPECT_EQ(message(1e-290, 0), "");
  EXPECT_EQ(message(1e288, 0), "");
  EXPECT_NE(message(1, 1e13).find("to the origin"), std::string::npos) << message(1, 1e13);
  EXPECT_NE(message(1e-320, 0).find("scale the mesh up"), std::string::npos) << message(1e-320, 0);
  EXPECT_NE(message(1e300, 0).find("scale the mesh down"), std::string::npos) << message(1e300, 0);
}

// Sizes of holes against the corners of the caps: farthest from the limit point.
TEST(RingSurface, SizesAreThoseOfTheCapsCorners) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Mesh mesh = refined(random_mesh(sample::cube(), seed));
    const auto sizes = [&](const RingSurface& surface) {
      std::vector<double> result;
      std::size_t patch = surface.begin[surface.groups() - 1];
      for (std::size_t v = 0; v < 8; ++v) {
        result.push_back(0);
        for (std::size_t k = 0; k < 3; ++k, ++patch) {
          const BezierPatch<Point3>& cap = surface.patches[patch];
          for (const std::size_t corner : {0U, 3U, 12U}) {
            result.back() =
                std::max(result.back(), std::hypot(cap[corner][0] - cap[15][0], cap[corner][1] - cap[15][1],
                                                   cap[corner][2] - cap[15][2]));
          }
        }
      }
      return result;
    };
    const std::vector<double> first =
        sizes(ring_surface(mesh.topology, mesh.points, schedule({}), {true, true}));
    const RingSurface surface =
        ring_surface(mesh.topology, mesh.points, schedule({Rational(2, 5)}), {true, true});
    const std::vector<double> last = sizes(surface);
    ASSERT_EQ(surface.holes.size(), 8U);
    for (std::size_t v = 0; v < 8; ++v) {
      EXPECT_EQ(surface.holes[v].first_size, first[v]);
      EXPECT_EQ(surface.holes[v].size, last[v]);
    }
  }
}

// Halstead, Kass & DeRose (1993): (n^2 V + 4 sum of edge + sum of face neighbours)/(n (n + 5)) is the limit.
TEST(RingSurface, CapsMeetInTheLimitPoint) {
  const Mesh mesh = refined(random_mesh(sample::quads_of(sample::bipyramid(7)), 3U));
  for (const std::vector<Rational>& speeds :
       {std::vector<Rational>{}, {Rational(3, 4)}, {Rational(1, 5), Rational(2, 3)}}) {
    const RingSurface surface = ring_surface(mesh.topology, mesh.points, schedule(speeds), {true, true});
    std::size_t patch = surface.begin[surface.groups() - 1];
    for (const RingHole& hole : surface.holes) {
      Point3 limit{};
      const double n = hole.valence;
      const auto add = [&](int v, double weight) {
        for (std::size_t d = 0; d < 3; ++d)
          limit[d] += weight / (n * (n + 5)) * mesh.points[static_cast<std::size_t>(v)][d];
      };
      add(hole.vertex, n * n);
      for_each_outgoing(mesh.topology, hole.vertex, [&](int h) {
        add(mesh.topology.target(h), 4);
        add(mesh.topology.target(mesh.topology.next(h)), 1);
      });
      for (int k = 0; k < hole.valence; ++k, ++patch) {
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(surface.patches[patch][15][d], limit[d], 1e-12);
      }
    }
    EXPECT_EQ(patch, surface.patches.size());
  }
}

// A border is the uniform cubic spline of its vertices, and ends in its corners.
TEST(RingSurface, BordersAreCubicSplines) {
  const Mesh mesh = random_mesh(sample::sheet(2, 3), 4U);
  const RingSurface surface = ring_surface(mesh.topology, mesh.points, schedule({}));
  ASSERT_EQ(surface.patches.size(), 6U);
  for (int f = 0; f < 3; ++f) {  // the row at the border of the vertices 0 .. 3
    const BezierPatch<Point3>& patch = surface.patches[static_cast<std::size_t>(f)];
    const auto line = edge_layers(patch, PatchEdge::first_j)[0];
    for (std::size_t d = 0; d < 3; ++d) {
      const auto p = [&](int i) { return mesh.points[static_cast<std::size_t>(i)][d]; };
      const auto at_vertex = [&](int i) {
        return i == 0 || i == 3 ? p(i) : (p(i - 1) + 4 * p(i) + p(i + 1)) / 6;
      };
      EXPECT_NEAR(line[0][d], at_vertex(f), 1e-14);
      EXPECT_NEAR(line[1][d], (2 * p(f) + p(f + 1)) / 3, 1e-14);
      EXPECT_NEAR(line[2][d], (p(f) + 2 * p(f + 1)) / 3, 1e-14);
      EXPECT_NEAR(line[3][d], at_vertex(f + 1), 1e-14);
    }
  }
}

// Neighbouring sectors have the points of their common spoke in common, bit by bit.
TEST(RingSurface, SectorsShareTheirSpokes) {
  const Mesh mesh = refined(random_mesh(sample::quads_of(sample::bipyramid(7)), 2U));
  const RingSurface surface =
      ring_surface(mesh.topology, mesh.points, schedule({Rational(3, 7), Rational(2, 3)}), {true, true});
  std::size_t start = 0;
  for (const RingHole& hole : surface.holes) {
    const auto n = static_cast<std::size_t>(hole.valence);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t own = start + k;
      const std::size_t next = start + (k + 1) % n;
      for (std::size_t ring = 1; ring <= 2; ++ring) {
        const auto& side = surface.patches[surface.begin[ring] + 3 * own + 1];
        const auto& beyond = surface.patches[surface.begin[ring] + 3 * next + 2];
        EXPECT_EQ(edge_layers(side, PatchEdge::last_i)[0], edge_layers(beyond, PatchEdge::last_j)[0]);
      }
      EXPECT_EQ(edge_layers(surface.patches[surface.begin[3] + own], PatchEdge::last_i)[0],
                edge_layers(surface.patches[surface.begin[3] + next], PatchEdge::last_j)[0]);
    }
    start += n;
  }
}

}  // namespace
}  // namespace subdiv
