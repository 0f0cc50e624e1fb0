#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

class Measure : public ::testing::Test {
 protected:
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  ProgramRun run(Strings arguments) const {
    arguments.insert(arguments.begin(), "measure");
    return run_program(arguments, folder_.path());
  }
  Json json(Strings arguments) const {
    arguments.emplace_back("--json");
    const ProgramRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return Json::parse(result.output);
  }

 private:
  TemporaryFolder folder_;
};

double number(const Json& text) { return std::stod(text.get<std::string>()); }

TEST_F(Measure, ASquare) {
  file("square.csv", "0,0\n4,0\n4,4\n0,4\n");
  const Json level = json({"square.csv"})["levels"][0];
  EXPECT_EQ(level["points"], 4);
  EXPECT_EQ(number(level["length"]), 16);
  EXPECT_EQ(number(level["area"]), 16);
  // A = (0,4), B = (0,0), C = (4,0), D = (4,4): -A + 3B - 3C + D = (-8, 0), along BC.
  EXPECT_EQ(number(level["normal_jerk"]["largest"]), 0);
}

TEST_F(Measure, OpenPolygonsAndSpace) {
  file("path.csv", "0,0,0\n3,4,0\n3,4,12\n");
  const Json open = json({"path.csv", "--open", "plain"});
  EXPECT_EQ(number(open["levels"][0]["length"]), 17);
  EXPECT_FALSE(open["levels"][0].contains("area"));
  const Json closed = json({"path.csv"});
  EXPECT_EQ(number(closed["levels"][0]["length"]), 30);
  EXPECT_EQ(closed["levels"][0]["vector_area"].size(), 3U);  // 1/2 (3,4,0) x (3,4,12) = (24, -18, 0)
  EXPECT_EQ(number(closed["levels"][0]["vector_area"][0]), 24);
  EXPECT_EQ(number(closed["levels"][0]["vector_area"][1]), -18);
}

TEST_F(
    Measure,
    LevelsOfAScheme) {  // J_{0,1} moves nothing; a square under *J_1 has area tending to that of its spline
  file("square.csv", "0,0\n4,0\n4,4\n0,4\n");
  const Json linear = json({"square.csv", "--scheme", "jspline:a=0,b=1", "--levels", "2"});
  for (const std::size_t k : {1U, 2U}) {
    EXPECT_EQ(number(linear["levels"][k]["displacement"]), 0);
    EXPECT_LE(number(linear["levels"][k]["hausdorff"]["upper"]), 1e-5);
    EXPECT_EQ(number(linear["levels"][k]["area"]), 16);
  }
  const Json dual = json({"square.csv", "--scheme", "bspline:degree=2", "--levels", "1"});
  EXPECT_FALSE(dual["levels"][1].contains("displacement")) << "points of its levels do not belong together";
  EXPECT_TRUE(dual["levels"][1].contains("hausdorff"));
}

TEST_F(Measure, DistanceBetweenPolygons) {
  file("square.csv", "0,0\n4,0\n4,4\n0,4\n");
  file("moved.csv", "1,0\n5,0\n5,4\n1,4\n");
  const Json result = json({"square.csv", "--against", "moved.csv", "--tolerance", "1e-9"})["against"];
  EXPECT_LE(number(result["hausdorff"]["lower"]), 1);
  EXPECT_GE(number(result["hausdorff"]["upper"]), 1 - 1e-12);
  EXPECT_LE(number(result["hausdorff"]["upper"]) - number(result["hausdorff"]["lower"]), 1.001e-9);
  expect_contains(run({"square.csv", "--against", "moved.csv"}).output, "Hausdorff distance to moved.csv");
}

TEST_F(Measure, LocalEstimates) {
  file("square.csv", "0,0\n4,0\n4,4\n0,4\n");
  const Json at = json({"square.csv", "--local"})["local"];
  ASSERT_EQ(at.size(), 4U);
  EXPECT_EQ(at[1]["vertex"], 1);  // (4,0) between (0,0) and (4,4)
  EXPECT_EQ(number(at[1]["velocity"][0]), 2);
  EXPECT_EQ(number(at[1]["velocity"][1]), 2);
  EXPECT_EQ(number(at[1]["acceleration"][0]), -4);
  EXPECT_EQ(number(at[1]["acceleration"][1]), 4);
  EXPECT_NEAR(number(at[1]["normal"][0]), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(number(at[1]["circle_radius"]), 2 * std::sqrt(2.0), 1e-14);  // half the diagonal
  EXPECT_NEAR(number(at[1]["parabola_radius"]), std::sqrt(2.0), 1e-14);    // V^2/(2h) = 8/(4 sqrt 2)
  EXPECT_EQ(number(at[0]["jerk"][0]), -8);  // of (0,0) to (4,0), by hand in ASquare
  EXPECT_EQ(number(at[0]["jerk"][1]), 0);
  EXPECT_EQ(number(at[0]["normal_jerk"]), 0);
  expect_contains(run({"square.csv", "--local"}).output, "radius, parabola");

  file("path.csv", "0,0,0\n1,0,0\n2,0,0\n2,1,0\n");
  const Json path = json({"path.csv", "--open", "plain", "--local"})["local"];
  ASSERT_EQ(path.size(), 2U);
  EXPECT_EQ(path[0]["vertex"], 1);
  EXPECT_EQ(path[0]["circle_radius"], "inf");
  EXPECT_TRUE(path[0]["normal"].empty());
  EXPECT_TRUE(path[0].contains("jerk"));
  EXPECT_FALSE(path[1].contains("jerk"));

  const Json fine = json({"square.csv", "--scheme", "jspline:s=1", "--levels", "3", "--local"});
  EXPECT_EQ(fine["local"].size(), 32U);
  double largest = 0;
  for (const Json& vertex : fine["local"])
    largest = std::max(largest, std::abs(number(vertex["normal_jerk"])));
  EXPECT_EQ(largest, number(fine["levels"][3]["normal_jerk"]["largest"]));
  EXPECT_FALSE(json({"square.csv"}).contains("local"));
}

TEST_F(Measure, BadInputEndsWith2) {
  file("square.csv", "0,0\n4,0\n4,4\n0,4\n");
  file("space.csv", "0,0,0\n1,1,1\n");
  const auto rejects = [&](const Strings& arguments, const Strings& parts) {
    expect_rejected(run(arguments), parts);
  };
  rejects({"absent.csv"}, {"absent.csv"});
  rejects({"square.csv", "--levels", "2"}, {"--scheme"});
  rejects({"square.csv", "--open", "plain", "--scheme", "jspline:s=1", "--levels", "1"}, {"--open plain"});
  rejects({"square.csv", "--against", "space.csv"}, {"space.csv", "3"});
  rejects({"square.csv", "--scheme", "jspline:s=1", "--levels", "40"}, {"--levels 40"});
  rejects({"square.csv", "--tolerance", "0"}, {"--tolerance"});
  rejects({"square.csv", "--scheme", "jspline:s=1", "--levels", "62"}, {"--levels 62"});
  file("two.csv", "0,0\n1,1\n");
  rejects({"two.csv", "--open", "plain", "--local"}, {"--local", "at least 3"});
  rejects({"square.csv", "--scheme", "jspline:s=1", "--levels", "19", "--local"},
          {"--local", "2097152", "1048576"});
  file("far.csv", "0,0\n1e308,0\n-1e308,1e308\n");
  for (const Strings& options :
       {Strings{}, Strings{"--local"}, Strings{"--json"}, Strings{"--json", "--local"}}) {
    Strings arguments{"far.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    rejects(arguments, {"far.csv: point 2", "1e150"});
  }
  rejects({"square.csv", "--against", "far.csv"}, {"--against far.csv: point 2"});
  file("near.csv", "0,0\n1e-320,0\n1e-320,1e-320\n");
  rejects({"near.csv", "--local"}, {"vertex 0", "curvature"});
  rejects({"near.csv", "--local", "--json"}, {"vertex 0", "curvature"});
  file("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  rejects({"open.obj"}, {"open.obj", "--open plain"});
}

}  // namespace
}  // namespace subdiv
