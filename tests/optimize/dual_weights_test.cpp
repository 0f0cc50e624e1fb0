#include "optimize/dual_weights.h"

#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

double worst_case(const std::vector<AffinePiece>& pieces, const std::vector<double>& weights, std::size_t n) {
  double value = 0;
  std::vector<double> slope(n, 0);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    value += weights[p] * pieces[p].constant;
    for (std::size_t j = 0; j < n; ++j) slope[j] += weights[p] * pieces[p].slope[j];
  }
  for (const double s : slope) value -= std::abs(s);
  return value;
}

TEST(DualWeights, BothSidesOfTheLinearProgramAgree) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (std::size_t n = 1; n <= 3; ++n) {
    for (int trial = 0; trial < 100; ++trial) {
      std::vector<AffinePiece> pieces(2 + static_cast<std::size_t>(trial) % 9);
      for (AffinePiece& piece : pieces) {
        piece.constant = number(random);
        for (std::size_t j = 0; j < n; ++j) piece.slope.push_back(3 * number(random));
      }
      const LeastMaximum result = least_maximum(pieces);
      EXPECT_NEAR(std::accumulate(result.weights.begin(), result.weights.end(), 0.0), 1, 1e-12);
      double largest = -INFINITY;
      for (const AffinePiece& piece : pieces) {
        double value = piece.constant;
        for (std::size_t j = 0; j < n; ++j) value += piece.slope[j] * result.point[j];
        largest = std::max(largest, value);
      }
      EXPECT_NEAR(largest, result.value, 1e-10);
      EXPECT_NEAR(worst_case(pieces, result.weights, n), result.value, 1e-10);
    }
  }
}

TEST(DualWeights, ScaleDoesNotMatter) {
  const std::vector<AffinePiece> pieces{{1e-18, {1e-17}}, {1e-18, {-2e-17}}};
  const LeastMaximum result = least_maximum(pieces);
  EXPECT_NEAR(result.weights[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(result.value, 1e-18, 1e-30);
}

TEST(DualWeights, MaximumWeighsAPairAgainstItsSlopes) {
  // max(|1 + 3y|, |1 - y|): weights 1/4 and 3/4 cancel the slopes.
  const std::vector<AffinePiece> residuals{{1, {3}}, {1, {-1}}};
  const std::vector<double> w = dual_weights(Norm::linf, residuals, {-0.5, {0}});
  EXPECT_NEAR(w[0], 0.25, 1e-9);
  EXPECT_NEAR(w[1], 0.75, 1e-9);
}

TEST(DualWeights, SumTakesFractionalSignsWhereAResidualVanishes) {
  // 3 + y + |2 y| is least at y = 0, where |2 y| takes the weight -1/2.
  const std::vector<AffinePiece> residuals{{3, {1}}, {0, {2}}};
  const std::vector<double> w = dual_weights(Norm::l1, residuals, {0, {0}});
  EXPECT_NEAR(w[0], 1, 1e-9);
  EXPECT_NEAR(w[1], -0.5, 1e-9);
}

}  // namespace
}  // namespace subdiv
