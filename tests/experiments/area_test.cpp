#include "experiments/area.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "experiments/area_schemes.h"
#include "experiments/data.h"
#include "schemes/algebra/common_zeros.h"
#include "schemes/algebra/real.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

/// m_1 .. m_5 of {J_{a,b}, *J_s} by the power method: the area of a polygon after ever more steps, as a form
/// in its own points. Written from the stencils (jsplines 1): a step with coefficients c turns the form m
/// into sum over n of d_{n-2k} m_n, d_l = sum of c_j c_{j+l}; the polygon's form converges by a factor of 4 a
/// step.
template <class T>
using Mask5 = std::array<T, 5>;

template <class T>
std::map<int, T> autocorrelation(const T& a, const T& b) {
  const std::array<T, 7> c{(b - 1) / 16, a / 8, (9 - b) / 16, (8 - 2 * a) / 8,
                           (9 - b) / 16, a / 8, (b - 1) / 16};
  std::map<int, T> d;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) d[j - i] += c[static_cast<std::size_t>(i)] * c[static_cast<std::size_t>(j)];
  }
  return d;
}

template <class T>
Mask5<T> pulled_back(const std::map<int, T>& d, const Mask5<T>& m) {
  const auto at = [&](int n) -> T {
    if (n == 0 || std::abs(n) > 5) return T(0);
    return n > 0 ? m[static_cast<std::size_t>(n - 1)] : T(-m[static_cast<std::size_t>(-n - 1)]);
  };
  Mask5<T> result{};
  for (int k = 1; k <= 5; ++k) {
    for (const auto& [l, value] : d) result[static_cast<std::size_t>(k - 1)] += value * at(2 * k + l);
  }
  return result;
}

template <class T>
Mask5<T> area_mask_by_iteration(const T& a, const T& b, const T& s, int steps) {
  Mask5<T> m{T(1) / 2, T(0), T(0), T(0), T(0)};
  const std::map<int, T> d = autocorrelation(s, s);
  for (int k = 0; k < steps; ++k) m = pulled_back(d, m);
  return pulled_back(autocorrelation(a, b), m);
}

double residual(double a, double b, double s) {
  Mask5<double> m = area_mask_by_iteration(a, b, s, 30);
  m[0] -= 0.5;
  double largest = 0;
  for (const double r : m) largest = std::max(largest, std::abs(r));
  return largest;
}

/// The minimum of a function with one local minimum on [low, high], by ternary search.
std::pair<double, double> minimum(const std::function<double(double)>& f, double low, double high) {
  for (int k = 0; k < 60; ++k) {
    const double first = low + (high - low) / 3;
    const double second = high - (high - low) / 3;
    (f(first) < f(second) ? high : low) = f(first) < f(second) ? second : first;
  }
  return {(low + high) / 2, f((low + high) / 2)};
}

using Point = std::pair<double, double>;

std::vector<Point> refine(const std::vector<Point>& p, double a, double b) {
  const std::size_t n = p.size();
  std::vector<Point> result;
  for (std::size_t j = 0; j < n; ++j) {
    const Point& before = p[(j + n - 1) % n];
    const Point& here = p[j];
    const Point& next = p[(j + 1) % n];
    const Point& after = p[(j + 2) % n];
    const auto even = [&](double x, double y, double z) { return (a * x + (8 - 2 * a) * y + a * z) / 8; };
    const auto odd = [&](double x, double y, double z, double w) {
      return ((b - 1) * x + (9 - b) * y + (9 - b) * z + (b - 1) * w) / 16;
    };
    result.emplace_back(even(before.first, here.first, next.first),
                        even(before.second, here.second, next.second));
    result.emplace_back(odd(before.first, here.first, next.first, after.first),
                        odd(before.second, here.second, next.second, after.second));
  }
  return result;
}

double shoelace(const std::vector<Point>& p) {
  double total = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point& q = p[(i + 1) % p.size()];
    total += p[i].first * q.second - p[i].second * q.first;
  }
  return total / 2;
}

/// The limit curve's area: ten and eleven refinements, and the error's factor of 4 taken out.
double limit_area(std::vector<Point> p, double a, double b, double s) {
  p = refine(p, a, b);
  for (int k = 1; k < 10; ++k) p = refine(p, s, s);
  const double before = shoelace(p);
  return (4 * shoelace(refine(p, s, s)) - before) / 3;
}

class Area : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_area();
    return all;
  }
  static const std::vector<Claim>& claims() { return results().claims; }
  static double value(const std::string& id) { return test::value_of(claims(), id); }
  static Verdict verdict(const std::string& id) { return test::find_claim(claims(), id).verdict; }
  static void expect_near(const std::string& id, const char* digits) {
    const Claim& claim = test::find_claim(claims(), id);
    const Rational expected = Rational::parse(digits);
    const Rational error = abs((*claim.lower + *claim.upper) / Rational(2) - expected);
    EXPECT_LT(error, abs(expected) * Rational::parse("1e-25")) << id;
    EXPECT_LT(*claim.upper - *claim.lower, Rational::parse("1e-15")) << id;
  }
};

TEST_F(Area, MasksOfMixedSchemesAgainstRefinedPolygons) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  struct Parameters {
    const char* a;
    const char* b;
    const char* s;
  };
  for (const Parameters& p : {Parameters{"0.46415", "0.46415", "0.46415"},
                              Parameters{"-0.0299", "-0.0299", "1.5"}, Parameters{"0.836", "0.836", "-0.531"},
                              Parameters{"-0.0053", "1.0276", "0.4666"}, Parameters{"0.3", "-0.4", "1.3"}}) {
    const Rational a = Rational::parse(p.a);
    const Rational b = Rational::parse(p.b);
    const Rational s = Rational::parse(p.s);
    const Laurent<Rational> mask = area_mask(anticipated_jspline(a, b, s));
    for (const std::size_t n : {3U, 5U, 9U, 12U}) {
      std::vector<Point> polygon(n);
      for (Point& q : polygon) q = {coordinate(random), coordinate(random)};
      std::vector<std::pair<Rational, Rational>> exact_polygon;
      for (const Point& q : polygon) {
        exact_polygon.emplace_back(Rational::from_double(q.first), Rational::from_double(q.second));
      }
      const std::span<const std::pair<Rational, Rational>> points(exact_polygon);
      EXPECT_NEAR(area(mask, points).to_double(),
                  limit_area(polygon, a.to_double(), b.to_double(), s.to_double()), 1e-8)
          << p.a << " " << p.b << " " << p.s << ", " << n << " points";
    }
  }
}

TEST_F(Area, OneParameterByDirectMinimisation) {
  const auto [s, least_s] = minimum([](double x) { return residual(x, x, x); }, 0.3, 0.7);
  EXPECT_NEAR(value("area.s.js-report"), s, 1e-8);
  EXPECT_NEAR(value("area.s.minimum"), least_s, 1e-10);
  const auto [r, least_r] = minimum([](double x) { return residual(x, x, 1.5); }, -0.5, 0.5);
  EXPECT_NEAR(value("area.r.js-report"), r, 1e-8);
  EXPECT_NEAR(value("area.r.minimum"), least_r, 1e-10);
  for (double x = -1.7; x <= 5.8; x += 0.05) EXPECT_GE(residual(x, x, x), least_s);
  for (double x = -6; x <= 6; x += 0.05) EXPECT_GE(residual(x, x, 1.5), least_r);
}

TEST_F(Area, TwoParametersByDirectMinimisation) {
  // Along s: the least value over r, in the valley's neighbourhood.
  const auto floor = [](double s) {
    return minimum([&](double r) { return residual(r, r, s); }, 0.6, 1.0).second;
  };
  const auto [s, least] = minimum(floor, -0.8, -0.3);
  EXPECT_NEAR(value("area.rs.s.js-report"), s, 1e-4);  // flat: the value is quadratic in s
  EXPECT_NEAR(value("area.rs.minimum"), least, 1e-11);
  const double best_s = value("area.rs.s.js-report");
  EXPECT_NEAR(value("area.rs.r.js-report"),
              minimum([&](double r) { return residual(r, r, best_s); }, 0.6, 1.0).first, 1e-7);
  EXPECT_NEAR(value("area.rs.residual.js-report"), residual(0.836, 0.836, -0.531), 1e-12);
  EXPECT_NEAR(value("area.rs.residual.jsplines"), residual(0.84, 0.84, -0.53), 1e-12);
}

TEST_F(Area, MinimisersToMoreDigits) {
  // From an independent elimination in a computer algebra system (resultants of the active residuals over Q).
  expect_near("area.s.js-report", "0.464153170303031334574444733929275157480128125");
  expect_near("area.r.js-report", "-0.029925749917644569883496254058420569670542");
  expect_near("area.rs.r.js-report", "0.841645442175279069964840414113020982682049975");
  expect_near("area.rs.s.js-report", "-0.548323113530852783330854358840963330455407842");
  expect_near("area.rs.minimum", "0.0001603816359299463464727646580936970596999");
}

TEST_F(Area, LeastResidualOfThreeParametersInHighPrecision) {
  const auto at = [](const Real& a, const Real& b, const Real& s) {
    Mask5<Real> m = area_mask_by_iteration(a, b, s, 120);
    m[0] -= Real(1) / 2;
    return m;
  };
  const auto largest = [](const Mask5<Real>& m) {
    Real result = 0;
    for (const Real& r : m) result = std::max(result, Real(abs(r)));
    return result;
  };
  const auto middle = [&](const std::string& id) {
    const Claim& claim = test::find_claim(claims(), id);
    return from_rational<Real>((*claim.lower + *claim.upper) / Rational(2));
  };
  const Real a = middle("area.exact.a");
  const Real b = middle("area.exact.b.js-report");
  const Real s = middle("area.exact.s.js-report");
  const Real least = middle("area.exact.residual");
  const Mask5<Real> r = at(a, b, s);
  const Real tiny("1e-40");
  for (const Real& active : {-r[0], -r[1], -r[2], r[4]}) EXPECT_LT(Real(abs(active - least)), tiny);
  EXPECT_LT(Real(abs(r[3])), least / 2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 60; ++k) {
    const Real step = pow(Real(10), -(1 + k % 12));
    EXPECT_GT(largest(at(a + step * number(random), b + step * number(random), s + step * number(random))),
              least);
  }
  // The value, found independently by Newton's iteration in 60-digit arithmetic.
  expect_near("area.exact.residual", "5.862978722641509215305266651684041785245e-16");
  expect_near("area.exact.a", "0.01272660442722638440751342948217422606042");
  expect_near("area.exact.b.js-report", "0.9998634028688804345046022706788757301662");
  expect_near("area.exact.s.js-report", "0.4811149890560860167381773931454678868594");
  EXPECT_NEAR(value("area.exact.residual.js-report"), residual(-0.0053, 1.0276, 0.4666), 1e-13);
  EXPECT_NEAR(value("area.exact.residual.jsplines"), residual(-0.0053, 1.03, 0.47), 1e-12);
}

TEST_F(Area, NonexistenceNeedsEveryMaskEntry) {
  EXPECT_EQ(verdict("area.exact.exists"), Verdict::refuted);
  // Three of the four independent equations do have common zeros: the proof must fail without the last.
  const std::vector<RationalFunction> r = area_residuals(anticipated_jspline(
      RationalFunction::variable(0), RationalFunction::variable(1), RationalFunction::variable(2)));
  ZeroSet without_last{{r[1].numerator(), r[2].numerator(), r[3].numerator()}, {r[4].denominator()}};
  EXPECT_FALSE(prove_empty(without_last).proved);
  // And so must it when an equation is changed so that (a, b, s) = (1, 2, 3) is a common zero.
  const std::vector<Rational> point{Rational(1), Rational(2), Rational(3)};
  ZeroSet shifted{{}, {r[4].denominator()}};
  for (const RationalFunction& f : r) {
    shifted.equations.push_back((f - RationalFunction(f.evaluate<Rational>(point))).numerator());
  }
  EXPECT_FALSE(prove_empty(shifted).proved);
}

TEST_F(Area, WitnessIsSimpleAndHasThePrintedErrors) {
  const auto exact_polygon = polygon_from_data("area-witness.csv");
  ASSERT_EQ(exact_polygon.size(), 7U);
  std::vector<Point> polygon;
  for (const auto& [x, y] : exact_polygon) polygon.emplace_back(x.to_double(), y.to_double());
  const auto side = [](const Point& p, const Point& q, const Point& r) {
    return (q.first - p.first) * (r.second - p.second) - (q.second - p.second) * (r.first - p.first);
  };
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = i + 2; j < 7; ++j) {
      if ((j + 1) % 7 == i) continue;
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % 7];
      const Point& c = polygon[j];
      const Point& d = polygon[(j + 1) % 7];
      EXPECT_FALSE(side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0)
          << "edges " << i << " and " << j;
    }
  }
  const auto error = [&](double a, double b, double s) {
    return limit_area(polygon, a, b, s) / shoelace(polygon) - 1;
  };
  EXPECT_NEAR(shoelace(polygon), 33, 1e-12);
  EXPECT_NEAR(value("area.errors.s.js-report"), error(0.46415, 0.46415, 0.46415), 1e-8);
  EXPECT_NEAR(value("area.errors.r.js-report"), error(-0.0299, -0.0299, 1.5), 1e-8);
  EXPECT_NEAR(value("area.errors.rs.js-report"), error(0.836, 0.836, -0.531), 1e-7);
  EXPECT_NEAR(value("area.errors.s.jsplines"), error(0.46, 0.46, 0.46), 1e-8);
  EXPECT_NEAR(value("area.errors.r.jsplines"), error(-0.03, -0.03, 1.5), 1e-8);
  EXPECT_NEAR(value("area.errors.rs.jsplines"), error(0.84, 0.84, -0.53), 1e-7);
  const double s = value("area.model.s");
  const double r = value("area.model.r");
  EXPECT_NEAR(error(s, s, s), 0, 1e-8);
  EXPECT_NEAR(error(r, r, 1.5), 0, 1e-8);
  EXPECT_NEAR(s, 0.476, 5e-4);
  EXPECT_NEAR(r, 0.050, 5e-4);
  const double worst = std::max({std::abs(error(0.476, 0.476, 0.476)), std::abs(error(0.05, 0.05, 1.5)),
                                 std::abs(error(0.46415, 0.46415, 0.46415) - 0.00786),
                                 std::abs(error(-0.0299, -0.0299, 1.5) - 0.03443),
                                 std::abs(error(0.836, 0.836, -0.531) - 0.00014)});
  EXPECT_NEAR(value("area.model.witness"), worst, 1e-7);
  EXPECT_LT(worst, 1e-4);
}

TEST_F(Area, QuadrilateralsAllHaveTheSameError) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Mask5<double> m = area_mask_by_iteration(0.476, 0.476, 0.476, 30);
  // The closed form that the claim prints for all s, at s = .476, and E of random quadrilaterals.
  EXPECT_NEAR(2 * (m[0] - m[2] + m[4]) - 1, -0.000240468, 1e-9);
  for (int k = 0; k < 5; ++k) {
    std::vector<Point> p(4);
    for (Point& q : p) q = {coordinate(random), coordinate(random)};
    EXPECT_NEAR(limit_area(p, 0.476, 0.476, 0.476) - shoelace(p), -0.000240468 * shoelace(p), 1e-8);
  }
  EXPECT_EQ(verdict("area.model.quadrilaterals"), Verdict::established);
}

/// The least maximum of |c_i + u_i x + v_i y - t_i| by trying all triples of signed equations.
double least_maximum(const std::vector<std::array<double, 3>>& rows, const std::vector<double>& targets) {
  double best = INFINITY;
  std::vector<std::array<double, 3>> planes;  // value at 0, slopes
  for (std::size_t i = 0; i < rows.size(); ++i) {
    planes.push_back({rows[i][0] - targets[i], rows[i][1], rows[i][2]});
    planes.push_back({targets[i] - rows[i][0], -rows[i][1], -rows[i][2]});
  }
  const auto height = [&](double x, double y) {
    double result = 0;
    for (const auto& p : planes) result = std::max(result, p[0] + p[1] * x + p[2] * y);
    return result;
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const double a = planes[i][1] - planes[j][1];
        const double b = planes[i][2] - planes[j][2];
        const double c = planes[i][1] - planes[k][1];
        const double d = planes[i][2] - planes[k][2];
        const double determinant = a * d - b * c;
        if (std::abs(determinant) < 1e-14) continue;
        const double e = planes[j][0] - planes[i][0];
        const double f = planes[k][0] - planes[i][0];
        best = std::min(best, height((e * d - b * f) / determinant, (a * f - c * e) / determinant));
      }
    }
  }
  return best;
}

TEST_F(Area, FractionsFitAndPerCentDoesNot) {
  const std::vector<Mask5<double>> masks{
      area_mask_by_iteration(0.476, 0.476, 0.476, 30), area_mask_by_iteration(0.05, 0.05, 1.5, 30),
      area_mask_by_iteration(0.46415, 0.46415, 0.46415, 30),
      area_mask_by_iteration(-0.0299, -0.0299, 1.5, 30), area_mask_by_iteration(0.836, 0.836, -0.531, 30)};
  std::vector<std::array<double, 3>> heptagon;
  std::vector<std::array<double, 3>> octagon;
  for (const Mask5<double>& m : masks) {
    heptagon.push_back({2 * m[0] - 1, 2 * (m[1] - m[4]), 2 * (m[2] - m[3])});  // x_4 = -x_3, x_5 = -x_2
    octagon.push_back({2 * m[0] - 1, 2 * m[1], 2 * (m[2] - m[4])});            // x_4 = 0, x_5 = -x_3
  }
  const std::vector<double> fractions{0, 0, 0.00786, 0.03443, 0.00014};
  std::vector<double> per_cent = fractions;
  for (double& t : per_cent) t /= 100;
  EXPECT_NEAR(value("area.errors.as-fractions"), least_maximum(heptagon, fractions), 1e-12);
  EXPECT_NEAR(value("area.errors.as-per-cent"),
              std::min(least_maximum(heptagon, per_cent), least_maximum(octagon, per_cent)), 1e-12);
}

TEST_F(Area, Verdicts) {
  for (const char* id : {"area.s.js-report", "area.s.jsplines", "area.r.js-report", "area.r.jsplines",
                         "area.r.jsplines.figure", "area.rs.r.jsplines"}) {
    EXPECT_EQ(verdict(id), Verdict::reproduced) << id;
  }
  for (const char* id : {"area.rs.r.js-report", "area.rs.s.js-report", "area.rs.s.jsplines",
                         "area.exact.exists", "area.exact.a", "area.exact.b.js-report",
                         "area.exact.b.jsplines", "area.exact.s.js-report", "area.exact.s.jsplines"}) {
    EXPECT_EQ(verdict(id), Verdict::refuted) << id;
    EXPECT_FALSE(test::find_claim(claims(), id).note.empty()) << id;
  }
  for (const char* id : {"area.model.s", "area.model.r", "area.errors.s.js-report", "area.errors.r.js-report",
                         "area.errors.rs.js-report", "area.errors.s.jsplines", "area.errors.r.jsplines",
                         "area.errors.rs.jsplines"}) {
    EXPECT_EQ(verdict(id), Verdict::not_reproducible) << id;
    EXPECT_NE(test::find_claim(claims(), id).note.find("lost"), std::string::npos) << id;
  }
  EXPECT_EQ(claims().size(), area_heads().size());
  for (const Claim& claim : claims()) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
    if (!claim.head.printed) {
      EXPECT_EQ(claim.verdict, Verdict::established) << claim.head.id;
    }
  }
}

TEST_F(Area, FiguresHaveTheirData) {
  EXPECT_GE(results().figures.size(), 6U);
  for (const Figure& figure : results().figures) {
    for (const Curve& curve : figure.curves) {
      const auto series =
          std::ranges::find_if(results().series, [&](const Series& s) { return s.name == curve.series; });
      ASSERT_NE(series, results().series.end()) << figure.name;
      EXPECT_EQ(std::ranges::count(series->columns, curve.x), 1) << figure.name;
      EXPECT_EQ(std::ranges::count(series->columns, curve.y), 1) << figure.name;
    }
  }
  // A sample of the objective's series against the second route.
  const Series& curve =
      *std::ranges::find_if(results().series, [](const Series& s) { return s.name == "area-objective-s"; });
  for (std::size_t i = 0; i < curve.rows.size(); i += 10) {
    const double s = std::stod(curve.rows[i][0]);
    if (i > 0) {
      EXPECT_GT(s, std::stod(curve.rows[i - 1][0]));
    }
    EXPECT_NEAR(std::stod(curve.rows[i][1]), residual(s, s, s), 1e-8 * (1 + residual(s, s, s))) << s;
  }
}

}  // namespace
}  // namespace subdiv
