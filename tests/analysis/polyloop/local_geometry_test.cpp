#include "analysis/polyloop/local_geometry.h"

#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using Exact = Vector<Rational>;

Exact point(std::initializer_list<Rational> values) {
  Exact p(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const Rational& x : values) p(i++) = x;
  return p;
}

TEST(LocalGeometry, AcceleratesTwiceTheWayToTheMiddleOfTheNeighbours) {
  const Exact a = point({1, 2});
  const Exact b = point({5, 3});
  const Exact c = point({4, 9});
  EXPECT_EQ(vertex_velocity(a, c), point({Rational(3, 2), Rational(7, 2)}));
  const Exact middle = (a + c) * Rational(1, 2);
  EXPECT_EQ(vertex_acceleration(a, b, c), Exact((middle - b) * Rational(2)));
  const Exact d = point({-2, 11});
  EXPECT_EQ(edge_jerk(a, b, c, d), Exact(vertex_acceleration(b, c, d) - vertex_acceleration(a, b, c)));
}

TEST(LocalGeometry, CircleOfARightTriangleIsThatOfThales) {
  const Exact a = point({0, 0});
  const Exact b = point({4, 0});
  const Exact c = point({4, 3});
  EXPECT_EQ(squared_circle_curvature(a, b, c), Rational(4, 25));
  EXPECT_EQ(squared_circle_curvature(b, c, a), Rational(4, 25));
  // V = (2, 3/2), h = 12/5: r = (25/4)/(24/5).
  EXPECT_EQ(squared_parabola_curvature(a, b, c), pow(Rational(96, 125), 2));
}

/// The curve x = t, y = m t^2 has the curvature 2 m at t = 0, and is the parabola through three of its
/// points.
TEST(LocalGeometry, ParabolaIsExactOnParabolas) {
  for (const Rational& step : {Rational(1, 10), Rational(1), Rational(7)}) {
    const Rational m(3, 5);
    const Exact a = point({-step, m * step * step});
    const Exact b = point({0, 0});
    const Exact c = point({step, m * step * step});
    EXPECT_EQ(squared_parabola_curvature(a, b, c), Rational(36, 25));
    EXPECT_EQ(squared_parabola_curvature(c, b, a), Rational(36, 25));
  }
}

TEST(LocalGeometry, PointsOnALineHaveNoCurvature) {
  const Exact a = point({0, 0, 1});
  const Exact b = point({1, 2, 1});
  const Exact c = point({3, 6, 1});
  for (const auto& [p, q, r] : {std::tuple{a, b, c}, std::tuple{a, c, b}, std::tuple{a, a, b},
                                std::tuple{a, b, b}, std::tuple{a, b, a}, std::tuple{a, a, a}}) {
    EXPECT_TRUE(is_zero(squared_circle_curvature(p, q, r)));
    EXPECT_TRUE(is_zero(squared_parabola_curvature(p, q, r)));
  }
}

using Curve = std::function<std::vector<double>(double)>;

Polyline sampled(const Curve& curve, const std::vector<double>& at, bool closed) {
  std::vector<std::vector<double>> coordinates(curve(0).size());
  for (const double t : at) {
    const std::vector<double> p = curve(t);
    for (std::size_t c = 0; c < p.size(); ++c) coordinates[c].push_back(p[c]);
  }
  return make_polyline(std::move(coordinates), closed);
}

Exact exact_point(const Polyline& polyline, std::size_t i) {
  Exact p(static_cast<Eigen::Index>(polyline.coordinates.size()));
  for (std::size_t c = 0; c < polyline.coordinates.size(); ++c)
    p(static_cast<Eigen::Index>(c)) = Rational::from_double(polyline.coordinates[c][i]);
  return p;
}

TEST(LocalGeometry, DoublesAgreeWithExactSquares) {
  const Polyline path =
      make_polyline({{0, 1, 2.5, 2, -1, -1.5}, {0, 0.25, -1, 3, 3, 1}, {1, 0, 2, 0.5, 0.25, 2}}, false);
  const auto at = vertex_geometry(path);
  ASSERT_EQ(at.size(), 4U);
  const std::vector<double> normal = normal_jerks(path);
  const auto jerks = edge_jerks(path);
  ASSERT_EQ(jerks.size(), normal.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Exact a = exact_point(path, i);
    const Exact b = exact_point(path, i + 1);
    const Exact c = exact_point(path, i + 2);
    EXPECT_NEAR(1 / std::pow(at[i].circle_radius(), 2), squared_circle_curvature(a, b, c).to_double(), 1e-14);
    EXPECT_NEAR(1 / std::pow(at[i].parabola_radius(), 2), squared_parabola_curvature(a, b, c).to_double(),
                1e-14);
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) along += at[i].normal[k] * at[i].tangent[k];
    EXPECT_NEAR(along, 0, 1e-15);
    if (i + 3 >= path.topology.points) continue;
    const Exact d = exact_point(path, i + 3);
    EXPECT_NEAR(normal[i] * normal[i], squared_normal_jerk(a, b, c, d).to_double(), 1e-12);
    EXPECT_EQ(jerks[i][0], edge_jerk(a, b, c, d)(0).to_double());
  }
}

TEST(LocalGeometry, SignsAndDirectionsInThePlane) {
  const auto left = vertex_geometry(make_polyline({{0, 2, 2, 0}, {0, 0, 2, 2}}, true));
  ASSERT_EQ(left.size(), 4U);
  for (const VertexGeometry& at : left) {  // V^2/(2h) = 2/(2 sqrt 2)
    EXPECT_NEAR(at.circle_curvature, 1 / std::numbers::sqrt2, 1e-15);
    EXPECT_NEAR(at.parabola_curvature, std::numbers::sqrt2, 1e-15);
  }
  EXPECT_NEAR(left[0].normal[0], 1 / std::numbers::sqrt2, 1e-15);  // at (0,0), towards the middle
  EXPECT_NEAR(left[0].normal[1], 1 / std::numbers::sqrt2, 1e-15);
  EXPECT_EQ(left[0].velocity, (std::vector<double>{1, -1}));
  EXPECT_EQ(left[0].acceleration, (std::vector<double>{2, 2}));
  const auto right = vertex_geometry(make_polyline({{0, 2, 2, 0}, {2, 2, 0, 0}}, true));
  for (const VertexGeometry& at : right) EXPECT_NEAR(at.circle_curvature, -1 / std::numbers::sqrt2, 1e-15);
}

TEST(LocalGeometry, DegenerateVerticesHaveNoDirectionAndInfiniteRadii) {
  const auto back = vertex_geometry(make_polyline({{0, 1, 0}, {0, 1, 0}}, false));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_TRUE(back[0].tangent.empty());
  EXPECT_TRUE(back[0].normal.empty());
  EXPECT_TRUE(std::isinf(back[0].circle_radius()));
  EXPECT_TRUE(std::isinf(back[0].parabola_radius()));
  const auto straight = vertex_geometry(make_polyline({{0, 1, 3}, {0, 1, 3}, {2, 2, 2}}, false));
  EXPECT_FALSE(straight[0].tangent.empty());
  EXPECT_TRUE(straight[0].normal.empty());
  EXPECT_TRUE(std::isinf(straight[0].circle_radius()));
  EXPECT_EQ(vertex_geometry(make_polyline({{1}, {1}}, true)).size(), 1U);
  EXPECT_TRUE(vertex_geometry(make_polyline({{0, 1}, {0, 1}}, false)).empty());
  EXPECT_TRUE(vertex_geometry(make_polyline({}, true)).empty());
  EXPECT_TRUE(edge_jerks(make_polyline({{1}, {1}}, true)).empty());
  const double huge = 1e200;
  const auto large = vertex_geometry(make_polyline({{0, 4 * huge, 4 * huge}, {0, 0, 3 * huge}}, false));
  EXPECT_NEAR(large[0].circle_radius() / huge, 2.5, 1e-14);
  const auto small = vertex_geometry(make_polyline({{0, 4 / huge, 4 / huge}, {0, 0, 3 / huge}}, false));
  EXPECT_NEAR(small[0].circle_radius() * huge, 2.5, 1e-14);
  EXPECT_TRUE(std::isnan(
      vertex_geometry(make_polyline({{0, std::nan(""), 1}, {0, 1, 0}}, false))[0].circle_curvature));
}

TEST(LocalGeometry, PointsThatCarryEndsDoNotCount) {
  const Polyline polyline{{6, false, 1, 2}, {{9, 0, 1, 2, 7, 8}, {9, 0, 1, 0, 7, 8}}};
  const auto at = vertex_geometry(polyline);
  ASSERT_EQ(at.size(), 1U);
  EXPECT_EQ(at[0].velocity, (std::vector<double>{1, 0}));
}

/// How fast an error falls when the step is halved, at a vertex in the middle of three.
struct Known {
  Curve curve;
  double t;
  double curvature;
  bool circle_is_exact = false;
  bool parabola_is_exact = false;
};

std::vector<Known> known_curves() {
  const double e = std::exp(0.3 * 0.8);  // the spiral e^(0.3 t): radius of curvature r sqrt(1 + 0.09)
  return {
      {[](double t) { return std::vector{3 * std::cos(t), 3 * std::sin(t)}; }, 0.4, 1.0 / 3, true},
      {[](double t) { return std::vector{3 * std::cos(t), 2 * std::sin(t)}; }, 0.7,
       6 / std::pow(9 * std::pow(std::sin(0.7), 2) + 4 * std::pow(std::cos(0.7), 2), 1.5)},
      {[](double t) { return std::vector{t, t * t}; }, 0.3, 2 / std::pow(1.36, 1.5), false, true},
      {[](double t) { return std::vector{t, t * t * t}; }, 0.5, 3 / std::pow(1 + 9.0 / 16, 1.5)},
      {[](double t) { return std::vector{std::exp(0.3 * t) * std::cos(t), std::exp(0.3 * t) * std::sin(t)}; },
       0.8, 1 / (e * std::sqrt(1.09))},
      {[](double t) { return std::vector{2 * std::cos(t), 2 * std::sin(t), t}; }, 0.3, 2.0 / 5}};
}

double order(const std::function<double(double)>& error) {
  const double step = 1.0 / 256;
  return std::log2(std::abs(error(step) / error(step / 2)));
}

TEST(LocalGeometry, CurvaturesOfKnownCurvesConvergeWithOrderTwo) {
  for (const Known& known : known_curves()) {
    const auto at = [&](double h) {
      return vertex_geometry(sampled(known.curve, {known.t - h, known.t, known.t + h}, false))[0];
    };
    const auto circle = [&](double h) { return at(h).circle_curvature - known.curvature; };
    const auto parabola = [&](double h) { return at(h).parabola_curvature - known.curvature; };
    EXPECT_NEAR(known.circle_is_exact ? circle(0.25) : order(circle) - 2, 0,
                known.circle_is_exact ? 1e-14 : 0.02);
    EXPECT_NEAR(known.parabola_is_exact ? parabola(0.25) : order(parabola) - 2, 0,
                known.parabola_is_exact ? 1e-14 : 0.02);
  }
}

/// Where the step doubles at B, the circle still converges, with order one, and the parabola to 8/9 of the
/// curvature. Curves of constant curvature keep the circle's order two.
TEST(LocalGeometry, UnevenStepsCostTheCircleAnOrderAndMisleadTheParabola) {
  for (const Known& known : known_curves()) {
    const auto at = [&](double h) {
      return vertex_geometry(sampled(known.curve, {known.t - h, known.t, known.t + 2 * h}, false))[0];
    };
    const auto circle = [&](double h) { return at(h).circle_curvature - known.curvature; };
    EXPECT_NEAR(at(1e-4).parabola_curvature, 8.0 / 9 * known.curvature, 1e-3);
    const bool helix = known.curve(0).size() == 3;
    EXPECT_NEAR(known.circle_is_exact ? circle(0.25) : order(circle) - (helix ? 2 : 1), 0,
                known.circle_is_exact ? 1e-14 : 0.05);
  }
}

TEST(LocalGeometry, JerkOfAnEdgeWithoutLengthIsAllNormal) {
  const Exact b = point({1, 2});
  EXPECT_EQ(squared_normal_jerk(point({0, 0}), b, b, point({3, 5})), Rational(34));  // D - A
}

TEST(LocalGeometry, TwoVerticesGoRound) {  // A = C and B = D: 4 (B - C)
  const Polyline two = make_polyline({{0, 1}, {0, 0}}, true);
  EXPECT_EQ(edge_jerks(two), (std::vector<std::vector<double>>{{-4, 0}, {4, 0}}));
  EXPECT_EQ(normal_jerks(two).size(), 2U);
}

TEST(LocalGeometry, InfinitePointsGiveNothingFinite) {
  const double far = std::numeric_limits<double>::infinity();
  const auto at = vertex_geometry(make_polyline({{far, 0, 1}, {0, 1, 0}}, false));
  EXPECT_FALSE(std::isfinite(at[0].circle_curvature));
  EXPECT_FALSE(std::isfinite(at[0].parabola_curvature));
}

}  // namespace
}  // namespace subdiv
