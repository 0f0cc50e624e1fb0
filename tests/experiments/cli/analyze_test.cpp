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

void expect_starts(const Json& text, const std::string& start) {
  EXPECT_EQ(text.get<std::string>().substr(0, start.size()), start);
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
  EXPECT_EQ(json["regularity"]["hoelder"]["value"], "5");
  EXPECT_EQ(json["regularity"]["hoelder"]["attained"], "yes");
  EXPECT_EQ(json["regularity"]["l2_exponent"]["lower"].get<std::string>().substr(0, 4), "5.50");
}

TEST(Analyze, HoelderExponents) {
  const Json four = analysis_of("four-point:w=1/16")["regularity"];
  EXPECT_EQ(four["hoelder"]["value"], "2");
  EXPECT_EQ(four["hoelder"]["attained"], "no") << "Dyn, Levin & Gregory 1987: f' is not Lipschitz";
  EXPECT_EQ(four["hoelder"]["rigour"], "exact");
  EXPECT_EQ(four["hoelder"]["status"], "closed");
  EXPECT_EQ(four["smp"], "0");
  EXPECT_EQ(four["single_matrix_radius"]["value"], "2");
  const Json j = analysis_of("jspline:s=0.689")["regularity"];
  EXPECT_EQ(j["continuity"], "C2");
  EXPECT_EQ(j["hoelder"]["value"], "3-log2(1311/1000)");
  expect_starts(j["hoelder"]["lower"], "2.60933231444033249");
  EXPECT_EQ(j["independent_shifts"], "yes");
}

// J_{1,7}: the symbol has the factor t(z^2)/t(z), t = (1+z+z^2)/3. Jia & Wang 1993 for the shifts; the radii
// 5/4 and 3/4 by hand.
TEST(Analyze, TellsLimitsFromTheScheme) {
  const Json json = analysis_of("jspline:a=1,b=7")["regularity"];
  EXPECT_EQ(json["independent_shifts"], "no");
  EXPECT_EQ(json["shift_factor"], "(1/3, 1/3, 1/3)");
  EXPECT_EQ(json["continuity"], "C1");
  EXPECT_EQ(json["limits"]["joint_spectral_radius"]["value"], "3/4");
  EXPECT_EQ(json["scheme"]["continuity"], "C0");
  EXPECT_EQ(json["scheme"]["joint_spectral_radius"]["value"], "5/4");
  const ProgramRun run = run_program({"analyze", "jspline:a=1,b=7"});
  for (const char* part :
       {"limits                C1; Hoelder exponent 3-log2(3)", "scheme                C0;",
        "dependent: the symbol has a factor t(z^m)/t(z), t = (1/3, 1/3, 1/3)"}) {
    expect_contains(run.output, part);
  }
}

TEST(Analyze, ADivergentSchemeIsCalledSoWithItsGrowth) {
  // J_s converges for -6 < s < 10; rho = s - 2 for the third differences, an eighth of it for the first.
  const Json json = analysis_of("jspline:s=11");
  EXPECT_EQ(json["regularity"]["continuity"], "none");
  EXPECT_TRUE(json["regularity"]["hoelder"].is_null());
  EXPECT_EQ(json["regularity"]["limits"]["converges"], "no");
  EXPECT_EQ(json["regularity"]["limits"]["first_difference_growth"]["value"], "9/8");
  EXPECT_TRUE(json["limit_mask"].is_null());
  expect_contains(run_program({"analyze", "jspline:s=11"}).output,
                  "divergent: growth of first differences a step 9/8 = 1.125");
}

TEST(Analyze, SymbolsAreTakenWithTheirWrittenFactors) {
  const TemporaryFolder folder;
  const auto symbol = [&](const std::string& text, const Strings& options = {}) {
    const auto path = folder.path() / "symbol.json";
    std::ofstream(path) << R"({"name": "x", "arity": 2, "symbol": ")" << text << "\"}";
    Strings arguments{"analyze", path.string(), "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return Json::parse(run.output)["regularity"];
  };
  EXPECT_EQ(symbol("2*((1+z)/2)^4*(1.25-0.5*z+0.25*z^2)")["hoelder"]["value"], "5-log2(5)");
  // Daubechies & Lagarias 1992: 2 - log2(1+sqrt 3) = 0.55001568652350415..
  const Json two = symbol("((1+z)/2)^2*((1+sqrt(3))+(1-sqrt(3))*z)");
  EXPECT_EQ(two["continuity"], "C0");
  expect_starts(two["hoelder"]["lower"], "0.55001568652350415");
  // (1+z)^4 (1+z^2)/16: quartic B-splines side by side.
  const Json quartic = symbol("(1+z)^4*(1+z^2)/16");
  EXPECT_EQ(quartic["independent_shifts"], "no");
  EXPECT_EQ(quartic["limits"]["smoothing_factors"], 5);
  EXPECT_EQ(quartic["hoelder"]["value"], "4");
  const Json rounded = symbol("2*((1+z)/2)^4*(1.250-0.500*z+0.250*z^2)", {"--rounded"});
  EXPECT_EQ(rounded["assumptions"], Strings({"the coefficients add up to 2"}));
  EXPECT_EQ(rounded["continuity"], "C2");
}

TEST(Analyze, RoundedMasksNeedToBeCalledSo) {
  const TemporaryFolder folder;
  const auto file = [&](const std::string& coefficients) {
    const auto path = folder.path() / "rounded.json";
    std::ofstream(path) << R"({"name": "x", "arity": 2, "mask": {"first": 0, "coefficients": [)"
                        << coefficients << "]}}";
    return path.string();
  };
  // Daubechies, Ten Lectures on Wavelets, table 6.1, order 4; its exponent 1.6179 in Daubechies & Lagarias
  // 1992.
  const std::string four = file(
      R"json("0.230377813309*sqrt(2)", "0.714846570553*sqrt(2)", "0.630880767930*sqrt(2)", "-0.027983769417*sqrt(2)",
             "-0.187034811719*sqrt(2)", "0.030841381836*sqrt(2)", "0.032883011667*sqrt(2)",
             "-0.010597401785*sqrt(2)")json");
  expect_rejected(run_program({"analyze", four}),
                  {"rounding of the written decimals", "--rounded", "about 1.280e-12"});
  const ProgramRun run = run_program({"analyze", four, "--rounded", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["sum_rules"], 4);
  EXPECT_EQ(json["regularity"]["assumptions"].size(), 4U);
  EXPECT_EQ(json["regularity"]["continuity"], "C1");
  expect_starts(json["regularity"]["hoelder"]["lower"], "1.6179263111");
  expect_starts(json["regularity"]["hoelder"]["upper"], "1.6179263111");
  // The sum and the first sum rule hold by luck, the second does not.
  const std::string lucky = file("0.25, 0.750001, 0.75, 0.249999");
  const Json remark = analysis_of(lucky);
  EXPECT_EQ(remark["regularity"]["continuity"], "C0");
  expect_contains(remark["remark"], "sum rule 2 is missed by 0.00000200");
  const std::string unlucky = file("0.250001, 0.75, 0.75, 0.249999");
  expect_rejected(run_program({"analyze", unlucky}),
                  {"index = 0 mod 2 add up to 1000001/1000000 instead of 1", "--rounded"});
  expect_rejected(run_program({"analyze", file("0.5, 0.8, 0.7, 0.05"), "--rounded"}),
                  {"the first sum rule fails by more than"});
}

TEST(Analyze, BudgetsAndFlagsAreChecked) {
  for (const char* budget : {"0", "-1", "nan", "inf", "soon"}) {
    expect_rejected(run_program({"analyze", "jspline:s=1", "--budget", budget}), {"--budget"});
  }
  const TemporaryFolder folder;
  const auto path = folder.path() / "free.json";
  std::ofstream(path) << R"({"name": "x", "arity": 2, "parameters": {"w": "0"},
    "mask": {"first": 0, "coefficients": ["0.50", "w", "0.50", "1-w"]}})";
  expect_rejected(run_program({"analyze", path.string() + ":w=w", "--rounded"}),
                  {"rounded coefficients need values", "w"});
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
  const Json json = analysis_of("bspline:degree=45");
  EXPECT_EQ(json["sum_rules"], 46);
  EXPECT_FALSE(json["limit_mask"].is_null());
  EXPECT_TRUE(json["eigenvalues"].is_null());
  EXPECT_EQ(json["regularity"]["continuity"], "C44");
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

TEST(Analyze, WhatThePowersLeaveOpenThePolytopesDecide) {
  const Json json = analysis_of("jspline:s=-199/100");
  EXPECT_EQ(json["regularity"]["continuity"], "C1");
  EXPECT_EQ(json["regularity"]["certified"][0]["continuity"], "C0");
  EXPECT_EQ(json["regularity"]["necessary"][0]["continuity"], "C1");
}

}  // namespace
}  // namespace subdiv
