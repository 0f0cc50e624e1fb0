// 'subdivlab rings': surface rings around extraordinary vertices of a mesh.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/mesh_file.h"
#include "tests/experiments/cli/program.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

using Strings = std::vector<std::string>;
using Json = nlohmann::json;

/// A sheet of rows x columns quads over random heights, as OBJ.
std::string sheet_text(int rows, int columns) {
  std::ostringstream text;
  const PolygonFaces faces = sample::sheet(rows, columns);
  const auto heights = sample::random_points<double>(static_cast<int>(faces.vertices), 3U);
  for (std::size_t v = 0; v < faces.vertices; ++v) {
    text << "v " << v / static_cast<std::size_t>(columns + 1) << ' '
         << v % static_cast<std::size_t>(columns + 1) << ' ' << heights[v][2] / 10 << '\n';
  }
  for (std::size_t f = 0; f < faces.faces(); ++f) {
    text << 'f';
    for (const long long corner : faces.face(f)) text << ' ' << corner + 1;
    text << '\n';
  }
  return text.str();
}

/// n quads around a vertex and nothing else.
std::string fan_text(int n) {
  constexpr double pi = 3.14159265358979324;
  std::ostringstream text;
  text << "v 0 0 1\n";
  for (int i = 0; i < 2 * n; ++i) {
    const double r = i % 2 == 0 ? 2 : 3;
    text << "v " << r * std::cos(pi * i / n) << ' ' << r * std::sin(pi * i / n) << " 0\n";
  }
  for (int i = 0; i < n; ++i)
    text << "f 1 " << 2 * i + 2 << ' ' << 2 * i + 3 << ' ' << (2 * i + 2) % (2 * n) + 2 << '\n';
  return text.str();
}

const std::string handles = std::string(SUBDIVLAB_SOURCE_DIR) + "/experiments/data/mesh-handles.obj";

class Rings : public ::testing::Test {
 protected:
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  ProgramRun run(Strings arguments, const std::string& verb = "rings") const {
    arguments.insert(arguments.begin(), verb);
    return run_program(arguments, folder_.path());
  }
  ProgramRun done(const Strings& arguments, const std::string& verb = "rings") const {
    ProgramRun result = run(arguments, verb);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result;
  }
  void rejects(const Strings& arguments, const Strings& parts) const {
    const std::set<std::string> before = folder_.files();
    expect_rejected(run(arguments), parts);
    EXPECT_EQ(folder_.files(), before) << "nothing half-written";
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }
  [[nodiscard]] MeshFile mesh(const std::string& name) const { return read_mesh(folder_.path() / name); }
  [[nodiscard]] std::string text(const std::string& name) const { return text_of(folder_.path() / name); }

  /// That every point of the one mesh is one of the other.
  void expect_among(const std::string& some, const std::string& all) const {
    const MeshFile fine = mesh(all);
    constexpr double cell = 1e-3;
    std::map<std::array<long, 3>, std::vector<Point3>> cells;
    const auto cell_of = [](double x) { return std::lround(std::floor(x / cell)); };
    for (const Point3& p : fine.points) cells[{cell_of(p[0]), cell_of(p[1]), cell_of(p[2])}].push_back(p);
    for (const Point3& p : mesh(some).points) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const double dx : {-1e-9, 1e-9}) {
        for (const double dy : {-1e-9, 1e-9}) {
          for (const double dz : {-1e-9, 1e-9}) {
            const auto found = cells.find({cell_of(p[0] + dx), cell_of(p[1] + dy), cell_of(p[2] + dz)});
            if (found == cells.end()) continue;
            for (const Point3& q : found->second)
              nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
          }
        }
      }
      EXPECT_LT(nearest, 1e-11) << p[0] << ' ' << p[1] << ' ' << p[2];
    }
  }

 private:
  TemporaryFolder folder_;
};

// Karciauskas & Peters, section III: speed 1/2 is Catmull-Clark. Its limit points come from limit masks.
TEST_F(Rings, OfSpeedOneHalfAreCatmullClarksSurface) {
  file("sheet.obj", sheet_text(3, 4));
  for (const std::string& input : {handles, std::string("sheet.obj")}) {
    // Two levels after the step: points at the quarters of a patch, and those of two rings and the vertex.
    done({"catmull-clark", input, "--limit", "--levels", "3", "-o", "limit.ply"}, "refine");
    done({input, "--catmull-clark-step", "--sigma", "1/2,1/2", "--fill", "--tessellation", "4", "-o",
          "rings.ply"});
    expect_among("limit.ply", "rings.ply");
  }
}

// At borders and corners without a step, too: the phantom points are exact, not a limit.
TEST_F(Rings, ContinueBordersAsCatmullClarkDoes) {
  for (const auto& [rows, columns] : {std::pair{1, 1}, {1, 3}, {2, 2}, {4, 3}}) {
    file("sheet.obj", sheet_text(rows, columns));
    done({"catmull-clark", "sheet.obj", "--limit", "--levels", "2", "-o", "limit.ply"}, "refine");
    done({"sheet.obj", "--tessellation", "4", "-o", "patches.ply"});
    expect_among("limit.ply", "patches.ply");
  }
}

TEST_F(Rings, AnyOtherSpeedKeepsTheLimitPointsOfVertices) {
  done({"catmull-clark", handles, "--limit", "--levels", "1", "-o", "limit.ply"}, "refine");
  done({handles, "--catmull-clark-step", "--sigma", "1/3,sqrt(2)/2,9/10", "--fill", "-o", "rings.ply"});
  const MeshFile control = read_mesh(handles);
  expect_among("limit.ply", "rings.ply");
}

TEST_F(Rings, ComeRingByRing) {
  file("fan.obj", fan_text(5));
  const ProgramRun result =
      done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2,0.75", "--fill", "--tessellation", "2", "-o",
            "fan-rings.obj", "--control-points", "control.obj"});
  expect_contains(result.output, "ring_2");
  // 20 faces after the step, 5 of them around the vertex; 3 n patches a ring, n in the cap; 4 quads each.
  std::vector<std::string> groups;
  std::map<std::string, int> faces;
  std::istringstream lines(text("fan-rings.obj"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("g ")) groups.push_back(line.substr(2));
    if (line.starts_with("f ")) ++faces[groups.back()];
  }
  EXPECT_EQ(groups, (Strings{"regular", "ring_1", "ring_2", "cap"}));
  EXPECT_EQ(faces, (std::map<std::string, int>{
                       {"regular", 4 * 15}, {"ring_1", 4 * 15}, {"ring_2", 4 * 15}, {"cap", 4 * 5}}));
  // A disc: one component without cracks, whose only border is the mesh's own.
  const MeshTopology surface(mesh("fan-rings.obj").faces);
  EXPECT_EQ(surface.faces(), 200);
  EXPECT_EQ(surface.vertices() - surface.edges() + surface.faces(), 1);
}

TEST_F(Rings, LeaveNoCracks) {
  for (const std::string n : {"1", "2", "5"}) {
    done({handles, "--catmull-clark-step", "--sigma", "1/3,9/10,1/2", "--fill", "--tessellation", n, "-o",
          "closed.ply"});
    const MeshTopology surface(mesh("closed.ply").faces);
    EXPECT_TRUE(surface.is_closed());
    EXPECT_EQ(surface.vertices() - surface.edges() + surface.faces(), -2);
  }
  // Without caps a border for each of the 44 extraordinary vertices.
  done({handles, "--catmull-clark-step", "--sigma", "3/4", "-o", "open.off"});
  const MeshTopology open(mesh("open.off").faces);
  EXPECT_EQ(open.vertices() - open.edges() + open.faces(), -2 - 44);
}

TEST_F(Rings, ControlPointsInBothFormatsAreTheSamePatches) {
  file("fan.obj", fan_text(3));
  const Strings common{"fan.obj", "--catmull-clark-step", "--sigma", "3/4", "--rings-only"};
  Strings obj = common;
  obj.insert(obj.end(), {"--control-points", "patches.obj", "--json"});
  Strings bv = common;
  bv.insert(bv.end(), {"--control-points", "patches.bv", "--json"});
  done(obj);
  done(bv);
  std::vector<Point3> listed;
  std::istringstream obj_lines(text("patches.obj"));
  std::size_t patches = 0;
  for (std::string line; std::getline(obj_lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      Point3& p = listed.emplace_back();
      words >> p[0] >> p[1] >> p[2];
    } else if (keyword == "surf") {
      std::array<double, 4> range{};
      for (double& x : range) words >> x;
      EXPECT_EQ(range, (std::array<double, 4>{0, 1, 0, 1}));
      for (std::size_t k = 1; k <= 16; ++k) {
        std::size_t number = 0;
        words >> number;
        EXPECT_EQ(number, 16 * patches + k);
      }
      ++patches;
    }
  }
  EXPECT_EQ(patches, 9U);
  ASSERT_EQ(listed.size(), 9U * 16);
  std::istringstream words(text("patches.bv"));
  std::string word;
  words >> word;
  EXPECT_EQ(word, "Group");
  words >> word >> word;
  EXPECT_EQ(word, "ring_1");
  for (std::size_t patch = 0; patch < 9; ++patch) {
    std::array<int, 3> header{};
    words >> header[0] >> header[1] >> header[2];
    EXPECT_EQ(header, (std::array<int, 3>{5, 3, 3}));
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        Point3 p{};
        words >> p[0] >> p[1] >> p[2];
        EXPECT_EQ(p, listed[16 * patch + 4 * j + i]);
      }
    }
  }
  EXPECT_FALSE(words >> word);
}

TEST_F(Rings, ReportTheHoles) {
  file("fan.obj", fan_text(5));
  const Json report = Json::parse(
      done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2,sqrt(1/2)", "--json", "-o", "out.off"})
          .output);
  EXPECT_EQ(report["speeds"], (Json{"1/2", "sqrt(2)/2"}));
  EXPECT_EQ(report["patches"][1], (Json{{"group", "ring_1"}, {"count", 15}}));
  ASSERT_EQ(report["holes"].size(), 1U);
  const Json& hole = report["holes"][0];
  EXPECT_EQ(hole["vertex"], 1);
  EXPECT_EQ(hole["valence"], 5);
  EXPECT_EQ(hole["filled"], false);
  const double share = std::stod(hole["share"].get<std::string>());
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 0.3);
  EXPECT_LT(std::stod(report["rounding"].get<std::string>()), 1e-11);
  EXPECT_TRUE(mesh("out.off").faces.faces() > 0);
}

TEST_F(Rings, RefuseSpeeds) {
  file("fan.obj", fan_text(5));
  const auto with = [](const std::string& sigma) {
    return Strings{"fan.obj", "--catmull-clark-step", "--sigma=" + sigma, "-o", "out.obj"};
  };
  for (const std::string sigma : {"0", "1", "-1/2", "3/2", "1/2,2"})
    rejects(with(sigma), {"--sigma", "between 0 and 1"});
  rejects(with("x"), {"--sigma", "expected a number", "'x'"});
  rejects(with("1/2,,1/2"), {"--sigma", "missing", "1/2,3/4"});
  rejects(with("1/0"), {"--sigma", "division by zero"});
  rejects(with("1-1e-30"), {"--sigma", "2^-64"});
  rejects(with("1e-14"), {"vertex 1", "fewer than three digits"});
  rejects(with("9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10,9/10"),
          {"vertex 1", "fewer steps"});
}

TEST_F(Rings, SayWhichCauseTakesTheDigits) {
  const auto with = [&](double scale, double offset, const std::string& sigma) {
    std::ostringstream text;
    text.precision(17);
    std::istringstream lines(fan_text(5));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string keyword;
      Point3 p{};
      words >> keyword;
      if (keyword != "v") {
        text << line << '\n';
        continue;
      }
      words >> p[0] >> p[1] >> p[2];
      text << "v " << scale * p[0] + offset << ' ' << scale * p[1] << ' ' << scale * p[2] << '\n';
    }
    file("moved.obj", text.str());
    return Strings{"moved.obj", "--catmull-clark-step", "--sigma", sigma, "-o", "out.obj"};
  };
  rejects(with(1, 0, "1e-14"), {"moved.obj", "vertex 1", "take fewer steps"});
  rejects(with(1, 1e12, "1/2"), {"moved.obj", "vertex 1", "move the mesh to the origin"});
  rejects(with(1e-320, 0, "1/2"), {"moved.obj", "vertex 1", "scale the mesh up"});
  rejects(with(1e307, 0, "1/2"), {"moved.obj", "vertex 1", "scale the mesh down"});
  // Scales in between change nothing but the scale.
  for (const double scale : {1e-250, 1.0, 1e250}) {
    Strings arguments = with(scale, 0, "1/2");
    arguments.emplace_back("--json");
    const Json report = Json::parse(done(arguments).output);
    const auto number = [&](const Json& x) { return std::stod(x.get<std::string>()); };
    EXPECT_NEAR(number(report["holes"][0]["share"]), 0.5, 0.2);
    EXPECT_GT(number(report["rounding"]), 1e-16 * scale);
    EXPECT_LT(number(report["rounding"]), 1e-12 * scale);
  }
}

TEST_F(Rings, RefuseMeshesAndSayWhatHelps) {
  file("cube.obj",
       "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
       "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  rejects({"cube.obj", "--sigma", "1/2", "-o", "out.obj"},
          {"vertex 1 of valence 3 shares face", "--catmull-clark-step"});
  done({"cube.obj", "--sigma", "1/2", "-o", "out.obj", "--catmull-clark-step"});
  file("fan.obj", fan_text(5));
  rejects({"fan.obj", "--sigma", "1/2", "-o", "new.obj"},
          {"vertex 1 of valence 5", "of the border", "--catmull-clark-step"});
  file("tetrahedron.off",
       "OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n");
  rejects({"tetrahedron.off", "--sigma", "1/2", "-o", "new.obj"},
          {"face 1 at vertex 1 has 3 corners", "--catmull-clark-step"});
  rejects({"tetrahedron.off", "--sigma", "1/2", "-o", "new.obj", "--catmull-clark-step"},
          {"after 1 Catmull-Clark step", "valence 3 shares face", "--catmull-clark-step once more"});
  done(
      {"tetrahedron.off", "--sigma", "1/2", "-o", "new.obj", "--catmull-clark-step", "--catmull-clark-step"});
  // Three quads at a vertex of the border: no step makes it regular.
  file("ell.obj",
       "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\n"
       "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\n");
  for (const Strings& steps : {Strings{}, Strings{"--catmull-clark-step"}}) {
    Strings arguments{"ell.obj", "--sigma", "1/2", "-o", "other.obj"};
    arguments.insert(arguments.end(), steps.begin(), steps.end());
    rejects(arguments, {"vertex 5 is extraordinary at the border: 3 faces", "no Catmull-Clark step changes"});
  }
}

TEST_F(Rings, RefuseOutputs) {
  file("fan.obj", fan_text(5));
  const Strings common{"fan.obj", "--catmull-clark-step", "--sigma", "1/2"};
  const auto with = [&](const Strings& more) {
    Strings result = common;
    result.insert(result.end(), more.begin(), more.end());
    return result;
  };
  rejects(with({}), {"nothing to write", "-o OUTPUT"});
  rejects(with({"-o", "out.stl"}), {"out.stl", ".ply"});
  rejects(with({"-o", "out.obj", "--control-points", "out.csv"}), {"--control-points", ".bv"});
  rejects(with({"-o", "out.obj", "--control-points", "out.obj"}), {"--control-points", "another"});
  for (const std::string same : {"./out.obj", "../out.obj", "linked.obj"}) {
    std::filesystem::create_directories(folder() / "inside");
    std::filesystem::remove(folder() / "linked.obj");
    std::filesystem::create_symlink("out.obj", folder() / "linked.obj");
    const std::string name = same.starts_with("..") ? "inside/" + same : same;
    rejects(with({"-o", name, "--control-points", "out.obj"}), {"--control-points", "another"});
    rejects(with({"-o", "out.obj", "--control-points", name}), {"--control-points", "another"});
  }
  for (const std::string output : {"-", "/dev/stdout", "/dev/fd/1"})
    rejects(with({"-o", output, "--json"}), {"--json", "standard output", "-o " + output});
  std::filesystem::create_symlink("/dev/stdout", folder() / "stdout.obj");
  rejects(with({"--control-points", "stdout.obj", "--json"}), {"--json", "standard output", "stdout.obj"});
  rejects(with({"-o", "-", "--control-points", "stdout.obj"}), {"--control-points", "another"});
  rejects(with({"-o", "absent/out.obj"}), {"absent/out.obj", "cannot be written"});
  const ProgramRun unwritten = run(with({"--control-points", "absent/out.obj"}));
  EXPECT_EQ(unwritten.errors.find("--out"), std::string::npos) << unwritten.errors;
  rejects(with({"-o", "out.svg", "--tessellation", "1000"}), {"--tessellation", "picture"});
  rejects({"missing.obj", "-o", "out.obj"}, {"missing.obj"});
}

TEST_F(Rings, WritePicturesAndStandardOutput) {
  file("fan.obj", fan_text(5));
  done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2", "-o", "out.svg"});
  expect_contains(text("out.svg"), "<svg");
  const ProgramRun plain = done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2", "-o", "-"});
  EXPECT_TRUE(plain.output.starts_with("v "));
  std::filesystem::create_symlink("/dev/stdout", folder() / "shown.obj");
  for (const std::string output : {"-", "/dev/stdout", "/dev/fd/1", "shown.obj"}) {
    const ProgramRun result = done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2", "-o", output});
    EXPECT_EQ(result.output, plain.output) << output;
    expect_contains(result.errors, "ring_1");
  }
  // Patches there, too; the report stays on standard output while they go to files.
  const ProgramRun patches =
      done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2", "--control-points", "shown.obj"});
  EXPECT_TRUE(patches.output.starts_with("v "));
  EXPECT_TRUE(patches.output.ends_with("end\n"));
  expect_contains(patches.errors, "ring_1");
  EXPECT_TRUE(done({"fan.obj", "--catmull-clark-step", "--sigma", "1/2", "-o", "/dev/null"})
                  .output.starts_with("group"));
}

}  // namespace
}  // namespace subdiv
