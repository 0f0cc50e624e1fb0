#include "optimize/linear_program.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

LinearProgram program(const std::vector<std::vector<Rational>>& rows,
                      const std::vector<Rational>& objective) {
  const auto n = static_cast<Eigen::Index>(objective.size());
  LinearProgram p{Matrix<Rational>(static_cast<Eigen::Index>(rows.size()), n),
                  Vector<Rational>(static_cast<Eigen::Index>(rows.size())), Vector<Rational>(n)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    p.b(static_cast<Eigen::Index>(i)) = rows[i][0];
    for (Eigen::Index j = 0; j < n; ++j)
      p.a(static_cast<Eigen::Index>(i), j) = rows[i][static_cast<std::size_t>(j) + 1];
  }
  for (Eigen::Index j = 0; j < n; ++j) p.c(j) = objective[static_cast<std::size_t>(j)];
  return p;
}

/// Maximise 3x + 5y over x <= 4, 2y <= 12, 3x + 2y <= 18, x, y >= 0 (Hillier & Lieberman): (2, 6), value 36.
LinearProgram textbook() {
  return program({{4, -1, 0}, {12, 0, -2}, {18, -3, -2}, {0, 1, 0}, {0, 0, 1}}, {3, 5});
}

TEST(LinearProgram, SolvesTheTextbookProblemWithItsDual) {
  const LinearProgram p = textbook();
  const LinearSolution s = solve(p);
  ASSERT_EQ(s.status, LinearSolution::Status::optimal);
  EXPECT_EQ(s.value, Rational(36));
  EXPECT_EQ(s.x(0), Rational(2));
  EXPECT_EQ(s.x(1), Rational(6));
  // The shadow prices of the three resources.
  EXPECT_EQ(s.y(0), Rational(0));
  EXPECT_EQ(s.y(1), Rational(3, 2));
  EXPECT_EQ(s.y(2), Rational(1));
  EXPECT_TRUE(is_optimal_pair(p, s.x, s.y));
}

TEST(LinearProgram, FreeVariablesAndFractions) {
  // Maximise -e with |x - 1/3| <= e, |x + 1/7| <= e: half of 10/21.
  const Rational third(1, 3);
  const Rational seventh(1, 7);
  const LinearSolution s =
      solve(program({{third, -1, 1}, {-third, 1, 1}, {-seventh, -1, 1}, {seventh, 1, 1}}, {0, -1}));
  ASSERT_EQ(s.status, LinearSolution::Status::optimal);
  EXPECT_EQ(s.value, Rational(-5, 21));
  EXPECT_EQ(s.x(0), Rational(2, 21));
}

TEST(LinearProgram, ACertificateThatWasTamperedWithDoesNotHold) {
  const LinearProgram p = textbook();
  const LinearSolution s = solve(p);
  const Rational little(1, 1000000000);
  for (Eigen::Index i = 0; i < s.y.size(); ++i) {
    for (const Rational& change : {little, -little}) {
      Vector<Rational> y = s.y;
      y(i) += change;
      EXPECT_FALSE(is_optimal_pair(p, s.x, y)) << i;
    }
  }
  for (Eigen::Index j = 0; j < s.x.size(); ++j) {
    for (const Rational& change : {little, -little}) {
      Vector<Rational> x = s.x;
      x(j) += change;
      EXPECT_FALSE(is_optimal_pair(p, x, s.y)) << j;
    }
  }
  LinearProgram other = p;
  other.c(1) += little;
  EXPECT_FALSE(is_optimal_pair(other, s.x, s.y));
  other = p;
  other.b(2) -= little;  // the vertex is no longer feasible
  EXPECT_FALSE(is_optimal_pair(other, s.x, s.y));
}

TEST(LinearProgram, AFeasiblePointThatIsNotOptimalHasNoCertificate) {
  const LinearProgram p = textbook();
  const LinearSolution s = solve(p);
  Vector<Rational> x(2);
  x(0) = 4;
  x(1) = 3;
  EXPECT_FALSE(is_optimal_pair(p, x, s.y));
}

TEST(LinearProgram, InfeasibilityIsProved) {
  // x >= 1, x <= 0.
  const LinearProgram p = program({{-1, 1}, {0, -1}}, {1});
  const LinearSolution s = solve(p);
  ASSERT_EQ(s.status, LinearSolution::Status::infeasible);
  // y >= 0, A^T y = 0, b . y < 0.
  EXPECT_EQ(s.y(0), s.y(1));
  EXPECT_GT(s.y(0), Rational(0));
}

TEST(LinearProgram, InfeasibilityOfThreeConstraintsInThePlane) {
  // x + y <= -1, x >= 0, y >= 0.
  const LinearSolution s = solve(program({{-1, -1, -1}, {0, 1, 0}, {0, 0, 1}}, {1, 1}));
  EXPECT_EQ(s.status, LinearSolution::Status::infeasible);
}

TEST(LinearProgram, UnboundednessIsSaid) {
  EXPECT_EQ(solve(program({{0, 1}}, {1})).status, LinearSolution::Status::unbounded);
}

TEST(LinearProgram, DegenerateVertices) {
  // Four constraints meet in one point of the plane.
  const LinearSolution s =
      solve(program({{1, -1, 0}, {1, 0, -1}, {2, -1, -1}, {3, -2, -1}, {3, -1, -2}}, {1, 1}));
  ASSERT_EQ(s.status, LinearSolution::Status::optimal);
  EXPECT_EQ(s.value, Rational(2));
}

}  // namespace
}  // namespace subdiv
