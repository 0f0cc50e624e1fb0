#include "analysis/open_polygon.h"

#include <gtest/gtest.h>

#include "analysis/limit_points.h"
#include "schemes/bspline.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Weights = std::vector<Laurent<Rational>>;

Rational q(long p, long denominator = 1) { return {p, denominator}; }

EndWeights<Rational> ends_of(const std::string& scheme, OpenEnd end = OpenEnd::clamped) {
  return end_weights<Rational>(parse_scheme(scheme), end);
}

/// P_{-1} and P_{-2} of js-report 11.
Weights papers_points(const Rational& s) {
  return {Laurent<Rational>(0, {(q(9) - s) / q(4), (s - q(3)) / q(2), (q(1) - s) / q(4)}),
          Laurent<Rational>(0, {(q(12) - s) / q(2), s - q(8), (q(6) - s) / q(2)})};
}

/// The points that the rings of a scheme need, of those.
Weights papers_points(const Rational& s, std::size_t count) {
  Weights result = papers_points(s);
  result.resize(count);
  return result;
}

TEST(OpenPolygon, ClampedJsplinesForAllParameters) {
  for (const auto& [text, s] : {std::pair{"0", q(0)},
                                {"1", q(1)},
                                {"1/2", q(1, 2)},
                                {"3/2", q(3, 2)},
                                {"-7/4", q(-7, 4)},
                                {"0.476", q(476, 1000)},
                                {"6", q(6)}}) {
    const EndWeights<Rational> ends = ends_of(std::string("jspline:s=") + text);
    const IndexWindow window = vertex_reach(stationary("J", jspline(s)));
    EXPECT_EQ(ends.start, papers_points(s, static_cast<std::size_t>(-window.first))) << text;
    EXPECT_EQ(ends.finish, papers_points(s, static_cast<std::size_t>(window.last))) << text;
  }
  const EndWeights<RationalFunction> family =
      end_weights<RationalFunction>(parse_scheme("jspline:s=s"), OpenEnd::clamped,
                                    std::vector<RationalFunction>{RationalFunction::variable(0)});
  EXPECT_EQ(family.start[1][1], RationalFunction::variable(0) - RationalFunction(8));
}

/// The curve starts and ends as it should, by exact masks and refined many times.
void expect_clamped(const Scheme<Rational>& scheme, const EndWeights<Rational>& ends) {
  const std::vector<Rational> points{q(3), q(-1), q(4), q(1), q(-5), q(9)};
  const ControlPolygon<Rational> polygon = with_ends(points, ends);
  const LimitPoints<Rational> limit = limit_points(scheme, polygon);
  EXPECT_EQ(limit.positions.front(), q(3));
  EXPECT_EQ(limit.positions.back(), q(9));
  EXPECT_EQ(limit.tangents.front(), q(-4));
  EXPECT_EQ(limit.tangents.back(), q(14));
  constexpr int depth = 12;
  constexpr int density = 1 << depth;
  const Ringing<Rational, Rational> rings(scheme, polygon, depth);  // has all the points it needs
  EXPECT_NEAR(rings.point().to_double(), 3, 5e-3);
  const auto refined = curve_points(refine_level_by_level(scheme, polygon, depth));
  EXPECT_EQ(refined.size(), 5U * density + 1);
  EXPECT_NEAR(refined.back().to_double(), 9, 5e-3);
  EXPECT_NEAR((q(density) * (refined[1] - refined[0])).to_double(), -4, 0.1);
}

TEST(OpenPolygon, LimitsStartAndEndAsTheyShould) {
  for (const char* text : {"jspline:s=0", "jspline:s=1", "jspline:s=3/2", "jspline:s=-1/2",
                           "jspline:a=-7/4,b=59/52+jspline:s=3/2", "jspline:s=0+jspline:s=1",
                           "jspline:s=-33/26+jspline:s=1/2", "four-point:w=1/16", "bspline:degree=3",
                           "bspline:degree=5", "bspline:degree=7", "deslauriers-dubuc:points=6"}) {
    SCOPED_TRACE(text);
    const SchemeDescription description = parse_scheme(text);
    expect_clamped(instantiate<Rational>(description), end_weights<Rational>(description, OpenEnd::clamped));
  }
}

TEST(OpenPolygon, MasksThatLookDifferentFromBothEnds) {
  const Laurent<Rational> uneven(-1, {q(1, 2), q(1, 3), q(1, 6)});
  const Scheme<Rational> skew = stationary("skew", Mask<Rational>{2, bspline<Rational>(3).symbol * uneven});
  const EndWeights<Rational> ends = end_weights(skew, OpenEnd::clamped);
  EXPECT_NE(ends.start, ends.finish);
  expect_clamped(skew, ends);
}

TEST(OpenPolygon, ChoicesAreNearestToReflectedPoints) {
  // Masks known as numbers only: at s = 0 the tangent (P_{-2} - 8 P_{-1} + 8 P_1 - P_2)/12 alone decides.
  // From the reflected points it misses by (-1, 1) - (-7, 8, -1)/6 = (1/6, -1/3, 1/6), times 12 along (-8,
  // 1)/65.
  const EndWeights<Rational> ends = end_weights(stationary("J", jspline(q(0))), OpenEnd::clamped);
  const Laurent<Rational> miss(0, {q(2), q(-4), q(2)});
  EXPECT_EQ(ends.start[0],
            Laurent<Rational>(0, {q(2), q(-1)}) - Laurent<Rational>::constant(q(8, 65)) * miss);
  EXPECT_EQ(ends.start[1],
            Laurent<Rational>(0, {q(2), q(0), q(-1)}) + Laurent<Rational>::constant(q(1, 65)) * miss);
  // Degree 7 reaches three points: the third is reflected.
  EXPECT_EQ(ends_of("bspline:degree=7").start[2], Laurent<Rational>(0, {q(2), q(0), q(0), q(-1)}));
}

TEST(OpenPolygon, Reflected) {
  const EndWeights<Rational> ends = ends_of("jspline:s=1/2", OpenEnd::reflected);
  EXPECT_EQ(ends.start,
            (Weights{Laurent<Rational>(0, {q(2), q(-1)}), Laurent<Rational>(0, {q(2), q(0), q(-1)})}));
  EXPECT_EQ(ends.finish, ends.start);
  const ControlPolygon<Rational> polygon = with_ends(std::vector<Rational>{q(5), q(7), q(8)}, ends);
  EXPECT_EQ(polygon.points, (std::vector<Rational>{q(2), q(3), q(5), q(7), q(8), q(9), q(11)}));
  EXPECT_EQ(polygon.topology, (Topology{7, false, 2, 2}));
}

TEST(OpenPolygon, AlgebraicAndInexactParameters) {
  const SchemeDescription root = parse_scheme("jspline:s=sqrt(2)");
  const EndWeights<Algebraic> exact = end_weights<Algebraic>(root, OpenEnd::clamped);
  EXPECT_EQ(exact.start[1][1], sqrt(Algebraic(2)) - Algebraic(8));
  const EndWeights<double> rounded = end_weights_in_double(root, OpenEnd::clamped);
  EXPECT_DOUBLE_EQ(rounded.start[1][1], std::sqrt(2.0) - 8);
  EXPECT_EQ(end_weights_in_double(parse_scheme("jspline:s=3/2"), OpenEnd::clamped).start[1][1], -6.5);
  EXPECT_THROW(static_cast<void>(end_weights_in_double(parse_scheme("jspline:s=t"), OpenEnd::clamped)),
               InputError);
}

TEST(OpenPolygon, RefusesWhatHasNoSuchEnds) {
  // t = 0 lies midway between two control points, and one added point cannot do two things.
  EXPECT_THROW(ends_of("bspline:degree=2"), InputError);
  EXPECT_THROW(ends_of("bspline:degree=2", OpenEnd::reflected), InputError);
  // The hat function has no tangent at its vertices.
  EXPECT_THROW(ends_of("bspline:degree=1"), InputError);
  const EndWeights<Rational> hat = ends_of("bspline:degree=1", OpenEnd::reflected);
  EXPECT_EQ(curve_points(with_ends(std::vector<Rational>{q(1), q(2)}, hat)).size(), 2U);
  const EndWeights<Rational> ends = ends_of("jspline:s=1/2");
  EXPECT_EQ(least_points(ends), 3U);
  EXPECT_THROW(with_ends(std::vector<Rational>{q(1), q(2)}, ends), InputError);
  EXPECT_THROW(with_ends(std::vector<Rational>{}, ends), InputError);
  EXPECT_EQ(least_points(EndWeights<Rational>{}), 2U);
}

}  // namespace
}  // namespace subdiv
