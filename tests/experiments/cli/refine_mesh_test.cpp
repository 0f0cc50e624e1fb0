// 'subdivlab refine' on meshes.

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "experiments/mesh_file.h"
#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Strings = std::vector<std::string>;

const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string tetrahedron =
    "OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";

class RefineMesh : public ::testing::Test {
 protected:
  RefineMesh() {
    file("cube.obj", cube);
    file("tetrahedron.off", tetrahedron);
  }
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  ProgramRun run(Strings arguments) const {
    arguments.insert(arguments.begin(), "refine");
    return run_program(arguments, folder_.path());
  }
  void done(const Strings& arguments) const {
    const ProgramRun result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
  }
  void rejects(const Strings& arguments, const Strings& parts) const {
    const std::set<std::string> before = folder_.files();
    expect_rejected(run(arguments), parts);
    EXPECT_EQ(folder_.files(), before) << "nothing half-written";
  }
  [[nodiscard]] MeshFile mesh(const std::string& name) const { return read_mesh(folder_.path() / name); }
  [[nodiscard]] std::string text(const std::string& name) const { return text_of(folder_.path() / name); }

 private:
  TemporaryFolder folder_;
};

TEST_F(RefineMesh, CatmullClarkOfTheCube) {
  // Catmull, Clark 1978 at valence 3: a corner goes to (F + 2 E)/3, F = (1, 1, 1)/3 and E = (2, 2, 2)/3.
  done({"catmull-clark", "cube.obj", "-k", "1", "-o", "fine.obj"});
  const MeshFile fine = mesh("fine.obj");
  ASSERT_EQ(fine.points.size(), 8U + 12 + 6);
  for (const double x : fine.points[6]) EXPECT_NEAR(x, 5.0 / 9, 1e-15);
  for (std::size_t i = 20; i < 26; ++i) {  // the faces' centroids
    EXPECT_NEAR(std::abs(fine.points[i][0]) + std::abs(fine.points[i][1]) + std::abs(fine.points[i][2]), 1,
                1e-15);
  }
  const MeshTopology surface = surface_of(fine);
  EXPECT_TRUE(surface.is_closed());
  EXPECT_EQ(surface.vertices() - surface.edges() + surface.faces(), 2);
}

TEST_F(RefineMesh, BothFormsAndAllFormatsAgree) {
  done({"loop", "tetrahedron.off", "-k", "3", "-o", "a.obj", "--threads", "1"});
  done({"--scheme", "loop", "tetrahedron.off", "-o", "b.obj", "--levels", "3", "--threads", "2"});
  EXPECT_EQ(text("a.obj"), text("b.obj"));
  const MeshFile expected = mesh("a.obj");
  EXPECT_EQ(expected.faces.faces(), 4U * 64);
  for (const char* name : {"a.ply", "a.off"}) {
    done({"loop", "tetrahedron.off", "-k", "3", "-o", name});
    EXPECT_EQ(mesh(name).points, expected.points);
    EXPECT_EQ(mesh(name).faces.corners, expected.faces.corners);
  }
  const ProgramRun printed = run({"loop", "tetrahedron.off", "-k", "3", "-o", "-"});
  EXPECT_EQ(printed.output, text("a.obj"));
}

TEST_F(RefineMesh, NoLevelsGiveTheMeshItself) {
  done({"butterfly", "tetrahedron.off", "-k", "0", "-o", "same.off"});
  EXPECT_EQ(text("same.off"),
            "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n");
}

TEST_F(RefineMesh, InterpolatingSchemesKeepTheVertices) {
  done({"kobbelt", "cube.obj", "-k", "2", "-o", "fine.ply"});
  const MeshFile fine = mesh("fine.ply");
  const MeshFile coarse = mesh("cube.obj");
  EXPECT_EQ(fine.points.size(), 98U);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(fine.points[v], coarse.points[v]);
}

TEST_F(RefineMesh, TheDirectionalSchemeAtOneIsCatmullClark) {
  done({"jspline-mesh:s=1", "cube.obj", "-k", "3", "-o", "j.obj"});
  done({"catmull-clark", "cube.obj", "-k", "3", "-o", "c.obj"});
  const MeshFile j = mesh("j.obj");
  const MeshFile c = mesh("c.obj");
  ASSERT_EQ(j.points.size(), c.points.size());
  const auto distance = [](const Point3& p, const Point3& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  for (const Point3& p : c.points) {  // new vertices may be numbered differently
    const auto nearest =
        std::min_element(j.points.begin(), j.points.end(),
                         [&](const Point3& q, const Point3& r) { return distance(p, q) < distance(p, r); });
    EXPECT_LT(distance(p, *nearest), 1e-14);
  }
}

TEST_F(RefineMesh, LimitPointsOfCatmullClark) {
  // Halstead, Kass, DeRose 1993: (n^2 V + 4 sum of edge neighbours + sum of diagonal ones)/(n (n + 5)); at a
  // corner of the cube, n = 3: (9 (1,1,1) + 4 (1,1,1) + (-1,-1,-1))/24 = 1/2. The normal is diagonal.
  for (const char* level : {"0", "2"}) {
    for (const char* name : {"limit.obj", "limit.off", "limit.ply"}) {
      done({"catmull-clark", "cube.obj", "-k", level, "--limit", "-o", name});
      for (const double x : mesh(name).points[6]) EXPECT_NEAR(x, 0.5, 1e-14);
    }
  }
  done({"catmull-clark", "cube.obj", "-k", "0", "--limit", "-o", "limit.off"});
  const std::string off = text("limit.off");
  EXPECT_EQ(off.substr(0, 5), "NOFF\n");
  expect_contains(off, "0.577350269189");
  done({"catmull-clark", "cube.obj", "-k", "0", "--limit", "-o", "limit.obj"});
  expect_contains(text("limit.obj"), "\nvn ");
  expect_contains(text("limit.obj"), "//");
  file("mixed.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0\nf 1 2 3 4\nf 2 5 3\n");
  rejects({"catmull-clark", "mixed.obj", "-k", "0", "--limit", "-o", "x.obj"}, {"--limit", "--levels 1"});
}

TEST_F(RefineMesh, PicturesShowTheFaces) {
  done({"catmull-clark", "cube.obj", "-k", "3", "-o", "cube.svg"});
  const std::string svg = text("cube.svg");
  expect_contains(svg, "<svg xmlns=");
  expect_contains(svg, "Z\"/>");
  done({"catmull-clark", "cube.obj", "-k", "0", "-o", "cube.svg"});
}

TEST_F(RefineMesh, EmptyMeshesStayEmpty) {
  file("empty.obj", "");
  file("empty.off", "OFF\n0 0 0\n");
  for (const char* name : {"empty.obj", "empty.off"}) {
    done({"catmull-clark", name, "-k", "3", "-o", "out.off"});
    EXPECT_EQ(text("out.off"), "OFF\n0 0 0\n");
    done({"loop", name, "-k", "2", "-o", "out.svg"});
  }
}

TEST_F(RefineMesh, VerticesWithoutFacesAreKept) {
  file("more.obj", cube + "v 9 8 7\n");
  done({"catmull-clark", "more.obj", "-k", "2", "-o", "fine.obj"});
  EXPECT_EQ(mesh("fine.obj").points[8], (Point3{9, 8, 7}));
}

TEST_F(RefineMesh, LevelsThatDoNotFitAreRefusedAtOnce) {
  rejects({"catmull-clark", "cube.obj", "-k", "62", "-o", "x.obj"},
          {"--levels 62", "faces, more than can be numbered", "--levels 13 makes 402653184"});
  rejects({"loop", "tetrahedron.off", "-k", "40", "-o", "x.obj"}, {"--levels 13 makes 268435456"});
  rejects({"catmull-clark", "cube.obj", "-k", "12", "-o", "x.svg"}, {"more than a picture shows"});
}

TEST_F(RefineMesh, SchemesAndInputsThatDoNotFit) {
  rejects({"loop", "cube.obj", "-k", "1", "-o", "x.obj"},
          {"cube.obj:9: face 1 has 4 corners", "refines triangles", "catmull-clark"});
  rejects({"jspline:s=1", "cube.obj", "-k", "1", "-o", "x.obj"}, {"cube.obj:9: a face", "catmull-clark"});
  rejects({"jspline:s=1", "tetrahedron.off", "-k", "1", "-o", "x.obj"},
          {"'jspline' is a scheme for curves", "loop"});
  rejects({"catmul-clark", "cube.obj", "-k", "1", "-o", "x.obj"}, {"did you mean 'catmull-clark'?"});
  rejects({"jspline-mesh:s=9", "cube.obj", "-k", "1", "-o", "x.obj"}, {"s = 9"});
  rejects({"jspline-mesh:s=t", "cube.obj", "-k", "1", "-o", "x.obj"}, {"t has no value"});
  rejects({"jspline-mesh", "cube.obj", "-k", "1", "-o", "x.obj"}, {"a value is missing for s"});
  rejects({"jspline-mesh:s=1e300", "cube.obj", "-k", "3", "-o", "x.obj"}, {"range of doubles"});
  file("square.csv", "0,0\n1,0\n1,1\n");
  rejects({"kobbelt", "square.csv", "-k", "1", "-o", "x.obj"}, {"square.csv", "faces", "jspline"});
  file("points.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\n");
  rejects({"kobbelt", "points.obj", "-k", "1", "-o", "x.obj"}, {"points.obj", "no faces", "jspline"});
  file("curve.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  rejects({"kobbelt", "curve.obj", "-k", "1", "-o", "x.obj"}, {"curve.obj", "curve"});
}

TEST_F(RefineMesh, OptionsThatMakeNoSense) {
  const Strings call{"kobbelt", "cube.obj", "-k", "1", "-o", "x.obj"};
  for (const auto& [option, value] : {std::pair<const char*, const char*>{"--open", "clamped"},
                                      {"--open-across", "reflected"},
                                      {"--grid", "2x4"},
                                      {"--details", "d.csv"},
                                      {"--retrofit", "direct"}}) {
    Strings arguments = call;
    arguments.insert(arguments.end(), {option, value});
    rejects(arguments, {option, "leave it out for meshes"});
  }
  file("square.csv", "0,0\n1,0\n1,1\n");
  rejects({"jspline:s=1", "square.csv", "-k", "1", "-o", "x.csv", "--threads", "2"},
          {"--threads is for meshes"});
  rejects({"kobbelt", "cube.obj", "-k", "1", "-o", "x.obj", "--threads", "0"}, {"--threads"});
  rejects({"kobbelt", "cube.obj", "-k", "1", "-o", "x.csv"}, {"x.csv", ".obj, .off, .ply or .svg"});
  rejects({"kobbelt", "cube.obj", "-k", "1", "-o", "none/x.obj"}, {"none/x.obj"});
  rejects({"kobbelt", "cube.obj", "-o", "x.obj"}, {"--levels"});
  rejects({"--scheme", "kobbelt", "cube.obj", "more.obj", "-k", "1", "-o", "x.obj"}, {"SCHEME"});
  rejects({"--scheme", "kobbelt", "-k", "1", "-o", "x.obj"}, {"INPUT"});
  rejects({"kobbelt", "-k", "1", "-o", "x.obj"}, {"INPUT"});
  rejects({"-k", "1", "-o", "x.obj"}, {"SCHEME"});
}

TEST_F(RefineMesh, UnusableMeshesAreRefusedWithTheirLine) {
  file("bow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n");
  rejects({"butterfly", "bow.obj", "-k", "1", "-o", "x.obj"}, {"bow.obj:7: face 2", "vertex 1", "one fan"});
  file("nan.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
       "property double z\nend_header\n0 nan 0\n");
  rejects({"butterfly", "nan.ply", "-k", "1", "-o", "x.obj"}, {"nan.ply:8:", "not finite"});
  rejects({"butterfly", "missing.ply", "-k", "1", "-o", "x.obj"}, {"missing.ply"});
}

}  // namespace
}  // namespace subdiv
