#include "analysis/three_tap_radius.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "analysis/sign_on_interval.h"
#include "analysis/transition_matrices.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

std::vector<Eigen::Matrix2d> pair_at(double p) {
  Eigen::Matrix2d first;
  first << p, 0, p, 1 - 2 * p;
  Eigen::Matrix2d second;
  second << 1 - 2 * p, p, 0, p;
  return {first, second};
}

/// Brute force bounds: the largest spectral radius^(1/k) and norm^(1/k) of all products of k matrices.
std::pair<double, double> brute_force(double p, int k) {
  double low = 0;
  double high = 0;
  const auto pair = pair_at(p);
  for (int bits = 0; bits < 1 << k; ++bits) {
    Eigen::Matrix2d product = Eigen::Matrix2d::Identity();
    for (int i = 0; i < k; ++i) product = pair[static_cast<std::size_t>(bits >> i & 1)] * product;
    const double half_trace = product.trace() / 2;
    const double square = half_trace * half_trace - product.determinant();
    const double radius =
        square >= 0 ? std::abs(half_trace) + std::sqrt(square) : std::sqrt(product.determinant());
    low = std::max(low, std::pow(radius, 1.0 / k));
    high = std::max(high, std::pow(product.norm(), 1.0 / k));
  }
  return {low, high};
}

TEST(ThreeTapRadius, MatricesAreTheTransitionMatricesOfTheMask) {
  const Function p = Function::variable(0);
  // A mask with two smoothing factors: 2 ((1+z)/2)^2 (p + (1-2p) z + p z^2).
  const Laurent<Function> b(0, {p, Function(1) - Function(2) * p, p});
  const Laurent<Function> symbol = fraction<Function>(1, 2) * (pow(smoothing_factor<Function>(2), 2) * b);
  EXPECT_TRUE(transition_matrices(normal_form(Mask<Function>{2, symbol})) == three_tap_matrices());
}

TEST(ThreeTapRadius, LiesBetweenBruteForceBounds) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> numerator(-300, 300);
  for (int i = 0; i < 25; ++i) {
    const Rational p(numerator(random), 100);
    const double value = three_tap_radius(Algebraic(p)).to_interval().to_double();
    const auto [low, high] = brute_force(p.to_double(), 12);
    EXPECT_GE(value, low - 1e-12) << p.to_string();
    EXPECT_LE(value, high + 1e-12) << p.to_string();
    EXPECT_NEAR(value, low, 1e-12) << p.to_string();  // words 0 and 01 have even powers of length 12
  }
}

TEST(ThreeTapRadius, ClosedForms) {
  EXPECT_TRUE(three_tap_radius(Algebraic(Rational(-1, 2))) == Algebraic(2));
  EXPECT_TRUE(three_tap_radius(Algebraic(0)) == Algebraic(1));
  EXPECT_TRUE(three_tap_radius(Algebraic(Rational(1, 4))) == Algebraic(Rational(1, 2)));
  EXPECT_TRUE(three_tap_radius(Algebraic(Rational(1, 2))) == Algebraic(Rational(1, 2)));
  EXPECT_TRUE(three_tap_radius(Algebraic(1)) == Algebraic(1));
  EXPECT_TRUE(three_tap_radius(Algebraic(3)) == Algebraic(5));
  // The largest value between 1/4 and 1/2: p = (4 + sqrt 2)/14, rho = (1 + 2 sqrt 2)/7.
  const Algebraic root = sqrt(Algebraic(2));
  const Algebraic top = (Algebraic(4) + root) / Algebraic(14);
  const Algebraic value = (Algebraic(1) + Algebraic(2) * root) / Algebraic(7);
  EXPECT_TRUE(three_tap_radius(top) == value);
  EXPECT_LT(three_tap_radius(top + Algebraic(Rational(1, 1000))), value);
  EXPECT_LT(three_tap_radius(top - Algebraic(Rational(1, 1000))), value);
}

TEST(ThreeTapRadius, PiecesCoverTheLineAndStandByThemselves) {
  const auto& pieces = three_tap_radius_pieces();
  ASSERT_EQ(pieces.size(), 5U);
  EXPECT_FALSE(pieces.front().range.lower.has_value());
  EXPECT_FALSE(pieces.back().range.upper.has_value());
  for (const RadiusPiece& piece : pieces) {
    EXPECT_EQ(find_flaw(piece.polytope, piece.parameters), std::nullopt);
    // A factor that is smaller by a millionth is no longer proved.
    ParametricPolytope tight = piece.polytope;
    tight.factor *= fraction<Function>(999999, 1000000);
    EXPECT_TRUE(find_flaw(tight, piece.parameters).has_value()) << piece.shape;
  }
  // The octagon ends where it should: just outside u = 1 and u = 3 it fails.
  EXPECT_TRUE(find_flaw(pieces[2].polytope, closed_interval(Rational(999, 1000), 3)).has_value());
  EXPECT_TRUE(find_flaw(pieces[2].polytope, closed_interval(1, Rational(3001, 1000))).has_value());
}

TEST(ThreeTapRadius, RangesBelowPowersOfTwo) {
  EXPECT_EQ(three_tap_radius_below(1).to_string(), "(0, 1)");
  EXPECT_EQ(three_tap_radius_below(2).to_string(), "(-1/2, 3/2)");
  EXPECT_EQ(three_tap_radius_below(4).to_string(), "(-3/2, 5/2)");
  EXPECT_TRUE(three_tap_radius_below(Rational(1, 2)).is_empty());
  // Above 1/2 and below the hump: two intervals, around p = 1/4 and 1/2.
  EXPECT_EQ(three_tap_radius_below(Rational(27, 50)).parts.size(), 2U);
}

TEST(ThreeTapRadius, CommonNormBoundsMixedProducts) {
  EXPECT_EQ(three_tap_common_norm(Rational(-2, 5), Rational(-1, 4)), Rational(9, 5));
  EXPECT_EQ(three_tap_common_norm(0, 1), Rational(1));
  EXPECT_EQ(three_tap_common_norm(Rational(1, 4), Rational(3, 4)), Rational(3, 4));
  EXPECT_EQ(three_tap_common_norm(2, 2), Rational(3));
  EXPECT_THROW((void)three_tap_common_norm(1, 0), std::domain_error);
  // Random products with a p of its own for every factor, in the norm whose unit ball is the hexagon.
  const auto hexagon_norm = [](const Eigen::Vector2d& v) {
    return v(0) * v(1) >= 0 ? v.cwiseAbs().maxCoeff() : v.cwiseAbs().sum();
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> p(-0.4, 0.7);
  const double bound = three_tap_common_norm(Rational(-2, 5), Rational(7, 10)).to_double();
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::Vector2d v(1, trial % 3 - 1);
    double allowed = hexagon_norm(v);
    for (int i = 0; i < 10; ++i) {
      v = pair_at(p(random))[random() % 2] * v;
      allowed *= bound;
      EXPECT_LE(hexagon_norm(v), allowed * (1 + 1e-12));
    }
  }
}

}  // namespace
}  // namespace subdiv
