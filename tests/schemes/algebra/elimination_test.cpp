#include "schemes/algebra/elimination.h"

#include <gtest/gtest.h>

#include "schemes/algebra/jet.h"
#include "schemes/algebra/real.h"
#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

/// A 5 x 3 system with the solution (1, -2, 3), and a pivot that must be exchanged.
template <class R>
std::pair<Matrix<R>, Vector<R>> system(int contradiction = 0) {
  const int rows[5][3] = {{0, 2, 1}, {1, 1, 1}, {2, 4, 3}, {1, -1, 4}, {3, 0, 0}};
  const int solution[3] = {1, -2, 3};
  Matrix<R> a(5, 3);
  Vector<R> b(5);
  for (int i = 0; i < 5; ++i) {
    int value = i == 4 ? contradiction : 0;
    for (int j = 0; j < 3; ++j) {
      a(i, j) = R(rows[i][j]);
      value += rows[i][j] * solution[j];
    }
    b(i) = R(value);
  }
  return {a, b};
}

template <class R>
class SolveLinear : public ::testing::Test {};
using Fields =
    ::testing::Types<Rational, RationalFunction, Algebraic, double, Interval, Real, ceres::Jet<double, 2>>;
TYPED_TEST_SUITE(SolveLinear, Fields);

TYPED_TEST(SolveLinear, FindsTheSolutionOfATallSystem) {
  using R = TypeParam;
  const auto [a, b] = system<R>();
  const auto x = solve_linear<R>(a, b);
  ASSERT_TRUE(x.has_value());
  for (int j = 0; j < 3; ++j) {
    const R expected = R(j == 1 ? -2 : j + 1);
    if constexpr (ExactRing<R>) {
      EXPECT_EQ((*x)(j), expected);
    } else {
      EXPECT_LT(std::abs(pivot_quality(R((*x)(j)-expected))), 1e-14);
    }
  }
}

TYPED_TEST(SolveLinear, RefusesSystemsWithoutAUniqueSolution) {
  using R = TypeParam;
  Matrix<R> a(3, 2);
  for (int i = 0; i < 3; ++i) {
    a(i, 0) = R(i + 1) / R(3);
    a(i, 1) = R(i + 1) / R(7);
  }
  const Vector<R> b = a.col(0);
  EXPECT_FALSE(solve_linear<R>(a, b).has_value());
  EXPECT_FALSE(solve_linear<R>(Matrix<R>(a.topRows(1)), Vector<R>(b.head(1))).has_value());
}

TEST(SolveLinear, ExactFieldsSeeContradictions) {
  const auto [a, b] = system<Rational>(1);
  EXPECT_FALSE(solve_linear<Rational>(a, b).has_value());
}

TEST(SolveLinear, IntervalsEncloseTheExactSolution) {
  testing::Generator generator(7);
  for (int trial = 0; trial < 50; ++trial) {
    Matrix<Rational> a(4, 4);
    Matrix<Interval> wide(4, 4);
    Vector<Rational> b(4);
    Vector<Interval> right(4);
    const Rational width(1, 1000);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        a(i, j) = testing::random_rational(generator) + Rational(i == j ? 60 : 0);
        wide(i, j) = Interval::hull(a(i, j) - width, a(i, j) + width);
      }
      b(i) = testing::random_rational(generator);
      right(i) = Interval::hull(b(i) - width, b(i) + width);
    }
    const auto exact = solve_linear(a, b);
    const auto enclosed = solve_linear(wide, right);
    ASSERT_TRUE(exact.has_value() && enclosed.has_value());
    for (int i = 0; i < 4; ++i) {
      EXPECT_TRUE((*enclosed)(i).contains((*exact)(i)));
      EXPECT_LT((*enclosed)(i).radius(), 0.01);
    }
  }
}

TEST(SolveLinear, AnIntervalThatMayVanishIsNoPivot) {
  EXPECT_EQ(pivot_quality(Interval::hull(Rational(-1), Rational(100))), 0.0);
  EXPECT_GT(pivot_quality(Interval::hull(Rational(1, 2), Rational(100))), 0.4);
  EXPECT_LE(pivot_quality(Interval::hull(Rational(1, 2), Rational(100))), 0.5);
  EXPECT_EQ(pivot_quality(-3.0), 3.0);
}

}  // namespace
}  // namespace subdiv
