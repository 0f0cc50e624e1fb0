#include "experiments/curve_figures.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "experiments/data.h"
#include "tests/experiments/find_claim.h"
#include "tests/plane_loop.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_curve_figures();
  return once;
}

const Claim& found(const std::string& id) { return test::find_claim(results().claims, id); }
double value(const std::string& id) { return test::value_of(results().claims, id); }

using Loop = test::Points;
using test::area;
using test::refined;

Loop stored(const std::string& file) {
  Loop loop;
  for (const auto& [x, y] : polygon_from_data(file)) loop.push_back({x.to_double(), y.to_double()});
  return loop;
}

/// J_{0,1}: mid-edge points inserted.
Loop linear(const Loop& p) { return refined(p, 0.0, 1.0); }

Loop refine_often(Loop p, double s, int depth) {
  for (int k = 0; k < depth; ++k) p = refined(p, s, s);
  return p;
}

double largest_squared(const Loop& p, const Loop& other, std::size_t stride = 1, std::size_t offset = 0) {
  double largest = 0;
  for (std::size_t i = 0; i < other.size(); ++i) {
    const auto& at = p[(i * stride + offset) % p.size()];
    largest = std::max(largest, std::pow(at[0] - other[i][0], 2) + std::pow(at[1] - other[i][1], 2));
  }
  return largest;
}

Loop mid_edges(const Loop& p) {
  Loop middles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& next = p[(i + 1) % p.size()];
    middles.push_back({(p[i][0] + next[0]) / 2, (p[i][1] + next[1]) / 2});
  }
  return middles;
}

TEST(CurveFigures, WhatIsPrintedHolds) {
  EXPECT_EQ(results().claims.size(), curve_figure_heads().size());
  for (const Claim& claim : results().claims) {
    EXPECT_EQ(claim.verdict, claim.head.printed ? Verdict::reproduced : Verdict::established)
        << claim.head.id;
    EXPECT_EQ(claim.rigour, Rigour::exact) << claim.head.id;
  }
  EXPECT_EQ(found("design.14").exact, "14");
}

TEST(CurveFigures, AreasByRefinementInDoubles) {
  const Loop shape = stored("figure-shape.csv");
  for (const auto& [name, s] : {std::pair{"j0", 0.0}, {"average", 0.5}, {"j1", 1.0}})
    EXPECT_NEAR(value(std::string("figure.three-curves.") + name),
                area(refine_often(shape, s, 6)) / area(shape), 1e-12);
  const Loop heptagon = stored("area-witness.csv");
  EXPECT_NEAR(value("figure.area"),
              area(refine_often(refined(heptagon, -0.0053, 1.0276), 0.4666, 5)) / area(heptagon), 1e-12);
}

// Fourteen levels down the points are limit points to 1e-6: no limit mask is used.
TEST(CurveFigures, DistancesOfLimitsByDeepRefinement) {
  constexpr int depth = 14;
  constexpr std::size_t stride = std::size_t{1} << depth;
  const Loop shape = stored("figure-shape.csv");
  const double near =
      largest_squared(refine_often(refined(shape, -33.0 / 26, -33.0 / 26), 1.5, depth - 1), shape, stride);
  EXPECT_NEAR(value("figure.anticipation"),
              near / largest_squared(refine_often(shape, 1.5, depth), shape, stride), 1e-6);
  const Loop middles = mid_edges(shape);
  double edge = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const auto& next = shape[(i + 1) % shape.size()];
    edge = std::max(edge, std::pow(next[0] - shape[i][0], 2) + std::pow(next[1] - shape[i][1], 2));
  }
  const double with_r = largest_squared(refine_often(refined(shape, 29.0 / 59, 29.0 / 59), 1.5, depth - 1),
                                        middles, stride, stride / 2);
  EXPECT_NEAR(value("figure.mid-edges.r"), with_r / edge, 1e-9);
  EXPECT_NEAR(value("figure.mid-edges.s"),
              largest_squared(refine_often(shape, 0.751, depth), middles, stride, stride / 2) / edge, 1e-10);
}

TEST(CurveFigures, DistanceFromTheQuadraticByItsClosedForm) {  // (1/2 - t)^2/2, 3/4 - t^2, (1/2 + t)^2/2
  constexpr int depth = 12;
  constexpr std::size_t samples = 32;
  const Loop shape = stored("figure-shape.csv");
  const Loop curve = refine_often(shape, 0.689, depth);
  const std::size_t n = shape.size();
  double largest = 0;
  for (std::size_t i = 0; i < n * samples; ++i) {
    const std::size_t middle = (i + samples / 2) / samples;  // the vertex whose parameter is nearest
    const double t = static_cast<double>(i) / samples - static_cast<double>(middle);
    const auto blend = [&](std::size_t c) {
      return std::pow(0.5 - t, 2) / 2 * shape[(middle + n - 1) % n][c] +
             (0.75 - t * t) * shape[middle % n][c] + std::pow(0.5 + t, 2) / 2 * shape[(middle + 1) % n][c];
    };
    const auto& at = curve[i << static_cast<unsigned>(depth - 5)];
    largest = std::max(largest, std::pow(at[0] - blend(0), 2) + std::pow(at[1] - blend(1), 2));
  }
  EXPECT_NEAR(value("figure.bsplines.quadratic"), largest, 1e-6);
}

TEST(CurveFigures,
     RetrofittingByTheErrorOfEachFrequency) {  // P <- P + (C - L P), in the frequencies of 8 points
  const Loop shape = stored("figure-shape.csv");
  const std::size_t n = shape.size();
  const auto error_after = [&](int iterations) {
    Loop error(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double w = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      const double response =
          1 - (66 + 52 * std::cos(w) + 2 * std::cos(2 * w)) / 120;  // quintic: 1,26,66,26,1
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t l = 0; l < n; ++l) {
          const double c =
              std::cos(w * (static_cast<double>(i) - static_cast<double>(l))) / static_cast<double>(n);
          error[i][0] += c * std::pow(response, iterations + 1) * shape[l][0];
          error[i][1] += c * std::pow(response, iterations + 1) * shape[l][1];
        }
      }
    }
    return largest_squared(error, Loop(n));
  };
  EXPECT_NEAR(value("figure.retrofit.iterations"), error_after(3) / error_after(0), 1e-10);
}

TEST(CurveFigures, LevelsByRefinementInDoubles) {
  const Loop shape = stored("figure-shape.csv");
  const auto moved = [&](double s) {
    const Loop coarse = refine_often(shape, s, 1);
    return largest_squared(refine_often(coarse, s, 1), linear(coarse));
  };
  EXPECT_NEAR(value("figure.levels"), moved(0.375) / moved(0), 1e-12);
  EXPECT_NEAR(value("figure.levels.cubic"), moved(0.375) / moved(1), 1e-12);
}

TEST(CurveFigures, EveryFigureHasItsNumbers) {
  for (const Figure& figure : results().figures) {
    const Series& series = test::find_series(results(), figure.name);
    EXPECT_GE(series.rows.size(), 8U) << figure.name;
    EXPECT_FALSE(figure.curves.empty());
  }
  EXPECT_EQ(results().figures.size(), 14U);
}

}  // namespace
}  // namespace subdiv
