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

const std::string pentagon = "x,y\n0,0\n8,0\n9,6\n4,9\n1,5\n";

/// On the polygon of a file with this text.
ProgramRun on_polygon(const std::string& text, const Strings& arguments,
                      const std::string& name = "polygon.csv") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / name) << text;
  Strings all{"optimize"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--polygon", name});
  return run_program(all, folder.path());
}

TEST(Optimize, OnAPolygonTheAreaIsPreservedExactly) {
  const ProgramRun run =
      on_polygon(pentagon, {"jspline:s=s", "--over", "s=-1..5", "--objective", "area", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["polygon"], "polygon.csv");
  EXPECT_EQ(json["minimum"]["exact"], "0");
  ASSERT_EQ(json["zeros"].size(), 1U);
  EXPECT_EQ(json["zeros"][0]["rigour"], "exact");
  EXPECT_EQ(json["termination"], "proved");
}

TEST(Optimize, OnAPolygonLeastSquaresAreProved) {
  // A square: the limit mask (a, b, c, b, a) puts a vertex (c - 1, .., ..) away; *J_0 keeps it (jsplines 5).
  const ProgramRun run = on_polygon(
      "0,0\n1,0\n1,1\n0,1\n",
      {"jspline:s=s", "--over", "s=-1/2..3/2", "--objective", "vertex-distance", "--norm", "l2", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["minimiser"][0]["exact"], "0");
  EXPECT_EQ(json["norm"], "l2");
}

TEST(Optimize, OnAPolygonDistancesToItAreLocal) {
  const ProgramRun run = on_polygon(
      pentagon, {"jspline:s=r+jspline:s=3/2", "--over", "r=-1..1", "--objective", "polygon-distance"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  for (const char* part : {"polygon         polygon.csv", "(approximate)", "termination     local"})
    expect_contains(run.output, part);
}

TEST(Optimize, BadPolygonsEndWith2) {
  const Strings area{"jspline:s=s", "--over", "s=0..1", "--objective", "area"};
  expect_rejected(on_polygon("0,0\n1,0\n1\n", area), {"polygon.csv:3"});
  expect_rejected(on_polygon("0,0\n1,nan\n1,1\n", area), {"polygon.csv:2", "nan"});
  expect_rejected(on_polygon("", area), {"polygon.csv"});
  expect_rejected(on_polygon("0\n1\n5\n", area), {"two coordinates"});
  expect_rejected(on_polygon("v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n",
                             {"jspline:s=s", "--over", "s=0..1", "--objective", "popping"}, "open.obj"),
                  {"open.obj", "closed"});
  expect_rejected(on_polygon(pentagon, {"jspline:s=s", "--over", "s=0..1", "--objective", "vertex"}),
                  {"'vertex'", "vertex-distance"});
  expect_rejected(
      on_polygon(pentagon, {"jspline:s=s", "--over", "s=-7..1", "--objective", "vertex-distance"}),
      {"division by zero", "s=-7..1"});
  expect_rejected(
      run_program({"optimize", "jspline:s=s", "--over", "s=0..1", "--objective", "edge-distance"}),
      {"--polygon"});
  expect_rejected(run_program({"optimize", "jspline:s=s", "--over", "s=0..1", "--objective", "vertex"}),
                  {"--norm is required"});
  expect_rejected(run_program({"optimize", "jspline:s=s", "--over", "s=0..1", "--objective", "area",
                               "--polygon", "/no/such.csv"}),
                  {"/no/such.csv"});
}

}  // namespace
}  // namespace subdiv
