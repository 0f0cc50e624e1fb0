#include "analysis/open_ends.h"

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);

F half(const F& x) { return F(Rational(1, 2)) * x; }
F quarter(const F& x) { return F(Rational(1, 4)) * x; }

std::vector<Laurent<F>> clamped_jspline() {
  return clamped_end(limit_mask(jspline(s)), tangent_mask(jspline(s)));
}

Laurent<Rational> at(const Laurent<F>& p, const Rational& value) {
  return map_coefficients(p, [&](const F& f) {
    const std::vector<Rational> point{value};
    return f.evaluate(std::span<const Rational>(point));
  });
}

const Laurent<Rational> first_point(1);
const Laurent<Rational> first_edge(0, {Rational(-1), Rational(1)});

TEST(OpenEnds, ClampedJsplines) {
  // js-report 11.
  const std::vector<Laurent<F>> added = clamped_jspline();
  ASSERT_EQ(added.size(), 2U);
  EXPECT_EQ(added[0], Laurent<F>(0, {quarter(F(9) - s), half(s - 3), quarter(F(1) - s)}));
  EXPECT_EQ(added[1], Laurent<F>(0, {half(F(12) - s), s - 8, half(F(6) - s)}));
  EXPECT_EQ(apply_at_end(limit_mask(jspline(s)), added), Laurent<F>(1));
  EXPECT_EQ(apply_at_end(tangent_mask(jspline(s)), added), Laurent<F>(0, {F(-1), F(1)}));
}

TEST(OpenEnds, HoldForEveryParameterThoughNotDeterminedAtTwo) {
  const std::vector<Laurent<F>> added = clamped_jspline();
  for (const Rational& value : {Rational(0), Rational(1), Rational(3, 2), Rational(-1), Rational(5)}) {
    const Mask<Rational> mask = jspline(value);
    const std::vector<Laurent<Rational>> concrete{at(added[0], value), at(added[1], value)};
    EXPECT_EQ(apply_at_end(limit_mask(mask), concrete), first_point);
    EXPECT_EQ(apply_at_end(tangent_mask(mask), concrete), first_edge);
  }
  EXPECT_THROW(clamped_end(limit_mask(jspline(Rational(0))), tangent_mask(jspline(Rational(0)))),
               std::domain_error);
  // At s = 1 the masks reach one point only, and two conditions agree on it.
  const auto cubic = clamped_end(limit_mask(jspline(Rational(1))), tangent_mask(jspline(Rational(1))));
  EXPECT_EQ(cubic, (std::vector{Laurent<Rational>(0, {Rational(2), Rational(-1)})}));
}

/// Points after `levels` refinements of an open polygon with added points, as a Laurent polynomial in which
/// index i stands at i / 2^levels.
Laurent<Rational> refine_open(const Mask<Rational>& mask, const std::vector<Rational>& points,
                              const std::vector<Laurent<Rational>>& added, int levels) {
  const std::size_t n = points.size();
  const std::size_t count = added.size();
  const auto weigh = [&](const Laurent<Rational>& weights, bool mirrored_end) {
    Rational value(0);
    for (std::size_t j = 0; j < n; ++j)
      value += weights[static_cast<int>(j)] * points[mirrored_end ? n - 1 - j : j];
    return value;
  };
  std::vector<Rational> all(n + 2 * count);
  for (std::size_t j = 0; j < n; ++j) all[count + j] = points[j];
  for (std::size_t k = 1; k <= count; ++k) {
    all[count - k] = weigh(added[k - 1], false);
    all[count + n - 1 + k] = weigh(added[k - 1], true);
  }
  Laurent<Rational> refined(-static_cast<int>(count), all);
  for (int level = 0; level < levels; ++level) refined = refine_sequence(mask, refined);
  return refined;
}

TEST(OpenEnds, RefinedPolygonsStartAndEndAsWished) {
  const std::vector<Rational> points{Rational(3), Rational(-1), Rational(4),
                                     Rational(1), Rational(-5), Rational(9)};
  constexpr int levels = 9;
  const Rational density = pow(Rational(2), levels);
  const std::vector<Laurent<F>> family = clamped_jspline();
  for (const Rational& value : {Rational(0), Rational(1, 2), Rational(3, 2)}) {
    const std::vector<Laurent<Rational>> added{at(family[0], value), at(family[1], value)};
    const Laurent<Rational> curve = refine_open(jspline(value), points, added, levels);
    const int end = 5 << levels;
    EXPECT_NEAR(curve[0].to_double(), 3, 1e-3);
    EXPECT_NEAR(curve[end].to_double(), 9, 1e-3);
    EXPECT_NEAR((density * (curve[1] - curve[0])).to_double(), -4, 0.2);
    EXPECT_NEAR((density * (curve[end] - curve[end - 1])).to_double(), 14, 0.2);
    const Laurent<Rational> reflected =
        refine_open(jspline(value), points, reflected_end<Rational>(2), levels);
    EXPECT_NEAR(reflected[0].to_double(), 3, 1e-3);
    EXPECT_NEAR(reflected[end].to_double(), 9, 1e-3);
  }
}

TEST(OpenEnds, Reflected) {
  const std::vector<Laurent<F>> added = reflected_end<F>(2);
  EXPECT_EQ(added[0], Laurent<F>(0, {F(2), F(-1)}));
  EXPECT_EQ(added[1], Laurent<F>(0, {F(2), F(0), F(-1)}));
  EXPECT_EQ(apply_at_end(limit_mask(jspline(s)), added), Laurent<F>(1));
  // The tangent is in general not along the first edge: (s - 4)/3 (P0 - P1) + ..
  EXPECT_NE(apply_at_end(tangent_mask(jspline(s)), added), Laurent<F>(0, {F(-1), F(1)}));
}

TEST(OpenEnds, TheOtherEnd) {
  // A symmetric scheme has the mirror image of the same weights at its other end; an uneven one has others.
  const Mask<F> even = jspline(s);
  EXPECT_EQ(clamped_end(mirrored(limit_mask(even), 0), mirrored(tangent_mask(even), 1)), clamped_jspline());
  const Laurent<Rational> uneven(-1, {Rational(1, 2), Rational(1, 3), Rational(1, 6)});
  const Mask<Rational> skew{2, bspline<Rational>(3).symbol * uneven};
  const auto start = clamped_end(limit_mask(skew), tangent_mask(skew));
  const auto finish = clamped_end(mirrored(limit_mask(skew), 0), mirrored(tangent_mask(skew), 1));
  EXPECT_NE(start, finish);
  EXPECT_EQ(apply_at_end(mirrored(limit_mask(skew), 0), finish), first_point);
  EXPECT_EQ(apply_at_end(mirrored(tangent_mask(skew), 1), finish), first_edge);
}

TEST(OpenEnds, FurtherConditions) {
  // Seven-coefficient limit masks would reach three points: the second derivative settles the third.
  const Mask<Rational> mask = bspline<Rational>(7);
  EXPECT_EQ(points_to_add<Rational>({{limit_mask(mask), first_point}}), 3);
  EXPECT_THROW(clamped_end(limit_mask(mask), tangent_mask(mask)), std::domain_error);
  const auto natural = solve_end<Rational>(
      {{limit_mask(mask), first_point}, {tangent_mask(mask), first_edge}, {derivative_mask(mask, 2), {}}});
  EXPECT_EQ(apply_at_end(limit_mask(mask), natural), first_point);
  EXPECT_EQ(apply_at_end(tangent_mask(mask), natural), first_edge);
  EXPECT_EQ(apply_at_end(derivative_mask(mask, 2), natural), Laurent<Rational>());
  EXPECT_THROW(apply_at_end(limit_mask(mask), reflected_end<Rational>(2)), std::domain_error);
}

TEST(OpenEnds, Spans) {
  // A loop of n + 4 points has n + 4 spans; n points have n - 1.
  const int added = points_to_add<F>({{limit_mask(jspline(s)), {}}});
  EXPECT_EQ(added, 2);
  EXPECT_EQ(dropped_spans(added), 5);
}

}  // namespace
}  // namespace subdiv
