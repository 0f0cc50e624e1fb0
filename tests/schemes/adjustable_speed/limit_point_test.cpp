#include "schemes/adjustable_speed/limit_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "schemes/evaluate/surface_ring.h"
#include "tests/schemes/evaluate/random_nets.h"

namespace subdiv {
namespace {

using sample::random_net;

class LimitPoint : public testing::TestWithParam<int> {};

// A left eigenvector: the step does not change the point.
TEST_P(LimitPoint, StaysTheSameInEveryStep) {
  const int n = GetParam();
  for (const Rational& sigma : {Rational(1, 3), Rational(1, 2), Rational(9, 10)}) {
    const VertexWeights<Rational> weights = vertex_weights(sigma, n);
    const VertexWeights<Rational> limit = limit_weights(weights, sigma);
    const auto net = random_net<Rational>(n, 7U);
    const auto refined = refined_net(net, ring_rules(sigma), weights);
    EXPECT_EQ(vertex_point(net, limit), vertex_point(refined, limit)) << sigma.to_string();
  }
}

TEST_P(LimitPoint, OfOtherWeightsToo) {
  const int n = GetParam();
  const Rational sigma(2, 5);
  const VertexWeights<Rational> weights{Rational(1, 3), Rational(1, 7)};
  const VertexWeights<Rational> limit = limit_weights(weights, sigma);
  const auto net = random_net<Rational>(n, 8U);
  EXPECT_EQ(vertex_point(net, limit), vertex_point(refined_net(net, ring_rules(sigma), weights), limit));
}

// That the fixed point of the step is where the steps lead.
TEST_P(LimitPoint, IsWhereTheStepsLead) {
  const int n = GetParam();
  for (const double sigma : {0.3, 0.5, 0.75}) {
    const VertexWeights<double> weights = vertex_weights(sigma, n);
    auto net = random_net<double>(n, 9U);
    const double limit = vertex_point(net, limit_weights(weights, sigma));
    constexpr int steps = 150;
    for (int k = 0; k < steps; ++k) net = refined_net(net, ring_rules(sigma), weights);
    for (const double x : net.points()) EXPECT_NEAR(x, limit, 1e-12) << sigma;
  }
}

// Karciauskas & Peters, section III: with (1) the limit point is Catmull-Clark's, whatever the speed.
TEST_P(LimitPoint, IsCatmullClarksAfterTheChangeOfKnots) {
  const int n = GetParam();
  for (const Rational& sigma : {Rational(1, 3), Rational(1, 2), Rational(9, 10)}) {
    const auto uniform = random_net<Rational>(n, 10U);
    const auto net = changed_net(uniform, changed_places(uniform_knots<Rational>(), unit_speed_knots(sigma)));
    EXPECT_EQ(vertex_point(net, limit_weights(vertex_weights(sigma, n), sigma)),
              vertex_point(uniform, uniform_limit_weights<Rational>(n)));
  }
}

INSTANTIATE_TEST_SUITE_P(Valences, LimitPoint, testing::Values(3, 4, 5, 8, 13));

}  // namespace
}  // namespace subdiv
