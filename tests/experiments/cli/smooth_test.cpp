#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

class Smooth : public ::testing::Test {
 protected:
  void SetUp() override {
    file("square.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n");
    file("path.csv", "0\n4\n2\n6\n");
  }
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const { return text_of(folder_.path() / name); }
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / name);
  }
  [[nodiscard]] std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      count += entry.exists() ? 1 : 0;
    return count;
  }
  ProgramRun run(Strings arguments) const {
    arguments.insert(arguments.begin(), "smooth");
    return run_program(arguments, folder_.path());
  }
  ProgramRun run(const std::string& input, const std::string& operators, Strings more = {}) const {
    more.insert(more.begin(), {input, "--operators", operators});
    return run(more);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Smooth, ASquareShrinksByTheFactorOfItsOnlyFrequency) {  // 1 - t about the centroid (2, 2)
  const ProgramRun result = run("square.csv", "tuck(1/2)", {"-o", "-"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, "x,y\n1,1\n3,1\n3,3\n1,3\n");
  EXPECT_EQ(result.errors, "");
}

TEST_F(Smooth, RepetitionsAndReport) {
  const ProgramRun result =
      run("square.csv", "tuck(1/2); tuck(-1/2)", {"--repeat", "2", "--json", "report.json", "-o", "out.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  expect_contains(result.output, "area      16 -> 5.0625, kept 0.31640625");  // (3/4)^4
  expect_contains(result.output, "gain      1 at frequency 0, in each repetition");
  const Json report = Json::parse(read("report.json"));
  EXPECT_EQ(report["area"]["after"], "5.0625");
  EXPECT_EQ(report["vertices"]["after"], 4);
  EXPECT_EQ(report["gain"]["exact"], "1");
  EXPECT_EQ(report["gain"]["amplifies"], "no");
  EXPECT_EQ(read("out.csv"), "x,y\n0.875,0.875\n3.125,0.875\n3.125,3.125\n0.875,3.125\n");
}

TEST_F(Smooth, WarnsOfGrowingFrequencies) {
  const ProgramRun result = run("square.csv", "tuck(2/sqrt(6)); tuck(-2/sqrt(6))", {"-o", "out.svg"});
  EXPECT_EQ(result.exit_code, 0);
  expect_contains(result.errors, "warning: the sequence amplifies");
  expect_contains(result.output, "gain      5/3 at frequency pi");  // the roots cancel
  expect_contains(read("out.svg"), "<svg");
  const ProgramRun roots = run("square.csv", "tuck(sqrt(5))", {"-o", "-"});  // 2 sqrt(5) - 1 = 3.47214
  expect_contains(roots.errors, "amplifies the frequency of its largest gain by 3.47213");
  file("point.csv", "1,2\n");
  expect_contains(run("point.csv", "untuck^9999", {"-o", "-"}).errors, "frequency pi by more than 1.7e308");
  const ProgramRun exact = run("square.csv", "untuck", {"-o", "out.obj"});
  expect_contains(exact.errors, "amplifies the frequency pi by 3;");
  expect_contains(read("out.obj"), "l 1 2 3 4 1");
}

TEST_F(Smooth, SchemesAndOpenPolygons) {
  const ProgramRun four_point = run("path.csv", "refine; tuck(1/2); untuck", {"--open", "keep", "-o", "-"});
  EXPECT_EQ(four_point.exit_code, 0) << four_point.errors;
  std::istringstream lines(four_point.output);
  Strings points;
  for (std::string line; std::getline(lines, line);) points.push_back(line);
  ASSERT_EQ(points.size(), 8U);  // a header and 2 n - 1
  EXPECT_EQ(points[1], "0");
  EXPECT_EQ(std::stod(points[4]), 3);  // (9 (4 + 2) - (0 + 6))/16
  EXPECT_EQ(points[7], "6");
  EXPECT_EQ(run("path.csv", "dual", {"--open", "drop", "-o", "-"}).output, "x\n2\n3\n4\n");
  EXPECT_EQ(run("path.csv", "tuck(1)", {"--open", "drop", "-o", "-"}).output, "x\n1\n5\n");
  expect_contains(run("path.csv", "J(4)", {"-o", "out.csv"}).output, "makes new vertices");
}

TEST_F(Smooth, BadInputEndsWith2AndWritesNothing) {
  const Strings out{"-o", "out.csv"};
  expect_rejected(run("square.csv", "tuk(1/2)", out), {"did you mean 'tuck'"});
  expect_rejected(run("square.csv", "tuck(t)", out), {"t has no value"});
  expect_rejected(run("square.csv", "tuck(1/0)", out), {"division by zero"});
  expect_rejected(run("square.csv", "tuck(1/2)", {"-o", "out.png"}), {".csv, .obj or .svg"});
  expect_rejected(run("square.csv", "tuck(1/2)", {"-o", "out.csv", "--open", "loose"}), {"--open"});
  expect_rejected(run("square.csv", "tuck(1/2)", {"-o", "out.csv", "--repeat", "0"}), {"--repeat"});
  expect_rejected(run("none.csv", "dual", out), {"none.csv"});
  file("triangle.csv", "0,0\n1,0\n0,1\n");
  expect_rejected(run("triangle.csv", "tweak(1/2,0)", out), {"3 vertices", "multiple"});
  expect_rejected(run("square.csv", "untuck", {"-o", "out.csv", "--repeat", "100000", "--json", "r.json"}),
                  {"'untuck' in repetition", "range of doubles"});
  expect_rejected(run("path.csv", "tuck(1/2)", {"-o", "out.csv", "--open", "drop", "--repeat", "2"}),
                  {"repetition 2", "no vertex is left", "--open keep"});
  expect_rejected(run("square.csv", "refine", {"-o", "out.csv", "--repeat", "60"}), {"more than 16777216"});
  expect_rejected(run("square.csv", "dual", {"-o", "-", "--json", "-"}), {"standard output"});
  expect_rejected(run("square.csv", "dual", {"-o", "out.csv", "--json", "out.csv"}),
                  {"-o out.csv", "another"});
  expect_rejected(run("square.csv", "dual", {"-o", "out.csv", "--json", "./out.csv"}), {"-o out.csv"});
  file("far.csv", "0,0\n1e308,0\n1e308,1e308\n");
  for (const std::string target : {"out.csv", "-"})
    expect_rejected(run("far.csv", "tuck(1/2)", {"-o", target}), {"far.csv: point 2", "1e150"});
  file("nan.csv", "0,0\nnan,1\n");
  expect_rejected(run("nan.csv", "dual", out), {"nan.csv"});
  file("empty.csv", "");
  expect_rejected(run("empty.csv", "dual", out), {"empty.csv"});
  expect_rejected(run({"square.csv", "-o", "out.csv"}), {"--operators"});
  EXPECT_FALSE(exists("out.csv"));
  EXPECT_EQ(files(), 6U) << "no temporary files are left";
}

}  // namespace
}  // namespace subdiv
