#include "optimize/several_parameters.h"

#include <gtest/gtest.h>

#include "schemes/algebra/univariate.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

using F = RationalFunction;

const F x = F::variable(0);
const F y = F::variable(1);
const F z = F::variable(2);

F squared_distance(int px, int py) { return (x - F(px)) * (x - F(px)) + (y - F(py)) * (y - F(py)); }

Range range(int lower, int upper) { return {Rational(lower), Rational(upper)}; }

Problem problem(Norm norm, std::vector<F> residuals, std::vector<Range> box) {
  return {std::move(residuals), norm, std::move(box), {}};
}

void expect_encloses(const Enclosure& e, const Rational& value) {
  EXPECT_TRUE(e.contains(value)) << e.lower.to_string();
  EXPECT_LE(e.width(), Rational(1, 1000000000000000));
  EXPECT_NE(e.rigour, Rigour::approximate);
}

void expect_encloses(const Enclosure& e, const Interval& value) {
  EXPECT_TRUE(e.lower <= value.lower() && value.upper() <= e.upper) << value.to_string();
  EXPECT_LE(e.width(), Rational(1, 1000000000000000));
  EXPECT_NE(e.rigour, Rigour::approximate);
}

/// Coarse enough to contain the enclosures' widths of 2^-150 and less: sqrt at fewer bits would not lie
/// inside.
Interval fine_sqrt(int n) { return sqrt(Interval(Rational(n), 1000)); }

TEST(SeveralParameters, SmallestCircleIsAVertex) {
  // About (0,0), (4,0), (1,3) and (2,2): centre (2,1), squared radius 5.
  const Summary s = minimise(problem(
      Norm::linf,
      {squared_distance(0, 0), squared_distance(4, 0), squared_distance(1, 3), squared_distance(2, 2)},
      {range(-10, 10), range(-10, 10)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(2));
  expect_encloses(s.minimiser[1], Rational(1));
  expect_encloses(s.minimum, Rational(5));
  EXPECT_EQ(s.active, (std::vector<int>{0, 1, 2}));
  EXPECT_GT(s.boxes, 0);
}

TEST(SeveralParameters, SmallestCircleOfAnObtuseTriangleIsAValley) {
  // (0,0), (4,0), (2,1): the longest side is a diameter; only two points are active.
  const Summary s =
      minimise(problem(Norm::linf, {squared_distance(0, 0), squared_distance(4, 0), squared_distance(2, 1)},
                       {range(-10, 10), range(-9, 7)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(2));
  expect_encloses(s.minimiser[1], Rational(0));
  expect_encloses(s.minimum, Rational(4));
  EXPECT_EQ(s.active, (std::vector<int>{0, 1}));
}

TEST(SeveralParameters, SmallestSphereOverThreeParameters) {
  const auto distance = [](int a, int b, int c) {
    return (x - F(a)) * (x - F(a)) + (y - F(b)) * (y - F(b)) + (z - F(c)) * (z - F(c));
  };
  // Four corners of a cube about (1,1,1), no two on an edge, and a point inside.
  const Summary s = minimise(
      problem(Norm::linf,
              {distance(2, 2, 2), distance(2, 0, 0), distance(0, 2, 0), distance(0, 0, 2), distance(1, 1, 0)},
              {range(-3, 3), range(-3, 3), range(-3, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  for (const Enclosure& e : s.minimiser) expect_encloses(e, Rational(1));
  expect_encloses(s.minimum, Rational(3));
  EXPECT_EQ(s.active, (std::vector<int>{0, 1, 2, 3}));
}

TEST(SeveralParameters, OneActiveResidualIsSmooth) {
  const Summary s = minimise(
      problem(Norm::linf, {F(1) + x * x + (y - F(1)) * (y - F(1)), x / F(10)}, {range(-2, 2), range(-2, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(0));
  expect_encloses(s.minimiser[1], Rational(1));
  expect_encloses(s.minimum, Rational(1));
  EXPECT_EQ(s.active, std::vector<int>{0});
}

TEST(SeveralParameters, NegativeResidualsAndTwinsCount) {
  const F up = squared_distance(1, 0);
  const F down = -squared_distance(-1, 0);
  const Summary s = minimise(problem(Norm::linf, {down, up, F(0), -up}, {range(-2, 2), range(-2, 2)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(0));
  expect_encloses(s.minimum, Rational(1));
  EXPECT_EQ(s.active, (std::vector<int>{0, 1, 3}));
}

TEST(SeveralParameters, RationalResiduals) {
  // max of (2 + x^2)/(1 + y^2/4) and (1 + y^2): along x = 0 they meet where (1 + t)(1 + t/4) = 2, t = y^2.
  const Summary s = minimise(problem(Norm::linf, {(F(2) + x * x) / (F(1) + y * y / F(4)), F(1) + y * y},
                                     {range(-1, 1), Range{Rational(0), Rational(3)}}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  const Interval t = (fine_sqrt(41) - Interval(5)) / Interval(2);
  expect_encloses(s.minimum, Interval(1) + t);
  expect_encloses(s.minimiser[1], sqrt(t));
}

// Freudenstein and Roth's function (More, Garbow and Hillstrom 1981, problem 2): minimum 0 at (5, 4), another
// local minimum 48.9842.. at ((53 - 4 sqrt 22)/3, (2 - sqrt 22)/3).
std::vector<F> freudenstein_roth() {
  return {F(-13) + x + ((F(5) - y) * y - F(2)) * y, F(-29) + x + ((y + F(1)) * y - F(14)) * y};
}

TEST(SeveralParameters, SumOfSquaresFindsTheGlobalMinimum) {
  const Summary s = minimise(problem(Norm::l2, freudenstein_roth(), {range(0, 20), range(-5, 6)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(5));
  expect_encloses(s.minimiser[1], Rational(4));
  EXPECT_TRUE(s.minimum.contains(Rational(0)));
  EXPECT_GE(s.minimum.lower, Rational(0));
}

TEST(SeveralParameters, SumOfSquaresWithAPositiveMinimum) {
  const Summary s = minimise(problem(Norm::l2, freudenstein_roth(), {range(8, 15), range(-2, 2)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], (Interval(53) - Interval(4) * fine_sqrt(22)) / Interval(3));
  expect_encloses(s.minimiser[1], (Interval(2) - fine_sqrt(22)) / Interval(3));
  EXPECT_TRUE(s.minimum.lower > Rational(489842, 10000) && s.minimum.upper < Rational(489843, 10000));
}

TEST(SeveralParameters, LeavesAWorseLocalMinimumForABetterOne) {
  // The only candidate is the local minimum: branch and bound must meet a better point and go on from there.
  const Problem p = problem(Norm::l2, freudenstein_roth(), {range(0, 20), range(-5, 6)});
  const Summary s = minimise_several_parameters(p, {}, {{{11.4128, -0.8968}, 48.9842}});
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(5));
}

TEST(SeveralParameters, SumOfAbsoluteValuesWithAKink) {
  // |y - x^2| + (x - 2)^2 + (y - 1)^2 + 1: on the parabola where 2 x^3 - x - 2 = 0, with weight -2 (x^2 - 1)
  // of the kink.
  const Summary s =
      minimise(problem(Norm::l1, {y - x * x, squared_distance(2, 1) + F(1)}, {range(-3, 3), range(-3, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  const auto roots = real_roots(UnivariatePolynomial({Rational(-2), Rational(-1), Rational(0), Rational(2)}));
  ASSERT_EQ(roots.size(), 1U);
  const Interval root = roots[0].value.to_interval(1000);
  expect_encloses(s.minimiser[0], root);
  expect_encloses(s.minimiser[1], root * root);
  EXPECT_EQ(s.active, std::vector<int>{0});
}

TEST(SeveralParameters, SumOfAbsoluteValuesWithoutAKink) {
  const Summary s = minimise(problem(Norm::l1, {squared_distance(1, 0), squared_distance(0, 2), F(4) + y * y},
                                     {range(-3, 3), range(-3, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(1, 2));
  expect_encloses(s.minimiser[1], Rational(2, 3));
  EXPECT_TRUE(s.active.empty());
}

TEST(SeveralParameters, SumOfAbsoluteValuesAtAVertex) {
  // Both kinks hold: y = x^2 and x y = 1 meet at (1, 1); the smooth part pulls less than they hold.
  const Summary s =
      minimise(problem(Norm::l1, {y - x * x, x * y - F(1), (squared_distance(0, 0) + F(1)) / F(8)},
                       {Range{Rational(1, 2), Rational(3)}, range(0, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(1));
  expect_encloses(s.minimiser[1], Rational(1));
  expect_encloses(s.minimum, Rational(3, 8));
  EXPECT_EQ(s.active, (std::vector<int>{0, 1}));
}

TEST(SeveralParameters, CommonZeroIsExact) {
  // Rosenbrock's residuals, and one more that is a combination of them.
  const F first = F(10) * (y - x * x);
  const F second = F(1) - x;
  for (const Norm norm : {Norm::l1, Norm::linf}) {
    const Summary s =
        minimise(problem(norm, {first, second, first / F(2) - second}, {range(-3, 3), range(-3, 3)}));
    ASSERT_EQ(s.termination, Termination::proved) << s.message;
    EXPECT_EQ(s.minimum.exact, "0");
    expect_encloses(s.minimiser[0], Rational(1));
    expect_encloses(s.minimiser[1], Rational(1));
    EXPECT_EQ(s.active, (std::vector<int>{0, 1, 2}));
  }
}

TEST(SeveralParameters, MinimumAtTheEndOfARange) {
  const Summary s =
      minimise(problem(Norm::linf, {F(1) + squared_distance(2, 0)}, {range(0, 1), range(-1, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(1));
  expect_encloses(s.minimiser[1], Rational(0));
  expect_encloses(s.minimum, Rational(2));
  EXPECT_NE(s.message.find("boundary"), std::string::npos);
}

TEST(SeveralParameters, MinimumInACorner) {
  const Summary s = minimise(problem(Norm::l2, {x * y, x + y}, {range(1, 2), range(1, 3)}));
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  expect_encloses(s.minimiser[0], Rational(1));
  expect_encloses(s.minimiser[1], Rational(1));
  expect_encloses(s.minimum, Rational(5));
}

TEST(SeveralParameters, TwoMinimisersAreNotUnique) {
  const F ring = x * x - F(1);
  const Summary s = minimise(problem(Norm::linf, {F(1) + ring * ring + y * y}, {range(-2, 2), range(-2, 3)}));
  EXPECT_EQ(s.termination, Termination::not_unique) << s.message;
  EXPECT_TRUE(s.minimum.contains(Rational(1)));
  EXPECT_LE(s.minimum.width(), Rational(1, 1000000000));
  EXPECT_TRUE(s.minimiser[0].contains(Rational(1)));
  EXPECT_TRUE(s.minimiser[0].contains(Rational(-1)));
}

TEST(SeveralParameters, ACurveOfZerosGivesOneOfThem) {
  // x^2 + y^2 = 1 and, over three parameters, also z = x y: two independent residuals and a combination of
  // them.
  const F ring = x * x + y * y - F(1);
  const F twist = z - x * y;
  for (const Norm norm : {Norm::l1, Norm::l2, Norm::linf}) {
    const Summary circle = minimise(problem(norm, {ring, -ring}, {range(-2, 2), range(-2, 3)}));
    EXPECT_EQ(circle.termination, Termination::not_unique) << circle.message;
    EXPECT_EQ(circle.minimum.exact, "0");
    const Interval px = Interval::hull(circle.minimiser[0].lower, circle.minimiser[0].upper, 400);
    const Interval py = Interval::hull(circle.minimiser[1].lower, circle.minimiser[1].upper, 400);
    EXPECT_TRUE((px * px + py * py).contains(Rational(1)));
    const Summary curve = minimise(
        problem(norm, {ring, twist, ring - F(3) * twist}, {range(-2, 2), range(-2, 3), range(-2, 3)}));
    EXPECT_EQ(curve.termination, Termination::not_unique) << curve.message;
    EXPECT_EQ(curve.minimum.exact, "0");
  }
}

TEST(SeveralParameters, ACircleOfMinimisersIsNotIsolated) {
  const F ring = x * x + y * y - F(1);
  const Summary s = minimise(problem(Norm::linf, {F(1) + ring * ring}, {range(-2, 2), range(-2, 3)}));
  EXPECT_EQ(s.termination, Termination::not_isolated);
  EXPECT_EQ(s.minimum.rigour, Rigour::approximate);
}

TEST(SeveralParameters, SaysWhenBoxesRunOut) {
  Options options;
  options.max_boxes = 3;
  const Summary s =
      minimise(problem(Norm::linf, {squared_distance(0, 0), squared_distance(4, 0), squared_distance(1, 3)},
                       {range(-10, 10), range(-10, 10)}),
               options);
  EXPECT_EQ(s.termination, Termination::out_of_boxes);
  EXPECT_EQ(s.minimum.status, Status::out_of_depth);
  EXPECT_EQ(s.minimum.rigour, Rigour::approximate);
  EXPECT_TRUE(s.minimum.contains(Rational(5)));
  EXPECT_EQ(s.boxes, 3);
}

TEST(SeveralParameters, RefusesAPole) {
  const Summary s = minimise(problem(Norm::linf, {F(1) / (x - y) + x * y, x}, {range(0, 2), range(1, 3)}));
  EXPECT_EQ(s.termination, Termination::pole_in_box);
}

TEST(SeveralParameters, NeedsAStart) {
  Options options;
  options.starts = 0;
  const Summary s =
      minimise(problem(Norm::linf, {squared_distance(0, 0)}, {range(-1, 1), range(-1, 1)}), options);
  EXPECT_EQ(s.termination, Termination::no_local_minimum);
}

TEST(SeveralParameters, EveryTerminationHasItsWords) {
  EXPECT_EQ(to_string(Termination::proved), "proved");
  EXPECT_EQ(to_string(Termination::not_unique), "not unique");
  EXPECT_EQ(to_string(Termination::out_of_boxes), "out of boxes");
  EXPECT_EQ(to_string(Termination::not_isolated), "not isolated");
  EXPECT_EQ(to_string(Termination::pole_in_box), "pole in box");
  EXPECT_EQ(to_string(Termination::no_local_minimum), "no local minimum");
}

TEST(SeveralParameters, RefusesAnEmptyRange) {
  EXPECT_THROW(minimise(problem(Norm::linf, {x * y}, {range(1, 1), range(0, 1)})), InputError);
  EXPECT_THROW(minimise(problem(Norm::linf, {}, {range(0, 1), range(0, 1)})), InputError);
}

}  // namespace
}  // namespace subdiv
