#include "analysis/mesh/derivative_bound.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/mesh/mesh_catalogue.h"

namespace subdiv {
namespace {

using Number = PlaneNumber<Interval>;
using Net = CharacteristicNet<Interval>;

Interval enclosed(double x) { return Interval(x); }

/// The same mask with zeros around it: verdicts then look at the squares between rows last and 2 last.
LatticeMask<Interval> padded(const LatticeMask<Rational>& mask, int last) {
  LatticeMask<Interval> result(last);
  for (int i = -mask.last(); i <= mask.last(); ++i) {
    for (int j = -mask.last(); j <= mask.last(); ++j) result(i, j) = Interval(mask(i, j));
  }
  return result;
}

/// Mode 1 at valence 4: the lattice itself when value(a, b) = a + i b.
Net net_of(int rings, const std::function<Number(int, int)>& value) {
  Net net(4, 4, 1, fraction<Interval>(1, 2));
  for (int ring = 1; ring <= rings; ++ring) net.add_ring(value);
  return net;
}

/// A net f(a) + i f(b): the Jacobian is F'(a) F'(b), F the limit of f.
Net product_net(int rings, const std::function<double(int)>& f) {
  return net_of(rings, [&](int a, int b) { return Number{enclosed(f(a)), enclosed(f(b))}; });
}

/// By subdivision of control points that are 1 at one place: all b_j at the points of a level on [0, 1]^2.
double sampled_norm(const LatticeMask<Rational>& mask, const LatticeWindow& window, bool all, int level) {
  constexpr int far = 12;  // the values used lie in the window: nothing further away matters
  const int last = mask.last();
  std::vector<std::vector<double>> weights(static_cast<std::size_t>(2 * last + 1));
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j)
      weights[static_cast<std::size_t>(i + last)].push_back(mask(i, j).to_double());
  }
  const int size = 1 << level;
  std::vector<double> sums(static_cast<std::size_t>((size + 1) * (size + 1)));
  for (int p = 0; p < window.size.a * window.size.b; ++p) {
    const LatticeOffset place{window.first.a + p / window.size.b, window.first.b + p % window.size.b};
    if (!all && place == window.reference) continue;
    // Values on -far .. 2^l + far.
    const auto slot = [](int side, int a, int b) {
      return static_cast<std::size_t>((a + far) * (side + 2 * far + 1) + b + far);
    };
    int side = 1;
    std::vector<double> values(static_cast<std::size_t>((side + 2 * far + 1) * (side + 2 * far + 1)));
    values[slot(side, place.a, place.b)] = 1;
    for (int l = 0; l < level; ++l) {
      const int next = 2 * side;
      std::vector<double> fine(static_cast<std::size_t>((next + 2 * far + 1) * (next + 2 * far + 1)));
      for (int a = -far; a <= side + far; ++a) {
        for (int b = -far; b <= side + far; ++b) {
          const double value = values[slot(side, a, b)];
          if (value == 0) continue;
          for (int i = -last; i <= last; ++i) {
            for (int j = -last; j <= last; ++j) {
              const int x = 2 * a + i;
              const int y = 2 * b + j;
              if (x < -far || y < -far || x > next + far || y > next + far) continue;
              fine[slot(next, x, y)] +=
                  value * weights[static_cast<std::size_t>(i + last)][static_cast<std::size_t>(j + last)];
            }
          }
        }
      }
      values = std::move(fine);
      side = next;
    }
    for (int a = 0; a <= size; ++a) {
      for (int b = 0; b <= size; ++b)
        sums[static_cast<std::size_t>(a * (size + 1) + b)] += std::abs(values[slot(side, a, b)]);
    }
  }
  return *std::ranges::max_element(sums);
}

TEST(DerivativeBound, FactorsAreAboveSampledNorms) {
  for (const char* name : {"kobbelt", "jspline-mesh:s=-1/4", "jspline-mesh:s=1/2", "butterfly", "loop"}) {
    const LatticeMask<Rational> mask =
        trimmed(lattice_mask(*mesh_scheme_forms(parse_mesh_scheme(name)).exact));
    const bool product = std::string(name) != "butterfly" && std::string(name) != "loop";
    std::vector<LatticeMask<Rational>> masks{mask};
    for (const bool first : {true, false}) {
      // The derivatives of the butterfly contract more slowly than is asked for.
      if (std::string(name) != "butterfly") masks.push_back(*derivative_scheme(mask, first));
    }
    for (const LatticeMask<Rational>& m : masks) {
      const std::optional<LatticeWindow> window = lattice_window(m);
      ASSERT_TRUE(window) << name;
      // Control points of level 5 are close to limits; products bound the sums over all j.
      const double norm = sampled_norm(m, *window, product, 5);
      EXPECT_GE(window->factor, norm) << name;
    }
  }
}

DerivativeBounds cubic_bounds() { return *derivative_bounds(spline_mask({4, 3})); }

/// The tests below: squares between the rows 6 and 12.
constexpr int row = 6;
constexpr int rings = 2 * row + 2;

TEST(DerivativeBound, TheLatticeItselfIsRegular) {
  const CharacteristicMap map = enclosed_verdict(product_net(rings, [](int a) { return a; }),
                                                 padded(spline_mask({4, 3}), row), cubic_bounds(), 2);
  EXPECT_EQ(map.regular, Decision::yes);
  EXPECT_EQ(map.injective, Decision::yes);
  EXPECT_EQ(map.winding, 1);
}

// The control points (9 + 1, 9) and (9, 9 + 1) move towards each other by t (-1, 1) and t (1, -1): the
// Jacobian is 1 - t (h_u - h_v), h = B_10(u) B_9(v) - B_9(u) B_10(v) in cubic B-splines. Its least value is
// at the square's centre, where B = 23/48 and B' = +-5/8: 1 - t 115/96. On the square's border it is
// positive.
TEST(DerivativeBound, AFoldOnTheDiagonalIsFound) {
  constexpr int at = 9;
  const auto jacobian = [](double t, double u, double v) {
    const auto first = [](double x) {
      return (3 * x * x * x - 6 * x * x + 4) / 6;
    };  // B_9(9 + x), x in [0, 1]
    const auto slope = [](double x) { return (3 * x * x - 4 * x) / 2; };
    const double hu = -slope(1 - u) * first(v) - slope(u) * first(1 - v);
    const double hv = first(1 - u) * slope(v) + first(u) * slope(1 - v);
    return 1 - t * (hu - hv);
  };
  constexpr double t = 0.9;
  EXPECT_NEAR(jacobian(1, 0.5, 0.5), 1 - 115.0 / 96, 1e-12);
  for (double x = 0; x <= 1; x += 1.0 / 64) {
    for (const double edge : {0.0, 1.0}) {
      EXPECT_GT(jacobian(t, x, edge), 0);
      EXPECT_GT(jacobian(t, edge, x), 0);
    }
  }
  const Net net = net_of(rings, [&](int a, int b) {
    const double shift = a == at + 1 && b == at ? t : 0;
    return Number{enclosed(a - shift), enclosed(b + shift)};
  });
  const CharacteristicMap map = enclosed_verdict(net, padded(spline_mask({4, 3}), row), cubic_bounds(), 5);
  EXPECT_EQ(map.regular, Decision::no);
  EXPECT_EQ(map.injective, Decision::no);
}

// f(11) = 12, f(12) = 11: F'(11 + 1/2) = 1 - 5/4, and F' > 0 on the other squares.
TEST(DerivativeBound, AFoldInTheOutermostRowIsFound) {
  const auto f = [](int a) { return a == 2 * row - 1 ? a + 1 : a == 2 * row ? a - 1 : a; };
  const CharacteristicMap map =
      enclosed_verdict(product_net(rings, f), padded(spline_mask({4, 3}), row), cubic_bounds(), 4);
  EXPECT_EQ(map.regular, Decision::no);
}

// The lattice with points known up to 0.6 in each coordinate: neighbours may coincide.
TEST(DerivativeBound, PointsThatAreHardlyKnownProveNothing) {
  const auto blurred = [](int a) {
    return Interval::hull(Rational(10 * a - 6, 10), Rational(10 * a + 6, 10));
  };
  const Net net = net_of(rings, [&](int a, int b) { return Number{blurred(a), blurred(b)}; });
  EXPECT_EQ(enclosed_verdict(net, padded(spline_mask({4, 3}), row), cubic_bounds(), 1).regular,
            Decision::undecided);
}

/// A product of curve schemes, centred at index last.
LatticeMask<Rational> product_mask(const std::vector<Rational>& curve, int last) {
  LatticeMask<Rational> mask(static_cast<int>(curve.size()));
  for (int i = 0; i < static_cast<int>(curve.size()); ++i) {
    for (int j = 0; j < static_cast<int>(curve.size()); ++j)
      mask(i - last, j - last) = curve[static_cast<std::size_t>(i)] * curve[static_cast<std::size_t>(j)];
  }
  return trimmed(mask);
}

/// -w, 0, 1/2 + w, 1, 1/2 + w, 0, -w from index -3 on: an interpolating scheme of curves.
std::vector<Rational> four_point(const Rational& w) {
  return {-w, Rational(0), Rational(1, 2) + w, Rational(1), Rational(1, 2) + w, Rational(0), -w};
}

/// Its basis functions b_j, j = -2 .. 3, at the multiples of 2^-level in [0, 1], by subdivision.
std::vector<std::vector<double>> four_point_basis(const Rational& w, int level) {
  constexpr int far = 8;
  const std::vector<Rational> mask = four_point(w);
  const auto slot = [](int x) { return static_cast<std::size_t>(x + far); };
  std::vector<std::vector<double>> basis;
  for (int j = -2; j <= 3; ++j) {
    std::vector<double> values(slot(1 + far) + 1);
    values[slot(j)] = 1;
    for (int side = 1; side < 1 << level; side *= 2) {
      std::vector<double> fine(slot(2 * side + far) + 1);
      for (int x = -far; x <= 2 * side + far; ++x) {
        for (int i = -3; i <= 3; ++i) {
          const int y = (x - i) / 2;
          if ((x - i) % 2 == 0 && -far <= y && y <= side + far)
            fine[slot(x)] += mask[static_cast<std::size_t>(i + 3)].to_double() * values[slot(y)];
        }
      }
      values = std::move(fine);
    }
    basis.emplace_back(values.begin() + far, values.end() - far);
  }
  return basis;
}

/// The largest sum of |b_j|, j = 1 (the reference) left out or not, and where it is.
std::pair<double, std::size_t> norm_of(const std::vector<std::vector<double>>& basis, bool all) {
  std::pair<double, std::size_t> result;
  for (std::size_t x = 0; x < basis.front().size(); ++x) {
    double sum = 0;
    for (std::size_t j = 0; j < basis.size(); ++j) sum += all || j != 3 ? std::abs(basis[j][x]) : 0;
    result = std::max(result, {sum, x});
  }
  return result;
}

/// The four-point mask along the first direction, the hat function's along the second; skewed: data that are
/// constant along the second direction do not feel that it is no product.
LatticeMask<Rational> along_first(const Rational& w, bool skewed) {
  LatticeMask<Rational> mask(3);
  for (int i = -3; i <= 3; ++i) {
    for (int j = -1; j <= 1; ++j)
      mask(i, j) = Rational(1, 1 + std::abs(j)) * four_point(w)[static_cast<std::size_t>(i + 3)];
  }
  if (skewed) {
    mask(0, 1) += Rational(1, 1000);
    mask(0, -1) -= Rational(1, 1000);
  }
  return mask;
}

// Limits at dyadic points are known after finitely many steps, and the hat functions' norm is 1.
TEST(DerivativeBound, FactorsAreAboveTheNormsOfRoughFunctions) {
  for (const int k : {4, 5, 8, 16}) {
    const Rational w(1, k);
    EXPECT_GE(lattice_window(along_first(w, false))->factor, norm_of(four_point_basis(w, 12), true).first)
        << k;
  }
  for (const int k : {3, 4, 5, 8, 16}) {
    const Rational w(1, k);
    const std::optional<LatticeWindow> window = lattice_window(along_first(w, true));
    EXPECT_TRUE(window || k < 5) << k;  // rough functions may contract too slowly to be bounded at all
    if (window) {
      EXPECT_GE(window->factor, norm_of(four_point_basis(w, 12), false).first) << k;
    }
  }
}

// At w = 3/4 basis functions grow from level to level, but stay bounded near the integers.
TEST(DerivativeBound, SchemesThatDivergeBetweenPointsHaveNoBounds) {
  const Rational w(3, 4);
  EXPECT_GT(norm_of(four_point_basis(w, 12), true).first, 4 * norm_of(four_point_basis(w, 6), true).first);
  EXPECT_FALSE(lattice_window(along_first(w, false)));
  EXPECT_FALSE(lattice_window(along_first(w, true)));
}

// Differences are refined by the four-point mask with a large w, whose basis functions b_j take large values
// of both signs: differences in 1 .. 1.95 have limits below 0.
TEST(DerivativeBound, DerivativesMayLeaveTheDifferencesByFar) {
  const Rational w(1, 3);
  const std::vector<Rational> differences = four_point(w);
  std::vector<Rational> curve(8);  // (1 + z)/2 times it: from index -4 on
  for (std::size_t i = 0; i < differences.size(); ++i) {
    curve[i] += Rational(1, 2) * differences[i];
    curve[i + 1] += Rational(1, 2) * differences[i];
  }
  const LatticeMask<Rational> mask = product_mask(curve, 4);
  const std::optional<DerivativeBounds> bounds = derivative_bounds(mask);
  ASSERT_TRUE(bounds);

  const std::vector<std::vector<double>> basis = four_point_basis(w, 6);
  const std::size_t where = norm_of(basis, true).second;
  constexpr int place = 8;
  constexpr int last = 16;
  std::vector<double> step(200, 1.4);
  double limit = 0;
  for (std::size_t j = 0; j < basis.size(); ++j) {
    step[place + j] = basis[j][where] > 0 ? 1 : 1.95;
    limit += step[place + j] * basis[j][where];
  }
  ASSERT_LT(limit, -0.05);
  std::vector<double> f{0};
  for (const double d : step) f.push_back(f.back() + d);
  const Net net = product_net(6 * last + 4, [&](int a) { return f[static_cast<std::size_t>(a)]; });
  EXPECT_NE(enclosed_verdict(net, padded(mask, last), *bounds, 0).regular, Decision::yes);
}

// Bilinear pieces: the curve is the circle's polygon on row 6 from 0 to an eighth of a turn, and winds once.
// The points of the next row, the discs' centres, turn the other way, from 50 degrees to -5.
TEST(DerivativeBound, WindingIsNotReadOffCentresFarFromTheCurve) {
  const LatticeMask<Rational> mask = spline_mask({4, 1});
  const std::optional<LatticeWindow> window = lattice_window(mask);
  ASSERT_TRUE(window);
  const auto polar = [](double length, double degrees) {
    const double angle = degrees / 180 * std::numbers::pi;
    return Number{enclosed(length * std::cos(angle)), enclosed(length * std::sin(angle))};
  };
  const Net net = net_of(3 * rings, [&](int a, int b) {
    if (a != row + 1 || b == 0 || b == a) return polar(a <= row ? 1 : 1.1, 45.0 * b / a);
    return polar(1.556, 50 - 55.0 * (b - 1) / (row - 1));
  });
  const CharacteristicMap map = enclosed_verdict(net, padded(mask, row), {*window, {*window, *window}}, 0);
  EXPECT_TRUE(!map.winding || map.winding == 1) << *map.winding;
}

}  // namespace
}  // namespace subdiv
