#include "experiments/speed_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "analysis/adjustable_speed/sector_form.h"
#include "analysis/mesh/limit_stencils.h"
#include "experiments/speed_parts.h"
#include "experiments/speed_printed.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/evaluate/surface_ring.h"
#include "schemes/mesh/catmull_clark.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_speed_rules();
  return once;
}

TEST(SpeedRules, EveryClaimIsSettledAndOnlyTheMisprintIsRefuted) {
  std::set<std::string> ids;
  for (const ClaimHead& head : speed_rule_heads()) ids.insert(head.id);
  EXPECT_EQ(ids.size(), speed_rule_heads().size());
  EXPECT_EQ(results().claims.size(), ids.size());
  std::set<std::string> refuted;
  std::set<std::string> lost;
  for (const Claim& claim : results().claims) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
    if (claim.verdict == Verdict::refuted) refuted.insert(claim.head.id);
    if (claim.verdict == Verdict::not_reproducible) lost.insert(claim.head.id);
  }
  EXPECT_EQ(refuted, std::set<std::string>{"speed.eq13.w33-2"});
  EXPECT_EQ(lost, (std::set<std::string>{"speed.doo-sabin", "speed.eq3"}));
}

TEST(SpeedRules, PrintedEntriesAreCounted) {
  EXPECT_EQ(printed_refinement().weights.size(), 7U);
  EXPECT_EQ(printed_conversion().weights.size(), 21U);
  EXPECT_EQ(printed_border().weights.size(), 42U);
}

TEST(SpeedRules, AnErrorInAnyEntryIsSeen) {
  for (const PrintedTable* table : {&printed_refinement(), &printed_conversion(), &recovered_refinement()}) {
    EXPECT_TRUE(is_complete(*table)) << table->equation;
    for (std::size_t i = 0; i < table->weights.size(); ++i) {
      PrintedTable wrong = *table;
      wrong.weights[i].text += "+s^9";
      EXPECT_FALSE(holds(wrong, wrong.weights[i])) << table->equation << ' ' << i;
      EXPECT_FALSE(is_complete(wrong)) << table->equation << ' ' << i;
      wrong.weights.erase(wrong.weights.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_FALSE(is_complete(wrong)) << table->equation << ' ' << i;
    }
  }
  EXPECT_FALSE(is_complete(printed_border()));  // the misprint
}

using Point = std::array<double, 1>;

SectorNet<Point> some_net(int valence, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Point> points(1 + 6 * static_cast<std::size_t>(valence));
  for (Point& p : points) p[0] = static_cast<double>(random() % 1000) / 100;
  return {valence, points};
}

// Numbers at small valences, where sectors meet: the formal sums count them without end.
TEST(SpeedRules, HalfIsCatmullClarkOnMeshes) {
  for (const int n : {3, 4, 5, 8}) {
    const SectorNet<Point> net = some_net(n, 7);
    const auto there = changed_places(uniform_knots<double>(), unit_speed_knots(0.5));
    const auto back = changed_places(unit_speed_knots(0.5), uniform_knots<double>());
    const auto step =
        changed_net(refined_net(changed_net(net, there), ring_rules(0.5), vertex_weights(0.5, n)), back);
    // fan_topology with a third ring of faces, whose points do not matter
    const MeshTopology mesh = fan_topology(4, n, 3);
    std::vector<Point> points{net.centre()};
    for (int k = 0; k < n; ++k) {
      for (int p = 0; p < static_cast<int>(sector_places(4, 3).size()); ++p)
        points.push_back(p < 6 ? net.at(k, p) : Point{99});
    }
    const auto fine = refined_points(mesh, catmull_clark<double>(), points);
    const MeshTopology fine_mesh = split(mesh, MeshSplit::quads);
    int spoke = -1;  // the half of the first spoke
    for_each_outgoing(fine_mesh, 0, [&](int h) {
      const int along = mesh.half_edge(fine_mesh.target(h) - mesh.vertices());
      if (mesh.origin(along) + mesh.target(along) == 1) spoke = h;
    });
    const auto order = fan_vertices(fine_mesh, spoke, 2);
    ASSERT_TRUE(order.has_value());
    for (std::size_t i = 0; i < order->size(); ++i)
      EXPECT_NEAR(fine[static_cast<std::size_t>((*order)[i])][0], step.points()[i][0], 1e-12)
          << n << ' ' << i;
  }
}

TEST(SpeedRules, LimitIsThatOfManySteps) {
  for (const int n : {3, 5, 7}) {
    const LimitStencil expected = limit_stencil(catmull_clark<double>(), n);
    for (const double sigma : {0.3, 0.5, 0.8}) {
      const SectorNet<Point> net = some_net(n, 11);
      double limit = expected.centre * net.centre()[0];
      for (int k = 0; k < n; ++k)
        limit += expected.position[0] * net.at(k, 0)[0] + expected.position[1] * net.at(k, 1)[0];
      auto current = changed_net(net, changed_places(uniform_knots<double>(), unit_speed_knots(sigma)));
      // Half way the speed is changed, and the net with it.
      const double other = 0.6;
      for (int step = 0; step < 200; ++step) {
        if (step == 3)
          current = changed_net(current, changed_places(unit_speed_knots(sigma), unit_speed_knots(other)));
        const double speed = step < 3 ? sigma : other;
        current = refined_net(current, ring_rules(speed), vertex_weights(speed, n));
      }
      EXPECT_NEAR(current.centre()[0], limit, 1e-9) << n << ' ' << sigma;
    }
  }
}

TEST(SpeedRules, ConversionIsConvexUpToItsEnd) {
  const double end = test::value_of(results().claims, "speed.eq11.convex");
  EXPECT_NEAR(end, 1 - std::sqrt(0.5), 1e-12);
  for (const double sigma : {0.05, 0.2, end - 1e-3, end + 1e-3, 0.5 + 1e-3, 0.7, 0.95}) {
    double least = 1;
    for (const auto& rule : changed_places(uniform_knots<double>(), unit_speed_knots(sigma))) {
      least = std::min(least, rule.centre);
      for (const auto& term : rule.terms) least = std::min(least, term.weight);
    }
    EXPECT_EQ(least >= 0, sigma < end) << sigma;
  }
}

TEST(SpeedRules, WeightsOfTheVertexArePositiveAtAllValences) {
  using Function = RationalFunction;
  using speed_variables::sigma;
  using speed_variables::valence;
  const VertexWeights<Function> own = printed_vertex_weights(sigma);
  const Function alpha = Function(1) - own.beta - own.gamma;
  for (const Function& weight : {own.beta, own.gamma, alpha}) {
    EXPECT_TRUE(is_positive_at_all_valences(weight));
    EXPECT_FALSE(is_positive_at_all_valences(-weight));
    for (const int n : {3, 4, 5, 50}) {
      for (const double s : {1e-6, 0.3, 0.7, 1 - 1e-6})
        EXPECT_GT(weight.evaluate<double>(std::array{s, 0.0, 0.0, static_cast<double>(n)}), 0);
    }
  }
  // Weights that are not: negative at some speed, at valence 3 alone, beyond one valence, with a pole.
  EXPECT_FALSE(is_positive_at_all_valences(own.beta - own.gamma * Function(8)));
  EXPECT_FALSE(is_positive_at_all_valences(alpha - Function(Rational(1, 2))));
  EXPECT_FALSE(is_positive_at_all_valences(own.gamma * (valence - Function(3))));
  EXPECT_FALSE(is_positive_at_all_valences(own.gamma * (Function(20) - valence)));
  EXPECT_FALSE(is_positive_at_all_valences(own.beta / (sigma - Function(Rational(1, 2)))));
  EXPECT_FALSE(is_positive_at_all_valences(Function(0)));
  // Two signs that cancel.
  EXPECT_TRUE(is_positive_at_all_valences(-own.beta / (sigma - Function(1))));
}

TEST(SpeedRules, TheVerticesRuleIsNeededForRings) {
  const Claim& appendix = test::find_claim(results().claims, "speed.appendix");
  EXPECT_EQ(appendix.verdict, Verdict::reproduced);
  EXPECT_NE(appendix.note.find("(1) to (3)"), std::string::npos);
  // In numbers: two rings of one net with different weights.
  const SectorNet<Point> net = some_net(5, 3);
  const RingRules<double> rules = ring_rules(0.6);
  const auto ring = [&](const VertexWeights<double>& weights) {
    return ring_sector(border_points(net, rules, 0),
                       border_points(refined_net(net, rules, weights), rules, 0), 0.6);
  };
  const auto a = ring({0.3, 0.2});
  const auto b = ring({0.2, 0.4});
  int different = 0;
  for (std::size_t k = 0; k < 16; ++k) {
    for (const auto patch :
         {&RingSector<Point>::corner, &RingSector<Point>::first_side, &RingSector<Point>::next_side})
      different += std::abs((a.*patch)[k][0] - (b.*patch)[k][0]) > 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(test::find_claim(results().claims, "speed.appendix.alone").exact,
            std::to_string(different) + " of 48 coefficients");
}

TEST(SpeedRules, RangeOfVertexWeights) {
  // The formulas of speed.eq1.range at n = 4, sigma = 1/2: with the cubic B-spline's eigenvalues 1/4 and 1/16
  // they give the weights of its knot insertion, beta = 3/8 and gamma = 1/16.
  const double q = 0.5;
  const double sum = 2 - 2 * 0.5 * (1 + q * q) - 5.0 / 16;
  const double share = (1.0 / 64 - q * q * q * q + q * q * q * sum) / (0.5 * q * q);
  EXPECT_NEAR(sum, 3.0 / 8 + 1.0 / 16, 1e-15);
  EXPECT_NEAR(share, 1.0 / 16, 1e-15);
}

}  // namespace
}  // namespace subdiv
