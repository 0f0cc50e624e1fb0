#include "schemes/mesh/border_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/mesh/limit_mesh.h"
#include "analysis/open_grid.h"
#include "schemes/evaluate/grid_ringing.h"
#include "schemes/evaluate/indexed_mesh.h"
#include "schemes/jspline.h"
#include "schemes/mesh/jspline_mesh.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

constexpr double tolerance = 1e-11;

/// One coordinate of the tensor-product surface with clamped ends in both directions (js-report 11, 13).
std::vector<double> clamped_surface(const std::vector<Rational>& points, std::size_t rows,
                                    std::size_t columns, const Rational& s, int levels) {
  const Scheme<Rational> scheme = stationary("J", jspline(s));
  const EndWeights<Rational> weights = end_weights(scheme, OpenEnd::clamped);
  const auto grid = control_grid<Rational>({rows, true, 0, 0}, {columns, true, 0, 0}, points);
  const Refinement<Rational> refinement{scheme, levels};
  std::vector<double> result;
  stream_surface(
      open_across(open_along(grid, weights), weights), refinement, refinement,
      [&](const Rational& p) { result.push_back(p.to_double()); }, [](const auto&) {});
  return result;
}

TEST(BorderLayers, SheetsAreClampedTensorProductSurfaces) {
  constexpr std::size_t rows = 4;
  constexpr std::size_t columns = 5;
  const MeshTopology sheet(sample::sheet(rows - 1, columns - 1));
  const auto points = sample::random_points<Rational>(sheet.vertices(), 3);
  std::vector<Point3> control;
  std::vector<Rational> first;
  for (const auto& p : points) {
    control.push_back({p[0].to_double(), p[1].to_double(), p[2].to_double()});
    first.push_back(p[0]);
  }
  for (const Rational& s : {Rational(1, 2), Rational(3, 2), Rational(-1, 4)}) {
    for (const int levels : {1, 2, 4}) {
      std::vector<double> expected = clamped_surface(first, rows, columns, s, levels);
      const IndexedMesh mesh = refine_mesh(sheet, control, jspline_mesh(s.to_double()), levels);
      std::vector<double> values;
      for (const Point3& p : mesh.points) values.push_back(p[0]);
      ASSERT_EQ(values.size(), expected.size());
      std::sort(values.begin(), values.end());
      std::sort(expected.begin(), expected.end());
      double largest = 0;
      for (std::size_t i = 0; i < values.size(); ++i)
        largest = std::max(largest, std::abs(values[i] - expected[i]));
      EXPECT_LT(largest, tolerance) << s.to_string() << ", " << levels;
    }
  }
}

TEST(BorderLayers, CornersAndNarrowMeshesAreContinued) {
  // A single quad and a strip: points beyond the far border are mirror images; the limit is at the corners.
  for (const auto& faces : {sample::sheet(1, 1), sample::sheet(1, 4), sample::sheet(2, 2)}) {
    const MeshTopology mesh(faces);
    const std::vector<Point3> points = sample::random_points<double>(mesh.vertices(), 9);
    for (const double s : {0.0, 0.5, 1.0, 1.5}) {
      const IndexedMesh limit = limit_mesh(mesh, points, jspline_mesh(s), 3);
      for (int v = 0; v < mesh.vertices(); ++v) {
        if (mesh.face_count(v) != 1) continue;
        for (std::size_t d = 0; d < 3; ++d) {
          EXPECT_NEAR(limit.points[static_cast<std::size_t>(v)][d], points[static_cast<std::size_t>(v)][d],
                      tolerance)
              << s;
        }
      }
    }
  }
}

TEST(BorderLayers, FacesAndHalfEdgesOfTheMeshKeepTheirNumbers) {
  // An L: its inner corner has three faces.
  const MeshTopology mesh(sample::polygons(8, {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}));
  const auto layers = border_layers(mesh, jspline_mesh(Rational(1, 2)).border_rules);
  ASSERT_GT(layers.mesh.half_edges(), mesh.half_edges());
  for (int h = 0; h < mesh.half_edges(); ++h) {
    EXPECT_EQ(layers.mesh.origin(h), mesh.origin(h));
    EXPECT_GE(layers.mesh.opposite(h), 0) << "nothing is at the border any more";
    if (mesh.opposite(h) >= 0) {
      EXPECT_EQ(layers.mesh.opposite(h), mesh.opposite(h));
    }
  }
  for (int v = 0; v < mesh.vertices(); ++v) EXPECT_EQ(layers.mesh.valence(v), v == 4 ? 5 : 4);
  EXPECT_EQ(layers.mesh.vertices(), mesh.vertices() + static_cast<int>(layers.added.size()));
  for (const auto& stencil : layers.added) EXPECT_EQ(stencil.sum(), Rational(1));
}

}  // namespace
}  // namespace subdiv
