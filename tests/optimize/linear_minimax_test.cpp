#include "optimize/linear_minimax.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const RationalFunction x = RationalFunction::variable(0);
const RationalFunction y = RationalFunction::variable(1);

RationalFunction number(long p, long q = 1) { return fraction<RationalFunction>(p, q); }

Problem problem(std::vector<RationalFunction> residuals, Norm norm, std::vector<Range> box) {
  return {std::move(residuals), norm, std::move(box), {}};
}

const Range wide{Rational(-10), Rational(10)};

TEST(LinearMinimax, MidrangeAndMedian) {
  const std::vector<RationalFunction> data{x - number(1), x - number(2), x - number(7)};
  const auto linf = minimise_linear(problem(data, Norm::linf, {wide}));
  ASSERT_TRUE(linf);
  EXPECT_EQ(linf->termination, Termination::proved);
  EXPECT_EQ(linf->minimiser[0].exact, "4");
  EXPECT_EQ(linf->minimum.exact, "3");
  EXPECT_EQ(linf->active, (std::vector<int>{0, 2}));
  const auto l1 = minimise_linear(problem(data, Norm::l1, {wide}));
  ASSERT_TRUE(l1);
  EXPECT_EQ(l1->minimiser[0].exact, "2");
  EXPECT_EQ(l1->minimum.exact, "6");
  EXPECT_EQ(l1->active, (std::vector<int>{1}));
}

TEST(LinearMinimax, BestLineInTheChebyshevSense) {
  // t^2 at 0, 1/2, 1 by x + y t: the error is 1/8 at all three (equioscillation).
  std::vector<RationalFunction> residuals;
  for (int i = 0; i <= 2; ++i) residuals.push_back(x + y * number(i, 2) - number(i * i, 4));
  const auto best = minimise_linear(problem(residuals, Norm::linf, {wide, wide}));
  ASSERT_TRUE(best);
  EXPECT_EQ(best->termination, Termination::proved);
  EXPECT_EQ(best->minimiser[0].exact, "-1/8");
  EXPECT_EQ(best->minimiser[1].exact, "1");
  EXPECT_EQ(best->minimum.exact, "1/8");
  EXPECT_EQ(best->active.size(), 3U);
}

TEST(LinearMinimax, TheBoxBinds) {
  const auto best = minimise_linear(problem({x - number(5)}, Norm::linf, {{Rational(0), Rational(2)}}));
  ASSERT_TRUE(best);
  EXPECT_EQ(best->minimiser[0].exact, "2");
  EXPECT_EQ(best->minimum.exact, "3");
}

TEST(LinearMinimax, SaysWhenTheMinimiserIsNotUnique) {
  const auto median = minimise_linear(problem({x - number(1), x + number(1)}, Norm::l1, {wide}));
  ASSERT_TRUE(median);
  EXPECT_EQ(median->termination, Termination::not_unique);
  EXPECT_EQ(median->minimum.exact, "2");
  // Unique in x, free in y.
  const auto partly = minimise_linear(problem({x - number(1), number(0) * y}, Norm::linf, {wide, wide}));
  ASSERT_TRUE(partly);
  EXPECT_EQ(partly->termination, Termination::not_unique);
}

TEST(LinearMinimax, LeavesOtherProblemsAlone) {
  EXPECT_FALSE(minimise_linear(problem({x * x}, Norm::linf, {wide})));
  EXPECT_FALSE(minimise_linear(problem({x * y}, Norm::linf, {wide, wide})));
  EXPECT_FALSE(minimise_linear(problem({number(1) / (x + number(20))}, Norm::linf, {wide})));
  EXPECT_FALSE(minimise_linear(problem({x}, Norm::l2, {wide})));
  EXPECT_FALSE(minimise_linear(problem({x + y}, Norm::linf, {wide})));  // y has no range
}

TEST(LinearMinimax, AgreesWithATableOverVertices) {
  // A minimax of n lines in one parameter lies where two of +-r_i cross: try them all.
  const std::vector<std::pair<Rational, Rational>> lines{{Rational(1, 3), Rational(2)},
                                                         {Rational(-3), Rational(5, 7)},
                                                         {Rational(1), Rational(-4)},
                                                         {Rational(2), Rational(1, 2)}};
  std::vector<RationalFunction> residuals;
  for (const auto& [slope, constant] : lines)
    residuals.push_back(RationalFunction(slope) * x + RationalFunction(constant));
  const auto worst = [&](const Rational& at) {
    Rational largest(0);
    for (const auto& [slope, constant] : lines) largest = std::max(largest, abs(slope * at + constant));
    return largest;
  };
  Rational best = worst(0);
  for (const auto& [a, b] : lines) {
    for (const auto& [c, d] : lines) {
      if (a != c) best = std::min(best, worst((d - b) / (a - c)));
      if (a != -c) best = std::min(best, worst((-d - b) / (a + c)));
    }
  }
  const auto found = minimise_linear(problem(residuals, Norm::linf, {wide}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->minimum.lower, best);
  EXPECT_EQ(worst(found->minimiser[0].lower), best);
}

}  // namespace
}  // namespace subdiv
