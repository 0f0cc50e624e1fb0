#include "experiments/selection.h"

#include <gtest/gtest.h>

#include "schemes/input_error.h"
#include "tests/experiments/sample_experiments.h"

namespace subdiv {
namespace {

const std::array all{letters, numbers};

TEST(Matches, StarsAndQuestionMarks) {
  EXPECT_TRUE(matches("area.r", "area.r"));
  EXPECT_FALSE(matches("area.r", "area.rs"));
  EXPECT_TRUE(matches("area.?", "area.r"));
  EXPECT_FALSE(matches("area.?", "area."));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("a*b*c", "axxbyybzc"));
  EXPECT_FALSE(matches("a*b*c", "axxbyybz"));
  EXPECT_TRUE(matches("*.rs.*", "area.rs.r"));
  EXPECT_FALSE(matches("", "a"));
}

TEST(Select, RunsTheExperimentsThatOwnMatchingClaims) {
  const std::vector<std::string> patterns{"*.b"};
  const Selection some = select(all, patterns);
  ASSERT_EQ(some.experiments.size(), 1U);
  EXPECT_EQ(some.experiments[0]->name, "letters");
  EXPECT_EQ(some.ids, std::set<std::string>{"letters.b"});
  EXPECT_FALSE(some.everything);

  const Selection everything = select(all, {});
  EXPECT_EQ(everything.experiments.size(), 2U);
  EXPECT_EQ(everything.ids.size(), 3U);
  EXPECT_TRUE(everything.everything);
}

std::string rejection(std::vector<std::string> patterns) {
  try {
    (void)select(all, patterns);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Select, NamesWhatIsNearAPatternThatMatchesNothing) {
  EXPECT_EQ(rejection({"letters.a", "leters.b"}), "no claim matches 'leters.b'; near it: letters.b");
  EXPECT_EQ(rejection({"letters"}), "no claim matches 'letters'; near it: letters.a and letters.b");
  EXPECT_EQ(rejection({"qqqqqqqqqq"}), "no claim matches 'qqqqqqqqqq'; 'subdivlab list claims' names them");
}

}  // namespace
}  // namespace subdiv
