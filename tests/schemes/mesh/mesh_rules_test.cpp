#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "schemes/algebra/rational_function.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/jspline.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/fan.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

using Points = std::vector<std::array<Rational, 3>>;

/// One step of a mask over a grid that is closed in both directions: tensor product of rows and columns.
Points tensor_step(const Mask<Rational>& mask, int rows, int columns, const Points& points) {
  Points fine(points.size() * 4, {Rational(0), Rational(0), Rational(0)});
  const int fine_columns = 2 * columns;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      for (int a = mask.symbol.first(); a <= mask.symbol.last(); ++a) {
        for (int b = mask.symbol.first(); b <= mask.symbol.last(); ++b) {
          const int row = ((2 * i + a) % (2 * rows) + 2 * rows) % (2 * rows);
          const int column = ((2 * j + b) % fine_columns + fine_columns) % fine_columns;
          const Rational weight = mask.symbol[a] * mask.symbol[b];
          for (std::size_t d = 0; d < 3; ++d) {
            fine[static_cast<std::size_t>(row * fine_columns + column)][d] +=
                weight * points[static_cast<std::size_t>(i * columns + j)][d];
          }
        }
      }
    }
  }
  return fine;
}

/// The largest difference of a mesh scheme on a torus of quads from the tensor product.
Rational difference_from_tensor(const MeshScheme<Rational>& scheme, const Mask<Rational>& mask) {
  constexpr int rows = 7;
  constexpr int columns = 8;
  const MeshTopology mesh(sample::torus(rows, columns, 4));
  const Points points = sample::random_points<Rational>(mesh.vertices(), 3);
  const Points refined = refined_points(mesh, scheme, points);
  const Points expected = tensor_step(mask, rows, columns, points);
  Rational largest(0);
  const auto compare = [&](int number, int row, int column) {
    for (std::size_t d = 0; d < 3; ++d) {
      const Rational difference = refined[static_cast<std::size_t>(number)][d] -
                                  expected[static_cast<std::size_t>(row * 2 * columns + column)][d];
      largest = std::max(largest, difference.sign() < 0 ? -difference : difference);
    }
  };
  for (int v = 0; v < mesh.vertices(); ++v) compare(v, 2 * (v / columns), 2 * (v % columns));
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const int v = mesh.origin(h);
    const int u = mesh.target(h);
    const bool along_rows = v / columns != u / columns;
    const int row =
        along_rows ? (u / columns == (v / columns + 1) % rows ? 2 * (v / columns) + 1 : 2 * (u / columns) + 1)
                   : 2 * (v / columns);
    const int column = along_rows ? 2 * (v % columns)
                                  : (u % columns == (v % columns + 1) % columns ? 2 * (v % columns) + 1
                                                                                : 2 * (u % columns) + 1);
    compare(mesh.vertices() + mesh.edge(h), row, column);
  }
  for (int f = 0; f < mesh.faces(); ++f)
    compare(mesh.vertices() + mesh.edges() + f, 2 * (f / columns) + 1, 2 * (f % columns) + 1);
  return largest;
}

TEST(MeshRules, DirectionalSchemeIsTheTensorProductOfJsWithItself) {
  for (const Rational& s : {Rational(0), Rational(1, 2), Rational(1), Rational(3, 2), Rational(-7, 5)})
    EXPECT_EQ(difference_from_tensor(jspline_mesh(s), jspline(s)), Rational(0)) << s.to_string();
}

TEST(MeshRules, LiteralBlendIsTheTensorProductOnlyAtItsTwoOperands) {
  for (const Rational& s : {Rational(0), Rational(1)})
    EXPECT_EQ(difference_from_tensor(jspline_mesh_literal(s), jspline(s)), Rational(0));
  EXPECT_NE(difference_from_tensor(jspline_mesh_literal(Rational(1, 2)), jspline(Rational(1, 2))),
            Rational(0));
}

TEST(MeshRules, BothBlendsAreCatmullClarkAtOneAndKobbeltAtZero) {
  const MeshTopology mesh(sample::quads_of(sample::joined(sample::bipyramid(5), sample::bipyramid(7))));
  const Points points = sample::random_points<Rational>(mesh.vertices(), 5);
  const Points spline = refined_points(mesh, catmull_clark<Rational>(), points);
  EXPECT_EQ(refined_points(mesh, jspline_mesh(Rational(1)), points), spline);
  EXPECT_EQ(refined_points(mesh, jspline_mesh_literal(Rational(1)), points), spline);
  const Points interpolating = refined_points(mesh, kobbelt<Rational>(), points);
  EXPECT_EQ(refined_points(mesh, jspline_mesh_literal(Rational(0)), points), interpolating);
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_EQ(interpolating[v], points[v]);
}

/// The face point of face 0 by the odd rule across the odd points of the edges h and its opposite, only.
Stencil<RationalFunction> one_way(const MeshTopology& mesh, int h, const OddRule<RationalFunction>& rule) {
  Stencil<RationalFunction> result;
  for (const int edge : {h, across(mesh, h)}) {
    result.add(odd_point(mesh, edge, rule), rule.inner);
    result.add(odd_point(mesh, across(mesh, mesh.opposite(edge)), rule), rule.outer);
  }
  return result;
}

bool same(const Stencil<RationalFunction>& a, const Stencil<RationalFunction>& b) {
  Stencil<RationalFunction> difference = a;
  difference.add(b, RationalFunction(-1));
  for (const auto& [vertex, weight] : difference.terms()) {
    if (!weight.is_zero()) return false;
  }
  return true;
}

TEST(MeshRules, FacePointsDoNotDependOnTheDirectionForOneWeightOfTheDiagonalsOnly) {
  OddRule<RationalFunction> rule(RationalFunction::variable(0));
  for (const int valence : {3, 5, 6, 9}) {
    const MeshTopology fan = fan_topology(4, valence, 5);
    int face = -1;
    for_each_outgoing(fan, 0, [&](int h) { face = fan.face(h); });
    const int h = fan.first(face);
    EXPECT_TRUE(same(one_way(fan, h, rule), one_way(fan, fan.next(h), rule))) << valence;
    OddRule<RationalFunction> other = rule;
    other.diagonal = RationalFunction(Rational(1, 5));
    EXPECT_FALSE(same(one_way(fan, h, other), one_way(fan, fan.next(h), other))) << valence;
  }
  EXPECT_EQ(OddRule<Rational>(Rational(0)).diagonal, Rational(1, 9)) << "Kobbelt 1996";
}

TEST(MeshRules, WeightsSumToOneOnEveryMesh) {
  const std::vector<MeshScheme<Rational>> quads{catmull_clark<Rational>(), kobbelt<Rational>(),
                                                jspline_mesh(Rational(2, 3)),
                                                jspline_mesh_literal(Rational(-1, 3))};
  const std::vector<MeshScheme<Rational>> triangles{loop<Rational>(), butterfly<Rational>()};
  const auto check = [](const MeshTopology& mesh, const MeshScheme<Rational>& scheme) {
    for_each_stencil(mesh, scheme, [&](int number, const Stencil<Rational>& stencil) {
      EXPECT_EQ(stencil.sum(), Rational(1)) << scheme.name << " " << number;
    });
  };
  for (const auto& scheme : quads) {
    check(MeshTopology(sample::quads_of(sample::bipyramid(6))), scheme);
    check(MeshTopology(sample::sheet(3, 2)), scheme);
    check(MeshTopology(sample::sheet(1, 1)), scheme);
  }
  for (const auto& scheme : triangles) {
    check(MeshTopology(sample::bipyramid(6)), scheme);
    check(MeshTopology(sample::tetrahedron()), scheme);
    check(MeshTopology(sample::polygons(3, {{0, 1, 2}})), scheme);
    check(MeshTopology(sample::polygons(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}})), scheme);
  }
}

/// The value of a polynomial of total degree `degree` at the place (x, y) of the triangle grid.
Rational polynomial(int degree, const Rational& x, const Rational& y) {
  Rational sum(0);
  for (int i = 0; i <= degree; ++i) {
    Rational term(i + 2);
    for (int k = 0; k < i; ++k) term *= x;
    for (int k = i; k < degree; ++k) term *= y;
    sum += term;
  }
  return sum;
}

/// One step on a regular fan: the new point on each inner edge against the polynomial there.
bool reproduces(const MeshScheme<Rational>& scheme, int degree) {
  const MeshTopology fan = fan_topology(3, 6, 5);
  const std::array<std::array<int, 2>, 7> spokes{
      {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}}};
  const auto places = sector_places(3, 5);
  std::vector<std::array<Rational, 2>> at(static_cast<std::size_t>(fan.vertices()));
  for (std::size_t v = 1; v < at.size(); ++v) {
    const std::size_t sector = (v - 1) / places.size();
    const FanPlace& p = places[(v - 1) % places.size()];
    for (std::size_t d = 0; d < 2; ++d)
      at[v][d] = Rational(p.a * spokes[sector][d] + p.b * spokes[sector + 1][d]);
  }
  std::vector<std::array<Rational, 1>> values;
  for (const auto& p : at) values.push_back({polynomial(degree, p[0], p[1])});
  for (int h = 0; h < fan.half_edges(); ++h) {
    const auto ring = [&](int v) {
      const auto& p = at[static_cast<std::size_t>(v)];
      return std::max({abs(p[0]), abs(p[1]), abs(p[0] + p[1])});
    };
    if (ring(fan.origin(h)) > Rational(2) || ring(fan.target(h)) > Rational(2)) continue;
    const auto& p = at[static_cast<std::size_t>(fan.origin(h))];
    const auto& q = at[static_cast<std::size_t>(fan.target(h))];
    const Rational expected = polynomial(degree, (p[0] + q[0]) / Rational(2), (p[1] + q[1]) / Rational(2));
    if (combine(scheme.edge_rule(fan, h), values)[0] != expected) return false;
  }
  return true;
}

TEST(MeshRules, ButterflyReproducesCubicsOnTheRegularGrid) {
  // Dyn, Levin, Gregory 1990: cubic precision at w = 1/16.
  for (const int degree : {1, 2, 3}) EXPECT_TRUE(reproduces(butterfly<Rational>(), degree)) << degree;
  EXPECT_FALSE(reproduces(butterfly<Rational>(), 4));
  EXPECT_TRUE(reproduces(loop<Rational>(), 1));
  EXPECT_FALSE(reproduces(loop<Rational>(), 2)) << "splines approximate";
}

/// Places (column, row) of a sheet: linear data in its vertices' order.
Points linear_data(int rows, int columns) {
  Points points;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) points.push_back({Rational(j), Rational(i), Rational(2 * i - 3 * j)});
  }
  return points;
}

TEST(MeshRules, LinearDataIsKeptUpToTheBorder) {
  constexpr int rows = 3;
  constexpr int columns = 4;
  PolygonFaces triangles;
  const PolygonFaces quads = sample::sheet(rows, columns);
  triangles.vertices = quads.vertices;
  for (std::size_t f = 0; f < quads.faces(); ++f) {
    const auto q = quads.face(f);
    triangles.add_face(std::array<long long, 3>{q[0], q[1], q[2]});
    triangles.add_face(std::array<long long, 3>{q[0], q[2], q[3]});
  }
  const Points points = linear_data(rows, columns);
  const auto check = [&](const MeshTopology& mesh, const MeshScheme<Rational>& scheme) {
    const Points refined = refined_points(mesh, scheme, points);
    // A vertex of two triangles at a corner of the sheet: the border runs on around it, and is not straight.
    const auto turns = [&](int v) {
      if (!mesh.is_border(v) || mesh.face_count(v) == 1) return false;
      const std::vector<int> around = neighbours(mesh, v);
      const auto& p = points[static_cast<std::size_t>(v)];
      const auto& a = points[static_cast<std::size_t>(around.front())];
      const auto& b = points[static_cast<std::size_t>(around.back())];
      return a[0] + b[0] != Rational(2) * p[0] || a[1] + b[1] != Rational(2) * p[1];
    };
    for (int v = 0; v < mesh.vertices(); ++v) {
      if (turns(v)) continue;
      EXPECT_EQ(refined[static_cast<std::size_t>(v)], points[static_cast<std::size_t>(v)]) << scheme.name;
    }
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.half_edge(e);
      if (mesh.opposite(h) < 0 && (turns(mesh.origin(h)) || turns(mesh.target(h)))) continue;
      const auto& p = points[static_cast<std::size_t>(mesh.origin(mesh.half_edge(e)))];
      const auto& q = points[static_cast<std::size_t>(mesh.target(mesh.half_edge(e)))];
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_EQ(refined[static_cast<std::size_t>(mesh.vertices() + e)][d], (p[d] + q[d]) / Rational(2))
            << scheme.name << ", edge of vertices " << mesh.origin(mesh.half_edge(e)) << " and "
            << mesh.target(mesh.half_edge(e));
      }
    }
  };
  for (const auto& scheme : {butterfly<Rational>(), loop<Rational>()}) check(MeshTopology(triangles), scheme);
  for (const auto& scheme : {catmull_clark<Rational>(), kobbelt<Rational>(), jspline_mesh(Rational(1, 2))})
    check(MeshTopology(quads), scheme);
}

TEST(MeshRules, BorderEdgesOfButterflyFollowTheFourPointScheme) {
  // A strip of triangles: new points on its straight sides are (-1, 9, 9, -1)/16 of four vertices in a row.
  const MeshTopology mesh(
      sample::polygons(8, {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6}, {3, 7, 6}}));
  for (int h = 0; h < mesh.half_edges(); ++h) {
    if (mesh.opposite(h) >= 0 || mesh.origin(h) != 1 || mesh.target(h) != 2) continue;
    const Stencil<Rational> stencil = butterfly<Rational>().edge_rule(mesh, h);
    EXPECT_EQ(stencil.weight(0), Rational(-1, 16));
    EXPECT_EQ(stencil.weight(1), Rational(9, 16));
    EXPECT_EQ(stencil.weight(2), Rational(9, 16));
    EXPECT_EQ(stencil.weight(3), Rational(-1, 16));
  }
}

TEST(MeshRules, LoopsWeightsAgreeWhereTheFormulasDo) {
  // 5/8 - (3/8 + cos(2 pi/n)/4)^2 = 9/16 at n = 3 and 3/8 at n = 6; Warren's exception is Loop's value.
  for (const int n : {3, 6}) {
    const MeshTopology fan = fan_topology(3, n, 2);
    EXPECT_EQ(loop<Rational>().vertex_rule(fan, 0).weight(0),
              loop_1987<Rational>().vertex_rule(fan, 0).weight(0));
  }
  const MeshTopology fan = fan_topology(3, 8, 2);
  const Stencil<Rational> stencil = loop<Rational>().vertex_rule(fan, 0);
  EXPECT_EQ(stencil.weight(0), Rational(5, 8));
  EXPECT_EQ(stencil.weight(fan.target(fan.outgoing(0))), Rational(3, 64)) << "notes 4: 3/(8*8)";
}

}  // namespace
}  // namespace subdiv
