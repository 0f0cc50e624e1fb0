#include "analysis/jsr/invariant_polytope.h"

#include <gtest/gtest.h>

#include "analysis/jsr/adapted_basis.h"
#include "analysis/transition_matrices.h"
#include "schemes/jspline.h"
#include "tests/analysis/daubechies.h"

namespace subdiv {
namespace {

constexpr long precision = 192;
const Deadline no_hurry(1000);

MatrixFamily pair(const std::vector<std::vector<int>>& a, const std::vector<std::vector<int>>& b) {
  std::vector<Matrix<Rational>> result;
  for (const auto& rows : {a, b}) {
    Matrix<Rational> t(2, 2);
    for (Eigen::Index i = 0; i < 2; ++i) {
      for (Eigen::Index j = 0; j < 2; ++j) {
        t(i, j) = Rational(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
      }
    }
    result.push_back(t);
  }
  return matrix_family(std::move(result), precision);
}

const MatrixFamily golden_pair = pair({{1, 1}, {0, 1}}, {{1, 0}, {1, 1}});

AdaptedFamily plain(const MatrixFamily& family) {
  return adapt(family, Eigen::MatrixXd::Identity(family.dimension(), family.dimension()));
}

TEST(LeadingVectors, AreEigenvectors) {
  const AdaptedFamily adapted = plain(golden_pair);
  const auto leading = leading_vectors(golden_pair, adapted, {0, 1});
  ASSERT_EQ(leading.size(), 1u);
  // The golden ratio squared, and (1, (1+sqrt 5)/2) up to scale.
  const Algebraic golden = (Algebraic(1) + sqrt(Algebraic(5))) / Algebraic(2);
  EXPECT_TRUE(leading[0].radius.contains(golden.to_interval(256)));
  EXPECT_LT(leading[0].radius.radius(), 1e-50);
  EXPECT_EQ(exact_radius(golden_pair, leading[0]), golden);
  const auto field = std::make_shared<const NumberField>(golden);
  const auto exact = exact_vector(golden_pair, leading[0], field);
  ASSERT_TRUE(exact);
  const FieldElement rho = FieldElement::generator(field);
  const Matrix<Rational> p = product(golden_pair.exact, {0, 1});
  for (Eigen::Index i = 0; i < 2; ++i) {
    FieldElement image(0);
    for (Eigen::Index j = 0; j < 2; ++j) image += FieldElement(p(i, j)) * (*exact)(j);
    EXPECT_EQ(image, rho * rho * (*exact)(i));
  }
}

TEST(LeadingVectors, OfRationalEigenvaluesAreExactAndComplete) {
  // The unit matrix: two null vectors of P - 1.
  const MatrixFamily family = pair({{1, 0}, {0, 1}}, {{0, 1}, {0, 0}});
  const auto leading = leading_vectors(family, plain(family), {0});
  ASSERT_EQ(leading.size(), 2u);
  EXPECT_TRUE(leading[0].rational && leading[1].rational);
  // Nilpotent: none.
  EXPECT_TRUE(leading_vectors(family, plain(family), {1}).empty());
}

TEST(LeadingVectors, OfAComplexPairComeOnce) {
  const MatrixFamily family = pair({{3, -4}, {4, 3}}, {{1, 0}, {0, 0}});
  const auto leading = leading_vectors(family, plain(family), {0});
  ASSERT_EQ(leading.size(), 1u);
  EXPECT_FALSE(leading[0].is_real());
  EXPECT_EQ(exact_radius(family, leading[0]), Algebraic(5));
}

TEST(InvariantPolytope, ClosesAtTheRightWord) {
  const AdaptedFamily adapted = plain(golden_pair);
  const LeadingVector start = leading_vectors(golden_pair, adapted, {0, 1})[0];
  InvariantPolytope polytope(golden_pair, adapted, {start.radius});
  polytope.add_cycle(start, 1);
  EXPECT_EQ(polytope.grow(50, no_hurry), Growth::closed);
  const auto proof = polytope.prove(no_hurry);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->tight);
}

TEST(InvariantPolytope, NeverClosesAtAWrongRadius) {
  // Just below the golden ratio; a radius one part in 10^6 too small.
  const AdaptedFamily adapted = plain(golden_pair);
  LeadingVector start = leading_vectors(golden_pair, adapted, {0, 1})[0];
  const Interval low = start.radius * Interval(Rational(999999, 1000000), precision);
  InvariantPolytope polytope(golden_pair, adapted, {low, nullptr, 0, false, false});
  polytope.add_vector(Eigen::Vector2d(1, 1));
  EXPECT_NE(polytope.grow(200, no_hurry), Growth::closed);
  const auto proof = polytope.prove(no_hurry);
  ASSERT_TRUE(proof);
  EXPECT_FALSE(proof->tight);
  EXPECT_TRUE(
      certainly_less(Interval(Rational(1000001, 1000000)), proof->bound + Interval(Rational(1, 1000000000))));
}

TEST(InvariantPolytope, WithSlackProvesNoLessThanTheRadius) {
  // Twice a right angle: T v / 2.4 becomes a vertex w, and T w = -4/2.4 v. Against the radius 1.6 asked for,
  // T w alone would show no more than 1.67; T v counts too.
  const MatrixFamily turn = pair({{0, -2}, {2, 0}}, {{0, 0}, {0, 0}});
  const AdaptedFamily adapted = plain(turn);
  const Interval low(Rational(8, 5), precision);
  InvariantPolytope polytope(turn, adapted, {low, nullptr, 0.5, false, false});
  polytope.add_vector(Eigen::Vector2d(1, 0));
  EXPECT_EQ(polytope.grow(200, no_hurry), Growth::closed);
  const auto proof = polytope.prove(no_hurry);
  ASSERT_TRUE(proof);
  EXPECT_FALSE(proof->tight);
  EXPECT_TRUE(certainly_less(Interval(Rational::parse("1.99"), precision), low * proof->bound));
}

TEST(InvariantPolytope, ReportsABetterWord) {
  // Word 0 of Daubechies' order 10 gives 3.381; 0011 is better.
  const MatrixFamily family = matrix_family(transition_matrices(testing::daubechies(10)), precision);
  const std::vector<Eigen::MatrixXd> middle = to_double(family.balls);
  const AdaptedFamily adapted = adapt(family, adapted_basis(middle, 49));
  const LeadingVector start = leading_vectors(family, adapted, {0})[0];
  InvariantPolytope polytope(family, adapted, {start.radius});
  polytope.add_cycle(start, 1);
  EXPECT_EQ(polytope.grow(1000, no_hurry), Growth::better_word);
  EXPECT_FALSE(polytope.better_word().empty());
}

TEST(InvariantPolytope, ProvesNothingWithoutFullRank) {
  // b = (1 + z^2)/2 of J_2 before its reduction: both matrices map onto multiples of (1, 1), a common
  // eigenvector.
  Matrix<Rational> t0 = zero_matrix<Rational>(2, 2);
  t0(0, 0) = t0(1, 0) = Rational(1, 2);
  Matrix<Rational> t1 = zero_matrix<Rational>(2, 2);
  t1(0, 1) = t1(1, 1) = Rational(1, 2);
  const MatrixFamily family = matrix_family(std::vector{t0, t1}, precision);
  const AdaptedFamily adapted = plain(family);
  const LeadingVector start = leading_vectors(family, adapted, {0})[0];
  InvariantPolytope polytope(family, adapted, {start.radius});
  polytope.add_cycle(start, 1);
  EXPECT_EQ(polytope.grow(50, no_hurry), Growth::closed);
  EXPECT_FALSE(polytope.prove(no_hurry));
  EXPECT_EQ(polytope.missing_directions().cols(), 1);
  polytope.add_vector(polytope.missing_directions().col(0) / 64);
  EXPECT_EQ(polytope.grow(50, no_hurry), Growth::closed);
  const auto proof = polytope.prove(no_hurry);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->tight);
}

TEST(InvariantPolytope, WithSlackBoundsTheRadiusFromAbove) {
  const AdaptedFamily adapted = plain(golden_pair);
  const LeadingVector start = leading_vectors(golden_pair, adapted, {0, 1})[0];
  const double slack = 0.01;
  InvariantPolytope polytope(golden_pair, adapted, {start.radius, nullptr, slack, false, false});
  polytope.add_cycle(start, 1);
  EXPECT_EQ(polytope.grow(50, no_hurry), Growth::closed);
  const auto proof = polytope.prove(no_hurry);
  ASSERT_TRUE(proof);
  EXPECT_FALSE(proof->tight);
  EXPECT_LE(proof->bound.upper(), Rational::from_double(1 + slack) + pow(Rational(10), -9));
}

TEST(InvariantPolytope, DecidesTheBoundaryExactly) {
  // J_{5/2}: the hexagon, whose images lie on its boundary.
  const std::vector<Matrix<Rational>> t =
      transition_matrices(normal_form(jspline(Rational(5, 2), Rational(5, 2))));
  const MatrixFamily family = matrix_family(t, precision);
  const AdaptedFamily adapted = plain(family);
  const auto field = std::make_shared<const NumberField>(Algebraic(Rational(3, 4)));
  InvariantPolytope polytope(family, adapted, {Interval(Rational(3, 4), precision), field});
  for (const Word& word : {Word{0}, Word{1}})
    polytope.add_cycle(leading_vectors(family, adapted, word)[0], 1);
  EXPECT_EQ(polytope.grow(50, no_hurry), Growth::closed);
  const auto proof = polytope.prove(no_hurry);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->tight);
}

TEST(InvariantPolytope, StopsInTime) {
  const MatrixFamily family = matrix_family(transition_matrices(testing::daubechies(9)), precision);
  const AdaptedFamily adapted = plain(family);
  const LeadingVector start = leading_vectors(family, adapted, {0})[0];
  InvariantPolytope polytope(family, adapted, {start.radius});
  polytope.add_cycle(start, 1);
  EXPECT_EQ(polytope.grow(1000, Deadline(0)), Growth::out_of_time);
  EXPECT_FALSE(polytope.prove(Deadline(0)));
}

}  // namespace
}  // namespace subdiv
