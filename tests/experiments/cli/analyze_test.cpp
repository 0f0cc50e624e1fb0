#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

Json analysis_of(const std::string& scheme, int exit_code = 0) {
  const ProgramRun run = run_program({"analyze", scheme, "--json"});
  EXPECT_EQ(run.exit_code, exit_code) << scheme << ": " << run.errors;
  return Json::parse(run.output);
}

TEST(Analyze, TheQuinticBSpline) {
  const Json json = analysis_of("jspline:s=3/2");
  EXPECT_EQ(json["scheme"]["arity"], 2);
  EXPECT_EQ(json["scheme"]["parameters"]["s"], "3/2");
  EXPECT_EQ(json["scheme"]["mask"]["first"], -3);
  EXPECT_EQ(json["scheme"]["mask"]["coefficients"],
            Strings({"1/32", "3/16", "15/32", "5/8", "15/32", "3/16", "1/32"}));
  EXPECT_EQ(json["support"], Strings({"-3", "3"}));
  EXPECT_EQ(json["sum_rules"], 6);
  EXPECT_EQ(json["reproduction_degree"], 1);
  // Printed in js-report 5 and jsplines 6.
  EXPECT_EQ(json["limit_mask"]["coefficients"], Strings({"1/120", "13/60", "11/20", "13/60", "1/120"}));
  EXPECT_EQ(json["tangent_mask"]["coefficients"], Strings({"-1/24", "-5/12", "0", "5/12", "1/24"}));
  EXPECT_EQ(json["area_mask"]["first"], -5);
  EXPECT_EQ(json["eigenvalues"][5], Json({{"value", "1/32"}, {"multiplicity", 2}}));
  EXPECT_EQ(json["regularity"]["continuity"], "C4");
  EXPECT_EQ(json["regularity"]["status"], "closed");
}

TEST(Analyze, TheWholeFamilyOverQOfS) {
  const Json json = analysis_of("jspline:s=s");
  EXPECT_EQ(json["scheme"]["free_parameters"], Strings({"s"}));
  EXPECT_EQ(json["limit_mask"]["coefficients"][0], "s*(s - 1)/(12*(s + 6))");
  EXPECT_EQ(json["eigenvalues"][4]["value"], "-(s - 2)/8");
  const Json& necessary = json["regularity"]["necessary"];
  ASSERT_EQ(necessary.size(), 5U);
  EXPECT_EQ(necessary[1], Json({{"continuity", "C1"}, {"set", "(-2, 6)"}}));
  EXPECT_EQ(necessary[2]["set"], "(0, 4)");
  EXPECT_EQ(necessary[3]["set"], "(1, 3)");
  EXPECT_EQ(necessary[4]["set"], "{3/2}");
}

TEST(Analyze, AMixedSchemeIsAListOfSteps) {
  const Json json = analysis_of("jspline:a=-7/4,b=59/52+jspline:s=3/2");
  EXPECT_FALSE(json["scheme"].contains("mask"));
  ASSERT_EQ(json["scheme"]["steps"].size(), 2U);
  EXPECT_EQ(json["scheme"]["steps"][0]["parameters"]["b"], "59/52");
  EXPECT_EQ(json["limit_mask"], Json({{"first", 0}, {"coefficients", Strings({"1"})}})) << "it interpolates";
}

TEST(Analyze, DualTernaryAndIrrationalSchemes) {
  const Json dual = analysis_of("bspline:degree=2");
  EXPECT_EQ(dual["parametric_shift"], "1/2");
  EXPECT_EQ(dual["limit_mask"]["coefficients"], Strings({"1/2", "1/2"}));
  const Json irrational = analysis_of("jspline:s=sqrt(2)");
  EXPECT_EQ(irrational["eigenvalues"][4]["value"], "(2-sqrt(2))/8");
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "hat.json")
      << R"({"name": "ternary hat", "arity": 3, "mask": {"first": -2, "coefficients": ["1/3", "2/3", "1", "2/3", "1/3"]}})";
  const Json ternary = analysis_of((folder.path() / "hat.json").string());
  EXPECT_EQ(ternary["scheme"]["arity"], 3);
  EXPECT_EQ(ternary["support"], Strings({"-1", "1"}));
  EXPECT_EQ(ternary["regularity"]["continuity"], "C0");
  EXPECT_TRUE(ternary["tangent_mask"].is_null());
  EXPECT_TRUE(ternary["reasons"].contains("tangent_mask"));
}

// Hassan, Ivrissimitzis, Dodgson & Sabin 2002: C2 for 1/15 < mu < 1/9.
TEST(Analyze, TheRangeOfATernarySchemeWithAParameter) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "ternary.json") << R"({"name": "ternary four-point", "arity": 3,
    "parameters": {"mu": "1/11"},
    "mask": {"first": -5, "coefficients": ["-1/18+mu/6", "-1/18-mu/6", "0", "7/18-mu/2", "13/18+mu/2", "1",
                                           "13/18+mu/2", "7/18-mu/2", "0", "-1/18-mu/6", "-1/18+mu/6"]}})";
  const Json json = analysis_of((folder.path() / "ternary.json:mu=mu").string());
  const Json& certified = json["regularity"]["certified"];
  ASSERT_EQ(certified.size(), 3U);
  EXPECT_EQ(certified[2]["continuity"], "C2");
  EXPECT_EQ(certified[2]["interval"]["lower"], "0.0666666666666666667");
  EXPECT_EQ(certified[2]["interval"]["upper"], "0.111111111111111111");
  EXPECT_EQ(json["regularity"]["necessary"][2]["set"], "(1/15, 1/3)");
}

TEST(Analyze, ForPeopleItSaysTheSame) {
  const ProgramRun run = run_program({"analyze", "four-point:w=1/16"});
  EXPECT_EQ(run.exit_code, 0);
  for (const char* part : {"reproduction degree   3", "limit mask            from index 0: (1)",
                           "tangent mask          from index -2: (1/12, -2/3, 0, 2/3, -1/12)",
                           "C1: power 2 of the difference scheme has norm 3/4", "at most C1"}) {
    expect_contains(run.output, part);
  }
}

TEST(Analyze, LongMasksGetTheCheapAnswers) {
  const Json json = analysis_of("bspline:degree=45", 3);
  EXPECT_EQ(json["sum_rules"], 46);
  EXPECT_FALSE(json["limit_mask"].is_null());
  EXPECT_TRUE(json["eigenvalues"].is_null());
  EXPECT_EQ(json["regularity"]["status"], "undecided");
  expect_contains(json["reasons"]["area_mask"].get<std::string>(), "47 coefficients");
}

TEST(Analyze, BadSchemesEndWith2AndSayWhereAndWhat) {
  const auto rejected = [](const std::string& scheme, const Strings& parts) {
    expect_rejected(run_program({"analyze", scheme}), parts);
  };
  rejected("jspln:s=1", {"unknown scheme 'jspln'", "jspline"});
  rejected("jspline:t=1", {"no parameter 't'", "jspline takes s, or a and b"});
  rejected("jspline:s=", {"s"});
  rejected("jspline:s=1/0", {"division by zero"});
  rejected("jspline:s=-6", {"jspline:s=-6", "division by zero", "choose other values"});
  rejected("nowhere.json", {"nowhere.json", "no such file"});
}

TEST(Analyze, BadSchemeFilesEndWith2AndNameTheLine) {
  const TemporaryFolder folder;
  const auto rejected = [&](const std::string& text, const Strings& parts) {
    const auto path = folder.path() / "scheme.json";
    std::ofstream(path) << text;
    expect_rejected(run_program({"analyze", path.string()}), parts);
  };
  const std::string good = R"({"name": "cubic", "arity": 2,
  "mask": {"first": -2, "coefficients": ["1/8", "1/2", "3/4", "1/2", "1/8"]}})";
  rejected(good.substr(0, good.size() - 10), {"scheme.json:2"});
  rejected(R"({"name": "x", "arity": 2, "mask": {"first": 0, "coefficients": ["1/2", "1"]}})",
           {"arity 2", "1.5"});
  rejected(R"({"name": "x", "arity": 2, "mask": {"first": 0, "coefficients": ["3/2", "1/2"]}})",
           {"not affinely invariant", "add up to 3/2 instead of 1"});
  rejected("[]", {"scheme.json"});
  std::string huge;
  huge.resize(10'000'000, ' ');
  rejected(huge, {"scheme.json", "larger than 1 MB"});
}

TEST(Analyze, WhatThePowersLeaveOpenEndsWith3) {
  const Json json = analysis_of("jspline:s=-199/100", 3);
  EXPECT_EQ(json["regularity"]["status"], "undecided");
  EXPECT_EQ(json["regularity"]["certified"][0]["continuity"], "C0");
  EXPECT_EQ(json["regularity"]["necessary"][0]["continuity"], "C1");
}

}  // namespace
}  // namespace subdiv
