#include "experiments/mesh_figures.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "experiments/mesh_file.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_mesh_figures();
  return once;
}

double value(const std::string& id) { return test::value_of(results().claims, id); }

MeshFile stored(const char* name) {
  return read_mesh(std::filesystem::path(SUBDIVLAB_SOURCE_DIR) / "experiments/data" / name);
}

/// The volume by fluxes of (0, 0, z): the mean over a triangle of z times its area seen from above. A quad is
/// the mean of its two pairs of triangles.
double volume(const IndexedMesh& mesh) {
  const auto sides = static_cast<std::size_t>(mesh.sides);
  const auto flux = [&](std::size_t f, std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [&](std::size_t corner) -> const Point3& {
      return mesh.points[static_cast<std::size_t>(mesh.corners[f * sides + corner % sides])];
    };
    const Point3& a = at(i);
    const Point3& b = at(j);
    const Point3& c = at(k);
    return (a[2] + b[2] + c[2]) / 6 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  };
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (sides == 3) {
      sum += flux(f, 0, 1, 2);
    } else {
      for (std::size_t i = 0; i < 4; ++i) sum += flux(f, i, i + 1, i + 2) / 2;
    }
  }
  return sum;
}

double refined_volume(const char* file, const std::string& scheme, int levels) {
  const MeshFile mesh = stored(file);
  return volume(
      refine_mesh(surface_of(mesh), mesh.points, mesh_scheme<double>(parse_mesh_scheme(scheme)), levels));
}

TEST(MeshFigures, WhatIsPrintedHolds) {
  EXPECT_EQ(results().claims.size(), mesh_figure_heads().size());
  for (const Claim& claim : results().claims) {
    EXPECT_EQ(claim.verdict, claim.head.printed ? Verdict::reproduced : Verdict::established)
        << claim.head.id;
    EXPECT_EQ(claim.rigour, Rigour::exact) << claim.head.id;
  }
}

TEST(MeshFigures, VolumesByFluxesOfTheFastRefinement) {
  const char* handles = "mesh-handles.obj";
  for (const auto& [name, s] : {std::pair{"j0", "0"}, {"average", "1/2"}, {"j1", "1"}, {"quintic", "3/2"}}) {
    const std::string scheme = std::string("jspline-mesh:s=") + s;
    const double ratio =
        refined_volume(handles, scheme, 2) / value("figure.mesh.volume." + std::string(name));
    static const double control = ratio;  // that of the control mesh, the same for all
    EXPECT_NEAR(ratio, control, 1e-11 * control) << name;
  }
  // The tetrahedron in the cube [-1, 1]^3 has a third of its volume.
  EXPECT_NEAR(refined_volume("mesh-tetrahedron.obj", "loop", 4),
              value("figure.notes.tetrahedron.volume") * 8 / 3, 1e-13);
}

TEST(MeshFigures, EveryFigureHasItsData) {
  EXPECT_EQ(results().figures.size(), 6U);
  for (const Figure& figure : results().figures) {
    for (const Curve& curve : figure.curves) {
      EXPECT_FALSE(test::find_series(results(), curve.series).rows.empty()) << figure.name;
    }
  }
}

TEST(MeshFigures, StoredMeshesAreAsDescribed) {
  const MeshTopology handles = surface_of(stored("mesh-handles.obj"));
  std::vector<int> count(9, 0);
  for (int v = 0; v < handles.vertices(); ++v) ++count[static_cast<std::size_t>(handles.valence(v))];
  EXPECT_EQ(count, (std::vector<int>{0, 0, 0, 21, 53, 20, 1, 1, 1}));
  EXPECT_TRUE(handles.is_closed());
  const MeshTopology example = surface_of(stored("mesh-valence-8.obj"));
  EXPECT_EQ(example.valence(8), 8);
  EXPECT_EQ(example.valence(9), 6);
  EXPECT_EQ(example.valence(10), 6);
  EXPECT_TRUE(example.is_closed());
  EXPECT_TRUE(surface_of(stored("mesh-handles-triangles.obj")).is_closed());
}

}  // namespace
}  // namespace subdiv
