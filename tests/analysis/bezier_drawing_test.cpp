#include "schemes/evaluate/bezier_drawing.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "analysis/hausdorff_distance.h"
#include "schemes/algebra/rational.h"
#include "schemes/evaluate/de_casteljau.h"
#include "schemes/input_error.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using subdiv::testing::expect_input_error;

/// Points on a curve by Bernstein's polynomials, another route than de Casteljau's.
std::vector<std::vector<double>> samples(const BezierCurve& curve, int count) {
  const std::size_t n = curve.front().size() - 1;
  std::vector<std::vector<double>> points(curve.size());
  for (int k = 0; k <= count; ++k) {
    const double t = static_cast<double>(k) / count;
    std::vector<double> weights(n + 1);
    double binomial = 1;
    for (std::size_t i = 0; i <= n; ++i) {
      weights[i] = binomial * std::pow(t, i) * std::pow(1 - t, n - i);
      binomial = binomial * static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    for (std::size_t c = 0; c < curve.size(); ++c) {
      double sum = 0;
      for (std::size_t i = 0; i <= n; ++i) sum += weights[i] * curve[c][i];
      points[c].push_back(sum);
    }
  }
  return points;
}

/// The distance of a polyline from curves sampled so finely that samples are within `close` of the curve.
DistanceBounds measured(const std::vector<BezierCurve>& curves, const BezierPolyline& line, double close) {
  std::vector<std::vector<double>> fine(curves.front().size());
  for (const BezierCurve& curve : curves) {
    const auto more = samples(curve, 4000);
    for (std::size_t c = 0; c < fine.size(); ++c)
      fine[c].insert(fine[c].end(), more[c].begin(), more[c].end());
  }
  return hausdorff_distance(make_polyline(line.coordinates, false), make_polyline(fine, false), close);
}

BezierCurve random_curve(std::mt19937& random, std::size_t dimension, std::size_t degree) {
  std::uniform_real_distribution<double> coordinate(-10, 10);
  BezierCurve curve(dimension);
  for (auto& c : curve) {
    for (std::size_t i = 0; i <= degree; ++i) c.push_back(coordinate(random));
  }
  return curve;
}

constexpr double rounding_of_samples = 1e-13;
constexpr std::size_t many = 1U << 20U;

TEST(DeCasteljau, SplitsAtAnyPlace) {  // over Q: both parts are the curve, by values at more places than n
  const std::vector<Rational> points{1, Rational(-2, 3), 5, Rational(7, 2), 0};
  const auto value = [](const std::vector<Rational>& b, const Rational& t) {
    Rational sum(0);
    Rational binomial(1);
    const int n = static_cast<int>(b.size()) - 1;
    for (int i = 0; i <= n; ++i) {
      sum += binomial * pow(t, i) * pow(Rational(1) - t, n - i) * b[static_cast<std::size_t>(i)];
      binomial *= Rational(n - i, i + 1);
    }
    return sum;
  };
  for (const Rational& t : {Rational(1, 2), Rational(1, 3), Rational(-2), Rational(0), Rational(1)}) {
    const auto [first, second] = split_bezier(points, [&](const Rational& a, const Rational& b) {
      return Rational((Rational(1) - t) * a + t * b);
    });
    for (int k = 0; k <= 5; ++k) {
      const Rational at(k, 7);
      EXPECT_EQ(value(first, at), value(points, at * t));
      EXPECT_EQ(value(second, at), value(points, t + at * (Rational(1) - t)));
    }
  }
}

TEST(BezierDrawing, KeepsItsToleranceForAllDegreesAndDimensions) {
  std::mt19937 random(7);
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    for (std::size_t dimension = 1; dimension <= 4; ++dimension) {
      const std::vector<BezierCurve> curves{random_curve(random, dimension, degree)};
      for (const double tolerance : {1.0, 0.01}) {
        const BezierPolyline line = draw_to_tolerance(curves, tolerance, many);
        EXPECT_LE(line.bound, tolerance);
        EXPECT_LE(line.deepest, levels_needed(curves[0], tolerance / 2));
        EXPECT_EQ(line.coordinates[0].size(), line.segments + 1);
        EXPECT_LE(measured(curves, line, 1e-4).lower, line.bound + rounding_of_samples);
      }
    }
  }
}

TEST(BezierDrawing, BoundsOfTheControlPolygonHold) {
  std::mt19937 random(11);
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    const std::vector<BezierCurve> curves{random_curve(random, 2, degree)};
    double before = 0;
    for (int depth = 0; depth <= 5; ++depth) {
      const BezierPolyline line = draw_to_depth(curves, depth, many);
      EXPECT_EQ(line.segments, degree << static_cast<unsigned>(depth));
      EXPECT_LE(measured(curves, line, 1e-4).lower, line.bound + rounding_of_samples);
      if (depth > 0) {
        EXPECT_LE(line.bound, before / 4 + 1e-12);
      }
      before = line.bound;
    }
  }
}

// Curves whose second differences are all equal attain both bounds: a parabola of any formal degree.
TEST(BezierDrawing, BoundsAreAttained) {
  for (std::size_t n = 2; n <= 9; ++n) {
    BezierCurve parabola(2);
    for (std::size_t i = 0; i <= n; ++i) {
      const auto x = static_cast<double>(i);
      parabola[0].push_back(0);
      parabola[1].push_back(x * x / 2);
    }
    const auto size = static_cast<double>(n);
    // (n (n-1) t^2 + n t)/2 against n^2 t/2: n (n-1)/8 at t = 1/2.
    const auto [first, second] = split_bezier(parabola[1], [](double a, double b) { return (a + b) / 2; });
    EXPECT_NEAR(size * size / 4 - second[0], size * (size - 1) / 8, 1e-12);
    // Chord and curve lie on one line here: the other bound sees that they are the same set.
    EXPECT_LT(chord_distance_bound(parabola), 1e-12);
    const double middle = static_cast<double>(n / 2);
    const double products = middle * (size - middle);
    EXPECT_NEAR(polygon_distance_bound(parabola), products / (2 * size), 1e-12);
    const double t = middle / size;
    const double on_curve = (size * (size - 1) * t * t + size * t) / 2;
    EXPECT_NEAR(on_curve - middle * middle / 2, products / (2 * size), 1e-12);
  }
  EXPECT_NEAR(polygon_distance_bound({{0, 0, 0, 1}, {0, 0, 0, 0}}), 1.0 / 3, 1e-12) << "a cubic: D/3";
}

// What second differences do along the chord does not count: the arch rises to 3/4, the parabola to 1/2.
TEST(BezierDrawing, OnlyBendsAcrossTheChordCount) {
  EXPECT_NEAR(chord_distance_bound({{0, 1, 9, 10}, {0, 1, 1, 0}}), 0.75, 1e-12);
  EXPECT_NEAR(chord_distance_bound({{0, 1, 2}, {0, 1, 0}}), 0.5, 1e-12);
  // Beyond the ends it does: from (0, 0) over (-3, 1), (3, 1) to (0, 0) or nearly so.
  const std::vector<BezierCurve> beyond{{{0, -3, 3, 1}, {0, 1, 1, 0}}};
  const BezierPolyline chord{{{0, 1}, {0, 0}}, 1, 0, chord_distance_bound(beyond[0])};
  EXPECT_LE(measured(beyond, chord, 1e-6).lower, chord.bound);
}

// Wang's number of levels, by hand: n (n-1)/8 D = 3/4 sqrt(2) = 1.06; four levels divide it by 256.
TEST(BezierDrawing, LevelsNeeded) {
  const BezierCurve arch{{0, 0, 1, 1}, {0, 1, 1, 0}};
  EXPECT_EQ(levels_needed(arch, 2), 0);
  EXPECT_EQ(levels_needed(arch, 1), 1);
  EXPECT_EQ(levels_needed(arch, 1.0607 / 256), 4);
  EXPECT_EQ(levels_needed(arch, 1.0606 / 256), 5);
  EXPECT_EQ(levels_needed({{0, 5}}, 1e-9), 0);
}

TEST(BezierDrawing, DegenerateCurves) {
  const std::vector<BezierCurve> point{{{2, 2, 2, 2}, {3, 3, 3, 3}}};
  EXPECT_EQ(draw_to_tolerance(point, 1e-9, many).segments, 1U);
  // Collinear and in order: the chord is the curve.
  const std::vector<BezierCurve> line{{{0, 0, 3, 9}, {0, 0, 6, 18}}};
  EXPECT_EQ(draw_to_tolerance(line, 1e-9, many).segments, 1U);
  // Collinear, beyond the ends: the chord misses what sticks out, at most 1.5 * 6/8 on either side.
  const std::vector<BezierCurve> overshoot{{{0, 3, -2, 1}, {0, 0, 0, 0}}};
  const BezierPolyline there_and_back = draw_to_tolerance(overshoot, 1e-3, many);
  EXPECT_GT(there_and_back.segments, 2U);
  EXPECT_LE(measured(overshoot, there_and_back, 1e-6).lower, 1e-3);
  // Ends that are equal: the chord has length 0, and the loop is drawn all the same.
  const std::vector<BezierCurve> loop{{{0, 4, -4, 0}, {0, 6, 6, 0}}};
  const BezierPolyline closed = draw_to_tolerance(loop, 1e-3, many);
  EXPECT_GT(closed.segments, 8U);
  EXPECT_LE(measured(loop, closed, 1e-5).lower, 1e-3);
  EXPECT_EQ(closed.coordinates[0].front(), closed.coordinates[0].back());
  // A cusp at t = 1/2: the derivative has Bezier points 3 (2, 2), 3 (-2, 0), 3 (2, -2).
  const std::vector<BezierCurve> cusp{{{0, 2, 0, 2}, {0, 2, 2, 0}}};
  EXPECT_LE(measured(cusp, draw_to_tolerance(cusp, 1e-4, many), 1e-6).lower, 1e-4);
}

// Halving is exact where digits suffice: dyadic points stay what rational arithmetic says.
TEST(BezierDrawing, CornersLieOnTheCurveExactlyForSmallIntegers) {
  const std::vector<BezierCurve> curves{{{0, 8, -16, 24}, {8, 0, 64, 16}}};
  const BezierPolyline line = draw_to_tolerance(curves, 0.01, many);
  std::size_t found = 0;
  const auto all = samples(curves[0], 1 << line.deepest);
  for (std::size_t i = 0; i < line.coordinates[0].size(); ++i) {
    for (std::size_t k = 0; k < all[0].size(); ++k) {
      if (std::hypot(all[0][k] - line.coordinates[0][i], all[1][k] - line.coordinates[1][i]) < 1e-13) {
        ++found;
        break;
      }
    }
  }
  EXPECT_EQ(found, line.segments + 1);
}

TEST(BezierDrawing, PointsGatherWhereCurvatureIsLarge) {
  // The parabola's axis: P1 close to the chord's middle makes a sharp turn at t = 1/2.
  const std::vector<BezierCurve> hairpin{{{0, 10, 10, 0}, {0, 0.05, 0.15, 0.2}}};
  const BezierPolyline line = draw_to_tolerance(hairpin, 1e-3, many);
  const BezierPolyline uniform = draw_to_depth(hairpin, line.deepest, many);
  EXPECT_LT(2 * line.segments, uniform.segments / 3) << "chords, against parts of uniform halving";
}

TEST(BezierDrawing, ScalesWithItsInput) {
  const BezierCurve curve{{0, 3, -1, 4}, {1, 5, 9, 2}};
  const std::size_t segments = draw_to_tolerance({curve}, 1e-3, many).segments;
  for (const int power : {-900, -300, 300, 990}) {
    BezierCurve scaled = curve;
    for (auto& c : scaled) {
      for (double& x : c) x = std::ldexp(x, power);
    }
    const BezierPolyline line = draw_to_tolerance({scaled}, std::ldexp(1e-3, power), many);
    EXPECT_EQ(line.segments, segments) << power;
    EXPECT_LE(line.bound, std::ldexp(1e-3, power));
  }
}

// Halving in doubles against halving over Q: control points are off by no more than is said.
TEST(BezierDrawing, RoundingIsBounded) {
  std::mt19937 random(13);
  constexpr int depth = 7;
  for (const std::size_t degree : {2U, 3U, 6U}) {
    for (const int power : {0, -1070, 900}) {  // among subnormal numbers, too
      BezierCurve curve = random_curve(random, 1, degree);
      for (double& x : curve[0]) x = std::ldexp(x, power);
      std::vector<std::vector<Rational>> parts(1);
      for (const double x : curve[0]) parts[0].push_back(Rational::from_double(x));
      for (int level = 0; level < depth; ++level) {
        std::vector<std::vector<Rational>> finer;
        for (const auto& part : parts) {
          auto [first, second] = split_bezier(
              part, [](const Rational& a, const Rational& b) { return Rational((a + b) / Rational(2)); });
          finer.push_back(std::move(first));
          finer.push_back(std::move(second));
        }
        parts = std::move(finer);
      }
      const std::vector<double> line = draw_to_depth({curve}, depth, many).coordinates[0];
      const Rational bound = Rational::from_double(rounding_of_halvings(curve, depth));
      Rational largest(0);
      for (std::size_t k = 0; k < parts.size(); ++k) {
        for (std::size_t i = 0; i <= degree; ++i) {
          const Rational difference = Rational::from_double(line[k * degree + i]) - parts[k][i];
          largest = std::max(largest, difference.sign() < 0 ? -difference : difference);
        }
      }
      EXPECT_LE(largest, bound) << degree << ' ' << power;
      EXPECT_GT(largest, Rational(0)) << "there is rounding to speak of";
    }
  }
}

// Far from the origin rounding is coarser than the curve: the bound knows.
TEST(BezierDrawing, CurvesFarFromTheOrigin) {
  BezierCurve curve{{0, 1, 2, 3}, {0, 1, 1, 0}};
  const double far = std::ldexp(1.0, 40);
  for (auto& c : curve) {
    for (double& x : c) x += far;
  }
  const BezierPolyline line = draw_to_tolerance({curve}, 0.05, many);
  EXPECT_LE(line.bound, 0.05);
  EXPECT_GT(line.bound, std::ldexp(1.0, 40 - 53));
  expect_input_error([&] { (void)draw_to_tolerance({curve}, 1e-5, many); }, {"rounding"});
}

TEST(BezierDrawing, ConsecutiveCurvesShareTheirEnds) {
  const auto curves = consecutive_curves({{0, 1, 2, 3, 4, 5, 6}}, 3);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[1], (BezierCurve{{3, 4, 5, 6}}));
  const BezierPolyline line = draw_to_tolerance(curves, 0.1, many);
  EXPECT_EQ(line.coordinates[0], (std::vector<double>{0, 3, 6}));
  expect_input_error([] { (void)consecutive_curves({{0, 1, 2, 3, 4}}, 3); }, {"5", "4, 7, 10"});
  expect_input_error([] { (void)consecutive_curves({{0}}, 1); }, {"1", "2, 3, 4"});
  expect_input_error([] { (void)consecutive_curves({{0, 1}}, 0); }, {"degree", "0"});
}

TEST(BezierDrawing, RefusesWhatItCannotKeep) {
  const BezierCurve curve{{0, 3, -1, 4}, {1, 5, 9, 2}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 1e303}) {
    const BezierCurve with_bad{{0, 1, bad, 2}};
    expect_input_error([&] { (void)draw_to_tolerance({with_bad}, 1, many); }, {"control point 3", "2^1000"});
    expect_input_error([&] { (void)draw_to_depth({with_bad}, 1, many); }, {"control point 3", "2^1000"});
  }
  expect_input_error([&] { (void)draw_to_tolerance({curve}, 0, many); }, {"positive", "0"});
  expect_input_error([&] { (void)draw_to_tolerance({curve}, nan, many); }, {"positive"});
  expect_input_error([&] { (void)draw_to_tolerance({curve}, 1e-15, many); }, {"rounding", "can be kept"});
  expect_input_error([&] { (void)draw_to_tolerance({curve}, 1e-6, 100); }, {"more than 100 segments"});
  expect_input_error([&] { (void)draw_to_depth({curve}, 6, 100); }, {"depth of 6", "5 is the most"});
  expect_input_error([&] { (void)draw_to_depth({curve}, -1, 100); }, {"-1"});
  expect_input_error([&] { (void)draw_to_tolerance({}, 1, many); }, {"no Bezier curve"});
  expect_input_error([&] { (void)draw_to_tolerance({{{0, 1}, {2}}}, 1, many); }, {"curve 1"});
}

// The tolerance that a refusal names, as it is printed, is kept. Far from the origin, where it is coarse.
TEST(BezierDrawing, TheToleranceThatARefusalNamesIsKept) {
  const BezierCurve square{{0, 0, 1, 1}, {0, 1, 1, 0}};
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const int power : {0, 3, -7, -1040, -1060}) {
    for (const double tolerance : {1e-300, 1e-20, 1e-16}) {
      BezierCurve curve = square;
      for (auto& c : curve) {
        for (double& x : c) x = std::ldexp(x + std::ldexp(1.0, 30), power);
      }
      try {
        (void)draw_to_tolerance({curve}, std::max(std::ldexp(tolerance, power), least), many);
        ADD_FAILURE() << "kept " << tolerance;
      } catch (const InputError& error) {
        const std::string message = error.what();
        const std::string before = "a tolerance of ";
        ASSERT_NE(message.find("can be kept"), std::string::npos) << message;
        const double named = std::strtod(message.c_str() + message.rfind(before) + before.size(), nullptr);
        EXPECT_LE(draw_to_tolerance({curve}, named, many).bound, named);
      }
    }
  }
}

// Half of a tolerance is for rounding: it is refused where rounding may take more.
TEST(BezierDrawing, HalfOfTheToleranceIsForRounding) {
  const BezierCurve square{{0, 0, 1, 1}, {0, 1, 1, 0}};
  const auto taken = [&](double tolerance) {
    return rounding_of_bound(square, rounding_of_halvings(square, levels_needed(square, tolerance / 2)));
  };
  double least = 1;
  while (taken(least) <= least / 2) least *= 0.999;
  EXPECT_GT(least, taken(least)) << "less than the tolerance, more than half of it";
  expect_input_error([&] { (void)draw_to_tolerance({square}, least, many * many); }, {"rounding"});
  // Where the last halving is needed for one half of the tolerance but not for the whole, it counts.
  EXPECT_GT(levels_needed(square, least / 2), levels_needed(square, 1.9 * least));
}

// Both bounds contain what halving in doubles may have moved the points.
TEST(BezierDrawing, BoundsContainRounding) {
  const BezierCurve arch{{0, 0.1, 0.2}, {0, 0.1, 0}};
  const auto [x0, x1] = split_bezier(arch[0], [](double a, double b) { return (a + b) / 2; });
  const auto [y0, y1] = split_bezier(arch[1], [](double a, double b) { return (a + b) / 2; });
  const double halves = std::max(chord_distance_bound({x0, y0}), chord_distance_bound({x1, y1}));
  ASSERT_LT(halves, chord_distance_bound(arch));
  EXPECT_EQ(draw_to_tolerance({arch}, halves, many).deepest, 2) << "nothing is left for rounding";
  const double enough = halves + rounding_of_halvings(arch, 1);
  EXPECT_EQ(draw_to_tolerance({arch}, enough, many).deepest, 1);
  EXPECT_EQ(draw_to_tolerance({arch}, enough, many).bound, enough);
  // A line segment is its own polygon, but in doubles its points leave it.
  const BezierCurve line{{0.1, 0.7}, {0.3, 1.9}};
  const BezierPolyline parts = draw_to_depth({line}, 4, many);
  const auto at = [&](std::size_t c, std::size_t i) {
    return Rational::from_double(parts.coordinates[c][i]) - Rational::from_double(line[c][0]);
  };
  Rational largest(0);  // the distance from the line, times its length
  for (std::size_t i = 1; i < 16; ++i) {
    const Rational across = at(0, i) * at(1, 16) - at(1, i) * at(0, 16);
    largest = std::max(largest, across.sign() < 0 ? Rational(-across) : across);
  }
  const Rational bound = Rational::from_double(parts.bound);
  EXPECT_GT(largest, Rational(0)) << "there is rounding to speak of";
  EXPECT_GE(bound * bound * (at(0, 16) * at(0, 16) + at(1, 16) * at(1, 16)), largest * largest);
}

TEST(BezierDrawing, AsManySegmentsAsAllowed) {
  const BezierCurve curve{{0, 3, -1, 4}, {1, 5, 9, 2}};
  const std::size_t segments = draw_to_tolerance({curve}, 1e-3, many).segments;
  EXPECT_EQ(draw_to_tolerance({curve}, 1e-3, segments).segments, segments);
  expect_input_error([&] { (void)draw_to_tolerance({curve}, 1e-3, segments - 1); }, {"segments"});
}

TEST(BezierDrawing, SmallTolerancesAreKept) {
  const BezierCurve curve{{0, 3, -1, 4}, {1, 5, 9, 2}};
  EXPECT_LE(draw_to_tolerance({curve}, 1e-10, many).bound, 1e-10);
}

}  // namespace
}  // namespace subdiv
