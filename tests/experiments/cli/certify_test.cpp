#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

ProgramRun certify(const std::string& scheme, const std::string& over, const std::string& continuity,
                   const Strings& more = {"--json"}) {
  Strings arguments{"certify", scheme, "--over", over, "--continuity", continuity};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

TEST(Certify, TheWholeRangeOfJSplines) {
  const ProgramRun run = certify("jspline:s=s", "s=-2..6", "1");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["status"], "mixed");
  EXPECT_EQ(json["over"][0], Json({{"parameter", "s"}, {"lower", "-2"}, {"upper", "6"}}));
  ASSERT_EQ(json["cells"].size(), 3U);
  EXPECT_EQ(json["cells"][0]["upper"][0], "-2");
  EXPECT_EQ(json["cells"][0]["status"], "refuted");
  EXPECT_EQ(json["cells"][1]["status"], "proved");
  EXPECT_EQ(json["cells"][1]["lower"][0], "-2");
  EXPECT_EQ(json["cells"][1]["lower_closed"][0], false);
  EXPECT_EQ(json["cells"][1]["upper"][0], "6");
  EXPECT_EQ(json["undecided_volume"], "0");
}

TEST(Certify, EndsAreAlgebraicNumbers) {
  const ProgramRun run = certify("four-point:w=w", "w=1/16..1/4", "1", {"--json", "--budget", "60"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  ASSERT_EQ(json["ends"].size(), 1U);
  expect_contains(json["ends"][0]["exact"], "32*x^3 + 4*x - 1");
  EXPECT_EQ(json["ends"][0]["lower"].get<std::string>().substr(0, 14), "0.192729249264");
  EXPECT_EQ(json["ends"][0]["below"], "proved");
  EXPECT_EQ(json["ends"][0]["above"], "refuted");
}

TEST(Certify, ForPeopleItSaysTheSame) {
  const ProgramRun run = certify("jspline:s=3/2+jspline:s=s", "s=-3..7", "1", {});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  for (const char* part :
       {"over            s in [-3, 7]", "C^1             mixed", "s in (-2, 6)", "s in [6, 7]"}) {
    expect_contains(run.output, part);
  }
  const ProgramRun single = certify("jspline:s=s", "s=-2..-2", "1", {});
  EXPECT_EQ(single.exit_code, 0) << single.errors;
  expect_contains(single.output, "C^1             refuted");
}

TEST(Certify, LimitsCanBeSmootherThanTheScheme) {
  const ProgramRun run = certify("dyn-floater-hormann:w=w", "w=-1/20..-1/30", "2");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["status"], "refuted");
  EXPECT_EQ(json["dependent"], Json::array({{{"value", "-1/28"}, {"limits", "proved"}}}));
}

TEST(Certify, TheBudgetLeavesCellsUndecided) {
  const ProgramRun run = certify("jspline:a=a,b=b", "a=-4..7,b=-5..10", "1", {"--json", "--budget", "0.2"});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["status"], "undecided");
  EXPECT_EQ(json["cells"][0]["lower"].size(), 2U);
}

TEST(Certify, BadInputEndsWith2) {
  const auto rejected = [](const std::string& scheme, const std::string& over, const std::string& continuity,
                           const Strings& parts, const Strings& more = {}) {
    expect_rejected(certify(scheme, over, continuity, more), parts);
  };
  rejected("jspline:s=s", "t=0..1", "1", {"'s' has no range"});
  rejected("jspline:s=s", "s=0..1,t=0..1", "1", {"'t' is no free parameter"});
  rejected("jspline:s=s", "s=0..1,s=0..1", "1", {"'s' has two ranges"});
  rejected("jspline:a=a,b=b", "a=0..1", "1", {"'b' has no range"});
  rejected("jspline:s=s", "s=1..0", "1", {"--over", "not be above"});
  rejected("jspline:s=s", "s=0..nan", "1", {"--over", "'nan'"});
  rejected("jspline:s=s", "s=-inf..0", "1", {"--over", "'inf'"});
  rejected("jspline:s=s", "s=0", "1", {"--over", "LO..HI"});
  rejected("jspline:s=s", "s=1/0..2", "1", {"division by zero"});
  rejected("jspline:s=1", "s=0..1", "1", {"no free parameter"});
  rejected("jspline:s=s", "s=0..1", "-1", {"--continuity"});
  rejected("jspline:s=s", "s=0..1", "one", {"--continuity"});
  rejected("jspline:s=s", "s=0..1", "nan", {"--continuity"});
  rejected("jspline:s=s", "s=0..1", "1", {"--budget"}, {"--budget", "nan"});
  rejected("jspline:s=s", "s=0..1", "1", {"--budget"}, {"--budget", "-1"});
  rejected("jspline:s=sqrt(2)*s", "s=0..1", "1", {"sqrt(2)"});
  rejected("four-point:w=1/t", "t=-1..1", "1", {"division by zero", "pole at 0"});
  rejected("jspline:s=1/t+jspline:s=3/2", "t=-1..1", "1", {"division by zero", "pole at 0"});
  rejected("four-point:w=1/t", "t=0..0", "1", {"division by zero"});
  rejected("four-poin:w=t", "t=0..1", "1", {"four-point"});
}

TEST(Certify, MasksThatViolateTheFirstSumRule) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "unbalanced.json")
      << R"({"name": "unbalanced", "arity": 2, "parameters": {"t": "1"}, "mask": {"first": 0, "coefficients": ["t", "2-t"]}})";
  const ProgramRun run =
      run_program({"certify", "unbalanced.json:t=t", "--over", "t=0..1", "--continuity", "0"}, folder.path());
  expect_rejected(run, {"sum rule"});
}

}  // namespace
}  // namespace subdiv
