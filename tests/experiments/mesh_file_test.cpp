// Meshes in OBJ, OFF and PLY files: what is read, what comes back, and what is refused with its place.

#include "experiments/mesh_file.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "tests/experiments/temporary_folder.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using Corners = std::vector<long long>;

/// The bytes of a number, the low one first or last.
template <class T>
std::string bytes_of(T x, bool big_endian) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &x, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

class MeshFileTest : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) const {
    const auto path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  MeshFile read(const std::string& name, const std::string& text) const {
    return read_mesh(file(name, text));
  }
  void rejects(const std::string& name, const std::string& text,
               const std::initializer_list<const char*> parts) const {
    const auto path = file(name, text);
    expect_input_error([&] { return surface_of(read_mesh(path)); }, parts);
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

Corners face(const MeshFile& mesh, std::size_t f) {
  return {mesh.faces.face(f).begin(), mesh.faces.face(f).end()};
}

const std::string two_faces = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 1e-3\n";

TEST_F(MeshFileTest, ObjInAllFormsOfCorners) {
  const MeshFile mesh = read("m.obj", "\xef\xbb\xbf# a comment\r\nmtllib x.mtl\r\no thing\r\n" + two_faces +
                                          "vn 0 0 1\nvt 0 0\ng part\ns off\nusemtl red\n\n"
                                          "f 1/1/1 2/1/1 3/1/1 4/1/1  # the square\n\tf -4//1 5//1 3/1");
  EXPECT_EQ(mesh.points.size(), 5U);
  EXPECT_EQ(mesh.points[4], (Point3{2, 0.5, 1e-3}));
  ASSERT_EQ(mesh.faces.faces(), 2U);
  EXPECT_EQ(face(mesh, 0), (Corners{0, 1, 2, 3}));
  EXPECT_EQ(face(mesh, 1), (Corners{1, 4, 2}));
  EXPECT_EQ(mesh.places, (std::vector<std::size_t>{15, 16}));
  EXPECT_EQ(surface_of(mesh).edges(), 6);
}

TEST_F(MeshFileTest, ObjFacesMayStandBeforeTheirVertices) {
  const MeshFile mesh = read("m.obj", "f 1 2 3\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n");
  EXPECT_EQ(surface_of(mesh).faces(), 1);
}

TEST_F(MeshFileTest, OffWithCommentsAndColours) {
  const std::string body =
      " # so many\n0 0 0\n1 0 0\n\n1 1 0 # corner\n0 1 0\n2 .5 0\n4 0 1 2 3 255 0 0\n3 1 4 2";
  for (const char* head : {"OFF\n5 2 0", "# first\r\nOFF\r\n# second\r\n5 2 6", "OFF 5 2 0", "OFF\n5 2"}) {
    const MeshFile mesh = read("m.off", head + body);
    EXPECT_EQ(mesh.points.size(), 5U);
    ASSERT_EQ(mesh.faces.faces(), 2U);
    EXPECT_EQ(face(mesh, 0), (Corners{0, 1, 2, 3}));
    EXPECT_EQ(face(mesh, 1), (Corners{1, 4, 2}));
  }
  const MeshFile coloured =
      read("m.off", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n");
  EXPECT_EQ(coloured.points[1], (Point3{1, 0, 0}));
  EXPECT_EQ(coloured.places, (std::vector<std::size_t>{6}));
}

const std::string ply_elements =
    "comment made by hand\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\n"
    "property uchar red\nelement edge 1\nproperty int a\nelement face 1\nproperty list uchar float quality\n"
    "property list uint16 int vertex_index\nend_header\n";

TEST_F(MeshFileTest, PlyText) {
  const MeshFile mesh =
      read("m.ply", "ply\r\nformat ascii 1.0\n" + ply_elements +
                        "0 0 0 255\n1 0 0 0\n1 1 0 7\n-.5 1e0 3 9\n17\n2 nan 0.5 4 0 1 2 3\n\n");
  EXPECT_FALSE(mesh.binary);
  EXPECT_EQ(mesh.points[3], (Point3{-0.5, 1, 3}));
  EXPECT_EQ(face(mesh, 0), (Corners{0, 1, 2, 3}));
  EXPECT_EQ(mesh.places, (std::vector<std::size_t>{20}));
}

std::string binary_ply(bool big) {
  std::string text = std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
                     " 1.0\n" + ply_elements;
  const double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-0.5, 1, -3}};
  for (const auto& p : points) {
    text += bytes_of(static_cast<float>(p[0]), big) + bytes_of(p[1], big) +
            bytes_of(static_cast<std::int16_t>(p[2]), big) + "\n";
  }
  text += bytes_of(std::int32_t{17}, big) + std::string(1, '\1') + bytes_of(0.5F, big);
  text += bytes_of(std::uint16_t{4}, big);
  for (const std::int32_t i : {0, 1, 2, 3}) text += bytes_of(i, big);
  return text;
}

TEST_F(MeshFileTest, PlyInBothByteOrders) {
  for (const bool big : {false, true}) {
    const std::string text = binary_ply(big);
    const MeshFile mesh = read("m.ply", text);
    EXPECT_TRUE(mesh.binary);
    EXPECT_EQ(mesh.points[3], (Point3{-0.5, 1, -3}));
    EXPECT_EQ(face(mesh, 0), (Corners{0, 1, 2, 3}));
    for (std::size_t size = 0; size < text.size(); ++size) {  // wherever it breaks off
      const auto path = file("cut.ply", text.substr(0, size));
      expect_input_error([&] { return read_mesh(path); }, {"cut.ply"});
    }
    rejects("m.ply", text + "x", {"m.ply: byte", "more bytes"});
  }
}

TEST_F(MeshFileTest, EmptyMeshesAndVerticesWithoutFaces) {
  for (const auto& [name, text] :
       {std::pair<const char*, const char*>{"m.obj", ""},
        {"m.off", "OFF\n0 0 0\n"},
        {"m.ply",
         "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
         "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"}}) {
    const MeshFile mesh = read(name, text);
    EXPECT_TRUE(surface_of(mesh).is_empty()) << name;
    EXPECT_EQ(mesh.faces.faces(), 0U);
  }
  const MeshTopology lonely = surface_of(read("m.obj", two_faces));
  EXPECT_EQ(lonely.vertices(), 5);
  EXPECT_EQ(lonely.faces(), 0);
}

TEST_F(MeshFileTest, WhatIsWrittenReadsBackTheSame) {
  PolygonFaces faces;
  faces.vertices = 6;  // the last without a face
  faces.add_face(Corners{0, 1, 2, 3});
  faces.add_face(Corners{1, 4, 2});
  const std::vector<Point3> points{{0.1, 1.0 / 3, 1e-300}, {1e22, -0.0, 3}, {5e-324, 1, 2}, {4, 5, 6},
                                   {-7.25, 8, 0.3},        {1, 1, 1}};
  for (const auto& [name, format] : {std::pair{"m.obj", MeshFormat::obj}, std::pair{"m.off", MeshFormat::off},
                                     std::pair{"m.ply", MeshFormat::ply}}) {
    OutputFile out(path(name));
    write_mesh(out, format, faces, points);
    out.finish();
    const MeshFile mesh = read_mesh(path(name));
    EXPECT_EQ(mesh.points, points) << name;
    EXPECT_EQ(mesh.faces.corners, faces.corners);
    EXPECT_EQ(mesh.faces.begin, faces.begin);
  }
  IndexedMesh triangles;
  triangles.sides = 3;
  triangles.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangles.corners = {0, 1, 2};
  OutputFile out(path("t.ply"));
  write_mesh(out, MeshFormat::ply, triangles);
  out.finish();
  EXPECT_EQ(face(read_mesh(path("t.ply")), 0), (Corners{0, 1, 2}));
}

TEST_F(MeshFileTest, NumbersThatAreNotFiniteAreNotWritten) {
  IndexedMesh mesh;
  mesh.points.push_back({0, 0, std::numeric_limits<double>::infinity()});
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply}) {
    expect_input_error(
        [&] {
          OutputFile out(path("bad"));
          write_mesh(out, format, mesh);
          out.finish();
          return 0;
        },
        {"range of doubles"});
    EXPECT_FALSE(std::filesystem::exists(path("bad")));
  }
}

TEST_F(MeshFileTest, FaultsOfTheSurfaceAreNamedWithTheirLine) {
  rejects("m.obj", two_faces + "f 1 2 3 4\nf 2 3 5\n",
          {"m.obj:7: face 2 runs through", "same direction as face 1"});
  rejects("m.obj", two_faces + "f 1 2 3\n\nf 1 2 99\n", {"m.obj:8: face 2 has vertex 99", "5 vertices"});
  rejects("m.obj", two_faces + "f 1 2\n", {"m.obj:6: face 1 has 2 corners", "at least 3"});
  rejects("m.obj", two_faces + "f 1 2 1\n", {"m.obj:6: face 1 meets vertex 1 more than once"});
  rejects("m.obj", two_faces + "f 1 2 3\nf 3 1 2\n", {"m.obj:7: face 2 has the same corners as face 1"});
  rejects("m.obj", two_faces + "f 1 2 3\nf 2 1 4\nf 2 1 5\n", {"m.obj:8: face 3 is face number 3"});
  rejects("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", {"m.off:6: face 1 has"});
  std::string text = binary_ply(false);
  text.back() = '\1';  // the last corner is far beyond the vertices
  rejects("m.ply", text, {"m.ply: byte", "face 1 has vertex 16777220"});
}

TEST_F(MeshFileTest, ObjErrorsNameTheLine) {
  rejects("m.obj", "v 0 0\n", {"m.obj:1:", "v x y z"});
  rejects("m.obj", "v 0 0 0 1\n", {"m.obj:1:", "colour"});
  rejects("m.obj", "\nv 0 nan 0\n", {"m.obj:2:", "'nan'", "not finite"});
  rejects("m.obj", "v 0 inf 0\n", {"m.obj:1:", "not finite"});
  rejects("m.obj", "v 0 1e999 0\n", {"does not fit a double"});
  rejects("m.obj", "v 0 1,5 0\n", {"'1,5' is no number"});
  rejects("m.obj", two_faces + "f 1 2 -6\n", {"m.obj:6:", "'-6' names no vertex"});
  rejects("m.obj", two_faces + "f 0 1 2\n", {"'0' names no vertex"});
  rejects("m.obj", two_faces + "f 1 2 x\n", {"'x' is no integer"});
  rejects("m.obj", two_faces + "f 1 2 3/a\n", {"'3/a' is no corner"});
  rejects("m.obj", two_faces + "f 1 2 99999999999999999999\n", {"too large"});
  rejects("m.obj", two_faces + "l 1 2 3\n", {"curve"});
  rejects("m.obj", std::string("v 0 0 0\nv\0 1 1 1\n", 17), {"m.obj:2:", "NUL"});
  rejects("none.txt", "", {"none.txt", ".obj, .off or .ply"});
  expect_input_error([&] { return read_mesh(path("missing.obj")); }, {"missing.obj"});
  std::filesystem::create_directory(path("folder.obj"));
  expect_input_error([&] { return read_mesh(path("folder.obj")); }, {"folder.obj"});
}

TEST_F(MeshFileTest, OffErrorsNameTheLine) {
  rejects("m.off", "", {"m.off:0:", "OFF"});
  rejects("m.off", "8 6 0\n", {"m.off:1:", "'8'"});
  rejects("m.off", "4OFF\n1 0 0\n", {"'4OFF'", "in space"});
  rejects("m.off", "OFF BINARY\n", {"binary"});
  rejects("m.off", "OFF\n3\n", {"m.off:2:", "numbers of vertices, faces"});
  rejects("m.off", "OFF\n-3 1 0\n", {"'-3'"});
  rejects("m.off", "OFF\n3 1 0\n0 0 0\n", {"ends after 1 of 3 vertices"});
  rejects("m.off", "OFF\n1000000000000 1000000000000 0\n0 0 0\n", {"ends after 1 of 1000000000000 vertices"});
  rejects("m.off", "OFF\n1 1 0\n0 0 0 1\n", {"m.off:3:", "no more"});
  rejects("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", {"m.off:6:", "4 corners lists 3"});
  rejects("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", {"m.off:7:", "more lines"});
  rejects("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999999 0 1 2\n", {"lists 3"});
}

TEST_F(MeshFileTest, PlyErrorsNameTheLine) {
  const std::string ascii = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  rejects("m.ply", "obj\n", {"m.ply:1:", "says ply"});
  rejects("m.ply", "ply\nend_header\n", {"no format"});
  rejects("m.ply", "ply\nformat morse 1.0\n", {"'morse'", "ascii"});
  rejects("m.ply", ascii + "element vertex 3\n", {"ends before end_header"});
  rejects("m.ply", ascii + "element vertex 3\nend_header\n0 0 0\n0 0 0\n0 0 0\n", {"has no properties"});
  rejects("m.ply", ascii + "element vertex 1000000000000\n" + xyz + "end_header\n0 0 0\n",
          {"claims 1000000000000 elements 'vertex'"});
  rejects(
      "m.ply",
      "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000\n" + xyz + "end_header\n0 0 0\n",
      {"claims 1000000000000 elements 'vertex'"});
  rejects("m.ply", ascii + "element vertex 1\n" + xyz + "end_header\n0.0 0.0\n",
          {"m.ply:8:", "'z'", "missing"});
  rejects("m.ply", ascii + "element vertex 1\n" + xyz + "end_header\n0 0 nan\n", {"not finite"});
  rejects("m.ply", ascii + "element vertex 1\n" + xyz + "end_header\n0 0 1 2\n", {"more numbers"});
  rejects("m.ply", ascii + "element vertex 1\nproperty float x\nend_header\n0\n", {"no property y"});
  rejects("m.ply", ascii + "element vertex 1\nproperty flaot x\n", {"m.ply:4:", "'flaot' is no type"});
  rejects("m.ply", ascii + "element face 1\nproperty list float int vertex_indices\n", {"length of a list"});
  rejects("m.ply", ascii + "element face 1\nproperty int a\nend_header\n0\n", {"vertex_indices"});
  rejects("m.ply", ascii + "element tristrips 1\nproperty int a\nend_header\n0\n", {"strips"});
}

TEST_F(MeshFileTest, TimeIsLinearInTheSize) {
  // Faces with a hundred thousand corners on one long line; quadratic work would take minutes.
  constexpr int count = 100'000;
  std::string vertices;
  std::string corners = "f";
  for (int i = 0; i < count; ++i) {
    vertices += "v " + std::to_string(i) + " 0 0\n";
    corners += " " + std::to_string(i + 1);
  }
  const MeshFile mesh = read("m.obj", vertices + corners);
  EXPECT_EQ(mesh.points.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(surface_of(mesh).degree(0), count);
}

}  // namespace
}  // namespace subdiv
