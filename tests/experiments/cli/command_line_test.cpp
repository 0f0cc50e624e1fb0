#include <array>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

constexpr std::array verbs{"reproduce", "check", "analyze", "optimize", "list"};

TEST(CommandLine, HelpShowsAnExampleForEveryVerb) {
  const ProgramRun help = run_program({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const std::string verb : verbs) {
    expect_contains(help.output, verb);
    const ProgramRun verb_help = run_program({verb, "--help"});
    EXPECT_EQ(verb_help.exit_code, 0);
    expect_contains(verb_help.output, "subdivlab " + verb);
    expect_contains(verb_help.output, "Example");
    EXPECT_EQ(verb_help.errors, "");
  }
}

TEST(CommandLine, Version) {
  const ProgramRun version = run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.output.starts_with("subdivlab ")) << version.output;
}

TEST(CommandLine, UsageErrorsEndWith2AndPointToTheHelp) {
  expect_rejected(run_program({}), {"no verb is given", "--help"});
  expect_rejected(run_program({"analyse"}), {"no verb 'analyse'", "did you mean 'analyze'?"});
  expect_rejected(run_program({"analyze"}), {"SCHEME is required"});
  expect_rejected(run_program({"analyze", "jspline:s=1", "--jason"}), {"--jason"});
  expect_rejected(run_program({"reproduce", "--jobs", "0"}), {"--jobs"});
  expect_rejected(run_program({"reproduce", "--jobs", "many"}), {"--jobs"});
  expect_rejected(run_program({"list", "schema"}), {"schema", "schemes"});
  expect_rejected(run_program({"optimize", "jspline:s=s"}), {"required"});
}

TEST(List, NamesEverythingThatCanBeAskedFor) {
  const ProgramRun all = run_program({"list"});
  EXPECT_EQ(all.exit_code, 0);
  for (const char* name :
       {"jspline", "lane-riesenfeld", "deslauriers-dubuc", "family.even-degree", "fit-bspline", "popping"}) {
    expect_contains(all.output, name);
  }
  const ProgramRun claims = run_program({"list", "claims", "--json"});
  const auto json = nlohmann::json::parse(claims.output);
  EXPECT_FALSE(json.contains("schemes"));
  EXPECT_GE(json["claims"].size(), 19U);
  EXPECT_EQ(json["claims"][0]["id"], "family.members.four-point");
  EXPECT_EQ(nlohmann::json::parse(run_program({"list", "--json"}).output).size(), 4U);
}

}  // namespace
}  // namespace subdiv
