#include "analysis/jsr/candidate_products.h"

#include <cmath>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Deadline no_hurry(1000);

TEST(CandidateProducts, FindsTheLongWordOfGripenbergsExample) {
  std::vector<Eigen::MatrixXd> family(2, Eigen::MatrixXd(2, 2));
  family[0] << 0.6, 0, 0.2, 0.6;
  family[1] << 0.6, -0.6, 0, -0.2;
  const auto best = candidate_products(family, no_hurry);
  EXPECT_EQ(word_text(best[0].word), "0000000000001");
  EXPECT_NEAR(best[0].radius, 0.659678908955283, 1e-13);
  EXPECT_GT(best[0].radius, best[1].radius);
}

TEST(CandidateProducts, GrowsWordsBeyondTheExhaustiveLength) {
  // Three letters: all words of up to 4 letters only, the winner has 13.
  std::vector<Eigen::MatrixXd> family(3, Eigen::MatrixXd(2, 2));
  family[0] << 0.6, 0, 0.2, 0.6;
  family[1] << 0.6, -0.6, 0, -0.2;
  family[2] << 0.1, 0, 0, 0.1;
  CandidateSearch search;
  search.words = 60;
  EXPECT_EQ(candidate_products(family, no_hurry, search)[0].word.size(), 13u);
}

TEST(CandidateProducts, PutsShortWordsFirstAmongEqualOnes) {
  std::vector<Eigen::MatrixXd> family(2, Eigen::MatrixXd::Identity(2, 2));
  family[1] *= -1;
  const auto best = candidate_products(family, no_hurry);
  EXPECT_EQ(word_text(best[0].word), "0");
  EXPECT_EQ(word_text(best[1].word), "1");
  EXPECT_EQ(word_text(best[2].word), "01");
}

TEST(CandidateProducts, OfANilpotentFamilyAreNone) {
  Eigen::MatrixXd t(2, 2);
  t << 0, 1, 0, 0;
  EXPECT_TRUE(candidate_products({t}, no_hurry).empty());
}

}  // namespace
}  // namespace subdiv
