#include "schemes/evaluate/geomorph.h"

#include <vector>

#include <gtest/gtest.h>

#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Rationals = std::vector<Rational>;

Rational q(long p, long denominator = 1) { return {p, denominator}; }

Scheme<Rational> j(const Rational& s) { return stationary("J", jspline(s)); }

Rationals squares(int n) {
  Rationals points;
  for (int i = 0; i < n; ++i) points.push_back(q(i * i * i - 5 * i));
  return points;
}

Rationals curve(const Scheme<Rational>& scheme, const Rationals& points, int depth) {
  return curve_points(refine_level_by_level(scheme, closed_polygon(points), depth));
}

TEST(Geomorph, LinearStepInsertsMidPoints) {  // J_{0,1}, jsplines 11
  EXPECT_EQ(linear_step<Rational>(2).symbol, jspline(q(0), q(1)).symbol);
  EXPECT_EQ(linear_step<Rational>(3).symbol,
            Laurent<Rational>(-2, {q(1, 3), q(2, 3), q(1), q(2, 3), q(1, 3)}));
}

TEST(Geomorph, RunsFromTheLevelBeforeToTheLevel) {
  const Rationals points = squares(5);
  for (int depth = 1; depth <= 3; ++depth) {
    const Scheme<Rational> scheme = mixed(j(q(-33, 26)), j(q(3, 2)));
    const Rationals coarse = curve(scheme, points, depth - 1);
    const Rationals fine = curve(scheme, points, depth);
    const Rationals begin = curve(geomorph(scheme, depth, q(0)), points, depth);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      EXPECT_EQ(begin[2 * i], coarse[i]);
      EXPECT_EQ(begin[2 * i + 1], (coarse[i] + coarse[(i + 1) % coarse.size()]) / q(2));
    }
    EXPECT_EQ(curve(geomorph(scheme, depth, q(1)), points, depth), fine);
    const Rationals third = curve(geomorph(scheme, depth, q(1, 3)), points, depth);
    for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_EQ(third[i], (q(2) * begin[i] + fine[i]) / q(3));
  }
  EXPECT_THROW(geomorph(j(q(1)), 0, q(1)), std::invalid_argument);
}

TEST(Geomorph, LaterStepsAreThoseOfTheScheme) {
  const Scheme<Rational> changed = geomorph(j(q(1)), 2, q(1, 2));
  EXPECT_EQ(changed.step(0), jspline(q(1)));
  EXPECT_EQ(changed.step(2), jspline(q(1)));
  EXPECT_EQ(changed.step(7), jspline(q(1)));
}

TEST(Geomorph, OfASurfaceIsStraight) {
  const auto grid = control_grid({3, true, 0, 0}, {4, true, 0, 0}, squares(12));
  const Refinement<Rational> along{j(q(3, 8)), 2};
  const Refinement<Rational> across{j(q(3, 2)), 1};
  const auto vertices = [&](const Rational& t) {
    Rationals result;
    stream_geomorph(grid, along, across, t, [&](const Rational& p) { result.push_back(p); });
    return result;
  };
  Rationals fine;
  stream_surface(grid, along, across, [&](const Rational& p) { fine.push_back(p); }, [](const auto&) {});
  EXPECT_EQ(vertices(q(1)), fine);
  const auto coarse = refine_grid_level_by_level(grid, Refinement{j(q(3, 8)), 1}, Refinement{j(q(3, 2)), 0});
  const Rationals begin = vertices(q(0));
  ASSERT_EQ(begin.size(), 16U * 6U);
  for (long long t = 0; t < 8; ++t) {
    for (long long v = 0; v < 3; ++v) {  // bilinear: vertices, mid-edges and centres of the quads before
      const auto at = [&](long long dt, long long dv) {
        return begin[static_cast<std::size_t>((2 * t + dt) * 6 + 2 * v + dv)];
      };
      EXPECT_EQ(at(0, 0), coarse.at(v, t));
      EXPECT_EQ(at(1, 0), (coarse.at(v, t) + coarse.at(v, t + 1)) / q(2));
      EXPECT_EQ(
          at(1, 1),
          (coarse.at(v, t) + coarse.at(v, t + 1) + coarse.at(v + 1, t + 1) + coarse.at(v + 1, t)) / q(4));
    }
  }
  const Rationals part = vertices(q(2, 5));
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_EQ(part[i], (q(3) * begin[i] + q(2) * fine[i]) / q(5));
}

TEST(Geomorph, BlendsOfBothDirectionsStepsRunOnParabolas) {  // why results are blended instead
  const auto grid = control_grid({3, true, 0, 0}, {4, true, 0, 0}, squares(12));
  const auto vertices = [&](const Rational& t) {
    const Refinement<Rational> blend{geomorph(j(q(1)), 1, t), 1};
    Rationals result;
    stream_surface(grid, blend, blend, [&](const Rational& p) { result.push_back(p); }, [](const auto&) {});
    return result;
  };
  const Rationals at0 = vertices(q(0));
  const Rationals at1 = vertices(q(1, 3));
  const Rationals at2 = vertices(q(2, 3));
  const Rationals at3 = vertices(q(1));
  bool straight = true;
  for (std::size_t i = 0; i < at0.size(); ++i) {
    EXPECT_EQ(at3[i] - q(3) * at2[i] + q(3) * at1[i] - at0[i], q(0));
    straight = straight && at2[i] - q(2) * at1[i] + at0[i] == q(0);
  }
  EXPECT_FALSE(straight);
}

}  // namespace
}  // namespace subdiv
