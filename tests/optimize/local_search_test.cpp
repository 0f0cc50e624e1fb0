#include "optimize/local_search.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const RationalFunction x = RationalFunction::variable(0);
const RationalFunction y = RationalFunction::variable(1);

RationalFunction number(long p, long q = 1) { return fraction<RationalFunction>(p, q); }

const Range range{Rational(-3), Rational(4)};

TEST(LocalSearch, FindsBothValleysBestFirst) {
  const RationalFunction f = (x * x - number(1)) * (x * x - number(1)) + x / number(10) + number(1);
  const auto found = local_minima({{f}, Norm::linf, {range}, {}}, {});
  ASSERT_GE(found.size(), 2U);
  EXPECT_NEAR(found[0].x[0], -1.0122, 1e-3);
  EXPECT_NEAR(found[1].x[0], 0.9873, 1e-3);
  EXPECT_LT(found[0].objective, found[1].objective);
}

TEST(LocalSearch, LeastSquaresInTwoParameters) {
  // Rosenbrock's valley as residuals.
  const auto found =
      local_minima({{number(10) * (y - x * x), number(1) - x}, Norm::l2, {range, range}, {}}, {});
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].x[0], 1, 1e-8);
  EXPECT_NEAR(found[0].x[1], 1, 1e-8);
  EXPECT_NEAR(found[0].objective, 0, 1e-16);
}

TEST(LocalSearch, KinksInTwoParameters) {
  const auto found =
      local_minima({{x + y - number(1), x - y, x * y - number(1, 4)}, Norm::l1, {range, range}, {}}, {});
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].x[0], 0.5, 1e-5);
  EXPECT_NEAR(found[0].x[1], 0.5, 1e-5);
}

TEST(LocalSearch, IsTheSameEveryTimeAndStaysInTheBox) {
  const Problem p{{x * x - y, y - number(9), x * y}, Norm::linf, {range, range}, {}};
  const auto first = local_minima(p, {});
  const auto second = local_minima(p, {});
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].x, second[i].x);
    for (const double c : first[i].x) {
      EXPECT_GE(c, -3);
      EXPECT_LE(c, 4);
    }
  }
}

TEST(LocalSearch, ListsAPointOnce) {
  const auto found =
      local_minima({{(x - number(1)) * (x - number(1)) + number(1)}, Norm::l1, {range}, {}}, {});
  EXPECT_EQ(found.size(), 1U);
}

TEST(LocalSearch, AnyFunctionOfTheParameters) {
  // |x - 1| + (y + 2)^2, and two equal valleys at x = +-1 with a wall of infinities between them.
  const std::vector<Range> box{{Rational(-3), Rational(3)}, {Rational(-3), Rational(3)}};
  const auto bowl = [](const std::vector<double>& at) {
    return std::abs(at[0] - 1) + (at[1] + 2) * (at[1] + 2);
  };
  const std::vector<LocalMinimum> one = local_minima(bowl, box, 8, 1e-9);
  ASSERT_FALSE(one.empty());
  EXPECT_NEAR(one.front().x[0], 1, 1e-6);
  EXPECT_NEAR(one.front().x[1], -2, 1e-3);
  const auto valleys = [](const std::vector<double>& at) {
    return std::abs(at[0]) < 0.1 ? std::numeric_limits<double>::infinity() : std::abs(at[0] * at[0] - 1);
  };
  const std::vector<LocalMinimum> two = local_minima(valleys, {box[0]}, 16, 1e-9);
  ASSERT_GE(two.size(), 2U);
  EXPECT_NEAR(two[0].x[0] * two[1].x[0], -1, 1e-6);
  EXPECT_TRUE(local_minima([](const auto&) { return std::nan(""); }, {box[0]}, 4, 1e-9).empty());
}

}  // namespace
}  // namespace subdiv
