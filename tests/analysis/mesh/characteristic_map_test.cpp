#include "analysis/mesh/characteristic_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "analysis/mesh/derivative_bound.h"
#include "analysis/mesh/lattice_limits.h"

namespace subdiv {
namespace {

MeshSchemeForms forms(const std::string& name) { return mesh_scheme_forms(parse_mesh_scheme(name)); }

MeshScheme<double> rounded(const std::string& name) { return forms(name).rounded; }

std::optional<LatticeSpline> spline_of(const std::string& name) {
  const MeshSchemeForms scheme = forms(name);
  return spline_with_mask(lattice_mask(*scheme.exact), scheme.exact->split == MeshSplit::quads ? 4 : 3);
}

/// The enclosed net of the leading eigenvalue of a mode.
CharacteristicNet<Interval> enclosed_net(const std::string& name, int valence, int mode, int rings) {
  const MeshScheme<Interval> scheme = forms(name).enclosed;
  const int inner = 2 * scheme.reach + 1;
  const auto core = static_cast<Eigen::Index>(
      sector_places(scheme.split == MeshSplit::quads ? 4 : 3, eigenvalue_rings(scheme)).size());
  const FanMatrix<Interval> fan = fan_matrix(scheme, valence, inner);
  const Matrix<Interval> matrix = mode_matrix(fan, mode);
  const Matrix<double> computed = mode_matrix(fan_matrix(rounded(name), valence, inner), mode);
  const RealEigenpair<Interval> pair = enclosed_eigenpair(
      matrix.topLeftCorner(core, core), dominant_eigenpair(computed.topLeftCorner(core, core)));
  EXPECT_EQ(pair.missing, "");
  return characteristic_net(fan, matrix, mode, pair, lattice_mask(scheme), rings);
}

/// A net with the values of another one, changed.
CharacteristicNet<Interval> changed(
    const CharacteristicNet<Interval>& net,
    const std::function<PlaneNumber<Interval>(int, int, const PlaneNumber<Interval>&)>& change) {
  CharacteristicNet<Interval> result(net.sides(), net.valence(), net.mode(), net.eigenvalue());
  for (int ring = 1; ring <= net.rings(); ++ring)
    result.add_ring([&](int a, int b) { return change(a, b, net.at(a, b)); });
  return result;
}

void expect_smooth(const CharacteristicMap& map, Rigour rigour) {
  EXPECT_EQ(map.missing, "");
  EXPECT_EQ(map.regular, Decision::yes);
  EXPECT_EQ(map.injective, Decision::yes);
  EXPECT_EQ(map.winding, 1);
  EXPECT_EQ(map.rigour, rigour);
}

double evaluate(const SquarePatch& f, double u, double v) {
  const auto basis = [](int n, int i, double t) {
    return std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1)) * std::pow(t, i) *
           std::pow(1 - t, n - i);
  };
  double sum = 0;
  for (int i = 0; i <= f.degree_u(); ++i) {
    for (int j = 0; j <= f.degree_v(); ++j)
      sum += basis(f.degree_u(), i, u) * basis(f.degree_v(), j, v) * f(i, j).to_double();
  }
  return sum;
}

double evaluate(const TrianglePatch& f, double u, double v) {
  double sum = 0;
  const int n = f.degree();
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const double coefficient =
          std::tgamma(n + 1) / (std::tgamma(i + 1) * std::tgamma(j + 1) * std::tgamma(n - i - j + 1));
      sum += coefficient * std::pow(u, i) * std::pow(v, j) * std::pow(1 - u - v, n - i - j) *
             f(i, j).to_double();
    }
  }
  return sum;
}

TEST(CharacteristicMap, SplinesAreFoundByTheirMasksNotByNames) {
  EXPECT_EQ(spline_of("catmull-clark")->degree, 3);
  EXPECT_EQ(spline_of("jspline-mesh:s=1")->degree, 3);
  EXPECT_EQ(spline_of("jspline-mesh-literal:s=1")->degree, 3);
  EXPECT_EQ(spline_of("jspline-mesh:s=3/2")->degree, 5);
  EXPECT_EQ(spline_of("loop")->sides, 3);
  EXPECT_EQ(spline_of("loop-1987")->degree, 4);
  for (const char* name : {"kobbelt", "jspline-mesh:s=1/2", "jspline-mesh-literal:s=3/2", "butterfly",
                           "jspline-mesh:s=1500001/1000000"})
    EXPECT_FALSE(spline_of(name)) << name;
  EXPECT_FALSE(forms("jspline-mesh:s=sqrt(2)").exact);
}

TEST(CharacteristicMap, IsTheIdentityAtRegularVertices) {
  for (const char* name : {"catmull-clark", "jspline-mesh:s=3/2", "loop", "loop-1987"}) {
    const LatticeSpline spline = *spline_of(name);
    const CharacteristicNet<Interval> net = enclosed_net(name, spline.sides == 4 ? 4 : 6, 1, 9);
    EXPECT_TRUE(net.eigenvalue().contains(Rational(1, 2)));
    const Interval area = determinant(net.at(1, 0), net.at(0, 1));
    for (const LatticeCell& cell : ring_cells(spline.sides, spline.sides == 4 ? 3 : 2)) {
      const SquarePatch values = jacobian(net, spline, cell);
      for (const Interval& c : values.coefficients()) {
        EXPECT_TRUE(c.overlaps(area)) << name;
        EXPECT_LT(c.radius(), 1e-20) << name;
      }
    }
  }
  for (const char* name : {"kobbelt", "jspline-mesh:s=1/2", "jspline-mesh-literal:s=1/2"})
    EXPECT_NEAR(sampled_characteristic_map(rounded(name), 4).jacobian_ratio, 1, 1e-9) << name;
  EXPECT_NEAR(sampled_characteristic_map(rounded("butterfly"), 6).jacobian_ratio, 1, 1e-9);
}

// Eigenvalues in closed form: Peters, Reif: Subdivision Surfaces (2008), sections 6.1 and 6.2.
TEST(CharacteristicMap, EnclosesTheKnownEigenvalues) {
  for (const int n : {3, 5, 7, 30}) {
    const Interval c = cosine_of_turn<Interval>(1, n);
    const Interval half_turn = cosine_of_turn<Interval>(1, 2 * n);
    const Interval quads =
        (Interval(5) + c + half_turn * sqrt(Interval(2) * (Interval(9) + c))) * fraction<Interval>(1, 16);
    EXPECT_TRUE(characteristic_map(forms("catmull-clark"), n).eigenvalue.overlaps(quads));
    const Interval triangles = fraction<Interval>(3, 8) + fraction<Interval>(1, 4) * c;
    EXPECT_TRUE(characteristic_map(forms("loop"), n).eigenvalue.overlaps(triangles));
    EXPECT_LT(characteristic_map(forms("loop"), n).eigenvalue.radius(), 1e-25);
  }
}

TEST(CharacteristicMap, SplineSchemesAreProvedRegularAndInjective) {
  for (const char* name : {"catmull-clark", "jspline-mesh:s=1", "jspline-mesh:s=3/2", "loop", "loop-1987"}) {
    const MeshSchemeForms scheme = forms(name);
    for (const int n : {3, 4, 5, 6, 7, 12, 30, 100}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(n));
      const CharacteristicMap map = characteristic_map(scheme, n);
      expect_smooth(map, Rigour::certified);
      EXPECT_EQ(map.mode, 1);
      // The two routes see the same Jacobians: those of samples lie among the Bernstein coefficients.
      const CharacteristicMap sampled = sampled_characteristic_map(scheme.rounded, n);
      expect_smooth(sampled, Rigour::approximate);
      EXPECT_GT(map.jacobian_ratio, 0);
      EXPECT_LE(map.jacobian_ratio, sampled.jacobian_ratio + 1e-9);
      EXPECT_GT(map.jacobian_ratio, sampled.jacobian_ratio - 0.2);
    }
  }
}

TEST(CharacteristicMap, OthersAreProvedByDiscsOfDerivatives) {
  for (const char* name :
       {"kobbelt", "jspline-mesh:s=-1/4", "jspline-mesh:s=1/2", "jspline-mesh-literal:s=1/2"}) {
    for (const int n : {3, 5, 8}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(n));
      expect_smooth(characteristic_map(forms(name), n), Rigour::certified);
    }
  }
}

TEST(CharacteristicMap, SchemesWithoutExactFormAreSampled) {
  for (const int n : {3, 5, 8, 20})
    expect_smooth(characteristic_map(forms("jspline-mesh:s=sqrt(2)"), n), Rigour::approximate);
}

// Splines are known in two ways: by pieces and by discs.
TEST(CharacteristicMap, DiscsAgreeWithBernsteinCoefficients) {
  for (const char* name : {"catmull-clark", "jspline-mesh:s=3/2", "loop"}) {
    SCOPED_TRACE(name);
    const MeshSchemeForms scheme = forms(name);
    const std::optional<DerivativeBounds> bounds = derivative_bounds(lattice_mask(*scheme.exact));
    ASSERT_TRUE(bounds);
    const LatticeMask<Interval> mask = trimmed(lattice_mask(scheme.enclosed));
    for (const int n : {3, 7}) {
      const CharacteristicNet<Interval> net = enclosed_net(name, n, 1, 2 * scheme.enclosed.reach + 2);
      expect_smooth(enclosed_verdict(net, mask, *bounds, 6), Rigour::certified);
    }
    const CharacteristicMap twice =
        enclosed_verdict(enclosed_net(name, 7, 2, 2 * scheme.enclosed.reach + 2), mask, *bounds, 6);
    EXPECT_EQ(twice.winding, 2);
    EXPECT_NE(twice.injective, Decision::yes);
  }
}

TEST(DerivativeBound, FactorsAreAboveTheNormsOfKnownBasisFunctions) {
  // B-splines are not negative: the norms are 1, and a bound comes close to it.
  const LatticeWindow cubic = *lattice_window(spline_mask({4, 3}));
  EXPECT_GE(cubic.factor, 1);
  EXPECT_LT(cubic.factor, 1.4);
  EXPECT_EQ(cubic.first, (LatticeOffset{-1, -1}));
  EXPECT_EQ(cubic.size, (LatticeOffset{4, 4}));
  // The derivative scheme of the cubic B-spline along a direction is the quadratic one in it.
  const LatticeMask<Rational> quadratic = *derivative_scheme(spline_mask({4, 3}), true);
  const std::array<Rational, 4> chaikin{Rational(1, 4), Rational(3, 4), Rational(3, 4), Rational(1, 4)};
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(quadratic(i - 1, 0), chaikin.at(static_cast<std::size_t>(i)) * Rational(3, 4));
  // Limits that are not C^1 have no bounds: the four-point scheme's neighbour J_{-2}, and the hat function.
  EXPECT_FALSE(derivative_bounds(lattice_mask(*forms("jspline-mesh:s=-2").exact)));
  EXPECT_FALSE(derivative_bounds(spline_mask({4, 1})));
}

// The net of rings that one step of the scheme makes of a mesh is the net times the eigenvalue.
TEST(CharacteristicMap, NetsAreEigenvectors) {
  for (const char* name : {"catmull-clark", "jspline-mesh:s=1/2", "loop", "butterfly"}) {
    const MeshScheme<double> scheme = rounded(name);
    for (const int n : {4, 5, 7}) {
      constexpr int rings = 8;
      const CharacteristicNet<double> net = *characteristic_net(scheme, n, rings);
      const MeshTopology mesh = fan_topology(net.sides(), n, rings);
      const std::vector<FanPlace> places = sector_places(net.sides(), rings);
      std::vector<std::array<double, 2>> points{{0, 0}};
      for (int k = 0; k < n; ++k) {
        const PlaneNumber<double> w = turn<double>(net.mode() * k, n);
        for (const FanPlace& place : places) {
          const PlaneNumber<double> p = w * net.at(place.a, place.b);
          points.push_back({p.x, p.y});
        }
      }
      const std::vector<std::array<double, 2>> fine = refined_points(mesh, scheme, points);
      const MeshTopology fine_mesh = split(mesh, scheme.split);
      int spoke = -1;
      for_each_outgoing(fine_mesh, 0, [&](int h) {
        const auto& p = fine[static_cast<std::size_t>(fine_mesh.target(h))];
        if (p[0] > 0 && std::abs(p[1]) < 1e-9) spoke = h;
      });
      ASSERT_GE(spoke, 0);
      const std::vector<int> order = *fan_vertices(fine_mesh, spoke, rings);
      for (std::size_t p = 0; p < places.size(); ++p) {
        const PlaneNumber<double> v = net.at(places[p].a, places[p].b);
        const auto& found = fine[static_cast<std::size_t>(order[p + 1])];
        EXPECT_NEAR(found[0], net.eigenvalue() * v.x, 1e-9) << name;
        EXPECT_NEAR(found[1], net.eigenvalue() * v.y, 1e-9) << name;
      }
    }
  }
}

// f(x) = lambda^2 f(4 x), and the net has limit points at the lattice points 4 x.
TEST(CharacteristicMap, PiecesAgreeWithRepeatedSubdivision) {
  for (const char* name : {"catmull-clark", "jspline-mesh:s=3/2", "loop"}) {
    constexpr int n = 5;
    const LatticeSpline spline = *spline_of(name);
    const CharacteristicNet<Interval> net = enclosed_net(name, n, 1, 9);
    const CharacteristicNet<double> fine = *characteristic_net(rounded(name), n, 30);
    const LatticeLimits limits = *lattice_limits(rounded(name));
    const double lambda = fine.eigenvalue();
    const double scale = lambda * lambda * net.at(1, 0).x.to_double() / fine.at(1, 0).x;
    const int r = spline.sides == 4 ? 3 : 2;
    for (const LatticeCell& cell : ring_cells(spline.sides, r)) {
      for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= (spline.sides == 4 ? 4 : 4 - i); ++j) {
          const double u = i / 4.0;
          const double v = j / 4.0;
          const int a = cell.upright ? 4 * cell.a + i : 4 * cell.a + 4 - i;
          const int b = cell.upright ? 4 * cell.b + j : 4 * cell.b + 4 - j;
          const PlaneNumber<double> limit = scale * limits.point(fine, a, b);
          if (spline.sides == 4) {
            const auto [x, y] = square_piece(net, spline.degree, cell);
            EXPECT_NEAR(evaluate(x, u, v), limit.x, 1e-9) << name;
            EXPECT_NEAR(evaluate(y, u, v), limit.y, 1e-9) << name;
          } else {
            const auto [x, y] = triangle_piece(net, cell);
            EXPECT_NEAR(evaluate(x, u, v), limit.x, 1e-9) << name;
            EXPECT_NEAR(evaluate(y, u, v), limit.y, 1e-9) << name;
          }
        }
      }
    }
  }
}

TEST(CharacteristicMap, RefutesWrongNets) {
  for (const char* name : {"catmull-clark", "jspline-mesh:s=3/2", "loop"}) {
    SCOPED_TRACE(name);
    const LatticeSpline spline = *spline_of(name);
    const int row = spline.sides == 4 ? 3 : 2;
    const CharacteristicNet<Interval> net = enclosed_net(name, 7, 1, 9);
    EXPECT_EQ(spline_verdict(net, spline, row).injective, Decision::yes);

    const CharacteristicMap twice = spline_verdict(enclosed_net(name, 7, 2, 9), spline, row);
    EXPECT_EQ(twice.winding, 2);
    EXPECT_EQ(twice.injective, Decision::no);

    // Mirrored about the bisector of the sector, each sector on its own: the wrong way around.
    const CharacteristicNet<Interval> mirrored =
        changed(net, [&](int a, int b, const PlaneNumber<Interval>& /*v*/) { return net.at(b, a); });
    EXPECT_NE(spline_verdict(mirrored, spline, row).injective, Decision::yes);
    EXPECT_NE(spline_verdict(mirrored, spline, row).regular, Decision::yes);

    // Folded along a row.
    const CharacteristicNet<Interval> folded =
        changed(net, [&](int a, int b, const PlaneNumber<Interval>& v) {
          return net.ring_of(a, b) == row + 1 ? fraction<Interval>(1, 4) * v : v;
        });
    EXPECT_EQ(spline_verdict(folded, spline, row).regular, Decision::no);
    EXPECT_EQ(spline_verdict(folded, spline, row).injective, Decision::no);

    // All in one point: no sign at all.
    const CharacteristicNet<Interval> point =
        changed(net, [](int, int, const PlaneNumber<Interval>& v) { return Interval(0) * v; });
    EXPECT_EQ(spline_verdict(point, spline, row).regular, Decision::undecided);
    EXPECT_EQ(spline_verdict(point, spline, row).injective, Decision::undecided);
  }
}

TEST(CharacteristicMap, WrongEigenvectorsAreNoticed) {
  const Matrix<Interval> matrix = mode_matrix(fan_matrix(forms("catmull-clark").enclosed, 5, 2), 1);
  const RealEigenpair<double> right =
      dominant_eigenpair(mode_matrix(fan_matrix(rounded("catmull-clark"), 5, 2), 1));
  EXPECT_EQ(enclosed_eigenpair(matrix, right).missing, "");
  RealEigenpair<double> wrong = right;
  wrong.vector(1) += 1e-3;
  EXPECT_NE(enclosed_eigenpair(matrix, wrong).missing, "");
  wrong = right;
  wrong.value += 1e-3;
  EXPECT_NE(enclosed_eigenpair(matrix, wrong).missing, "");
}

TEST(CharacteristicMap, EigenvaluesThatAreNotSimpleHaveNone) {
  Matrix<double> jordan(2, 2);
  jordan << 0.25, 1, 0, 0.25;
  EXPECT_NE(dominant_eigenpair(jordan).missing, "");
  RealEigenpair<double> computed{"", 0.25, Vector<double>::Unit(2, 0)};
  const Matrix<Interval> enclosed = jordan.unaryExpr([](double x) { return Interval(x); });
  EXPECT_NE(enclosed_eigenpair(enclosed, computed).missing, "");
  // notes 5: a Jordan block at valence 3.
  EXPECT_FALSE(characteristic_map(forms("butterfly"), 3).exists());
  EXPECT_FALSE(characteristic_map(forms("jspline-mesh:s=6"), 20).exists());
  EXPECT_THROW(characteristic_map(forms("loop"), 2), std::invalid_argument);
}

// From valence 8 on mode 2 has the larger eigenvalue (notes 5); two turns of the map at valence 8 are the one
// at valence 4.
TEST(CharacteristicMap, ButterflyWindsTwice) {
  for (const int n : {4, 5, 6, 7})
    expect_smooth(sampled_characteristic_map(rounded("butterfly"), n), Rigour::approximate);
  const CharacteristicMap map = characteristic_map(forms("butterfly"), 8);
  EXPECT_EQ(map.mode, 2);
  EXPECT_EQ(map.winding, 2);
  EXPECT_EQ(map.regular, Decision::yes);
  EXPECT_EQ(map.injective, Decision::no);
  EXPECT_LT(map.eigenvalue_of_mode_1, map.eigenvalue.to_double());
  EXPECT_NEAR(map.eigenvalue.to_double(), characteristic_map(forms("butterfly"), 4).eigenvalue.to_double(),
              1e-12);
}

SquarePatch square(const std::vector<int>& quadratic) {
  SquarePatch f(2, 2);
  for (int i = 0; i <= 2; ++i) {
    for (int j = 0; j <= 2; ++j)
      f(i, j) = Interval(quadratic[static_cast<std::size_t>(i)] + quadratic[static_cast<std::size_t>(j)]);
  }
  return f;
}

TEST(BernsteinPatch, SignsAreProvedOrLeftOpen) {
  SignsFound found;
  int parts = 1000;
  add_signs(found, square({2, -1, 2}), 10,
            parts);  // 2 - 6 t (1 - t) > 0 for each of u, v: the least value is 1
  EXPECT_TRUE(found.positive && !found.negative && !found.open);
  found = {};
  add_signs(found, square({1, -2, 1}), 10, parts);  // 1 - 6 t (1 - t): below 0 in the middle
  EXPECT_TRUE(found.both());
  found = {};
  add_signs(found, square({1, -1, 1}), 4, parts);  // (1 - 2 t)^2: a zero that is no change of sign
  EXPECT_TRUE(found.positive && !found.negative && found.open);
}

TEST(BernsteinPatch, ProductsAndTheSquareOverATriangle) {
  TrianglePatch f(4);
  TrianglePatch g(3);
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; i + j <= 4; ++j) f(i, j) = Interval((i * i + 3 * j) % 5 - 2);
  }
  for (int i = 0; i <= 3; ++i) {
    for (int j = 0; i + j <= 3; ++j) g(i, j) = Interval((2 * i + j * j) % 7 - 3);
  }
  const SquarePatch product = over_square(f * g);
  for (const double p : {0.0, 0.25, 0.7, 1.0}) {
    for (const double q : {0.0, 0.4, 1.0}) {
      const double u = p * (1 - q);
      const double v = p * q;
      EXPECT_NEAR(evaluate(product, p, q), evaluate(f, u, v) * evaluate(g, u, v), 1e-10);
      constexpr double h = 1e-5;
      EXPECT_NEAR(evaluate(derivative_u(f), u, v), (evaluate(f, u + h, v) - evaluate(f, u - h, v)) / (2 * h),
                  1e-6);
      EXPECT_NEAR(evaluate(derivative_v(f), u, v), (evaluate(f, u, v + h) - evaluate(f, u, v - h)) / (2 * h),
                  1e-6);
    }
  }
}

TEST(BernsteinPatch, AnglesAroundZero) {
  const auto number = [](int x, int y) { return PlaneNumber<Interval>{Interval(x), Interval(y)}; };
  // From 1 to i and from 1 to -1, above 0 and below it.
  const auto angle = [](const std::optional<Interval>& found) { return found ? found->to_double() : 100; };
  EXPECT_NEAR(angle(turned_angle({number(1, 0), number(1, 1), number(0, 1)}, 10)), std::numbers::pi / 2,
              1e-15);
  EXPECT_NEAR(angle(turned_angle({number(1, 0), number(0, 2), number(-1, 0)}, 10)), std::numbers::pi, 1e-15);
  EXPECT_NEAR(angle(turned_angle({number(1, 0), number(0, -2), number(-1, 0)}, 10)), -std::numbers::pi,
              1e-15);
  EXPECT_FALSE(turned_angle({number(1, 0), number(0, 0), number(-1, 0)}, 10));
}

}  // namespace
}  // namespace subdiv
