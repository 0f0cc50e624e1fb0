#include "experiments/ringing.h"

#include <map>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_ringing();
  return once;
}

const Claim& found(const std::string& id) { return test::find_claim(results().claims, id); }

TEST(RingingExperiment, FootprintIsThePrintedOne) {  // js-report 12: five points; f23 and b3 reach four
  EXPECT_EQ(found("ringing.footprint").verdict, Verdict::reproduced);
  EXPECT_EQ(found("ringing.footprint").lower, Rational(5));
  EXPECT_EQ(found("ringing.footprint.moving").lower, Rational(4));
}

TEST(RingingExperiment, TheCurveIsThatOfRefinement) {
  for (const char* id : {"ringing.same-curve", "ringing.minimum-input", "ringing.appendix"})
    EXPECT_EQ(found(id).verdict, Verdict::reproduced) << id;
  EXPECT_EQ(found("ringing.once").verdict, Verdict::established);
}

TEST(RingingExperiment, AClosedLoopComputesItsFirstRingTwice) {
  // Filling the rings loads 5 points a level; n 2^k moves follow, one fewer at the last level.
  EXPECT_EQ(found("ringing.no-redundancy").verdict, Verdict::refuted);
  EXPECT_EQ(found("ringing.repeated.inner").lower, Rational(5));
  EXPECT_EQ(found("ringing.repeated.last").lower, Rational(4));
}

TEST(RingingExperiment, FaultsOfThePrintedCodeAndCaptions) {
  const std::map<std::string, std::string> mended{
      {"ringing.appendix.reset", "d=rec before the loop"},
      {"ringing.appendix.stepper-comment", "is rec minus the number"},
      {"ringing.appendix.stepper-text", "always that of the last ring"},
      {"ringing.appendix.f23-comment", "edge 3"},
      {"ringing.appendix.b3-comment", "vertex 4"},
      {"ringing.figure-14", "advance r2"}};
  for (const auto& [id, note] : mended) {
    EXPECT_EQ(found(id).verdict, Verdict::refuted) << id;
    EXPECT_NE(found(id).note.find(note), std::string::npos) << found(id).note;
  }
  EXPECT_EQ(found("ringing.appendix.first-point").lower, Rational(1));
  EXPECT_EQ(found("ringing.appendix.depth").lower, Rational(6)) << "ring [7] holds r0 .. r6";
}

}  // namespace
}  // namespace subdiv
