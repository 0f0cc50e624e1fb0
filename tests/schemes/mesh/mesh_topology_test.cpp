#include "schemes/mesh/mesh_topology.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "schemes/input_error.h"
#include "schemes/mesh/fan.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

using sample::polygons;

std::string fault_text(const PolygonFaces& faces) {
  const auto fault = find_fault(faces);
  return fault ? "face " + std::to_string(fault->face + 1) + " " + fault->what : "none";
}

int euler_characteristic(const MeshTopology& mesh) { return mesh.vertices() - mesh.edges() + mesh.faces(); }

void expect_consistent(const MeshTopology& mesh) {
  for (int h = 0; h < mesh.half_edges(); ++h) {
    EXPECT_EQ(mesh.previous(mesh.next(h)), h);
    EXPECT_EQ(mesh.face(mesh.next(h)), mesh.face(h));
    const int o = mesh.opposite(h);
    if (o < 0) continue;
    EXPECT_EQ(mesh.opposite(o), h);
    EXPECT_EQ(mesh.origin(o), mesh.target(h));
    EXPECT_EQ(mesh.edge(o), mesh.edge(h));
  }
  int spokes = 0;
  for (int v = 0; v < mesh.vertices(); ++v) {
    for_each_outgoing(mesh, v, [&](int h) {
      EXPECT_EQ(mesh.origin(h), v);
      ++spokes;
    });
  }
  EXPECT_EQ(spokes, mesh.half_edges());
}

TEST(MeshTopology, CountsOfAClosedMeshFollowEuler) {
  for (const PolygonFaces& faces : {sample::cube(), sample::tetrahedron(), sample::bipyramid(7)}) {
    MeshTopology mesh(faces);
    EXPECT_TRUE(mesh.is_closed());
    EXPECT_EQ(euler_characteristic(mesh), 2);
    expect_consistent(mesh);
    mesh = split_into_quads(mesh);
    EXPECT_EQ(euler_characteristic(mesh), 2);
    expect_consistent(mesh);
  }
  EXPECT_EQ(euler_characteristic(MeshTopology(sample::torus(5, 4, 4))), 0);
  EXPECT_EQ(euler_characteristic(MeshTopology(sample::joined(sample::cube(), sample::torus(5, 4, 3)))), 2);
}

TEST(MeshTopology, SplitsKeepVerticesAndValences) {
  const MeshTopology cube(sample::cube());
  const MeshTopology quads = split_into_quads(cube);
  EXPECT_EQ(quads.faces(), 24);
  EXPECT_EQ(quads.vertices(), 8 + 12 + 6);
  for (int v = 0; v < 8; ++v) EXPECT_EQ(quads.valence(v), 3);
  for (int v = 8; v < quads.vertices(); ++v) EXPECT_EQ(quads.valence(v), 4);
  const MeshTopology pyramid(sample::bipyramid(5));
  const MeshTopology triangles = split_into_triangles(pyramid);
  expect_consistent(triangles);
  EXPECT_EQ(triangles.faces(), 40);
  EXPECT_EQ(triangles.valence(5), 5);
  for (int v = 7; v < triangles.vertices(); ++v) EXPECT_EQ(triangles.valence(v), 6);
  EXPECT_THROW(static_cast<void>(split_into_triangles(cube)), std::invalid_argument);
  // A pentagon's face point has valence 5.
  const MeshTopology pentagon(polygons(5, {{0, 1, 2, 3, 4}}));
  EXPECT_EQ(split_into_quads(pentagon).valence(10), 5);
}

TEST(MeshTopology, BordersBeginWithTheEdgeThatHasNoFaceToItsRight) {
  const MeshTopology sheet(sample::sheet(2, 3));
  EXPECT_FALSE(sheet.is_closed());
  expect_consistent(sheet);
  EXPECT_EQ(euler_characteristic(sheet), 1);
  EXPECT_EQ(neighbours(sheet, 0), (std::vector<int>{1, 4}));
  EXPECT_EQ(sheet.face_count(0), 1);
  EXPECT_EQ(sheet.valence(0), 2);
  EXPECT_EQ(sheet.face_count(1), 2);
  EXPECT_EQ(neighbours(sheet, 1), (std::vector<int>{2, 5, 0}));
  EXPECT_FALSE(sheet.is_border(5));
  EXPECT_EQ(neighbours(sheet, 5).size(), 4U);
}

TEST(MeshTopology, EveryFaultIsNamedWithItsFace) {
  EXPECT_EQ(fault_text(polygons(3, {{0, 1, 3}})),
            "face 1 has vertex 4 as a corner, but the mesh has 3 vertices");
  EXPECT_EQ(fault_text(polygons(3, {{0, 1, -1}})),
            "face 1 has vertex -1 from 0 as a corner, but the mesh has 3 vertices");
  EXPECT_EQ(fault_text(polygons(3, {{0, 1, 9223372036854775807LL}})),
            "face 1 has vertex 9223372036854775808 as a corner, but the mesh has 3 vertices");
  EXPECT_EQ(fault_text(polygons(3, {{0, 1, 2}, {0, 1}})), "face 2 has 2 corners");
  EXPECT_EQ(fault_text(polygons(3, {{}})), "face 1 has 0 corners");
  EXPECT_EQ(fault_text(polygons(4, {{0, 1, 2, 1}})), "face 1 meets vertex 2 more than once");
  EXPECT_EQ(fault_text(polygons(4, {{0, 1, 2}, {3, 2, 1}, {2, 0, 1}})),
            "face 3 has the same corners as face 1");
  EXPECT_EQ(fault_text(polygons(3, {{0, 1, 2}, {2, 1, 0}})), "face 2 has the same corners as face 1");
  EXPECT_EQ(fault_text(polygons(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})),
            "face 3 is face number 3 of 3 at the edge of vertex 1 and vertex 2");
  EXPECT_EQ(fault_text(polygons(4, {{0, 1, 2}, {0, 1, 3}})),
            "face 2 runs through the edge of vertex 1 and vertex 2 in the same direction as face 1");
  EXPECT_EQ(fault_text(polygons(5, {{0, 1, 2}, {0, 3, 4}})),
            "face 2 meets face 1 only at vertex 1: they share no edge there, nor do the faces between them");
  // Two closed fans at one vertex: two tetrahedra that share a corner.
  PolygonFaces twice = sample::tetrahedron();
  for (const auto& face : std::vector<std::vector<long long>>{{0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}})
    twice.add_face(face);
  twice.vertices = 7;
  EXPECT_EQ(fault_text(twice),
            "face 5 meets face 1 only at vertex 1: they share no edge there, nor do the faces between them");
  EXPECT_THROW(MeshTopology{twice}, InputError);
  EXPECT_EQ(fault_text(sample::cube()), "none");
}

TEST(MeshTopology, NoFacesAndLooseVerticesAreDefined) {
  const MeshTopology empty{PolygonFaces{}};
  EXPECT_TRUE(empty.is_empty());
  EXPECT_EQ(split_into_quads(empty).faces(), 0);
  PolygonFaces loose = sample::cube();
  loose.vertices = 10;
  const MeshTopology mesh(loose);
  EXPECT_EQ(mesh.outgoing(9), -1);
  EXPECT_EQ(mesh.valence(9), 0);
  EXPECT_TRUE(neighbours(mesh, 9).empty());
}

TEST(Fan, WalksGiveTheNumbersItWasBuiltWith) {
  for (const int sides : {3, 4}) {
    for (const int valence : {3, 4, 5, 6, 9}) {
      const MeshTopology fan = fan_topology(sides, valence, 4);
      const std::size_t places = sector_places(sides, 4).size();
      EXPECT_EQ(places, sides == 4 ? 20U : 10U);  // rings of 2 r and of r places
      ASSERT_EQ(static_cast<std::size_t>(fan.vertices()), 1 + places * static_cast<std::size_t>(valence));
      EXPECT_EQ(fan.valence(0), valence);
      int spoke = -1;
      for_each_outgoing(fan, 0, [&](int h) {
        if (fan.target(h) == 1) spoke = h;
      });
      const auto order = fan_vertices(fan, spoke, 3);
      ASSERT_TRUE(order.has_value());
      const std::size_t inner = sector_places(sides, 3).size();
      for (std::size_t i = 1; i < order->size(); ++i) {
        const std::size_t sector = (i - 1) / inner;
        EXPECT_EQ((*order)[i], static_cast<int>(1 + sector * places + (i - 1) % inner));
      }
    }
  }
  const MeshTopology cube(sample::cube());
  EXPECT_TRUE(fan_vertices(cube, cube.outgoing(0), 1).has_value());
  EXPECT_FALSE(fan_vertices(cube, cube.outgoing(0), 2).has_value()) << "its neighbours are irregular";
}

}  // namespace
}  // namespace subdiv
