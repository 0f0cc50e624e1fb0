#include "optimize/one_parameter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

const RationalFunction x = RationalFunction::variable(0);

RationalFunction number(long p, long q = 1) { return fraction<RationalFunction>(p, q); }

Summary solve(std::vector<RationalFunction> residuals, Norm norm, const Rational& lower,
              const Rational& upper, const Options& options = {}) {
  return minimise_one_parameter({std::move(residuals), norm, {{lower, upper}}, {"x"}}, options);
}

void expect_at(const Summary& s, double minimiser, double minimum) {
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  EXPECT_LE(s.minimiser[0].width(), Rational(1, 1000000000000000));
  EXPECT_NE(s.minimiser[0].rigour, Rigour::approximate);
  EXPECT_NEAR(s.minimiser[0].midpoint().to_double(), minimiser, 1e-15);
  EXPECT_LE(s.minimum.lower.to_double(), minimum + 1e-14);
  EXPECT_GE(s.minimum.upper.to_double(), minimum - 1e-14);
  EXPECT_LE(s.minimum.width(), Rational(1, 1000000000000));
}

TEST(OneParameter, LinfKinkBetweenTwoResiduals) {
  // max(|x^2|, |x - 1|): x^2 = 1 - x, the golden section.
  const Summary s = solve({x * x, x - number(1)}, Norm::linf, 0, 5);
  const double golden = (std::sqrt(5.0) - 1) / 2;
  expect_at(s, golden, golden * golden);
  EXPECT_EQ(s.minimiser[0].exact, "(-1+sqrt(5))/2");
  EXPECT_EQ(s.active, (std::vector<int>{0, 1}));
}

TEST(OneParameter, LinfSmoothMinimumOfOneResidual) {
  expect_at(solve({x * x * x * x - number(4) * x + number(10), x}, Norm::linf, -2, 3), 1, 7);
}

TEST(OneParameter, LinfAtAZeroOfTheOnlyResidual) {
  // |x^2 - 2| vanishes: a kink of one residual with itself.
  const Summary s = solve({x * x - number(2)}, Norm::linf, 0, 5);
  EXPECT_TRUE(s.termination == Termination::proved || s.termination == Termination::not_isolated)
      << s.message;
  EXPECT_NEAR(s.minimiser[0].midpoint().to_double(), std::sqrt(2.0), 1e-15);
  EXPECT_LT(s.minimum.upper.to_double(), 1e-14);
}

TEST(OneParameter, L1KinkWhereOneResidualVanishes) {
  // |x^3 - 2| + |x - 1|: the cube root outweighs the line.
  const Summary s = solve({x * x * x - number(2), x - number(1)}, Norm::l1, -3, 3);
  const double root = std::cbrt(2.0);
  expect_at(s, root, root - 1);
  EXPECT_EQ(s.active, (std::vector<int>{0}));
  EXPECT_NE(s.minimiser[0].exact.find("x^3"), std::string::npos);
}

TEST(OneParameter, L1SmoothMinimum) {
  // |x^2 + 1| + |x - 5|: 2x = 1.
  const Summary s = solve({x * x + number(1), x - number(5)}, Norm::l1, -3, 3);
  expect_at(s, 0.5, 1.25 + 4.5);
  EXPECT_EQ(s.minimiser[0].exact, "1/2");
  EXPECT_EQ(s.minimum.exact, "23/4");
}

TEST(OneParameter, L1CountsEqualAndOppositeResidualsEach) {
  // 2|x - 1| + |x^2|: 2 outweighs 2x below 1 only; without the count the minimum would be at 1/2.
  const Summary s = solve({x - number(1), number(1) - x, x * x}, Norm::l1, -3, 3);
  EXPECT_NEAR(s.minimum.upper.to_double(), 1, 1e-13);
  const Summary other = solve({x - number(2), number(2) - x, x * x}, Norm::l1, -3, 5);
  expect_at(other, 1, 3);
}

TEST(OneParameter, L2IsTheSumOfSquares) {
  // (x^2 - 2)^2 + (x - 1)^2 has the derivative 4x^3 - 6x - 2 = 2 (x + 1)(2x^2 - 2x - 1).
  const Summary s = solve({x * x - number(2), x - number(1)}, Norm::l2, -3, 3);
  const double root = (1 + std::sqrt(3.0)) / 2;
  expect_at(s, root, (root * root - 2) * (root * root - 2) + (root - 1) * (root - 1));
  EXPECT_EQ(s.minimiser[0].exact, "(1+sqrt(3))/2");
  EXPECT_TRUE(s.active.empty());
}

TEST(OneParameter, RationalResiduals) {
  // 1/x + x on (0, ..): 1, with the minimum 2.
  expect_at(solve({number(1) / x + x}, Norm::linf, Rational(1, 10), 5), 1, 2);
}

TEST(OneParameter, PicksTheLowerOfTwoValleys) {
  // (x^2 - 1)^2 + x/10: the valley near -1. 4x(x^2 - 1) = -1/10.
  const RationalFunction f = (x * x - number(1)) * (x * x - number(1)) + x / number(10) + number(1);
  const Summary s = solve({f}, Norm::linf, -2, 2);
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  const double at = s.minimiser[0].midpoint().to_double();
  EXPECT_NEAR(4 * at * (at * at - 1), -0.1, 1e-14);
  EXPECT_LT(at, -1);
}

TEST(OneParameter, EndOfTheRange) {
  const Summary s = solve({x * x + number(1), x}, Norm::l1, 2, 3);
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  EXPECT_EQ(s.minimiser[0].exact, "2");
  EXPECT_TRUE(s.minimum.contains(7));
  EXPECT_NE(s.message.find("end of the range"), std::string::npos);
  const Summary other = solve({x * x - number(30)}, Norm::linf, 2, 3);
  ASSERT_EQ(other.termination, Termination::proved) << other.message;
  EXPECT_EQ(other.minimiser[0].exact, "3");
}

TEST(OneParameter, SeveralMinimisersAreNotUnique) {
  const Summary s = solve({x * x - number(1)}, Norm::linf, -2, 2);
  EXPECT_EQ(s.termination, Termination::not_unique);
  EXPECT_LE(s.minimiser[0].lower, Rational(-1));
  EXPECT_GE(s.minimiser[0].upper, Rational(1));
  EXPECT_LT(s.minimum.upper.to_double(), 1e-14);
}

TEST(OneParameter, APoleInTheRangeIsSaid) {
  EXPECT_EQ(solve({number(1) / x}, Norm::linf, -1, 1).termination, Termination::pole_in_box);
  EXPECT_EQ(solve({number(1) / x}, Norm::linf, 0, 1).termination, Termination::pole_in_box);  // at the end
  EXPECT_EQ(solve({number(1) / (x * x - number(2)), x}, Norm::l1, 1, 2).termination,
            Termination::pole_in_box);
  EXPECT_NE(solve({number(1) / (x * x + number(2))}, Norm::l1, 1, 2).termination, Termination::pole_in_box);
}

TEST(OneParameter, AFlatMinimumRunsOutOfBoxes) {
  // max(|x^2 - 1|, 2) is 2 on a whole interval.
  Options few;
  few.max_boxes = 500;
  const Summary s = solve({x * x - number(1), number(2)}, Norm::linf, -3, 3, few);
  EXPECT_EQ(s.termination, Termination::out_of_boxes);
  EXPECT_EQ(s.minimiser[0].status, Status::out_of_depth);
  EXPECT_LE(s.boxes, 500);
  EXPECT_TRUE(s.minimum.contains(2));
  EXPECT_LE(s.minimiser[0].lower, Rational(-1));
  EXPECT_GE(s.minimiser[0].upper, Rational(1));
}

TEST(OneParameter, ADegenerateMinimumIsEnclosedButNotIsolated) {
  // |x^3| + |x^2 + 1|: the residual that vanishes has no slope there.
  Options coarse;
  coarse.width = Rational(1, 1000);
  const Summary s = solve({x * x * x, x * x + number(1)}, Norm::l1, -1, 2, coarse);
  EXPECT_EQ(s.termination, Termination::not_isolated) << s.message;
  EXPECT_TRUE(s.minimiser[0].contains(0));
  EXPECT_TRUE(s.minimum.contains(1));
  EXPECT_LE(s.minimiser[0].width(), coarse.width);
}

TEST(OneParameter, ACommonZeroIsProved) {
  const Summary s = solve({x * x * x, x * x * x * x * x - x}, Norm::l1, -1, 2);
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  EXPECT_EQ(s.minimiser[0].exact, "0");
  EXPECT_EQ(s.minimum.exact, "0");
}

TEST(OneParameter, CandidatesAreNotTrusted) {
  const Problem p{{x * x, x - number(1)}, Norm::linf, {{Rational(0), Rational(5)}}, {}};
  const Summary s = minimise_one_parameter(p, {}, {4.5, -100, 1e9});
  expect_at(s, (std::sqrt(5.0) - 1) / 2, (3 - std::sqrt(5.0)) / 2);
}

TEST(OneParameter, TheWidthIsAnOption) {
  Options fine;
  fine.width = Rational::power_of_two(-150);
  fine.precision = 400;
  const Summary s = solve({x * x * x - number(2), x - number(1)}, Norm::l1, -3, 3, fine);
  ASSERT_EQ(s.termination, Termination::proved) << s.message;
  const Rational cube = pow(s.minimiser[0].lower, 3);
  EXPECT_LE(s.minimiser[0].width(), fine.width);
  EXPECT_LE(cube, Rational(2));
  EXPECT_GE(pow(s.minimiser[0].upper, 3), Rational(2));
}

TEST(Minimise, RoutesToTheSolverThatFits) {
  const Range range{Rational(-2), Rational(2)};
  EXPECT_NE(minimise({{x - number(1)}, Norm::linf, {range}, {}}).method.find("LP"), std::string::npos);
  const Summary s = minimise({{x * x, x - number(1)}, Norm::linf, {range}, {}});
  expect_at(s, (std::sqrt(5.0) - 1) / 2, (3 - std::sqrt(5.0)) / 2);
}

TEST(Minimise, RejectsProblemsWithoutSense) {
  const Range range{Rational(-2), Rational(2)};
  EXPECT_THROW((void)minimise({{x}, Norm::linf, {}, {}}), InputError);
  EXPECT_THROW((void)minimise({{}, Norm::linf, {range}, {}}), InputError);
  EXPECT_THROW((void)minimise({{x}, Norm::linf, {{Rational(2), Rational(2)}}, {"s"}}), InputError);
  try {
    (void)minimise({{x}, Norm::linf, {{Rational(3), Rational(1)}}, {"s"}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("s=3..1"), std::string::npos);
  }
}

}  // namespace
}  // namespace subdiv
