#include "analysis/area_mask.h"

#include <vector>

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

template <class R>
using Polygon = std::vector<std::pair<R, R>>;

/// One step on a closed polygon: P'_i = sum over j of a_{i - 2j} P_j.
template <class R>
Polygon<R> refine(const Mask<R>& mask, const Polygon<R>& p) {
  const int n = static_cast<int>(p.size());
  Polygon<R> result(2 * p.size(), {R(0), R(0)});
  for (int j = 0; j < n; ++j) {
    for (int k = mask.symbol.first(); k <= mask.symbol.last(); ++k) {
      auto& target = result[static_cast<std::size_t>(residue(2 * j + k, 2 * n))];
      const auto& source = p[static_cast<std::size_t>(j)];
      target.first = target.first + mask.symbol[k] * source.first;
      target.second = target.second + mask.symbol[k] * source.second;
    }
  }
  return result;
}

template <class R>
R shoelace(const Polygon<R>& p) {
  R twice(0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& a = p[i];
    const auto& b = p[(i + 1) % p.size()];
    twice = twice + a.first * b.second - a.second * b.first;
  }
  return twice / R(2);
}

const Polygon<Rational> control{{0, 0}, {4, 1}, {5, 4}, {2, 3}, {1, 7}, {-2, 2}, {-3, -1}};

TEST(AreaMask, IsTheAreaOfThePolygonAfterTenRefinements) {
  for (const Rational& s : {Rational(-1, 2), Rational(0), Rational(47, 100), Rational(1), Rational(13, 5)}) {
    const Scheme<Rational> scheme = mixed(stationary<Rational>("", jspline(Rational(1, 5), Rational(3, 4))),
                                          stationary<Rational>("", jspline(s)));
    const Rational predicted = area<Rational>(area_mask(scheme), control);
    const auto rounded = [](const Rational& q) { return q.to_double(); };
    Polygon<double> p;
    for (const auto& [x, y] : control) p.emplace_back(x.to_double(), y.to_double());
    for (std::size_t k = 0; k < 10; ++k) p = refine(map_coefficients(scheme.step(k), rounded), p);
    // Inscribed polygons of N points lack O(1/N^2) of the area.
    EXPECT_NEAR(shoelace(p), predicted.to_double(), 2e-5 * std::abs(predicted.to_double())) << s.to_string();
  }
}

TEST(AreaMask, DoesNotChangeWhenThePolygonIsRefinedByTheScheme) {
  const Mask<Rational> mask = jspline(Rational(7, 10));
  const Laurent<Rational> m = area_mask(stationary<Rational>("", mask));
  EXPECT_EQ(area<Rational>(m, control), area<Rational>(m, refine(mask, control)));
  // A dual scheme as well, and an anticipation step.
  const Mask<Rational> dual = bspline<Rational>(2);
  const Laurent<Rational> d = area_mask(stationary<Rational>("", dual));
  EXPECT_EQ(area<Rational>(d, control), area<Rational>(d, refine(dual, control)));
  const Laurent<Rational> both =
      area_mask(mixed(stationary<Rational>("", dual), stationary<Rational>("", mask)));
  EXPECT_EQ(area<Rational>(both, control), area<Rational>(m, refine(dual, control)));
}

TEST(AreaMask, OfPolygonsIsThatOfLinearSubdivision) {
  EXPECT_EQ(area_mask(stationary<Rational>("", bspline<Rational>(1))), polygon_area_mask<Rational>());
  EXPECT_EQ(area<Rational>(polygon_area_mask<Rational>(), control), shoelace(control));
}

TEST(AreaMask, IsAntisymmetricWithFirstMomentOneOverTheWholeFamily) {
  const Laurent<RationalFunction> m = area_mask(stationary<RationalFunction>(
      "", jspline(RationalFunction::variable(0), RationalFunction::variable(1))));
  EXPECT_EQ(reverse(m), -m);
  EXPECT_EQ(sum(euler_derivative(m)), RationalFunction(1));
}

}  // namespace
}  // namespace subdiv
