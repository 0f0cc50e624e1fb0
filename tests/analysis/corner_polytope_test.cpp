#include "analysis/corner_polytope.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

Matrix<Rational> matrix(std::initializer_list<Rational> entries) {
  Matrix<Rational> result(2, 2);
  Eigen::Index i = 0;
  for (const Rational& q : entries) {
    result(i / 2, i % 2) = q;
    ++i;
  }
  return result;
}

TEST(CornerPolytope, ContractionsInAnAwkwardBasis) {
  // Radius 1/2, 1-norm 10: needs more than the unit vectors.
  const auto vertices = contracting_polytope({matrix({Rational(1, 2), 10, 0, Rational(1, 2)})}, 100);
  ASSERT_TRUE(vertices.has_value());
  EXPECT_GT(*vertices, 2U);
}

TEST(CornerPolytope, NothingIsProvedAtOrAboveOne) {
  EXPECT_FALSE(contracting_polytope({matrix({1, 0, 0, 0})}, 50).has_value());
  // Within the margin of 1 nothing is proved either.
  EXPECT_FALSE(contracting_polytope({matrix({Rational(999999, 1000000), 0, 0, 0})}, 50).has_value());
  EXPECT_TRUE(contracting_polytope({matrix({Rational(999, 1000), 0, 0, 0})}, 50).has_value());
  // Each matrix alone is nilpotent, their product has the radius 1.
  EXPECT_FALSE(contracting_polytope({matrix({0, 1, 0, 0}), matrix({0, 0, 1, 0})}, 50).has_value());
  const Rational c(9, 10);
  EXPECT_TRUE(contracting_polytope({matrix({0, c, 0, 0}), matrix({0, 0, c, 0})}, 50).has_value());
  // A rotation: products are bounded but do not shrink.
  EXPECT_FALSE(
      contracting_polytope({matrix({Rational(3, 5), Rational(-4, 5), Rational(4, 5), Rational(3, 5)})}, 200));
}

TEST(CornerPolytope, GoldenMeanPair) {
  // [1 1; 0 1], [1 0; 1 1] have the radius (1 + sqrt 5)/2 = 1.618..
  const auto scaled = [](const Rational& by) {
    return std::vector{matrix({by, by, 0, by}), matrix({by, 0, by, by})};
  };
  EXPECT_TRUE(contracting_polytope(scaled(Rational(617, 1000)), 200).has_value());
  EXPECT_FALSE(contracting_polytope(scaled(Rational(6181, 10000)), 200).has_value());
}

TEST(CornerPolytope, StopsAtTheBudget) {
  EXPECT_FALSE(contracting_polytope({matrix({Rational(1, 2), 10, 0, Rational(1, 2)})}, 2).has_value());
  EXPECT_FALSE(contracting_polytope({matrix({Rational::power_of_two(2000), 0, 0, 0})}, 50).has_value());
}

}  // namespace
}  // namespace subdiv
