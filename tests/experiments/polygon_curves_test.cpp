#include "experiments/polygon_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "experiments/simple_polygons.h"
#include "tests/experiments/find_claim.h"
#include "tests/experiments/polygon_rule.h"
#include "tests/plane_loop.h"

namespace subdiv {
namespace {

using test::find_claim;
using test::find_series;
using test::value_of;

using test::area;
using test::Points;
using test::refined;

std::vector<Points> family() {
  std::vector<Points> result;
  for (const PlanePolygon& polygon : simple_polygons()) {
    Points points;
    for (const auto& [x, y] : polygon) points.push_back({x.to_double(), y.to_double()});
    result.push_back(std::move(points));
  }
  return result;
}

/// {J_r, *J_s}, `depth` steps in all.
Points curve(Points p, double r, double s, int depth) {
  for (int k = 0; k < depth; ++k) p = k == 0 ? refined(p, r, r) : refined(p, s, s);
  return p;
}

double area_error(const Points& p, double r, double s) {
  constexpr int depth = 6;
  // The area of a refined polygon misses the limit's by a term that falls by 4 a step.
  const double fine = area(curve(p, r, s, depth));
  const double finer = area(curve(p, r, s, depth + 1));
  return std::abs((finer + (finer - fine) / 3) / area(p) - 1);
}

class PolygonCurves : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_polygon_curves();
    return all;
  }
  static const Claim& claim(const std::string& id) { return find_claim(results().claims, id); }
  /// How many of the family, by the claim's share.
  static long count(const std::string& id, double total) {
    return std::lround(value_of(results().claims, id) * total);
  }
};

TEST(SimplePolygons, AreThoseOfTheRule) {
  const auto expected = test::PolygonRule(test::family_seed).family(test::family_size);
  ASSERT_EQ(simple_polygons().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    PlanePolygon polygon;
    for (const auto& [x, y] : expected[i]) polygon.emplace_back(Rational(x), Rational(y));
    EXPECT_EQ(simple_polygons()[i], polygon) << i + 1;
  }
}

TEST(SimplePolygons, SharesOfMoreThanHalfAreUsual) {
  const ClaimHead printed{"x", "js-report", "1", "usually", ClaimKind::tendency, ""};
  EXPECT_EQ(settle_share(printed, 101, 200).verdict, Verdict::reproduced);
  EXPECT_EQ(settle_share(printed, 100, 200).verdict, Verdict::refuted);
  EXPECT_EQ(settle_share(printed, 150, 200).exact, "3/4");
  EXPECT_EQ(settle_share(printed, 150, 200, "So.").note, "So it is on 150 of 200. So.");
  EXPECT_EQ(settle_share(printed, 101, 200, "", Rigour::approximate).verdict, Verdict::consistent);
  EXPECT_EQ(settle_share(printed, 100, 200, "", Rigour::approximate).verdict, Verdict::inconsistent);
}

TEST_F(PolygonCurves, AreaSharesByRefinement) {
  int nearly = 0;
  int very_close = 0;
  int better_than_ends = 0;
  int kinks = 0;
  for (const Points& p : family()) {
    const double half = area_error(p, 0.5, 0.5);
    nearly += half < 0.05 ? 1 : 0;
    very_close += half < 0.02 ? 1 : 0;
    better_than_ends += half < area_error(p, 0, 0) && half < area_error(p, 1, 1) ? 1 : 0;
    const double error = area_error(p, 0.836, -0.531);
    kinks += error < area_error(p, 0.46415, 0.46415) && error < area_error(p, -0.0299, 1.5) ? 1 : 0;
  }
  EXPECT_EQ(nearly, count("family.area-usually", 200));
  EXPECT_EQ(very_close, count("family.area-usually.abstract", 200));
  EXPECT_EQ(better_than_ends, count("family.area-usually.against-ends", 200));
  EXPECT_EQ(kinks, count("area.tendency.rs", 200));
  EXPECT_EQ(claim("family.area-usually").verdict, Verdict::reproduced);
}

TEST_F(PolygonCurves, AreaFigureHasTheErrorsInOrder) {
  std::vector<double> errors;
  for (const Points& p : family()) errors.push_back(area_error(p, 0.5, 0.5));
  std::ranges::sort(errors);
  const Series& series = find_series(results(), "area-usually");
  EXPECT_EQ(series.columns[2], "*J_{1/2}");
  for (const std::size_t i : {0U, 50U, 100U, 199U}) {
    EXPECT_NEAR(std::stod(series.rows[i][0]), (static_cast<double>(i) + 1) / 200, 1e-11);
    EXPECT_NEAR(std::stod(series.rows[i][2]), errors[i], 1e-6);
  }
}

TEST_F(PolygonCurves, AreaPreservingParametersAreSmooth) {
  int changes = 0;
  for (const Points& p : family()) {
    constexpr int depth = 6;
    const auto too_large = [&](double s) { return area(curve(p, s, s, depth)) > area(p); };
    bool changed = false;
    for (double s = 0.05; s < 4 && !changed; s += 0.05) changed = too_large(s - 0.05) != too_large(s);
    changes += changed ? 1 : 0;
  }
  EXPECT_EQ(changes, count("area.tendency.c2", 200));
}

double disparity(const Points& parent, double s) {
  const Points fine = refined(parent, s, s);
  const Points linear = refined(parent, 0, 1);
  double largest = 0;
  for (std::size_t i = 0; i < fine.size(); ++i)
    largest = std::max(largest, std::hypot(fine[i][0] - linear[i][0], fine[i][1] - linear[i][1]));
  return largest;
}

std::vector<double> four_disparities(Points p, double s) {
  std::vector<double> result;
  for (int k = 0; k < 4; ++k) {
    result.push_back(disparity(p, s));
    p = refined(p, s, s);
  }
  return result;
}

TEST_F(PolygonCurves, PoppingSharesByTheStencils) {
  int fixed = 0;
  int maillot_stam = 0;
  int l1 = 0;
  for (const Points& p : family()) {
    const auto best = four_disparities(p, 0.375);
    const auto four_point = four_disparities(p, 0);
    const auto cubic = four_disparities(p, 1);
    const auto third = four_disparities(p, 0.3);
    const auto by_l1 = four_disparities(p, 0.304763);
    const auto by_linf = four_disparities(p, 0.152773);
    for (std::size_t k = 0; k < 4; ++k) {
      fixed += best[k] < four_point[k] && best[k] < cubic[k] ? 1 : 0;
      maillot_stam += best[k] < third[k] ? 1 : 0;
      l1 += by_l1[k] < by_linf[k] ? 1 : 0;
    }
  }
  EXPECT_EQ(fixed, count("popping.fixed", 800));
  EXPECT_EQ(maillot_stam, count("popping.fixed.maillot-stam", 800));
  EXPECT_EQ(l1, count("fit.linear.tendency.l1", 800));
  EXPECT_EQ(claim("popping.fixed").verdict, Verdict::reproduced);
  EXPECT_EQ(claim("popping.fixed.js-report").verdict, Verdict::consistent);
}

TEST_F(PolygonCurves, PoppingFigure) {
  const Series& series = find_series(results(), "popping-fixed");
  for (const std::size_t row : {0U, 20U, 50U}) {
    const double s = static_cast<double>(row) / 50;
    EXPECT_NEAR(std::stod(series.rows[row][0]), s, 1e-12);
    std::vector<double> mean(4, 0);
    for (const Points& p : family()) {
      double length = 0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const auto& q = p[(i + 1) % p.size()];
        length += std::hypot(q[0] - p[i][0], q[1] - p[i][1]);
      }
      const auto values = four_disparities(p, s);
      for (std::size_t k = 0; k < 4; ++k)
        mean[k] += values[k] / (length / static_cast<double>(p.size())) / 200;
    }
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(std::stod(series.rows[row][k + 1]), mean[k], 1e-11);
  }
}

/// Steps of P <- P + (C - L P), L as printed in jsplines 5.
int retrofit_steps(const Points& target, double s) {
  const double scale = 12 * (6 + s);
  const std::array<double, 5> mask{(s - 1) * s / scale, 2 * s * (8 - s) / scale,
                                   (72 + 2 * (s - 9) * s) / scale, 2 * s * (8 - s) / scale,
                                   (s - 1) * s / scale};
  const std::size_t n = target.size();
  Points p = target;
  for (int count = 0;; ++count) {
    Points miss = target;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 5; ++k) {
        for (const std::size_t c : {0U, 1U}) miss[i][c] -= mask[k] * p[(i + 5 * n + k - 2) % n][c];
      }
      largest = std::max(largest, std::hypot(miss[i][0], miss[i][1]));
    }
    if (largest <= 1e-3) return count;
    for (std::size_t i = 0; i < n; ++i) {
      for (const std::size_t c : {0U, 1U}) p[i][c] += miss[i][c];
    }
  }
}

TEST_F(PolygonCurves, RetrofitsByTheIterationItself) {
  const Series& series = find_series(results(), "retrofit-iterations");
  int largest = 0;
  for (const std::size_t row : {0U, 2U, 27U, 47U, 56U}) {  // s = -0.85, -0.75, 0.5, 1.5, 1.95
    const double s = static_cast<double>(row) / 20 - 0.85;
    EXPECT_NEAR(std::stod(series.rows[row][0]), s, 1e-12);
    std::vector<int> counts;
    for (const Points& p : family()) counts.push_back(retrofit_steps(p, s));
    const int most = *std::ranges::max_element(counts);
    EXPECT_EQ(std::stoi(series.rows[row][1]), most);
    EXPECT_NEAR(std::stod(series.rows[row][2]), std::accumulate(counts.begin(), counts.end(), 0) / 200.0,
                1e-9);
    EXPECT_NEAR(std::stod(series.rows[row][3]), std::abs(2 * s * (8 - s) / (3 * (6 + s))), 1e-11);
    if (row == 2 || row == 47) largest = std::max(largest, most);
  }
  EXPECT_EQ(value_of(results().claims, "retrofit.realtime.iterations"), largest);
  EXPECT_EQ(claim("retrofit.realtime.rate").exact, "13/15");  // 2 s (8 - s)/(3 (6 + s)) at 3/2
  EXPECT_EQ(claim("retrofit.realtime").verdict, Verdict::reproduced);
  EXPECT_EQ(claim("retrofit.realtime.slower").verdict, Verdict::reproduced);
  EXPECT_EQ(claim("retrofit.realtime.js-report").verdict, Verdict::not_reproducible);
}

TEST_F(PolygonCurves, RetrofittedCurvesMoveEverywhereByLittle) {
  // The numbers 1, 0, .., 0 on a loop of 12, retrofitted for s = 3/2 (mask 1/120 (1, 26, 66, 26, 1), jsplines
  // 6).
  constexpr std::size_t n = 12;
  Points p(n);
  Points target(n);
  target[0] = {1, 0};
  for (int k = 0; k < 400; ++k) {
    const Points before = p;
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](std::size_t j) { return before[(i + n + j - 2) % n][0]; };
      p[i][0] += target[i][0] - (at(0) + 26 * at(1) + 66 * at(2) + 26 * at(3) + at(4)) / 120;
    }
  }
  const Points fine = curve(p, 1.5, 1.5, 9);
  double farthest = 0;
  for (std::size_t i = 5 * 512; i < 6 * 512; i += 32) farthest = std::max(farthest, std::abs(fine[i][0]));
  const std::string three_digits = fmt::format("{:.3g}", farthest);
  EXPECT_NE(claim("retrofit.local.whole").note.find(three_digits), std::string::npos) << three_digits;
  EXPECT_EQ(claim("retrofit.local.whole").verdict, Verdict::reproduced);
  EXPECT_EQ(count("retrofit.local.nearby", 56), 56);
}

double distance_from_edges(const std::array<double, 2>& x, const Points& p) {
  double least = 1e300;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& a = p[i];
    const auto& b = p[(i + 1) % p.size()];
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double t = std::clamp(((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(x[0] - a[0] - t * dx, x[1] - a[1] - t * dy));
  }
  return least;
}

/// From the points of a curve, and from many points of its control polygon, to the other one.
double hausdorff_by_samples(const Points& p, double s) {
  constexpr std::size_t samples = 16;
  const Points fine = curve(p, s, s, 7);
  double largest = 0;
  for (const auto& x : fine) largest = std::max(largest, distance_from_edges(x, p));
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& b = p[(i + 1) % p.size()];
    for (std::size_t k = 0; k < samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      largest = std::max(
          largest,
          distance_from_edges({p[i][0] + t * (b[0] - p[i][0]), p[i][1] + t * (b[1] - p[i][1])}, fine));
    }
  }
  return largest;
}

TEST_F(PolygonCurves, TheFourPointCurveIsOftenCloserToThePolygon) {
  int closer = 0;
  for (const Points& p : family()) {
    const double fixed = hausdorff_by_samples(p, 0.375);
    closer += fixed < hausdorff_by_samples(p, 0) && fixed < hausdorff_by_samples(p, 1) ? 1 : 0;
  }
  EXPECT_NEAR(closer, static_cast<double>(count("popping.fixed.close", 200)), 2);
  EXPECT_EQ(claim("popping.fixed.close").verdict, Verdict::inconsistent);
}

/// The integral of the squared curvature times the length, by central differences of a fine curve.
double bending(const Points& p) {
  const std::size_t n = p.size();
  double energy = 0;
  double length = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& a = p[(i + n - 1) % n];
    const auto& b = p[(i + 1) % n];
    const double vx = (b[0] - a[0]) / 2;
    const double vy = (b[1] - a[1]) / 2;
    const double speed = std::hypot(vx, vy);
    const double cross = vx * (a[1] - 2 * p[i][1] + b[1]) - vy * (a[0] - 2 * p[i][0] + b[0]);
    energy += cross * cross / std::pow(speed, 5);
    length += speed;
  }
  return energy * length;
}

TEST_F(PolygonCurves, ShapesByCurvature) {
  int edges = 0;
  int rounded = 0;
  for (const Points& p : family()) {
    const auto energy = [&](double a, double b) {
      Points q = refined(p, a, b);
      for (int k = 0; k < 7; ++k) q = refined(q, 1.5, 1.5);
      return bending(q);
    };
    const double vertices = energy(-33.0 / 26, -33.0 / 26);
    edges += energy(29.0 / 59, 29.0 / 59) < vertices ? 1 : 0;
    rounded += vertices < energy(-7.0 / 4, 59.0 / 52) ? 1 : 0;
  }
  EXPECT_NEAR(edges, static_cast<double>(count("edge.tendency.shape", 200)), 2);
  EXPECT_NEAR(rounded, static_cast<double>(count("vertex.tendency.rounded", 200)), 2);
}

/// The quadratic B-spline curve with the middle of its basis functions at the control points.
std::array<double, 2> quadratic(const Points& p, std::size_t i, double t) {
  const std::size_t n = p.size();
  std::array<double, 2> result{};
  for (int j = -2; j <= 2; ++j) {
    const double x = std::abs(t - j);
    const double weight = x <= 0.5 ? 0.75 - x * x : x <= 1.5 ? (1.5 - x) * (1.5 - x) / 2 : 0;
    for (const std::size_t c : {0U, 1U})
      result[c] += weight * p[(i + n + static_cast<std::size_t>(j + 4) - 4) % n][c];
  }
  return result;
}

TEST_F(PolygonCurves, FitsByRefinement) {
  constexpr int depth = 11;  // the points i/64 of the 64 2^5 of a span
  int mean = 0;
  int largest = 0;
  for (const Points& p : family()) {
    std::array<double, 2> sums{};
    std::array<double, 2> maxima{};
    for (const std::size_t which : {0U, 1U}) {
      const double s = which == 0 ? 0.689 : 0.639;
      const Points fine = curve(p, s, s, depth);
      for (std::size_t k = 0; k < p.size() * 64; ++k) {
        const auto b2 = quadratic(p, k / 64, static_cast<double>(k % 64) / 64);
        const double d = std::hypot(fine[k * 32][0] - b2[0], fine[k * 32][1] - b2[1]);
        sums[which] += d;
        maxima[which] = std::max(maxima[which], d);
      }
    }
    mean += sums[0] < sums[1] ? 1 : 0;
    largest += maxima[1] < maxima[0] ? 1 : 0;
  }
  EXPECT_EQ(mean, count("fit.tendency.l1.js-report", 200));
  EXPECT_EQ(largest, count("fit.tendency.linf", 200));
  EXPECT_EQ(claim("fit.tendency.l1.jsplines").verdict, Verdict::consistent);
  EXPECT_EQ(claim("edge.tendency.shape").verdict, Verdict::consistent);
}

TEST_F(PolygonCurves, EveryHeadIsSettledOnce) {
  EXPECT_EQ(results().claims.size(), polygon_curve_heads().size());
  for (const ClaimHead& h : polygon_curve_heads()) EXPECT_NO_THROW(static_cast<void>(claim(h.id)));
}

}  // namespace
}  // namespace subdiv
