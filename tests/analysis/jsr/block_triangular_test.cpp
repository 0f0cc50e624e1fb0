#include "analysis/jsr/block_triangular.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

using Family = std::vector<Matrix<Rational>>;

Matrix<Rational> matrix(const std::vector<std::vector<int>>& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Matrix<Rational> result(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      result(i, j) = Rational(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

std::vector<Eigen::Index> sizes(const std::vector<Family>& blocks) {
  std::vector<Eigen::Index> result;
  for (const Family& block : blocks) result.push_back(block[0].rows());
  std::sort(result.begin(), result.end());
  return result;
}

/// The characteristic polynomials of all blocks multiply to that of the whole, for each matrix and for their
/// sum.
void expect_consistent(const Family& family, const std::vector<Family>& blocks) {
  Matrix<Rational> sum = family[0];
  for (std::size_t i = 1; i < family.size(); ++i) sum = (sum + family[i]).eval();
  for (std::size_t i = 0; i <= family.size(); ++i) {
    UnivariatePolynomial product(1);
    for (const Family& block : blocks) {
      Matrix<Rational> part = block[0];
      for (std::size_t k = 1; k < block.size(); ++k) part = (part + block[k]).eval();
      if (i < family.size()) part = block[i];
      product *= UnivariatePolynomial(characteristic_polynomial(part));
    }
    EXPECT_EQ(product, UnivariatePolynomial(characteristic_polynomial(i < family.size() ? family[i] : sum)))
        << i;
  }
}

TEST(BlockTriangular, SplitsByZeroPatterns) {
  const Family family{matrix({{1, 0, 2}, {5, 3, 7}, {0, 0, 4}}), matrix({{2, 0, 0}, {0, 1, 0}, {0, 0, 9}})};
  const auto blocks = diagonal_blocks(family);
  EXPECT_EQ(sizes(blocks), (std::vector<Eigen::Index>{1, 1, 1}));
  expect_consistent(family, blocks);
}

TEST(BlockTriangular, FindsHiddenSubspaces) {
  // A pair with the invariant line (1, 2, 3) and a 2 x 2 quotient, written in a basis that hides it.
  const Family upper{matrix({{2, 1, 5}, {0, 1, 1}, {0, 1, 0}}), matrix({{-1, 0, 3}, {0, 0, 2}, {0, 1, 1}})};
  const Matrix<Rational> s = matrix({{1, 0, 0}, {2, 1, 0}, {3, -1, 1}});
  const Matrix<Rational> inverse = matrix({{1, 0, 0}, {-2, 1, 0}, {-5, 1, 1}});
  ASSERT_TRUE(Matrix<Rational>(s * inverse) == identity_matrix<Rational>(3));
  Family hidden;
  for (const Matrix<Rational>& t : upper) hidden.emplace_back(s * t * inverse);
  const auto blocks = diagonal_blocks(hidden);
  EXPECT_EQ(sizes(blocks), (std::vector<Eigen::Index>{1, 2}));
  expect_consistent(hidden, blocks);
  // The transposes have an invariant plane.
  Family transposed;
  for (const Matrix<Rational>& t : hidden) transposed.emplace_back(t.transpose());
  EXPECT_EQ(sizes(diagonal_blocks(transposed)), (std::vector<Eigen::Index>{1, 2}));
}

TEST(BlockTriangular, LeavesIrreducibleFamiliesWhole) {
  EXPECT_EQ(diagonal_blocks(Family{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})}).size(), 1u);
  // Irreducible over Q only: eigenvalues +-sqrt(2), +-i.
  EXPECT_EQ(diagonal_blocks(Family{matrix({{0, 2}, {1, 0}})}).size(), 1u);
  EXPECT_EQ(diagonal_blocks(Family{matrix({{0, -1}, {1, 0}})}).size(), 1u);
  // Multiples of the unit matrix split completely.
  EXPECT_EQ(diagonal_blocks(Family{matrix({{2, 0}, {0, 2}}), matrix({{3, 0}, {0, 3}})}).size(), 2u);
}

TEST(BlockTriangular, SplitsIntervalsByExactZerosOnly) {
  std::vector<Matrix<Interval>> family(1, zero_matrix<Interval>(2, 2));
  family[0](0, 0) = family[0](1, 1) = family[0](0, 1) = Interval(1);
  EXPECT_EQ(diagonal_blocks(family).size(), 2u);
  family[0](1, 0) = Interval::hull(Rational(-1, 1000), Rational(1, 1000));
  EXPECT_EQ(diagonal_blocks(family).size(), 1u);
}

}  // namespace
}  // namespace subdiv
