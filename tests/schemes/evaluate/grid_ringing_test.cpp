#include "schemes/evaluate/grid_ringing.h"

#include <algorithm>
#include <array>
#include <utility>

#include <gtest/gtest.h>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/matrix.h"
#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Rationals = std::vector<Rational>;
using QuadList = std::vector<std::pair<std::array<std::size_t, 4>, std::array<Rational, 4>>>;

Rational q(long p, long denominator = 1) { return {p, denominator}; }

Refinement<Rational> j(const Rational& s, int depth) { return {stationary("J", jspline(s)), depth}; }

/// Control points 2^i: no value arises from other indices.
Rationals powers(std::size_t n) {
  Rationals points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(pow(q(2), static_cast<long>(i)));
  return points;
}

ControlGrid<Rational> powers_on(const Topology& rows, const Topology& columns) {
  return control_grid(rows, columns, powers(rows.points * columns.points));
}

/// Tori, cylinders of both kinds and disks.
std::vector<ControlGrid<Rational>> grids() {
  std::vector<ControlGrid<Rational>> result;
  for (const Topology& rows : {Topology{3, true, 0, 0}, Topology{5, true, 0, 0}, Topology{7, false, 2, 2}})
    for (const Topology& columns :
         {Topology{3, true, 0, 0}, Topology{4, true, 0, 0}, Topology{6, false, 2, 2}})
      result.push_back(powers_on(rows, columns));
  return result;
}

std::vector<std::pair<Refinement<Rational>, Refinement<Rational>>> refinements() {
  const Scheme<Rational> smooth =
      mixed(stationary("J", jspline(q(-33, 26))), stationary("J", jspline(q(3, 2))));
  return {{j(q(1), 0), j(q(1), 0)},
          {j(q(0), 1), j(q(3, 2), 2)},
          {j(q(3, 8), 3), {stationary("B2", bspline<Rational>(2)), 1}},
          {{smooth, 2}, {smooth, 2}}};
}

/// The quads as the tensor product by levels gives them: the second route.
QuadList expected_quads(const ControlGrid<Rational>& grid, const Refinement<Rational>& along,
                        const Refinement<Rational>& across) {
  const ControlGrid<Rational> fine = refine_grid_level_by_level(grid, along, across);
  const auto n = static_cast<long long>(refined_points(grid.rows, 2, across.depth));
  const auto m = static_cast<long long>(refined_points(grid.columns(), 2, along.depth));
  const auto index = [&](long long t, long long v) { return static_cast<std::size_t>((t % m) * n + v % n); };
  QuadList result;
  for (long long t = 0; t < m - (grid.columns().closed ? 0 : 1); ++t) {
    for (long long v = 0; v < n - (grid.rows.closed ? 0 : 1); ++v) {
      result.push_back({{index(t, v), index(t + 1, v), index(t + 1, v + 1), index(t, v + 1)},
                        {fine.at(v, t), fine.at(v, t + 1), fine.at(v + 1, t + 1), fine.at(v + 1, t)}});
    }
  }
  return result;
}

auto collecting(QuadList& quads) {
  return [&quads](const Quad<Rational>& quad) {
    const auto& c = quad.corners;
    quads.push_back({quad.vertices, {*c[0], *c[1], *c[2], *c[3]}});
  };
}

TEST(GridRinging, BothConstructionsGiveTheQuadsOfTheTensorProduct) {  // js-report 13, over the rationals
  for (const ControlGrid<Rational>& grid : grids()) {
    for (const auto& [along, across] : refinements()) {
      const QuadList expected = expected_quads(grid, along, across);
      QuadList two_rings;
      QuadList once;
      quads_by_two_rings(grid, along, across, collecting(two_rings));
      quads_evaluated_once(grid, along, across, collecting(once));
      EXPECT_EQ(two_rings, expected);
      EXPECT_EQ(once, expected);
    }
  }
}

TEST(GridRinging, StreamsEveryVertexOnceAndQuadsOfVerticesAlreadyThere) {
  for (const ControlGrid<Rational>& grid : grids()) {
    for (const auto& [along, across] : refinements()) {
      Rationals vertices;
      QuadList quads;
      stream_surface(
          grid, along, across, [&](const Rational& p) { vertices.push_back(p); },
          [&](const std::array<std::size_t, 4>& c) {
            quads.push_back(
                {c, {vertices.at(c[0]), vertices.at(c[1]), vertices.at(c[2]), vertices.at(c[3])}});
          });
      EXPECT_EQ(quads, expected_quads(grid, along, across));
      const SurfaceSize size = surface_size(grid, along, across);
      EXPECT_EQ(vertices.size(), size.along * size.across);
    }
  }
}

TEST(GridRinging, VerticesAreTheSumOverTheBasisFunctionsOfBothDirections) {  // a third route, by symbols
  const ControlGrid<Rational> grid = powers_on({4, true, 0, 0}, {3, true, 0, 0});
  const Refinement<Rational> along = j(q(1, 2), 2);
  const Refinement<Rational> across = j(q(3, 2), 3);
  const Laurent<Rational> u = iterated_symbol(along.scheme, along.depth);
  const Laurent<Rational> v = iterated_symbol(across.scheme, across.depth);
  Rationals vertices;
  stream_surface(grid, along, across, [&](const Rational& p) { vertices.push_back(p); }, [](const auto&) {});
  for (int t = 0; t < 12; ++t) {
    for (int i = 0; i < 32; ++i) {
      Rational sum;
      for (int column = -8; column <= 16; ++column)
        for (int row = -8; row <= 16; ++row) sum += u[t - 4 * column] * v[i - 8 * row] * grid.at(row, column);
      EXPECT_EQ(vertices.at(static_cast<std::size_t>(t * 32 + i)), sum);
    }
  }
}

TEST(GridRinging, FootprintIsFivePointsForEveryRowAndTwoMore) {  // js-report 14
  for (const std::size_t n : {3U, 4U, 6U}) {
    const ControlGrid<Rational> grid = powers_on({n, true, 0, 0}, {4, true, 0, 0});
    const SurfaceWork two = quads_by_two_rings(grid, j(q(1, 2), 2), j(q(1, 2), 2), [](const auto&) {});
    EXPECT_EQ(two.points_a_level(), 5 * (n + 2));
    EXPECT_EQ(two.rings(), n + 2);
    const SurfaceWork once = quads_evaluated_once(grid, j(q(1, 2), 2), j(q(1, 2), 2), [](const auto&) {});
    EXPECT_EQ(once.points_a_level(), 5 * (n + 1));
    EXPECT_EQ(once.curve_points, 2 * 4 * n);  // the curve before, and the first
  }  // The cubic B-spline alone needs no more than 3.
  const auto torus = powers_on({4, true, 0, 0}, {4, true, 0, 0});
  EXPECT_EQ(quads_by_two_rings(torus, j(q(1), 2), j(q(1), 2), [](const auto&) {}).points_a_level(), 3 * 6U);
}

TEST(GridRinging, EachTransversalCurveIsEvaluatedTwiceOrOnce) {
  const ControlGrid<Rational> torus = powers_on({4, true, 0, 0}, {3, true, 0, 0});
  const auto ignore = [](const auto&) {};
  const SurfaceWork two = quads_by_two_rings(torus, j(q(1), 3), j(q(1), 3), ignore);
  const SurfaceWork once = quads_evaluated_once(torus, j(q(1), 3), j(q(1), 3), ignore);
  EXPECT_EQ(two.curves, 2 * 24U);
  EXPECT_EQ(once.curves, 24U);
  EXPECT_EQ(two.computed_across, 2 * once.computed_across);
  EXPECT_EQ(stream_surface(torus, j(q(1), 3), j(q(1), 3), ignore, ignore).curves, 24U);
  // An open motion of 2 spans at depth 3 has 17 curves, of which 15 bound two strips.
  const ControlGrid<Rational> cylinder = powers_on({4, true, 0, 0}, {7, false, 2, 2});
  EXPECT_EQ(quads_by_two_rings(cylinder, j(q(1), 3), j(q(1), 3), ignore).curves, 2 * 16U);
  EXPECT_EQ(quads_evaluated_once(cylinder, j(q(1), 3), j(q(1), 3), ignore).curves, 17U);
}

/// A number that counts how many of its kind are alive.
struct Counted {
  double value = 0;
  static inline long alive = 0;
  static inline long most = 0;

  Counted(double x = 0) : value(x) { note(); }
  Counted(const Counted& o) : value(o.value) { note(); }
  Counted& operator=(const Counted&) = default;
  ~Counted() { --alive; }
  static void note() { most = std::max(most, ++alive); }

  friend Counted operator+(const Counted& a, const Counted& b) { return {a.value + b.value}; }
  friend Counted operator*(double w, const Counted& a) { return {w * a.value}; }
};

TEST(GridRinging, KeepsNoMorePointsThanItSays) {  // counted on the points themselves
  const std::size_t n = 4;
  const ControlGrid<Counted> grid =
      control_grid({n, true, 0, 0}, {5, true, 0, 0}, std::vector<Counted>(5 * n, Counted(1)));
  constexpr long passing = 12;  // corners of a quad, terms of a sum
  for (const int depth : {2, 4, 6}) {
    const Refinement<double> both{stationary("J", jspline(0.5)), depth};
    const auto most_alive = [&](const auto& evaluate) {
      const long before = Counted::most = Counted::alive;
      const SurfaceWork work = evaluate();
      const auto said = static_cast<long>((static_cast<std::size_t>(depth) + 1) * work.points_a_level() +
                                          work.control_points + work.curve_points);
      EXPECT_LE(Counted::most - before, said + passing);
      EXPECT_GE(Counted::most - before, said);
    };
    const auto ignore = [](const auto&) {};
    most_alive([&] { return quads_by_two_rings(grid, both, both, ignore); });
    most_alive([&] { return quads_evaluated_once(grid, both, both, ignore); });
    most_alive([&] { return stream_surface(grid, both, both, ignore, ignore); });
  }
}

TEST(GridRinging, VectorsAndIntervals) {
  using Point = Eigen::Vector3d;
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(i % 3, i % 4, i);
  const auto grid = control_grid({4, true, 0, 0}, {3, true, 0, 0}, points);
  const Refinement<double> cubic{stationary("J", jspline(1.0)), 3};
  std::vector<Point> vertices;
  stream_surface(grid, cubic, cubic, [&](const Point& p) { vertices.push_back(p); }, [](const auto&) {});
  ASSERT_EQ(vertices.size(), 24U * 32U);

  std::vector<Interval> intervals;
  for (const Point& p : points) intervals.emplace_back(Rational::from_double(p.z()));
  const Refinement<Interval> enclosed{
      map_coefficients(j(q(1), 3).scheme, [](const Rational& x) { return Interval(x); }), 3};
  std::size_t i = 0;
  stream_surface(
      control_grid({4, true, 0, 0}, {3, true, 0, 0}, intervals), enclosed, enclosed,
      [&](const Interval& z) { EXPECT_NEAR(vertices[i++].z(), z.midpoint().to_double(), 1e-12); },
      [](const auto&) {});
}

TEST(GridRinging, NothingOfAnEmptyGridAndNoQuadsOfASinglePoint) {
  const auto count = [](const Topology& rows, const Topology& columns) {
    std::pair<int, int> counts{0, 0};
    const auto grid = powers_on(rows, columns);
    stream_surface(
        grid, j(q(1), 2), j(q(1), 2), [&](const auto&) { ++counts.first; },
        [&](const auto&) { ++counts.second; });
    int quads = 0;
    quads_by_two_rings(grid, j(q(1), 2), j(q(1), 2), [&](const auto&) { ++quads; });
    EXPECT_EQ(quads, counts.second);
    quads_evaluated_once(grid, j(q(1), 2), j(q(1), 2), [&](const auto&) { --quads; });
    EXPECT_EQ(quads, 0);
    return counts;
  };
  EXPECT_EQ(count({0, true, 0, 0}, {0, true, 0, 0}), std::pair(0, 0));
  EXPECT_EQ(count({3, true, 0, 0}, {0, true, 0, 0}), std::pair(0, 0));
  EXPECT_EQ(count({5, false, 2, 2}, {5, false, 2, 2}), std::pair(1, 0));
  EXPECT_EQ(count({5, false, 2, 2}, {3, true, 0, 0}), std::pair(12, 0));
  EXPECT_EQ(count({1, true, 0, 0}, {1, true, 0, 0}), std::pair(16, 16));
}

TEST(GridRinging, RefusesWhatIsNoGrid) {
  EXPECT_THROW(control_grid({2, true, 0, 0}, {3, true, 0, 0}, powers(5)), std::invalid_argument);
  ControlGrid<Rational> grid = powers_on({3, true, 0, 0}, {3, true, 0, 0});
  const auto ignore = [](const auto&) {};
  EXPECT_THROW(quads_by_two_rings(grid, j(q(1), -3), j(q(1), 1), ignore), std::invalid_argument);
  EXPECT_THROW(quads_by_two_rings(grid, j(q(1), 1), j(q(1), -3), ignore), std::invalid_argument);
  EXPECT_THROW(stream_surface(grid, j(q(1), 31), j(q(1), 31), ignore, ignore), std::overflow_error);
  const auto short_ends = powers_on({4, false, 1, 1}, {3, true, 0, 0});  // J_s depends on two points
  EXPECT_THROW(stream_surface(short_ends, j(q(1, 2), 2), j(q(1, 2), 2), ignore, ignore), std::out_of_range);
  grid.lines[1].points.pop_back();
  EXPECT_THROW(quads_evaluated_once(grid, j(q(1), 1), j(q(1), 1), ignore), std::invalid_argument);
  grid.lines.pop_back();
  EXPECT_THROW(refine_grid_level_by_level(grid, j(q(1), 1), j(q(1), 1)), std::invalid_argument);
}

TEST(MovingPolygon, EveryPointRunsOnItsTrajectory) {  // an animated curve, js-report 13
  const auto grid = powers_on({3, true, 0, 0}, {4, true, 0, 0});
  const Scheme<Rational> motion = stationary("J", jspline(q(1, 2)));
  const Scheme<Rational> shape = stationary("J", jspline(q(3, 2)));
  MovingPolygon<Rational, Rational> moving(motion, grid, 2);
  EXPECT_EQ(moving.frames(), 16U);
  EXPECT_EQ(moving.points_per_level(), 15U);
  const Rationals first = moving.polygon().points;
  const auto by_levels = refine_grid_level_by_level(grid, Refinement{motion, 2}, Refinement{shape, 2});
  for (; !moving.done(); moving.advance()) {
    Ringing<Rational, Rational> curve(shape, moving.polygon(), 2);
    for (const Rational& p : curve)
      EXPECT_EQ(p, by_levels.at(curve.index(), static_cast<long long>(moving.frame())));
  }
  EXPECT_EQ(moving.polygon().points, first);  // the motion is closed
  moving.advance();
  EXPECT_EQ(moving.frame(), 16U);
}

TEST(MovingPolygon, AnOpenMotionEnds) {
  const auto grid = powers_on({3, true, 0, 0}, {7, false, 2, 2});
  MovingPolygon<Rational, Rational> moving(stationary("J", jspline(q(1))), grid, 1);
  Ringing<Rational, Rational> point(stationary("J", jspline(q(1))), grid.lines[2], 1);
  for (; !moving.done(); moving.advance(), point.advance())
    EXPECT_EQ(moving.polygon().points[2], point.point());
  EXPECT_TRUE(point.done());
  EXPECT_EQ(moving.frame(), 5U);
}

}  // namespace
}  // namespace subdiv
