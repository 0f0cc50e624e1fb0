#include "experiments/polyloop_smoothing.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "experiments/data.h"
#include "experiments/simple_polygons.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using test::find_claim;
using test::find_series;
using test::value_of;

const Results& smoothing() {
  static const Results once = run_polyloop_smoothing();
  return once;
}
const Results& filters() {
  static const Results once = run_polyloop_filters();
  return once;
}

std::set<std::string> refuted_of(std::span<const ClaimHead> heads, const Results& results) {
  std::set<std::string> ids;
  for (const ClaimHead& head : heads) ids.insert(head.id);
  EXPECT_EQ(ids.size(), heads.size());
  EXPECT_EQ(results.claims.size(), heads.size());
  std::set<std::string> refuted;
  for (const Claim& claim : results.claims) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
    if (claim.verdict == Verdict::refuted) refuted.insert(claim.head.id);
  }
  return refuted;
}

TEST(PolyloopSmoothing, WhatIsRefuted) {
  EXPECT_EQ(refuted_of(polyloop_operator_heads(), run_polyloop_operators()),
            (std::set<std::string>{"polyloops.dual.squared", "polyloops.rtu.caption"}));
  EXPECT_EQ(refuted_of(polyloop_smoothing_heads(), smoothing()),
            (std::set<std::string>{"polyloops.tuck.range.end", "polyloops.push-pull.adjust",
                                   "polyloops.push-pull.fixed.closed", "polyloops.shrink.circle"}));
  EXPECT_TRUE(refuted_of(polyloop_filter_heads(), filters()).empty());
}

TEST(PolyloopSmoothing, NumbersOfTheChapter) {
  EXPECT_EQ(find_claim(smoothing().claims, "polyloops.push-pull.unstable.gain").exact, "5/3");
  EXPECT_NEAR(value_of(smoothing().claims, "polyloops.push-pull.stable"), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(find_claim(smoothing().claims, "polyloops.shrink.ellipse.n4").exact, "2/3");
}

/// The slowest part of {tuck(s); tuck(-s)} by the moduli of 1 - s^2 x_k^2 in doubles, against the bound of
/// the note of polyloops.push-pull.fixed.closed.
TEST(PolyloopSmoothing, SlowestPartOfPushPull) {
  for (const int n : {4, 5, 6, 9, 12}) {
    for (int i = 1; i < 70; ++i) {
      const double s = i / 100.0;
      std::vector<double> x;
      for (int k = 1; k <= n / 2; ++k) x.push_back(1 - std::cos(2 * std::numbers::pi * k / n));
      const auto kept = [&](double at) { return std::abs(1 - s * s * at * at); };
      double largest = 0;
      for (const double at : x) largest = std::max(largest, kept(at));
      const bool first = s * s * (x.front() * x.front() + x.back() * x.back()) < 2;
      EXPECT_NEAR(largest, kept(first ? x.front() : x.back()), 1e-14) << n << " " << s;
      if (!first) {
        EXPECT_GT(kept(x.back()), kept(x.front()) - 1e-14);
      }
    }
  }
  const std::string note = find_claim(smoothing().claims, "polyloops.push-pull.fixed.closed").note;
  EXPECT_NE(note.find("(x_1^2 + x_max^2) < 2"), std::string::npos) << note;
}

TEST(PolyloopSmoothing, RegionOfPushPullAgreesWithGains) {  // by samples of s, t and the frequency
  for (int i = 0; i <= 24; ++i) {
    for (int j = 0; j <= 24; ++j) {
      const double s = i / 16.0;
      const double t = j / 16.0;
      double largest = 0;
      for (int k = 0; k <= 2000; ++k) {
        const double x = k / 1000.0;
        largest = std::max(largest, std::abs((1 - s * x) * (1 + t * x)));
      }
      EXPECT_EQ(largest <= 1 + 1e-12, t <= s && s * (1 + 2 * t) <= 1 + t) << s << " " << t;
    }
  }
}

TEST(PolyloopSmoothing, SeriesOfTransferFunctionsHasTheClosedForm) {
  const Series& series = find_series(filters(), "polyloops-transfer");
  for (const std::vector<std::string>& row : series.rows) {
    const double x = 1 - std::cos(std::numbers::pi * std::stod(row[0]));
    EXPECT_NEAR(std::stod(row[1]), 1 - x / 2, 1e-13);
    EXPECT_NEAR(std::stod(row[3]), 1 - x * x / 4, 1e-13);
    EXPECT_NEAR(std::stod(row[4]), (1 - x / 2) * (1 + 0.7 * x), 1e-13);
    EXPECT_NEAR(std::stod(row[5]), std::pow((1 - x / 2) * (1 + 0.7 * x), 20), 1e-12);
    EXPECT_NEAR(std::stod(row[6]), 1 - 2 * x * x / 3, 1e-13);
  }
}

TEST(PolyloopSmoothing, RefinedAndSmoothedTurnsByAngles) {
  const auto sharpest = [](const std::vector<std::complex<double>>& p) {
    double largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto next = p[(i + 1) % p.size()];
      largest = std::max(largest, std::abs(std::arg((p[(i + 2) % p.size()] - next) / (next - p[i]))));
    }
    return largest;
  };
  int smoother = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    std::vector<std::complex<double>> p;
    for (const auto& [x, y] : polygon) p.emplace_back(x.to_double(), y.to_double());
    const double before = sharpest(p);
    for (int k = 0; k < 2; ++k) {
      std::vector<std::complex<double>> fine;
      for (std::size_t i = 0; i < p.size(); ++i) {
        fine.push_back(p[i]);
        fine.push_back((p[i] + p[(i + 1) % p.size()]) / 2.0);
      }
      p = fine;
    }
    for (int k = 0; k < 4; ++k) {
      auto tucked = p;
      for (std::size_t i = 0; i < p.size(); ++i)
        tucked[i] = (p[(i + p.size() - 1) % p.size()] + 2.0 * p[i] + p[(i + 1) % p.size()]) / 4.0;
      p = tucked;
    }
    smoother += sharpest(p) < before ? 1 : 0;
  }
  EXPECT_NEAR(value_of(smoothing().claims, "polyloops.refine-then-smooth") * 200, smoother, 1e-9);
}

TEST(PolyloopSmoothing, TheNoisyPolyloopFollowsItsRule) {  // data/README.md
  std::mt19937 random(20060101);
  const auto points = polygon_from_data("polyloop-noisy.csv");
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double a = 2 * std::numbers::pi * static_cast<double>(j) / 96;
    const double r = 1000 * (1 + std::cos(3 * a) / 4 + 0.12 * std::sin(2 * a));
    const long dx = static_cast<long>(random() % 121) - 60;
    const long dy = static_cast<long>(random() % 121) - 60;
    EXPECT_EQ(points[j].first, Rational(std::lround(r * std::cos(a)) + dx)) << j;
    EXPECT_EQ(points[j].second, Rational(std::lround(r * std::sin(a)) + dy)) << j;
  }
}

/// Areas and energies from the Fourier coefficients of the polyloop: a mode of frequency w and complex
/// amplitude c has the area n |c|^2 sin(w)/2 and the energy n |c|^2 x^2.
TEST(PolyloopSmoothing, NoisyPolyloopByItsFrequencies) {
  const auto points = polygon_from_data("polyloop-noisy.csv");
  const std::size_t n = points.size();
  ASSERT_EQ(n, 96U);
  const auto kept = [&](double s, double t) {
    double area = 0;
    double whole = 0;
    double energy = 0;
    double rough = 0;
    for (std::size_t k = 0; k < n; ++k) {
      std::complex<double> c;
      const double w = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      for (std::size_t j = 0; j < n; ++j) {
        c += std::complex<double>(points[j].first.to_double(), points[j].second.to_double()) *
             std::polar(1.0, -w * static_cast<double>(j));
      }
      const double x = 1 - std::cos(w);
      const double gain = std::pow((1 - s * x) * (1 + t * x), 20);
      whole += std::norm(c) * std::sin(w);
      area += std::norm(c * gain) * std::sin(w);
      rough += std::norm(c) * x * x;
      energy += std::norm(c * gain) * x * x;
    }
    return std::pair(area / whole, energy / rough);
  };
  EXPECT_NEAR(value_of(filters().claims, "figure.polyloops.noisy.tuck"), kept(0.5, 0).first, 1e-10);
  EXPECT_NEAR(value_of(filters().claims, "figure.polyloops.noisy.push-pull"), kept(0.5, 0.5).first, 1e-10);
  EXPECT_NEAR(value_of(filters().claims, "figure.polyloops.noisy.balanced"), kept(0.5, 0.53).first, 1e-10);
  EXPECT_NEAR(value_of(filters().claims, "figure.polyloops.noisy.energy"), kept(0.5, 0.53).second, 1e-10);
}

}  // namespace
}  // namespace subdiv
