#include "experiments/surfaces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "analysis/limit_mask.h"
#include "experiments/grid_data.h"
#include "experiments/surface_pictures.h"
#include "schemes/evaluate/grid_ringing.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::find_claim;
using test::find_series;
using test::value_of;

/// One step of J_{a,b} on a closed grid along both directions, from the stencils of jsplines 1;
/// [row][column].
using Table = std::vector<std::vector<Vector3d>>;

Table transposed_table(const Table& table) {
  Table result(table[0].size());
  for (const auto& row : table)
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  return result;
}

Table refine_rows(const Table& table, double a, double b) {
  Table result;
  for (const auto& row : table) {
    const std::size_t n = row.size();
    const auto at = [&](std::size_t i) { return row[i % n]; };
    result.emplace_back();
    for (std::size_t i = n; i < 2 * n; ++i) {
      result.back().emplace_back((a * at(i - 1) + (8 - 2 * a) * at(i) + a * at(i + 1)) / 8);
      result.back().emplace_back(
          ((b - 1) * at(i - 1) + (9 - b) * at(i) + (9 - b) * at(i + 1) + (b - 1) * at(i + 2)) / 16);
    }
  }
  return result;
}

Table refine(const Table& table, double a, double b) {
  return transposed_table(refine_rows(transposed_table(refine_rows(table, a, b)), a, b));
}

Table table_of(const ControlGrid<SpacePoint>& grid) {
  Table table;
  for (const auto& line : grid.lines) {
    table.emplace_back();
    for (const SpacePoint& p : line.points) table.back().push_back(rounded(p));
  }
  return table;
}

DoubleGrid grid_of(const std::string& file) { return map_points(grid_from_data(file), rounded); }
Scheme<double> j(double s) { return stationary("J", jspline(s)); }

class Surfaces : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_surfaces();
    return all;
  }
  static const std::vector<Claim>& claims() { return results().claims; }
  static Verdict verdict(const std::string& id) { return find_claim(claims(), id).verdict; }
};

TEST_F(Surfaces, EveryHeadIsSettledOnce) {
  std::set<std::string> ids;
  for (const Claim& claim : claims()) EXPECT_TRUE(ids.insert(claim.head.id).second);
  EXPECT_EQ(ids.size(), surface_heads().size());
  for (const ClaimHead& head : surface_heads()) EXPECT_TRUE(ids.contains(head.id)) << head.id;
}

TEST_F(Surfaces, FootprintsAreAsPrinted) {
  EXPECT_EQ(verdict("ringing.footprint.surface"), Verdict::reproduced);
  EXPECT_EQ(verdict("ringing.rings"), Verdict::reproduced);
  EXPECT_EQ(verdict("ringing.footprint.surface.once"), Verdict::established);
  EXPECT_EQ(verdict("ringing.footprint.surface.borders"), Verdict::established);
  EXPECT_EQ(verdict("ringing.same-surface"), Verdict::established);
}

TEST_F(Surfaces, ThePrintedConstructionDoesEverythingTwice) {  // 4 columns, 5 steps: 4 x 32 curves
  const Claim& printed = find_claim(claims(), "ringing.no-redundancy.surface");
  EXPECT_EQ(printed.verdict, Verdict::refuted);
  EXPECT_EQ(printed.exact, "256 evaluations of 128 transversal curves");
  const Claim& once = find_claim(claims(), "ringing.no-redundancy.surface.once");
  EXPECT_EQ(once.verdict, Verdict::established);
  EXPECT_EQ(once.exact, "128 evaluations of 128 transversal curves");
}

TEST_F(Surfaces, ToriCylindersAndDisks) {  // 9 x 4^4 vertices; 33 x 48 and 33 x 33 with borders
  EXPECT_EQ(find_claim(claims(), "ringing.minimum-input.torus").exact, "2304 - 4608 + 2304 = 0, 0 borders");
  EXPECT_EQ(find_claim(claims(), "ringing.borders.cylinder").exact, "1584 - 3120 + 1536 = 0, 2 borders");
  EXPECT_EQ(find_claim(claims(), "ringing.borders.disk").exact, "1089 - 2112 + 1024 = 1, 1 borders");
  for (const char* id : {"ringing.minimum-input.torus", "ringing.borders.cylinder", "ringing.borders.disk"})
    EXPECT_EQ(verdict(id), Verdict::reproduced);
}

TEST_F(Surfaces, GeomorphsHideThePop) {
  EXPECT_EQ(verdict("popping.geomorph"), Verdict::reproduced);
  EXPECT_EQ(verdict("popping.geomorph.surface"), Verdict::established);
  // Radii 7, 5, 3, 5 and right angles: |R_1 - R_0| |(1,0) - (0,1)| / 4 = 2 sqrt(2) / 4; heights cancel.
  EXPECT_EQ(find_claim(claims(), "popping.geomorph.triangles").exact, "1/2");
}

TEST_F(Surfaces, JumpsOfTheSeriesFollowFromTheStencils) {  // second route, over double
  const Table torus = table_of(grid_from_data("surface-torus.csv"));
  for (const auto& row : find_series(results(), "surface-geomorph").rows) {
    const double s = std::stod(row[1]);
    const Table before = row[0] == "1" ? torus : refine(torus, s, s);
    const Table flat = refine(before, 0, 1);
    const Table fine = refine(before, s, s);
    double jump = 0;
    for (std::size_t i = 0; i < fine.size(); ++i)
      for (std::size_t k = 0; k < fine[i].size(); ++k)
        jump = std::max(jump, (fine[i][k] - flat[i][k]).squaredNorm());
    EXPECT_NEAR(std::stod(row[2]), jump, 1e-8);
    EXPECT_NEAR(std::stod(row[3]), jump / 16, 1e-8);
  }
}

TEST_F(Surfaces, SilhouettesPopLeastNearThreeEighths) {
  EXPECT_EQ(verdict("popping.silhouettes"), Verdict::consistent);
  EXPECT_EQ(verdict("popping.silhouettes.s"), Verdict::consistent);
  EXPECT_NEAR(value_of(claims(), "popping.silhouettes.s"), 0.375, 1e-12);
  const double share = value_of(claims(), "popping.silhouettes");
  EXPECT_NEAR(share * 40, std::round(share * 40), 1e-9);
}

TEST_F(Surfaces, FourTimesAsManyLinesGiveTheSameShare) {
  int smaller = 0;
  for (const ViewedGrid& surface : rough_tori(2026, 40)) {
    const auto disparity = [&](double s) {
      return silhouette_disparity(surface.grid, j(s), 2, view_from(surface.direction), 1600);
    };
    const double middle = disparity(0.375);
    smaller += middle < disparity(0) && middle < disparity(1) ? 1 : 0;
  }
  EXPECT_NEAR(value_of(claims(), "popping.silhouettes"), smaller / 40.0, 1e-9);
}

TEST_F(Surfaces, AGeomorphDividesTheChangeOfSilhouettes) {
  const Series& series = find_series(results(), "surface-geomorph-silhouettes");
  const DoubleGrid grid = grid_of("surface-torus.csv");
  const View view = view_from({2, -5, 4});
  for (std::size_t column = 1; column < 4; ++column) {
    double last = 1;
    for (const auto& row : series.rows) {
      EXPECT_LT(std::stod(row[column]), 0.75 * last);  // halved or nearly so
      last = std::stod(row[column]);
    }
  }
  // Without pictures in between: the pop from level 1, its quads divided at their bilinear centres, to 2.
  const Table before = refine(table_of(grid_from_data("surface-torus.csv")), 1, 1);
  const auto picture = [&](const Table& table) {
    std::vector<PictureTriangle> result;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const auto& next = table[(i + 1) % table.size()];
      for (std::size_t k = 0; k < next.size(); ++k) {
        const std::size_t l = (k + 1) % next.size();
        append_quad(result, view, table[i][k], table[i][l], next[l], next[k]);
      }
    }
    return result;
  };
  const PictureAreas areas =
      compare_pictures(picture(refine(before, 0, 1)), picture(refine(before, 1, 1)), 1000);
  EXPECT_NEAR(std::stod(series.rows[0][3]), areas.difference / areas.first, 1e-6);
}

bool covers(const std::vector<PictureTriangle>& picture, const Vector2d& p) {
  return std::ranges::any_of(picture, [&](const PictureTriangle& t) {
    int left = 0;
    int right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d edge = t[(k + 1) % 3] - t[k];
      const Vector2d to = p - t[k];
      (edge.x() * to.y() - edge.y() * to.x() > 0 ? left : right)++;
    }
    return left == 0 || right == 0;
  });
}

TEST(SurfacePopping, DisparityAgreesWithAGridOfPoints) {  // second route
  const std::vector<ViewedGrid> surfaces = rough_tori(2026, 2);
  for (const ViewedGrid& surface : surfaces) {
    const View view = view_from(surface.direction);
    const auto before = picture_of(surface.grid, j(1), 0, view);
    const auto after = picture_of(surface.grid, j(1), 1, view);
    int one = 0;
    int earlier = 0;
    constexpr double half = 40;
    constexpr int n = 300;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const Vector2d p(half * ((2 * i + 1.0) / n - 1), half * ((2 * k + 1.0) / n - 1));
        const bool in_before = covers(before, p);
        earlier += in_before ? 1 : 0;
        one += in_before != covers(after, p) ? 1 : 0;
      }
    }
    const double by_lines = silhouette_disparity(surface.grid, j(1), 1, view, 400);
    EXPECT_NEAR(by_lines, static_cast<double>(one) / earlier, 0.01);
    EXPECT_NEAR(by_lines, silhouette_disparity(surface.grid, j(1), 1, view, 4000), 1e-3);
  }
}

TEST(SurfacePopping, TrianglesThatRunOneWayCoverThePicture) {
  for (const ViewedGrid& surface : rough_tori(7, 3)) {
    const View view = view_from(surface.direction);
    std::vector<PictureTriangle> all;
    for (const SpaceQuad& quad : space_quads(surface.grid, j(0.5), 2))
      append_quad(all, view, quad.corners[0], quad.corners[1], quad.corners[2], quad.corners[3]);
    const auto half = picture_of(surface.grid, j(0.5), 2, view);
    EXPECT_LT(half.size(), all.size());
    const PictureAreas areas = compare_pictures(all, half, 200);
    EXPECT_LT(areas.difference, 1e-12 * areas.first);
  }
}

TEST(SurfacePopping, TheFamilyIsAsStated) {
  const std::vector<ViewedGrid> surfaces = rough_tori(2026, 40);
  ASSERT_EQ(surfaces.size(), 40U);
  for (const ViewedGrid& surface : surfaces) {
    for (const std::size_t n : {surface.grid.rows.points, surface.grid.columns().points}) {
      EXPECT_GE(n, 4U);
      EXPECT_LE(n, 7U);
    }
    for (const auto& line : surface.grid.lines) {
      for (const Vector3d& p : line.points) {
        EXPECT_EQ(p, p.array().round().matrix());
        const double radius = std::hypot(p.x(), p.y());
        EXPECT_LT(std::hypot(radius - 20, p.z()), 8 + 3 * std::sqrt(3.0) + 1);  // rounded, and moved
      }
    }
    EXPECT_LE(surface.direction.cwiseAbs().maxCoeff(), 9);
    EXPECT_GT(surface.direction.head<2>().norm(), 0);
  }
}

/// Row r's trajectory in the figure: 4 x 8 points and the first again, and an empty row; two panels.
TEST_F(Surfaces, TrajectoriesOfTheFigureAreSumsOfBasisFunctions) {
  const Series& series = find_series(results(), "surface-torus-trajectories");
  const ControlGrid<SpacePoint> grid = grid_from_data("surface-torus.csv");
  const Laurent<Rational> basis = iterated_symbol(stationary("J", jspline(Rational(1))), 3);
  const View view = view_from({2, -5, 4});
  ASSERT_EQ(series.rows.size(), 4U * 2U * 34U);
  for (std::size_t line = 0; line < 8; ++line) {
    for (std::size_t i = 0; i < 33; ++i) {
      const auto& row = series.rows[line * 34 + i];
      SpacePoint sum(Rational(0), Rational(0), Rational(0));
      for (int c = -8; c < 12; ++c)
        sum = sum + basis[static_cast<int>(i) - 8 * c] * grid.at(static_cast<long long>(line / 2), c);
      const Vector3d p = rounded(sum);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::stod(row[2 + static_cast<std::size_t>(k)]), p[k], 1e-6);
      const Vector2d place = Vector2d(line % 2 == 0 ? 0 : 200, 0) + 11 * view.project(p);
      EXPECT_NEAR(std::stod(row[0]), place.x(), 0.051);
      EXPECT_NEAR(std::stod(row[1]), place.y(), 0.051);
    }
  }
}

TEST_F(Surfaces, VerticesTendToTheTensorProductOfLimitMasks) {  // the torus of figure 15, *J_1
  const ControlGrid<SpacePoint> exact_grid = grid_from_data("surface-torus.csv");
  const DoubleGrid grid = grid_of("surface-torus.csv");
  const Laurent<Rational> limit = limit_mask(jspline(Rational(1)));
  SpacePoint expected(Rational(0), Rational(0), Rational(0));
  for (int i = -2; i <= 2; ++i)
    for (int k = -2; k <= 2; ++k) expected = expected + (limit[i] * limit[k]) * exact_grid.at(1 + i, 2 + k);
  std::vector<Vector3d> vertices;
  const Refinement<double> fine{j(1), 7};
  const SurfaceSize size = surface_size(grid, fine, fine);
  stream_surface(grid, fine, fine, [&](const Vector3d& p) { vertices.push_back(p); }, [](const auto&) {});
  EXPECT_NEAR((vertices[size.vertex(2 * 128, 1 * 128)] - rounded(expected)).norm(), 0, 1e-3);
}

TEST_F(Surfaces, FiguresAreComplete) {
  std::set<std::string> names;
  for (const Figure& figure : results().figures) names.insert(figure.name);
  EXPECT_EQ(names,
            (std::set<std::string>{"surface-torus", "surface-rows", "surface-borders", "surface-silhouettes",
                                   "surface-silhouette-disparity", "surface-geomorph-silhouettes"}));
}

TEST(SurfacePictures, QuadsStandInOrderOfDepthAndFaceTheEye) {
  const Placement front{view_from({0, -1, 0}), 1, {0, 0}};
  // A cube's front and back, outwards.
  const SpaceQuad near{{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 0, 1), Vector3d(0, 0, 1)}, 0, 0};
  const SpaceQuad far{{Vector3d(0, 1, 0), Vector3d(0, 1, 1), Vector3d(1, 1, 1), Vector3d(1, 1, 0)}, 0, 1};
  Series closed = polygons("closed");
  add_quads(closed, {near, far}, true, front, Paint::flat, 0x102030);
  ASSERT_EQ(closed.rows.size(), 5U);
  EXPECT_EQ(closed.rows[2], (std::vector<std::string>{"1.0", "1.0", std::to_string(0x102030)}));
  Series open = polygons("open");
  add_quads(open, {near, far}, false, front, Paint::flat, 0x102030);
  ASSERT_EQ(open.rows.size(), 10U);
  EXPECT_EQ(open.rows[1][1], "1.0");  // the far one first: it rises to its second corner
}

TEST(GridData, MissingFilesAreNamed) { EXPECT_THROW((void)grid_from_data("no-such.csv"), InputError); }

}  // namespace
}  // namespace subdiv
