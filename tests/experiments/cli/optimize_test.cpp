#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

ProgramRun optimize(const std::string& scheme, const std::string& over, const std::string& objective,
                    const std::string& norm, bool json = true) {
  Strings arguments{"optimize", scheme, "--over", over, "--objective", objective, "--norm", norm};
  if (json) arguments.emplace_back("--json");
  return run_program(arguments);
}

TEST(Optimize, TheVertexMinimaxIsExact) {
  const ProgramRun run = optimize("jspline:s=r+jspline:s=3/2", "r=-2..2", "vertex", "linf");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["minimiser"][0]["parameter"], "r");
  EXPECT_EQ(json["minimiser"][0]["exact"], "-33/26") << "js-report 6, jsplines 6";
  EXPECT_EQ(json["minimum"]["exact"], "5/156");
  EXPECT_EQ(json["termination"], "proved");
  EXPECT_EQ(json["over"][0], Json({{"parameter", "r"}, {"lower", "-2"}, {"upper", "2"}}));
}

TEST(Optimize, SeveralParametersInAnyOrder) {
  const ProgramRun run = optimize("jspline:a=a,b=b+jspline:s=3/2", "b=0..2, a=-2..2", "vertex", "linf");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["minimiser"][0]["exact"], "-7/4") << "js-report 6, jsplines 6";
  EXPECT_EQ(json["minimiser"][1]["exact"], "59/52");
}

TEST(Optimize, ForPeopleItSaysTheSame) {
  const ProgramRun run = optimize("jspline:s=r+jspline:s=1", "r=-1..1", "edge", "l1", false);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  for (const char* part :
       {"over            r in [-1, 1]", "minimiser       r = 2/3  (exact)", "minimum         0  (exact)"}) {
    expect_contains(run.output, part);
  }
}

TEST(Optimize, BadInputEndsWith2) {
  const auto rejected = [](const std::string& scheme, const std::string& over, const std::string& objective,
                           const std::string& norm, const Strings& parts) {
    expect_rejected(optimize(scheme, over, objective, norm), parts);
  };
  rejected("jspline:s=s", "s=0..1", "vertices", "linf", {"'vertices'", "vertex"});
  rejected("jspline:s=s", "s=0..1", "vertex", "l3", {"--norm", "linf"});
  rejected("jspline:s=s", "s=0,1", "vertex", "linf", {"--over", "LO..HI"});
  rejected("jspline:s=s", "s=1..0", "vertex", "linf", {"--over", "below the upper end"});
  rejected("jspline:s=s", "t=0..1", "vertex", "linf", {"'s' has no range"});
  rejected("jspline:s=s", "s=0..1,t=0..1", "vertex", "linf", {"'t' is no free parameter", "s"});
  rejected("jspline:s=s", "s=0..1,s=0..1", "vertex", "linf", {"'s' has two ranges"});
  rejected("jspline:s=s", "s=0..x", "vertex", "linf", {"--over", "'x'"});
  rejected("jspline:s=1", "s=0..1", "vertex", "linf", {"no free parameter"});
  rejected("jspline:s=s", "s=-7..0", "vertex", "linf", {"division by zero", "s=-7..0"});
}

}  // namespace
}  // namespace subdiv
