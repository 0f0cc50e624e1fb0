#include "schemes/evaluate/block_table.h"

#include <cmath>

#include <gtest/gtest.h>

#include "schemes/evaluate/level_by_level.h"
#include "tests/schemes/evaluate/sample_schemes.h"

namespace subdiv {
namespace {

using testing::binary_and_ternary_schemes;
using testing::j;
using testing::q;
using testing::Rationals;

/// The steps of a scheme from one on.
Scheme<Rational> from_step(const Scheme<Rational>& scheme, std::size_t step) {
  Scheme<Rational> rest{scheme.name, {}};
  for (std::size_t k = step; k < scheme.steps.size(); ++k) rest.steps.push_back(scheme.steps[k]);
  if (rest.steps.empty()) rest.steps.push_back(scheme.last());
  return rest;
}

TEST(BlockTable, HoldsWhatStepsMakeOfAnImpulse) {
  constexpr int around = 24;  // more points than any window has
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    for (const int step : {0, 1, 3}) {
      for (int count = 0; count <= 3; ++count) {
        const auto table = block_table<double>(scheme, step, count);
        Rationals impulse(2 * around + 1, q(0));
        impulse[around] = q(1);
        const ControlPolygon<Rational> refined = refine_level_by_level(
            from_step(scheme, static_cast<std::size_t>(step)), closed_polygon(impulse), count);
        const auto B = static_cast<long long>(table.outputs);
        for (int o = -around; o <= around; ++o) {
          for (long long i = 0; i < B; ++i) {
            const double expected = refined.at(B * (around - o) + i).to_double();
            const bool inside = table.window.first <= o && o <= table.window.last;
            const double weight = inside ? table.weights[table.place(o, static_cast<std::size_t>(i))] : 0;
            EXPECT_EQ(weight, expected) << scheme.name << " " << count << " " << o << " " << i;
          }
        }
      }
    }
  }
}

TEST(BlockTable, SixPointsABlockForJ) {
  for (int steps = 2; steps <= 8; ++steps) {
    EXPECT_EQ(block_table<double>(j(q(3, 2)), 0, steps).window, (IndexWindow{-2, 3}));
    EXPECT_EQ(block_table<float>(j(q(-1)), 0, steps).window, (IndexWindow{-2, 3}));
  }
  EXPECT_EQ(block_table<double>(j(q(3, 2)), 0, 6).bytes(), 3072U);
  EXPECT_EQ(block_table<float>(j(q(3, 2)), 0, 6).bytes(), 1536U);
}

TEST(BlockTable, FillsCacheLines) {
  const auto table = block_table<double>(binary_and_ternary_schemes().back(), 0, 3);
  EXPECT_EQ(table.outputs, 27U);
  EXPECT_EQ(table.lines(), 4U);
  EXPECT_EQ(table.padding(), 5U);
  EXPECT_EQ(table.weights.size(), 4U * 8U * static_cast<std::size_t>(table.window.size()));
  for (int o = table.window.first; o <= table.window.last; ++o)
    for (std::size_t i = 27; i < 32; ++i) EXPECT_EQ(table.weights[table.place(o, i)], 0);
}

TEST(BlockTable, IsRoundedOnceFromAnyRing) {  // 1/3 is no double: over the doubles errors add up
  const Scheme<Rational> exact = j(q(1, 3));
  const auto in_doubles = map_coefficients(exact, [](const Rational& x) { return x.to_double(); });
  const auto table = block_table<double>(exact, 0, 6);
  const auto other = block_table<double>(in_doubles, 0, 6);
  ASSERT_EQ(table.weights.size(), other.weights.size());
  for (std::size_t i = 0; i < table.weights.size(); ++i)
    EXPECT_NEAR(table.weights[i], other.weights[i], 6 * 4 * 0x1p-52);
}

std::vector<std::size_t> outputs(const Scheme<Rational>& scheme, int depth) {
  std::vector<std::size_t> result;
  for (const auto& table : block_stages<double>(scheme, depth).tables) result.push_back(table.outputs);
  return result;
}

TEST(BlockStages, TheLastTableIsSmall) {
  using Sizes = std::vector<std::size_t>;
  EXPECT_EQ(outputs(j(q(1)), 0), Sizes{1});
  EXPECT_EQ(outputs(j(q(1)), 1), Sizes{2});
  EXPECT_EQ(outputs(j(q(1)), 6), Sizes{64});
  EXPECT_EQ(outputs(j(q(1)), 7), (Sizes{2, 64}));
  EXPECT_EQ(outputs(j(q(1)), 14), (Sizes{256, 64}));
  EXPECT_EQ(outputs(j(q(1)), 28), (Sizes{64, 256, 256, 64}));
  EXPECT_EQ(outputs(binary_and_ternary_schemes().back(), 10), (Sizes{9, 243, 27}));
  EXPECT_EQ(block_stages<double>(j(q(3, 2)), 14).bytes(), (256U + 64U) * 6 * 8);
}

TEST(BlockStages, RefusesDepthsWithoutMeaning) {
  EXPECT_THROW((void)block_stages<double>(j(q(1)), -1), std::invalid_argument);
  EXPECT_THROW((void)block_stages<double>(j(q(1)), 63), std::overflow_error);
}

TEST(BlockStages, AMaskOfNothingGivesNothing) {
  const auto stages = block_stages<double>(stationary("0", Mask<Rational>{2, Laurent<Rational>()}), 3);
  ASSERT_EQ(stages.tables.size(), 1U);
  EXPECT_EQ(stages.tables[0].window.size(), 1);
  for (const double weight : stages.tables[0].weights) EXPECT_EQ(weight, 0);
}

}  // namespace
}  // namespace subdiv
