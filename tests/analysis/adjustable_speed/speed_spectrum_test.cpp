#include "analysis/adjustable_speed/speed_spectrum.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/adjustable_speed/speed_matrix.h"
#include "analysis/mesh/mesh_condition.h"
#include "schemes/adjustable_speed/limit_point.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

SpectralCondition condition_at(int valence) {
  const Function sigma = Function::variable(0);
  return {turning_modes(speed_matrix(sigma, 11)), invariant_mode(speed_matrix(sigma, valence)), valence};
}

// Karciauskas & Peters, (6), as a polynomial of the numbers.
double printed_six(double x, double sigma, double beta, double gamma) {
  const double q = 1 - sigma;
  return x * x + (beta + gamma - 2 + 2 * sigma * (q * q + 1)) * x +
         q * q * (q * q - (beta + gamma) * q + gamma * sigma);
}

TEST(SpeedSpectrum, QuadraticsAreThePrintedOnes) {
  const SpeedQuadratics found = speed_quadratics();
  const double sigma = 0.3;
  const double beta = 0.21;
  const double gamma = 0.17;
  const double c = 0.4;
  const double q = 0.7;
  const double x = 0.55;
  const std::array<double, max_parameters> values{sigma, beta, gamma, 0, 0, c, 0, x};
  EXPECT_NEAR(found.invariant.evaluate<double>(values), printed_six(x, sigma, beta, gamma), 1e-14);
  EXPECT_NEAR(found.turning.evaluate<double>(values),
              x * x - q * (sigma * sigma * (1 + c) + 2 * q) * x + q * q * q * q, 1e-14);
}

TEST(SpeedSpectrum, WholeMatrixHasRowsOfSumOneAndTheLimitAsLeftEigenvector) {
  for (const int n : {3, 4, 5, 7}) {
    const Rational sigma(3, 5);
    const VertexWeights<Rational> weights = vertex_weights(sigma, n);
    const Matrix<Rational> matrix = full_matrix(speed_matrix(sigma, n));
    const VertexWeights<Rational> limit = limit_weights(weights, sigma);
    std::vector<Rational> left(static_cast<std::size_t>(matrix.rows()), Rational(0));
    left[0] = Rational(1) - limit.beta - limit.gamma;
    for (int k = 0; k < n; ++k) {
      const auto first = static_cast<std::size_t>(1 + 6 * k);
      left[first] = limit.beta / Rational(n);
      left[first + 1] = limit.gamma / Rational(n);
    }
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      Rational row(0);
      Rational column(0);
      for (Eigen::Index j = 0; j < matrix.rows(); ++j) {
        row += matrix(i, j);
        column += left[static_cast<std::size_t>(j)] * matrix(j, i);
      }
      EXPECT_EQ(row, Rational(1));
      EXPECT_EQ(column, left[static_cast<std::size_t>(i)]) << n << " " << i;
    }
  }
}

TEST(SpeedSpectrum, EachIdentityIsAskedFor) {
  const SpeedComparison right = speed_comparison();
  ASSERT_TRUE(identities_hold(right));
  for (Function SpeedComparison::* part : {&SpeedComparison::P, &SpeedComparison::Q, &SpeedComparison::a,
                                           &SpeedComparison::b, &SpeedComparison::E, &SpeedComparison::G}) {
    SpeedComparison wrong = right;
    wrong.*part = wrong.*part + Function::variable(0);
    EXPECT_FALSE(identities_hold(wrong));
  }
}

TEST(SpeedSpectrum, InequalitiesFailWhereTheyShould) {
  const SpeedComparison comparison = speed_comparison();
  const Function half = fraction<Function>(1, 2);
  // C = q^4 (1 - 9 (1 - q^2)/D): |C| < q^4 for D = 9/2 exactly, not for less.
  EXPECT_TRUE(product_is_small(comparison, Function(9) * half));
  EXPECT_FALSE(product_is_small(comparison, Function(4)));
  EXPECT_FALSE(product_is_small(comparison, Function(-9)));
  EXPECT_TRUE(mirrored_is_larger(comparison, Function(9), Function(-1)));
  EXPECT_FALSE(mirrored_is_larger(comparison, Function(2), Function(-1)));
  SpeedComparison wrong = comparison;
  wrong.b = wrong.b * Function(2);
  EXPECT_FALSE(mirrored_is_larger(wrong, Function(9), Function(-1)));
}

TEST(SpeedSpectrum, LambdaIsSubdominantByTheArgumentForAllValences) {
  EXPECT_TRUE(mode_0_is_compared());
  EXPECT_TRUE(lambda_is_subdominant());
}

// The second route: circles between the moduli, cell by cell.
TEST(SpeedSpectrum, LambdaIsSubdominantByIntervalsAtSingleValences) {
  for (const int n : {3, 5, 12}) {
    const std::vector<ConditionCell> cells =
        condition_at(n).cells(Rational(1, 20), Rational(19, 20), Rational(1, 1L << 20));
    ASSERT_EQ(cells.size(), 1);
    EXPECT_EQ(cells[0].holds, Decision::yes) << n;
  }
}

TEST(SpeedSpectrum, ModeTwoIsNextBelowTheEndAtValenceFive) {
  const RealSet speeds = speeds_with_mode_2_next(5);
  ASSERT_EQ(speeds.parts.size(), 1);
  const RealInterval& part = speeds.parts[0];
  EXPECT_TRUE(*part.lower == Algebraic(0));
  // The zero of (6) at the larger root of (7) for k = 2, by bisection in multiprecision floating point.
  EXPECT_NEAR(part.upper->to_interval().to_double(), 0.981608267833502934, 1e-15);
  const SpectralCondition condition = condition_at(5);
  EXPECT_EQ(condition.rival(Rational(981, 1000)).mode, 2);
  EXPECT_EQ(condition.rival(Rational(982, 1000)).mode, 0);
}

TEST(SpeedSpectrum, ModeTwoIsNextFromValenceSixOn) {
  EXPECT_TRUE(mode_2_is_next_from(6));
  EXPECT_FALSE(mode_2_is_next_from(5));
  for (const int n : {6, 7, 9, 17, 18, 25}) {
    const RealSet speeds = speeds_with_mode_2_next(n);
    ASSERT_EQ(speeds.parts.size(), 1);
    EXPECT_TRUE(*speeds.parts[0].upper == Algebraic(1)) << n;
    const SpectralCondition condition = condition_at(n);
    for (const Rational& sigma : {Rational(1, 50), Rational(1, 2), Rational(999, 1000)})
      EXPECT_EQ(condition.rival(sigma).mode, 2) << n;
  }
  EXPECT_THROW(static_cast<void>(speeds_with_mode_2_next(4)), std::invalid_argument);
}

TEST(SpeedSpectrum, ModeTwoExceedsTheSquare) {
  EXPECT_TRUE(mode_2_exceeds_square());
  const auto leading = condition_at(5).leading(Rational(1, 2));
  ASSERT_TRUE(leading);
  EXPECT_TRUE(certainly_less(leading->subdominant * leading->subdominant, leading->next));
}

TEST(SpeedSpectrum, NextIsBelowTheSquareBetweenTheEndsAtValenceThree) {
  const RealSet speeds = speeds_with_next_below_square_at_3();
  ASSERT_EQ(speeds.parts.size(), 1);
  const double lower = speeds.parts[0].lower->to_interval().to_double();
  const double upper = speeds.parts[0].upper->to_interval().to_double();
  EXPECT_FALSE(speeds.parts[0].lower_closed || speeds.parts[0].upper_closed);
  const SpectralCondition condition = condition_at(3);
  for (const double end : {lower, upper}) {
    for (const double off : {-0.001, 0.001}) {
      const auto leading = condition.leading(Rational::parse(std::to_string(end + off)));
      ASSERT_TRUE(leading);
      const Interval square = leading->subdominant * leading->subdominant;
      const bool inside = (off > 0) == (end == lower);
      EXPECT_TRUE(inside ? certainly_less(leading->next, square) : certainly_less(square, leading->next))
          << end + off;
    }
  }
}

// Catmull-Clark at valence 3: mode 0 has 1/6 (Peters & Reif: Subdivision Surfaces,
// 2008, 6.1: 16 x^2 - (12 - 28/n) x + 1 - 3/n).
TEST(SpeedSpectrum, HalfSpeedHasCatmullClarksEigenvalues) {
  const auto leading = condition_at(3).leading(Rational(1, 2));
  ASSERT_TRUE(leading);
  EXPECT_NEAR(leading->next.to_double(), 1.0 / 6, 1e-15);
  const double c = -0.5;
  EXPECT_NEAR(leading->subdominant.to_double(), (5 + c + std::sqrt((9 + c) * (1 + c))) / 16, 1e-15);
}

}  // namespace
}  // namespace subdiv
