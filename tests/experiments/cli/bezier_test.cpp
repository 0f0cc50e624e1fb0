#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/polygon_file.h"
#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

class Bezier : public ::testing::Test {
 protected:
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  ProgramRun run(Strings arguments) const {
    arguments.insert(arguments.begin(), "bezier");
    return run_program(arguments, folder_.path());
  }
  ProgramRun done(const Strings& arguments) const {
    ProgramRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result;
  }
  void rejects(const Strings& arguments, const Strings& parts) const {
    const std::set<std::string> before = folder_.files();
    expect_rejected(run(arguments), parts);
    EXPECT_EQ(folder_.files(), before) << "nothing half-written";
  }
  [[nodiscard]] PointList<double> points(const std::string& name) const {
    return read_points<double>(folder_.path() / name);
  }
  [[nodiscard]] std::string text(const std::string& name) const { return text_of(folder_.path() / name); }

 private:
  TemporaryFolder folder_;
};

const std::string arch = "0,0\n0,8\n8,8\n8,0\n";

// Notes 1: P01 = (0,4), P12 = (4,8), P23 = (8,4), P012 = (2,6), P123 = (6,6), P0123 = (4,6).
TEST_F(Bezier, OneSplitDrawsTheControlPolygonsOfTheHalves) {
  file("arch.csv", arch);
  const ProgramRun result = done({"arch.csv", "--depth", "1", "-o", "out.csv"});
  EXPECT_EQ(text("out.csv"), "x,y\n0,0\n0,4\n2,6\n4,6\n6,6\n8,4\n8,0\n");
  expect_contains(result.output, "6 segments");
  done({"arch.csv", "--depth", "0", "-o", "same.csv"});
  EXPECT_EQ(text("same.csv"), "x,y\n0,0\n0,8\n8,8\n8,0\n");
}

TEST_F(Bezier, ATolerance) {
  file("arch.csv", arch);
  const Json report =
      Json::parse(done({"arch.csv", "--tolerance", "0.01", "-o", "out.csv", "--json"}).output);
  const PointList<double> line = points("out.csv");
  EXPECT_EQ(report["segments"].get<std::size_t>() + 1, line.size());
  EXPECT_EQ(report["curves"], 1);
  EXPECT_LE(std::stod(report["distance_at_most"].get<std::string>()), 0.01);
  // 24 t (1-t) and 8 t^2 (3-2t): every corner lies on y = 24 t (1-t) for its t; by the chord's symmetry.
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double x = line.coordinates[0][i];
    double low = 0;
    double high = 1;
    for (int k = 0; k < 60; ++k) {
      const double t = (low + high) / 2;
      (8 * t * t * (3 - 2 * t) < x ? low : high) = t;
    }
    EXPECT_NEAR(line.coordinates[1][i], 24 * low * (1 - low), 1e-6);
  }
}

TEST_F(Bezier, ConsecutiveCurvesOfAnyDegreeAndDimension) {
  file("space.csv", "x,y,z\n0,0,0\n1,2,0\n2,0,1\n3,-2,2\n4,0,3\n");
  expect_contains(done({"space.csv", "--degree", "2", "--tolerance", "0.1", "-o", "two.csv"}).output,
                  "2 Bezier curves of degree 2");
  EXPECT_EQ(points("two.csv").dimension(), 3U);
  done({"space.csv", "--degree", "4", "--tolerance", "0.1", "-o", "one.obj"});
  EXPECT_EQ(points("one.obj").closed, false);
  done({"space.csv", "--degree", "1", "--tolerance", "0.1", "-o", "lines.csv"});
  EXPECT_EQ(points("lines.csv").size(), 5U);
  file("arch.csv", arch);
  done({"arch.csv", "--tolerance", "0.1", "-o", "arch.svg"});
  expect_contains(text("arch.svg"), "<svg");
}

TEST_F(Bezier, ALineElementSaysTheOrder) {
  file("loop.obj", "v 0 0 0\nv 8 0 0\nv 8 8 0\nl 1 2 3 1\n");  // closed: the last point is the first
  done({"loop.obj", "--depth", "0", "-o", "out.csv"});
  EXPECT_EQ(text("out.csv"), "x,y,z\n0,0,0\n8,0,0\n8,8,0\n0,0,0\n");
}

TEST_F(Bezier, StandardOutputTakesThePolylineAlone) {
  file("arch.csv", arch);
  const ProgramRun result = done({"arch.csv", "--depth", "0", "-o", "-"});
  EXPECT_EQ(result.output, "x,y\n0,0\n0,8\n8,8\n8,0\n");
  expect_contains(result.errors, "3 segments");
}

TEST_F(Bezier, BadInputEndsWith2) {
  file("arch.csv", arch);
  file("five.csv", arch + "9,9\n");
  file("infinite.csv", "0,0\n1,inf\n2,2\n3,3\n");
  file("huge.csv", "0,0\n1,1e305\n2,2\n3,3\n");
  const auto with = [](Strings arguments) {
    arguments.insert(arguments.end(), {"-o", "out.csv"});
    return arguments;
  };
  rejects(with({"arch.csv"}), {"--tolerance T", "--depth K"});
  rejects(with({"arch.csv", "--tolerance", "1", "--depth", "1"}), {"in one way"});
  rejects(with({"arch.csv", "--tolerance", "0"}), {"--tolerance", "positive"});
  rejects(with({"arch.csv", "--tolerance", "nan"}), {"--tolerance", "positive"});
  rejects(with({"arch.csv", "--depth", "-1"}), {"--depth"});
  rejects(with({"arch.csv", "--depth", "1", "--degree", "0"}), {"--degree"});
  rejects(with({"arch.csv", "--depth", "40"}), {"--depth", "more than", "is the most"});
  rejects(with({"arch.csv", "--tolerance", "1e-18"}), {"--tolerance", "rounding", "can be kept"});
  rejects(with({"five.csv", "--depth", "1"}), {"five.csv", "5 control points", "4, 7, 10"});
  rejects(with({"infinite.csv", "--depth", "1"}), {"infinite.csv:2", "coordinate 2"});
  rejects(with({"huge.csv", "--depth", "1"}), {"huge.csv", "control point 2", "2^1000"});
  rejects(with({"absent.csv", "--depth", "1"}), {"absent.csv"});
  rejects({"arch.csv", "--depth", "1"}, {"--out"});
  rejects({"arch.csv", "--depth", "1", "-o", "out.stl"}, {"out.stl", ".svg"});
  rejects({"arch.csv", "--depth", "1", "-o", "-", "--json"}, {"--json", "standard output"});
}

}  // namespace
}  // namespace subdiv
