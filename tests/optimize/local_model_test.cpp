#include "optimize/local_model.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using F = RationalFunction;

const F x = F::variable(0);
const F y = F::variable(1);
constexpr long precision = 128;

Box around(const Rational& cx, const Rational& cy, const Rational& r) {
  return {{{cx - r, cx + r}, {cy - r, cy + r}}};
}

F squared_distance(int px, int py) { return (x - F(px)) * (x - F(px)) + (y - F(py)) * (y - F(py)); }

/// The smallest circle about (0,0), (4,0), (1,3): centre (2,1), squared radius 5, all three on it.
LocalModel smallest_circle() {
  const F base = squared_distance(0, 0);
  return {base,
          {{squared_distance(4, 0) - base, KinkKind::maximum},
           {squared_distance(1, 3) - base, KinkKind::maximum}},
          2};
}

/// max((x-1)^2 + y^2, (x+1)^2 + y^2): minimum 1 at (0,0) with weights 1/2, curved along y only.
LocalModel valley() {
  const F base = squared_distance(1, 0);
  return {base, {{squared_distance(-1, 0) - base, KinkKind::maximum}}, 2};
}

TEST(LocalModel, ProvesAVertex) {
  const CompiledModel model(smallest_circle(), precision);
  const auto point = model.critical_point({1.9, 1.2});
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->x[0].contains(Rational(2)));
  EXPECT_TRUE(point->x[1].contains(Rational(1)));
  // The centre is 1/4 (0,0) + 5/12 (4,0) + 1/3 (1,3).
  EXPECT_TRUE(point->multipliers[0].contains(Rational(5, 12)));
  EXPECT_TRUE(point->multipliers[1].contains(Rational(1, 3)));
  EXPECT_TRUE(model.is_minimum_over(*point, around(Rational(2), Rational(1), Rational(1, 10))));
}

TEST(LocalModel, ProvesAValley) {
  const CompiledModel model(valley(), precision);
  const auto point = model.critical_point({0.1, -0.2});
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->x[0].contains(Rational(0)));
  EXPECT_TRUE(point->multipliers[0].contains(Rational(1, 2)));
  EXPECT_TRUE(model.is_minimum_over(*point, around(Rational(0), Rational(0), Rational(1, 10))));
}

TEST(LocalModel, ProvesAValleyWhoseLagrangianIsNotConvex) {
  // max(y^2 - x^2 + x, y^2 - x^2 - x) = |x| - x^2 + y^2: the weighted sum y^2 - x^2 is a saddle, the kink
  // makes the minimum.
  const LocalModel model{y * y - x * x + x, {{F(-2) * x, KinkKind::maximum}}, 2};
  const CompiledModel compiled(model, precision);
  const auto point = compiled.critical_point({0.05, 0.05});
  ASSERT_TRUE(point);
  EXPECT_TRUE(compiled.is_minimum_over(*point, around(Rational(0), Rational(0), Rational(1, 8))));
  // At |x| >= 1 the objective falls below its value at 0: no proof can exist there.
  EXPECT_FALSE(compiled.is_minimum_over(*point, around(Rational(0), Rational(0), Rational(3, 2))));
}

TEST(LocalModel, ProvesAKinkOfASum) {
  // y^2 + (x - 1)^2 + |x - 2y + 1|: on the line x = 2y - 1, multiplier in (-1, 1).
  const F u = x - F(2) * y + F(1);
  const CompiledModel model(LocalModel{y * y + (x - F(1)) * (x - F(1)), {{u, KinkKind::absolute}}, 2},
                            precision);
  const auto point = model.critical_point({0.5, 0.7});
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->x[0].contains(Rational(3, 5)));
  EXPECT_TRUE(point->x[1].contains(Rational(4, 5)));
  EXPECT_TRUE(point->multipliers[0].contains(Rational(4, 5)));
  EXPECT_TRUE(model.is_minimum_over(*point, around(Rational(3, 5), Rational(4, 5), Rational(1, 10))));
}

TEST(LocalModel, ProvesAMinimumAtTheEndOfARange) {
  const CompiledModel model(LocalModel{(x - F(2)) * (x - F(2)) + y * y, {{x - F(1), KinkKind::bound}}, 2},
                            precision);
  const auto point = model.critical_point({1, 0.1});
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->multipliers[0].contains(Rational(2)));
  EXPECT_TRUE(model.is_minimum_over(*point, around(Rational(1), Rational(0), Rational(1, 4))));
}

TEST(LocalModel, RefusesAWrongSignOfAMultiplier) {
  // The objective still falls beyond the bound's other side: (x - 2)^2 with x >= 1 as the constraint pushes
  // outward.
  const CompiledModel outward(LocalModel{(x - F(2)) * (x - F(2)) + y * y, {{F(1) - x, KinkKind::bound}}, 2},
                              precision);
  EXPECT_FALSE(outward.critical_point({1, 0.1}));
  // |u| too weak to hold the point: 3 y against |y|.
  const CompiledModel weak(LocalModel{x * x + F(3) * y, {{y, KinkKind::absolute}}, 2}, precision);
  EXPECT_FALSE(weak.critical_point({0.1, 0.1}));
  // An obtuse triangle: the circle through all three corners is not the smallest.
  const F base = squared_distance(0, 0);
  const CompiledModel obtuse(LocalModel{base,
                                        {{squared_distance(4, 0) - base, KinkKind::maximum},
                                         {squared_distance(2, 1) - base, KinkKind::maximum}},
                                        2},
                             precision);
  EXPECT_FALSE(obtuse.critical_point({2, -1.4}));
}

TEST(LocalModel, RefusesACriticalPointThatIsNoMinimum) {
  const CompiledModel saddle(LocalModel{x * x - y * y, {}, 2}, precision);
  const auto point = saddle.critical_point({0.1, 0.1});
  ASSERT_TRUE(point);
  EXPECT_FALSE(saddle.is_minimum_over(*point, around(Rational(0), Rational(0), Rational(1, 1000))));
  const CompiledModel maximum(LocalModel{-(x * x) - y * y, {}, 2}, precision);
  const auto top = maximum.critical_point({0.1, 0.1});
  ASSERT_TRUE(top);
  EXPECT_FALSE(maximum.is_minimum_over(*top, around(Rational(0), Rational(0), Rational(1, 1000))));
}

TEST(LocalModel, RefusesTamperedCertificates) {
  const CompiledModel model(valley(), precision);
  const auto point = model.critical_point({0.1, -0.2});
  ASSERT_TRUE(point);
  const Box good = around(Rational(0), Rational(0), Rational(1, 10));
  ASSERT_TRUE(model.is_minimum_over(*point, good));
  CriticalPoint moved = *point;
  moved.x[0] += Interval(Rational(1, 100));
  EXPECT_FALSE(model.is_minimum_over(moved, good)) << "a point that is not critical";
  CriticalPoint weighted = *point;
  weighted.multipliers[0] = Interval(Rational(2, 3));
  EXPECT_FALSE(model.is_minimum_over(weighted, good)) << "a multiplier that does not balance the gradients";
  CriticalPoint shifted = *point;
  shifted.region(2) += Interval(Rational(1, 10));
  EXPECT_FALSE(model.is_minimum_over(shifted, good)) << "a region without a zero";
  EXPECT_FALSE(model.is_minimum_over(*point, around(Rational(1), Rational(0), Rational(1, 10))))
      << "a neighbourhood without the point";
  const CompiledModel other(smallest_circle(), precision);
  const auto vertex = other.critical_point({1.9, 1.2});
  ASSERT_TRUE(vertex);
  CriticalPoint unbalanced = *vertex;
  std::swap(unbalanced.multipliers[0], unbalanced.multipliers[1]);
  EXPECT_FALSE(other.is_minimum_over(unbalanced, around(Rational(2), Rational(1), Rational(1, 10))));
}

TEST(LocalModel, PositiveDefiniteMeansAllMatricesOfTheEnclosure) {
  Matrix<Interval> a(2, 2);
  a(0, 0) = a(1, 1) = Interval(Rational(2));
  a(0, 1) = a(1, 0) = Interval::hull(Rational(-1), Rational(1));
  EXPECT_TRUE(is_positive_definite(a));
  a(0, 1) = a(1, 0) = Interval::hull(Rational(-2), Rational(2));
  EXPECT_FALSE(is_positive_definite(a));
  a(0, 1) = a(1, 0) = Interval(Rational(0));
  a(0, 0) = Interval::hull(Rational(-1, 1000), Rational(2));
  EXPECT_FALSE(is_positive_definite(a));
}

}  // namespace
}  // namespace subdiv
