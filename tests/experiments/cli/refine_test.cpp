#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "experiments/polygon_file.h"
#include "schemes/algebra/rational.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"
#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Strings = std::vector<std::string>;
using Names = std::set<std::string>;

class Refine : public ::testing::Test {
 protected:
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  ProgramRun run(Strings arguments, const std::string& prefix = "") const {
    arguments.insert(arguments.begin(), "refine");
    return run_program(arguments, folder_.path(), prefix);
  }
  void done(const Strings& arguments) const {
    const ProgramRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
  }
  void rejects(const Strings& arguments, const Strings& parts) const {
    const Names before = folder_.files();
    expect_rejected(run(arguments), parts);
    EXPECT_EQ(folder_.files(), before) << "nothing half-written";
  }
  [[nodiscard]] PointList<double> points(const std::string& name) const {
    return read_points<double>(folder_.path() / name);
  }
  [[nodiscard]] std::string text(const std::string& name) const { return text_of(folder_.path() / name); }
  [[nodiscard]] Names files() const { return folder_.files(); }

 private:
  TemporaryFolder folder_;
};

const std::string square = "x,y\n0,0\n4,0\n4,4\n0,4\n";

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-14) << i;
}

TEST_F(Refine, ClosedCurveToCsv) {
  file("square.csv", square);
  done({"jspline:s=1/2", "square.csv", "--levels", "3", "-o", "curve.csv"});
  EXPECT_EQ(text("curve.csv").substr(0, 4), "x,y\n");
  std::vector<double> x;
  const auto controls = closed_polygon(std::vector<Rational>{0, 4, 4, 0});
  Ringing<Rational, Rational> rings(stationary("J", jspline(Rational(1, 2))), controls, 3);
  for (const Rational& p : rings) x.push_back(p.to_double());
  expect_near(points("curve.csv").coordinates[0], x);
}

TEST_F(Refine, ObjRoundTrip) {
  file("square.csv", square);
  done({"jspline:s=3/2", "square.csv", "-k", "4", "-o", "curve.obj"});
  const PointList<double> curve = points("curve.obj");
  EXPECT_EQ(curve.size(), 64U);
  EXPECT_EQ(curve.closed, true);
  done({"jspline:s=3/2", "curve.obj", "-k", "0", "-o", "again.obj"});
  EXPECT_EQ(text("again.obj"), text("curve.obj"));
}

TEST_F(Refine, StandardOutputIsCsv) {
  file("square.csv", square);
  const ProgramRun result = run({"jspline:a=0,b=1", "square.csv", "-k", "1", "-o", "-"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "x,y\n0,0\n2,0\n4,0\n4,2\n4,4\n2,4\n0,4\n0,2\n");
}

TEST_F(Refine, SvgShowsTheCurve) {
  file("square.csv", square);
  done({"jspline:s=1", "square.csv", "-k", "5", "-o", "curve.svg"});
  const std::string svg = text("curve.svg");
  expect_contains(svg, "<svg xmlns=");
  expect_contains(svg, " Z\"/>");
}

TEST_F(Refine, OpenCurvesRunFromEndToEnd) {  // js-report 11
  file("path.csv", "0,0\n1,3\n4,3\n6,0\n");
  for (const char* s : {"0", "1/2", "1", "3/2"}) {
    done({std::string("jspline:s=") + s, "path.csv", "-k", "12", "--open", "clamped", "--limit", "-o",
          "curve.csv"});
    const PointList<double> curve = points("curve.csv");
    ASSERT_EQ(curve.size(), 3U * 4096 + 1);
    EXPECT_NEAR(curve.coordinates[0].front(), 0, 1e-13);
    EXPECT_NEAR(curve.coordinates[1].front(), 0, 1e-13);
    EXPECT_NEAR(curve.coordinates[0].back(), 6, 1e-13);
    const double slope = curve.coordinates[1][1] / curve.coordinates[0][1];
    EXPECT_NEAR(slope, 3, 0.02) << "along P_1 - P_0";
  }
  rejects({"jspline:s=1", "path.csv", "-k", "1", "--open", "pinned", "-o", "x.csv"}, {"--open", "clamped"});
  rejects({"bspline:degree=2", "path.csv", "-k", "1", "--open", "reflected", "-o", "x.csv"}, {"symmetric"});
  file("short.csv", "0,0\n1,3\n");
  rejects({"jspline:s=3/2", "short.csv", "-k", "1", "--open", "clamped", "-o", "x.csv"}, {"at least 3", "2"});
}

TEST_F(Refine, LineElementsSayWhetherTheCurveIsClosed) {
  file("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  file("closed.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3 1\n");
  rejects({"jspline:s=1", "open.obj", "-k", "1", "-o", "x.csv"}, {"--open clamped", "reflected"});
  rejects({"jspline:s=1", "closed.obj", "-k", "1", "--open", "clamped", "-o", "x.csv"}, {"--open", "closed"});
  done({"jspline:s=1", "closed.obj", "-k", "1", "-o", "x.csv"});
}

TEST_F(Refine, LimitPointsOfTheCubic) {  // (P_{i-1} + 4 P_i + P_{i+1}) / 6
  file("square.csv", square);
  done({"jspline:s=1", "square.csv", "-k", "0", "--limit", "-o", "limit.csv"});
  expect_near(points("limit.csv").coordinates[0], {4.0 / 6, 20.0 / 6, 20.0 / 6, 4.0 / 6});
  rejects({"jspline:s=-6", "square.csv", "-k", "2", "--limit", "-o", "x.csv"}, {"--limit", "eigenvalue"});
}

TEST_F(Refine, RetrofittedCurvesPassThroughThePoints) {
  file("square.csv", square);
  for (const char* how : {"direct", "iteration"}) {
    done({"jspline:s=3/2", "square.csv", "-k", "0", "--retrofit", how, "--limit", "-o", "limit.csv"});
    const PointList<double> limit = points("limit.csv");
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(limit.coordinates[0][i], i == 1 || i == 2 ? 4 : 0, 1e-8);
  }
  rejects({"jspline:s=3", "square.csv", "-k", "1", "--retrofit", "iteration", "-o", "x.csv"},
          {"--retrofit iteration", "1.111", "directly"});
  rejects(
      {"jspline:s=3/2", "square.csv", "-k", "1", "--open", "clamped", "--retrofit", "direct", "-o", "x.csv"},
      {"--retrofit", "closed"});
}

TEST_F(Refine, RetrofittingFollowsTheExtent) {
  for (const char* side : {"1e-10", "1e8"}) {
    const double length = std::stod(side);
    file("square.csv", std::string("0,0\n") + side + ",0\n" + side + "," + side + "\n0," + side + "\n");
    done({"jspline:s=3/2", "square.csv", "-k", "0", "--retrofit", "iteration", "--limit", "-o", "limit.csv"});
    EXPECT_NEAR(points("limit.csv").coordinates[0][1] / length, 1, 1e-10) << side;
  }
}

TEST_F(Refine, DetailsMovePointsAtTheirLevels) {
  file("square.csv", square);
  file("details.csv", "level,index,dx,dy\n0,1,4,0\n1,3,0,1\n");
  done({"jspline:a=0,b=1", "square.csv", "-k", "2", "--details", "details.csv", "-o", "curve.csv"});
  const PointList<double> curve = points("curve.csv");
  EXPECT_EQ(curve.coordinates[0][4], 8);
  EXPECT_EQ(curve.coordinates[1][6], 3);
  // The steps behind the last detail are those of the scheme: {J_{0,1}, B_0}, the second doubles points.
  file("first.csv", "1,0,1,0\n");
  done({"jspline:a=0,b=1+bspline:degree=0", "square.csv", "-k", "2", "--details", "first.csv", "-o",
        "curve.csv"});
  EXPECT_EQ(points("curve.csv").coordinates[0],
            (std::vector<double>{1, 1, 2, 2, 4, 4, 4, 4, 4, 4, 2, 2, 0, 0, 0, 0}));
  file("bad.csv", "3,1,4,0\n");
  rejects({"jspline:s=1", "square.csv", "-k", "2", "--details", "bad.csv", "-o", "x.csv"},
          {"level 3", "--levels"});
  file("bad.csv", "1,8,4,0\n");
  rejects({"jspline:s=1", "square.csv", "-k", "2", "--details", "bad.csv", "-o", "x.csv"},
          {"bad.csv", "8 points"});
  file("bad.csv", "25,1,4,4\n");
  rejects({"jspline:s=1", "square.csv", "-k", "26", "--details", "bad.csv", "-o", "x.csv"},
          {"bad.csv", "level 25"});
  file("bad.csv", "1,1,4\n");
  rejects({"jspline:s=1", "square.csv", "-k", "2", "--details", "bad.csv", "-o", "x.csv"},
          {"bad.csv", "expected 4"});
}

/// Every edge of the quads of an OBJ file, as often as it occurs.
std::map<std::pair<int, int>, int> edges_of(const std::string& obj, int& vertices, int& quads) {
  std::map<std::pair<int, int>, int> edges;
  std::istringstream lines(obj);
  vertices = quads = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("v ")) ++vertices;
    if (!line.starts_with("f ")) continue;
    ++quads;
    std::istringstream words(line.substr(2));
    std::array<int, 4> corner{};
    for (int& c : corner) words >> c;
    for (std::size_t i = 0; i < 4; ++i) {
      const int a = corner[i];
      const int b = corner[(i + 1) % 4];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  return edges;
}

std::string grid_text(int rows, int columns) {
  std::string text;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j)
      text += std::to_string(i) + "," + std::to_string(j) + "," + std::to_string((i * 7 + j * 3) % 5) + "\n";
  }
  return text;
}

TEST_F(Refine, GridsAreWatertight) {
  file("grid.csv", grid_text(3, 3));
  const auto count = [&](const Strings& more, int expected_vertices, int expected_quads, int open_edges) {
    Strings arguments{"jspline:s=3/2", "grid.csv", "--grid", "3x3", "-k", "2", "-o", "surface.obj"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    done(arguments);
    int vertices = 0;
    int quads = 0;
    int once = 0;
    for (const auto& [edge, times] : edges_of(text("surface.obj"), vertices, quads)) {
      EXPECT_LE(times, 2);
      once += times == 1 ? 1 : 0;
    }
    EXPECT_EQ(vertices, expected_vertices);
    EXPECT_EQ(quads, expected_quads);
    EXPECT_EQ(once, open_edges);
  };
  count({}, 144, 144, 0);  // a torus
  count({"--open", "clamped"}, 12 * 9, 12 * 8, 2 * 12);
  count({"--open-across", "reflected"}, 12 * 9, 12 * 8, 2 * 12);
  count({"--open", "clamped", "--open-across", "clamped"}, 81, 64, 4 * 8);
}

TEST_F(Refine, FilesMaySayThemselvesThatTheyHoldAGrid) {
  file("grid.csv", grid_text(3, 4));
  std::string named = "row,column,x,y,z\n";
  std::istringstream lines(grid_text(3, 4));
  int i = 0;
  for (std::string line; std::getline(lines, line); ++i)
    named += std::to_string(i / 4) + "," + std::to_string(i % 4) + "," + line + "\n";
  file("named.csv", named);
  done({"jspline:s=1", "grid.csv", "--grid", "3x4", "-k", "2", "-o", "one.obj"});
  done({"jspline:s=1", "named.csv", "-k", "2", "-o", "two.obj"});
  EXPECT_EQ(text("one.obj"), text("two.obj"));
  rejects({"jspline:s=1", "named.csv", "--grid", "4x3", "-k", "2", "-o", "x.obj"}, {"--grid 4x3", "3x4"});
  file("named.csv", named + "3,0,1,1,1\n");
  rejects({"jspline:s=1", "named.csv", "-k", "2", "-o", "x.obj"}, {"last row"});
  file("named.csv", named + "3,1,1,1,1\n");
  rejects({"jspline:s=1", "named.csv", "-k", "2", "-o", "x.obj"}, {"point 13", "next one"});
  file("named.csv", "row,column,x,y,z\n1,0,1,1,1\n");
  rejects({"jspline:s=1", "named.csv", "-k", "2", "-o", "x.obj"}, {"point 1 ", "next one"});
}

TEST_F(Refine, BadGridsAreRefused) {
  file("grid.csv", grid_text(3, 4));
  const auto with = [](const Strings& more) {
    Strings arguments{"jspline:s=1", "grid.csv", "-k", "1", "-o", "x.obj"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  rejects(with({"--grid", "3x5"}), {"--grid 3x5", "12 points"});
  rejects(with({"--grid", "3by4"}), {"--grid", "ROWSxCOLUMNS"});
  rejects(with({"--grid", "0x4"}), {"--grid", "ROWSxCOLUMNS"});
  rejects(with({"--grid", "3x4", "--limit"}), {"--limit", "curves"});
  rejects(with({"--open-across", "clamped"}), {"--open-across", "--grid"});
  rejects({"jspline:s=1", "grid.csv", "--grid", "3x4", "-k", "1", "-o", "x.svg"}, {"x.svg", ".obj"});
}

TEST_F(Refine, TooManyPointsAreRefusedWithTheirNumber) {
  file("triangle.csv", "0,0\n1,0\n0,1\n");
  rejects({"jspline:s=1", "triangle.csv", "-k", "29", "-o", "x.csv"},
          {"--levels 29", "1610612736", "--levels 28", "805306368"});
  rejects({"jspline:s=1", "triangle.csv", "-k", "62", "-o", "x.csv"}, {"13835058055282163712"});
  rejects({"jspline:s=1", "triangle.csv", "-k", "63", "-o", "x.csv"}, {"--levels"});
  rejects({"jspline:s=1", "triangle.csv", "-k", "-1", "-o", "x.csv"}, {"--levels"});
}

TEST_F(Refine, DeepCurvesStreamInLittleMemory) {  // 3 points at depth 20: 3 M points, 100 MB of text
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer reserves terabytes of addresses";
#endif
  file("triangle.csv", "0,0\n1,0\n0,1\n");
  const ProgramRun result =
      run({"jspline:s=1", "triangle.csv", "-k", "20", "-o", "/dev/null"}, "ulimit -v 400000;");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
}

TEST_F(Refine, OnePointAndRepeatedPoints) {
  file("one.csv", "3,5\n");
  done({"jspline:s=1", "one.csv", "-k", "3", "-o", "curve.csv"});
  expect_near(points("curve.csv").coordinates[1], std::vector<double>(8, 5.0));
  file("same.csv", "1,2\n1,2\n1,2\n1,2\n");
  done({"jspline:s=3/2", "same.csv", "-k", "2", "-o", "curve.svg"});
  done({"jspline:s=3/2", "same.csv", "-k", "2", "-o", "curve.csv"});
  expect_near(points("curve.csv").coordinates[0], std::vector<double>(16, 1.0));
}

TEST_F(Refine, WhatIsWrongIsNamed) {
  file("square.csv", square);
  file("line.csv", "1\n2\n3\n");
  file("huge.csv", "1e308,0\n-1e308,1e308\n1e308,-1e308\n");
  rejects({"jspline:s=s", "square.csv", "-k", "1", "-o", "x.csv"}, {"'jspline:s=s'", "s has no value"});
  rejects({"jspline:s=1", "square.csv", "-k", "1", "-o", "x.png"}, {"x.png", ".svg"});
  rejects({"jspline:s=1", "square.csv", "-k", "1", "-o", "absent/x.csv"},
          {"absent/x.csv", "cannot be written"});
  rejects({"jspline:s=1", "absent.csv", "-k", "1", "-o", "x.csv"}, {"absent.csv", "cannot be read"});
  rejects({"jspline:s=1", "line.csv", "-k", "1", "-o", "x.svg"}, {"1 coordinates", "at least two"});
  rejects({"jspline:s=-30", "huge.csv", "-k", "3", "-o", "x.csv"}, {"range of doubles"});
  rejects({"jspline:s=1", "square.csv", "-o", "x.csv"}, {"--levels"});
  EXPECT_EQ(files(), (Names{"square.csv", "line.csv", "huge.csv"}));
}

TEST_F(Refine, AnOldFileSurvivesAFailure) {
  file("huge.csv", "1e308,0\n-1e308,1e308\n1e308,-1e308\n");
  file("curve.csv", "old");
  rejects({"jspline:s=-30", "huge.csv", "-k", "3", "-o", "curve.csv"}, {"range of doubles"});
  EXPECT_EQ(text("curve.csv"), "old");
}

TEST_F(Refine, MasksWithRootsAndMixedSchemes) {
  file("square.csv", square);
  done({"jspline:s=sqrt(2)+jspline:s=3/2", "square.csv", "-k", "3", "-o", "curve.csv"});
  EXPECT_EQ(points("curve.csv").size(), 32U);
  done({"jspline:a=-7/4,b=59/52+jspline:s=3/2", "square.csv", "-k", "6", "--limit", "-o", "curve.csv"});
  const PointList<double> curve = points("curve.csv");
  for (std::size_t i = 0; i < 4; ++i)  // js-report 6: through the control points
    EXPECT_NEAR(curve.coordinates[0][64 * i], i == 1 || i == 2 ? 4 : 0, 1e-13);
}

}  // namespace
}  // namespace subdiv
