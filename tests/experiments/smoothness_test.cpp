#include "experiments/smoothness.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

/// norm_k by the obvious loops, from the coefficients of jsplines equation (1): divide 2^m S(z) by
/// (1+z)^(m+1), multiply the iterates out, and add absolute values by residues.
double norm_of_power(double s, int m, int k) {
  std::vector<double> d{(s - 1) / 16, s / 8, (9 - s) / 16, 1 - s / 4, (9 - s) / 16, s / 8, (s - 1) / 16};
  for (double& c : d) c *= std::pow(2.0, m);
  for (int i = 0; i <= m; ++i) {
    for (std::size_t j = 1; j < d.size(); ++j) d[j] -= d[j - 1];
    d.pop_back();
  }
  std::vector<double> iterate{1.0};
  std::size_t spacing = 1;
  for (int i = 0; i < k; ++i, spacing *= 2) {
    std::vector<double> next(iterate.size() + spacing * (d.size() - 1), 0.0);
    for (std::size_t a = 0; a < iterate.size(); ++a) {
      for (std::size_t b = 0; b < d.size(); ++b) next[a + spacing * b] += iterate[a] * d[b];
    }
    iterate = std::move(next);
  }
  std::vector<double> sums(spacing, 0.0);
  for (std::size_t i = 0; i < iterate.size(); ++i) sums[i % spacing] += std::abs(iterate[i]);
  return *std::ranges::max_element(sums);
}

class Smoothness : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_smoothness();
    return all;
  }
};

TEST_F(Smoothness, FirstPowersByTheObviousLoop) {
  const auto first = [&](const std::string& id) {
    return static_cast<int>(test::value_of(results().claims, "smooth.first-power." + id));
  };
  const auto expect_first = [](double s, int m, int k) {
    EXPECT_LT(norm_of_power(s, m, k), 1);
    for (int i = 1; i < k; ++i) EXPECT_GE(norm_of_power(s, m, i), 1) << i;
  };
  expect_first(-1.7, 1, first("c1.lower"));
  expect_first(5.8, 1, first("c1.upper"));
  expect_first(2.8, 3, first("c3.upper"));
}

TEST_F(Smoothness, EndsOfCertifiedIntervalsHaveNormOne) {
  const Series& series = results().series.at(0);
  for (const int k : {2, 5, 9}) {
    const auto& row = series.rows.at(static_cast<std::size_t>(k - 1));
    EXPECT_NEAR(norm_of_power(std::stod(row.at(1)), 1, k), 1, 1e-7) << k;
    EXPECT_NEAR(norm_of_power(std::stod(row.at(2)), 1, k), 1, 1e-7) << k;
    EXPECT_NEAR(norm_of_power(std::stod(row.at(6)), 3, k), 1, 1e-7) << k;
  }
  // k = 2, m = 1 by hand: the interval ends at 5/2 -+ sqrt(33)/2.
  EXPECT_NEAR(std::stod(series.rows.at(1).at(1)), 2.5 - std::sqrt(33.0) / 2, 1e-9);
  EXPECT_NEAR(std::stod(series.rows.at(1).at(2)), 2.5 + std::sqrt(33.0) / 2, 1e-9);
}

TEST_F(Smoothness, AbstractIsRefutedAtOneEndOnly) {
  EXPECT_EQ(test::find_claim(results().claims, "smooth.abstract.c3").verdict, Verdict::refuted);
  EXPECT_EQ(test::find_claim(results().claims, "smooth.abstract.c2").verdict, Verdict::reproduced);
  EXPECT_EQ(test::find_claim(results().claims, "smooth.abstract.c4").verdict, Verdict::reproduced);
}

TEST_F(Smoothness, EveryClaimIsSettled) {
  EXPECT_EQ(results().claims.size(), smoothness_heads().size());
  for (const Claim& claim : results().claims) EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
}

}  // namespace
}  // namespace subdiv
