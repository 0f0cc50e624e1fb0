#include "experiments/run.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/experiments/sample_experiments.h"

namespace subdiv {
namespace {

Outcome outcome_of(const Experiment& experiment) {
  const std::vector<const Experiment*> chosen{&experiment};
  return run(chosen, 1).front();
}

TEST(Run, ClaimsStandInTheOrderOfTheTable) {
  const Outcome outcome = outcome_of(letters);
  ASSERT_EQ(outcome.results.claims.size(), 2U) << outcome.error;
  EXPECT_EQ(outcome.results.claims[0].head.id, "letters.a");
  EXPECT_EQ(outcome.results.claims[1].head.id, "letters.b");
}

TEST(Run, OutcomesStandInTheGivenOrderForAnyNumberOfThreads) {
  std::vector<const Experiment*> chosen;
  for (int i = 0; i < 20; ++i) chosen.push_back(i % 3 == 0 ? &letters : &numbers);
  for (const int jobs : {0, 1, 4, 50}) {
    int finished = 0;
    const auto outcomes = run(chosen, jobs, [&](const Experiment&) { ++finished; });
    ASSERT_EQ(outcomes.size(), chosen.size());
    EXPECT_EQ(finished, 20);
    for (std::size_t i = 0; i < chosen.size(); ++i) EXPECT_EQ(outcomes[i].experiment, chosen[i]);
  }
}

TEST(Run, AnExperimentThatThrowsBreaksAlone) {
  const Experiment broken{"broken", "", numbers_heads, run_broken};
  const std::vector<const Experiment*> chosen{&broken, &letters};
  const auto outcomes = run(chosen, 2);
  EXPECT_EQ(outcomes[0].error, "out of luck");
  EXPECT_TRUE(outcomes[0].broke());
  EXPECT_FALSE(outcomes[1].broke());
}

TEST(Run, EachClaimIsSettledExactlyOnceAndFilesHaveProperNames) {
  EXPECT_EQ(outcome_of({"x", "", letters_heads, run_forgetful}).error, "claim 'letters.a' was not settled");
  EXPECT_EQ(outcome_of({"x", "", numbers_heads, run_twice}).error, "claim 'numbers.one' was settled twice");
  EXPECT_TRUE(outcome_of({"x", "", numbers_heads, run_letters}).broke()) << "claims of another table";
  EXPECT_TRUE(outcome_of({"x", "", numbers_heads, run_with_bad_file_name}).broke());
}

TEST(Registry, IdsAndNamesAreUniqueAndHeadsAreComplete) {
  std::set<std::string> ids;
  std::set<std::string> names;
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(names.insert(experiment.name).second) << experiment.name;
    for (const ClaimHead& head : experiment.heads()) {
      EXPECT_TRUE(ids.insert(head.id).second) << head.id;
      EXPECT_FALSE(head.definition.empty()) << head.id;
      EXPECT_FALSE(head.section.empty()) << head.id;
      constexpr std::array documents{"js-report", "jsplines", "polyloops", "notes", "speed", "subdivlab"};
      EXPECT_NE(std::find(documents.begin(), documents.end(), head.document), documents.end()) << head.id;
      EXPECT_EQ(head.printed.has_value(), head.document != "subdivlab") << head.id;
    }
  }
}

TEST(Head, NamesAMissingClaim) {
  EXPECT_EQ(head(letters_heads(), "letters.b").id, "letters.b");
  EXPECT_THROW((void)head(letters_heads(), "letters.c"), std::logic_error);
}

}  // namespace
}  // namespace subdiv
