#include "analysis/expanding_line.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Polynomial x = Polynomial::variable(0);

RealSet as_set(const ExpandingLine& line) {
  RealSet set;
  for (const ExpandingPart& part : line.parts()) set.parts.push_back(part.range);
  return set;
}

TEST(ExpandingLine, PartsAndGapsShareTheirEnds) {
  ExpandingLine line(-3, 3);
  EXPECT_EQ(line.gaps().size(), 1U);
  line.add({{0}, Polynomial(1) - x});                                // x >= 1
  line.add({{1}, Polynomial(2) - x * x});                            // |x| >= sqrt 2
  line.add({{0, 1}, x * x * (x - Polynomial(5)) * Polynomial(-1)});  // touches 0 at 0
  EXPECT_EQ(as_set(line).to_string(), "[-3, -sqrt(2)] u {0} u [1, 3]");
  ASSERT_EQ(line.gaps().size(), 2U);
  const OpenGap& left = line.gaps()[0];
  EXPECT_EQ(left.at_lower, (std::vector<Word>{{1}}));
  EXPECT_EQ(left.at_upper, (std::vector<Word>{{0, 1}}));
  EXPECT_FALSE(left.range.lower_closed || left.range.upper_closed);
  EXPECT_TRUE(*left.range.upper == Algebraic(0));
  EXPECT_TRUE(*line.gaps()[1].range.upper == Algebraic(1));
}

TEST(ExpandingLine, EndsOfTheLine) {
  ExpandingLine line(0, 1);
  line.add({{0}, x});  // 0 alone
  EXPECT_EQ(as_set(line).to_string(), "{0}");
  ASSERT_EQ(line.gaps().size(), 1U);
  EXPECT_FALSE(line.gaps()[0].range.lower_closed);
  EXPECT_TRUE(line.gaps()[0].range.upper_closed);
  line.add({{1}, Polynomial(0)});  // everywhere
  EXPECT_EQ(as_set(line).to_string(), "[0, 1]");
  EXPECT_TRUE(line.gaps().empty());
  EXPECT_THROW(ExpandingLine(1, 1), std::domain_error);
}

}  // namespace
}  // namespace subdiv
