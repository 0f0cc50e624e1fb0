#include "schemes/algebra/matrix.h"

#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/elimination.h"
#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_int;
using testing::Samples;

template <class R>
Matrix<R> random_matrix(Generator& generator, int rows, int columns) {
  Matrix<R> result = zero_matrix<R>(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) result(i, j) = Samples<R>::draw(generator);
  }
  return result;
}

template <class R>
Matrix<R> product(const Matrix<R>& a, const Matrix<R>& b) {
  Matrix<R> result = zero_matrix<R>(a.rows(), b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      for (Eigen::Index k = 0; k < a.cols(); ++k) result(i, j) = result(i, j) + a(i, k) * b(k, j);
    }
  }
  return result;
}

template <class R>
Vector<R> random_vector(Generator& generator, int size) {
  const Matrix<R> column = random_matrix<R>(generator, size, 1);
  return column.col(0);
}

template <class R>
class MatrixOver : public ::testing::Test {};
using Rings = ::testing::Types<Rational, Polynomial, RationalFunction, Algebraic, Interval>;
TYPED_TEST_SUITE(MatrixOver, Rings);

// Every matrix is a root of its characteristic polynomial (Cayley and Hamilton).
TYPED_TEST(MatrixOver, CharacteristicPolynomialAnnihilatesTheMatrix) {
  using R = TypeParam;
  Generator generator(71);
  for (int n = 1; n <= 3; ++n) {
    const auto a = random_matrix<R>(generator, n, n);
    const std::vector<R> p = characteristic_polynomial(a);
    ASSERT_EQ(p.size(), static_cast<std::size_t>(n + 1));
    Matrix<R> value = zero_matrix<R>(n, n);
    for (auto c = p.rbegin(); c != p.rend(); ++c) {
      value = product(value, a);
      for (Eigen::Index i = 0; i < n; ++i) value(i, i) = value(i, i) + *c;
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) EXPECT_TRUE(Samples<R>::agree(value(i, j), R(0))) << n << i << j;
    }
    EXPECT_TRUE(Samples<R>::agree(p.back(), R(1)));
  }
}

TYPED_TEST(MatrixOver, CharacteristicPolynomialOfATriangularMatrixHasTheDiagonalAsRoots) {
  using R = TypeParam;
  Generator generator(72);
  auto a = random_matrix<R>(generator, 4, 4);
  std::vector<R> expected{R(1)};  // the product of x - a_ii, lowest power first
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) a(i, j) = R(0);
    std::vector<R> next(expected.size() + 1, R(0));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      next[k + 1] = next[k + 1] + expected[k];
      next[k] = next[k] - a(i, i) * expected[k];
    }
    expected = next;
  }
  const std::vector<R> p = characteristic_polynomial(a);
  for (std::size_t k = 0; k < p.size(); ++k) EXPECT_TRUE(Samples<R>::agree(p[k], expected[k]));
}

TEST(Matrix, CharacteristicPolynomialOfTheEmptyMatrixIsOne) {
  EXPECT_EQ(characteristic_polynomial(zero_matrix<Rational>(0, 0)), std::vector<Rational>{1});
}

// Trace and determinant are two coefficients: a second route for a 5 x 5 matrix.
TEST(Matrix, CharacteristicPolynomialOfACompanionMatrixIsThePolynomial) {
  const std::vector<Rational> c{Rational(3, 2), -7, 0, Rational(1, 5), 4};
  Matrix<Rational> companion = zero_matrix<Rational>(5, 5);
  for (Eigen::Index i = 0; i < 5; ++i) {
    if (i > 0) companion(i, i - 1) = Rational(1);
    companion(i, 4) = -c[static_cast<std::size_t>(i)];
  }
  std::vector<Rational> expected = c;
  expected.emplace_back(1);
  EXPECT_EQ(characteristic_polynomial(companion), expected);
}

template <class R>
class MatrixOverField : public ::testing::Test {};
using Fields = ::testing::Types<Rational, RationalFunction, Algebraic>;
TYPED_TEST_SUITE(MatrixOverField, Fields);

TYPED_TEST(MatrixOverField, SolvesWhatItMultiplied) {
  using R = TypeParam;
  Generator generator(73);
  for (int round = 0; round < 5; ++round) {
    const int columns = 1 + round % 3;
    const int rows = columns + round % 2;
    const auto a = random_matrix<R>(generator, rows, columns);
    const auto x = random_vector<R>(generator, columns);
    const Vector<R> b = product<R>(a, x).col(0);
    const auto solution = solve(a, b);
    if (!null_space(a).empty()) {
      EXPECT_FALSE(solution.has_value());
      continue;
    }
    ASSERT_TRUE(solution.has_value());
    for (int i = 0; i < columns; ++i) EXPECT_EQ((*solution)(i), x(i));
  }
}

TYPED_TEST(MatrixOverField, NullSpaceIsAnnihilatedAndHasTheRightDimension) {
  using R = TypeParam;
  Generator generator(74);
  // A product of a 4 x 2 and a 2 x 4 matrix has rank at most 2.
  const auto left = random_matrix<R>(generator, 4, 2);
  const auto right = random_matrix<R>(generator, 2, 4);
  const auto a = product(left, right);
  const auto basis = null_space(a);
  EXPECT_EQ(basis.size() + row_reduce(a).second.size(), 4U);
  EXPECT_GE(basis.size(), 2U);
  for (const Vector<R>& x : basis) {
    const auto image = product<R>(a, x);
    for (Eigen::Index i = 0; i < 4; ++i) EXPECT_TRUE(is_zero(image(i, 0)));
  }
  EXPECT_TRUE(null_space(identity_matrix<R>(3)).empty());
  EXPECT_EQ(null_space(zero_matrix<R>(2, 3)).size(), 3U);
}

TEST(Matrix, SolveRefusesContradictoryAndAmbiguousSystems) {
  Matrix<Rational> a = zero_matrix<Rational>(2, 2);
  a << Rational(1), Rational(2), Rational(2), Rational(4);
  Vector<Rational> consistent(2);
  consistent << Rational(1), Rational(2);
  Vector<Rational> contradictory(2);
  contradictory << Rational(1), Rational(3);
  EXPECT_FALSE(solve(a, consistent).has_value());
  EXPECT_FALSE(solve(a, contradictory).has_value());
  // More equations than unknowns, all of them satisfied or not.
  Matrix<Rational> tall = zero_matrix<Rational>(3, 1);
  tall << Rational(1), Rational(2), Rational(3);
  Vector<Rational> multiple(3);
  multiple << Rational(5), Rational(10), Rational(15);
  ASSERT_TRUE(solve(tall, multiple).has_value());
  EXPECT_EQ((*solve(tall, multiple))(0), Rational(5));
  multiple(2) = Rational(16);
  EXPECT_FALSE(solve(tall, multiple).has_value());
}

// The Hilbert matrix of order 8: its inverse has integer entries, its determinant is 1 over a 33-digit
// integer, and floating point loses it.
TEST(Matrix, InvertsTheHilbertMatrixExactly) {
  constexpr int n = 8;
  Matrix<Rational> hilbert = zero_matrix<Rational>(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) hilbert(i, j) = Rational(1, i + j + 1);
  }
  Vector<Rational> unit = Vector<Rational>::Constant(n, Rational(0));
  unit(0) = Rational(1);
  const auto column = solve(hilbert, unit);
  ASSERT_TRUE(column.has_value());
  EXPECT_EQ((*column)(0), Rational(n * n));
  for (int i = 0; i < n; ++i) EXPECT_TRUE((*column)(i).is_integer());
}

TEST(Matrix, FlintSolvesAsTheGeneralEliminationDoes) {
  Generator generator(76);
  for (int round = 0; round < 200; ++round) {
    const int columns = random_int(generator, 1, 6);
    const auto a = random_matrix<Rational>(generator, random_int(generator, 1, 7), columns);
    const Matrix<Rational> x = random_matrix<Rational>(generator, columns, 1);
    Vector<Rational> b = product(a, x).col(0);
    if (round % 3 == 0) b(0) += Rational(1);
    EXPECT_EQ(solve_linear(a, b), solve(a, b)) << round;
  }
}

TEST(Matrix, EigenMultipliesOurRings) {
  Generator generator(75);
  const auto a = random_matrix<Rational>(generator, 3, 3);
  const auto b = random_matrix<Rational>(generator, 3, 3);
  const Matrix<Rational> eigen_product = a * b;
  EXPECT_TRUE(eigen_product == product(a, b));
}

}  // namespace
}  // namespace subdiv
