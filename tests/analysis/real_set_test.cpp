#include "analysis/real_set.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Algebraic root = sqrt(Algebraic(2));

RealSet solve(const std::vector<Algebraic>& critical, const std::function<bool(const Algebraic&)>& holds) {
  return solve_by_cells(critical, holds);
}

TEST(RealSet, SolvesByCells) {
  const std::vector<Algebraic> critical{root, Algebraic(-1), root, Algebraic(0), -root};
  const auto value = [](const Algebraic& x) { return (x * x - Algebraic(2)) * (x + Algebraic(1)) * x * x; };
  EXPECT_EQ(solve(critical, [&](const Algebraic& x) { return value(x).sign() > 0; }).to_string(),
            "(-sqrt(2), -1) u (sqrt(2), inf)");
  EXPECT_EQ(solve(critical, [&](const Algebraic& x) { return value(x).sign() >= 0; }).to_string(),
            "[-sqrt(2), -1] u {0} u [sqrt(2), inf)");
}

TEST(RealSet, ClosedOpenAndIsolated) {
  const std::vector<Algebraic> critical{Algebraic(0), Algebraic(1), Algebraic(2), Algebraic(3), Algebraic(4)};
  const auto holds = [](const Algebraic& x) {
    return (x >= Algebraic(0) && x < Algebraic(2) && !(x == Algebraic(1))) || x == Algebraic(3);
  };
  const RealSet set = solve(critical, holds);
  EXPECT_EQ(set.to_string(), "[0, 1) u (1, 2) u {3}");
  for (int twice = -2; twice <= 10; ++twice) {
    const Algebraic x(Rational(twice, 2));
    EXPECT_EQ(set.contains(x), holds(x)) << twice;
  }
  EXPECT_TRUE(set.contains(root));
  EXPECT_EQ(solve(critical, [](const Algebraic&) { return true; }).to_string(), "(-inf, inf)");
  EXPECT_EQ(solve({}, [](const Algebraic&) { return true; }).to_string(), "(-inf, inf)");
  EXPECT_EQ(solve({}, [](const Algebraic&) { return false; }).to_string(), "empty");
  EXPECT_TRUE(solve(critical, [](const Algebraic&) { return false; }).is_empty());
}

TEST(RealSet, RationalBetween) {
  EXPECT_EQ(rational_between(Algebraic(0), Algebraic(1)), Rational(1, 2));
  // Two irrational numbers closer than double precision: sqrt(2) and sqrt(2 + 10^-60).
  const Algebraic near = sqrt(Algebraic(Rational(2) + pow(Rational(10), -60)));
  const Rational between = rational_between(root, near);
  EXPECT_TRUE(root < Algebraic(between) && Algebraic(between) < near);
  EXPECT_THROW(rational_between(root, root), std::domain_error);
}

TEST(RealSet, RootsOfOneParameter) {
  const Polynomial x = Polynomial::variable(3);
  std::vector<Algebraic> roots{Algebraic(7)};
  append_real_roots(x * x - Polynomial(2), 3, roots);
  append_real_roots(Polynomial(5), 3, roots);
  append_real_roots(Polynomial(0), 3, roots);
  EXPECT_EQ(roots, (std::vector<Algebraic>{Algebraic(7), -root, root}));
  EXPECT_THROW(append_real_roots(x * Polynomial::variable(1), 3, roots), std::domain_error);
}

}  // namespace
}  // namespace subdiv
