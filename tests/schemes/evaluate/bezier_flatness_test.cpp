#include "schemes/evaluate/bezier_flatness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "schemes/algebra/rational.h"

namespace subdiv {
namespace {

using Vector = std::vector<Rational>;

Vector point(const BezierCurve& curve, std::size_t i) {
  Vector result;
  for (const auto& c : curve) result.push_back(Rational::from_double(c[i]));
  return result;
}
Vector combination(const Rational& a, const Vector& x, const Rational& b, const Vector& y) {
  Vector result;
  for (std::size_t c = 0; c < x.size(); ++c) result.push_back(a * x[c] + b * y[c]);
  return result;
}
Vector minus(const Vector& x, const Vector& y) { return combination(Rational(1), x, Rational(-1), y); }
Rational inner(const Vector& x, const Vector& y) {
  Rational sum(0);
  for (std::size_t c = 0; c < x.size(); ++c) sum += x[c] * y[c];
  return sum;
}
Rational square(const Rational& x) { return x * x; }

std::size_t degree_of(const BezierCurve& curve) { return curve.front().size() - 1; }

Vector second_difference(const BezierCurve& curve, std::size_t i) {
  return minus(minus(point(curve, i - 1), point(curve, i)), minus(point(curve, i), point(curve, i + 1)));
}

Rational chord_factor(const BezierCurve& curve) {
  const auto n = static_cast<std::int64_t>(degree_of(curve));
  return {n * (n - 1), 8};
}

/// D^2.
Rational squared_difference(const BezierCurve& curve) {
  Rational largest(0);
  for (std::size_t i = 1; i < degree_of(curve); ++i) {
    const Vector d = second_difference(curve, i);
    largest = std::max(largest, inner(d, d));
  }
  return largest;
}

/// h^2.
Rational squared_distance_from_chord(const BezierCurve& curve) {
  const Vector chord = minus(point(curve, degree_of(curve)), point(curve, 0));
  const Rational length = inner(chord, chord);
  Rational largest(0);
  for (std::size_t i = 1; i < degree_of(curve); ++i) {
    const Vector from = minus(point(curve, i), point(curve, 0));
    Rational s = length.sign() == 0 ? Rational(0) : Rational(inner(from, chord) / length);
    s = std::clamp(s, Rational(0), Rational(1));
    const Vector rest = combination(Rational(1), from, Rational(-s), chord);
    largest = std::max(largest, inner(rest, rest));
  }
  return largest;
}

/// Whether x >= sqrt(a) + sqrt(b).
bool is_at_least_sum(const Rational& x, const Rational& a, const Rational& b) {
  const Rational rest = x * x - a - b;
  return rest.sign() >= 0 && square(rest) >= Rational(4) * a * b;
}

/// Whether x is at least the bound by second differences across the chord and by what reaches beyond it.
bool is_at_least_across_and_beyond(const Rational& x, const BezierCurve& curve) {
  const Vector first = point(curve, 0);
  const Vector last = point(curve, degree_of(curve));
  const Vector chord = minus(last, first);
  const Rational length = inner(chord, chord);
  if (length.sign() == 0) return false;
  Rational across(0);
  Rational beyond(0);
  for (std::size_t i = 1; i < degree_of(curve); ++i) {
    const Vector d = second_difference(curve, i);
    const Vector rest = combination(Rational(1), d, Rational(-inner(d, chord) / length), chord);
    across = std::max(across, inner(rest, rest));
    beyond = std::max(
        {beyond, inner(minus(first, point(curve, i)), chord), inner(minus(point(curve, i), last), chord)});
  }
  return is_at_least_sum(x, square(chord_factor(curve)) * across, square(beyond) / length);
}

/// The promise: in doubles not less than the smallest of the three bounds over Q.
bool chord_bound_is_rounded_upwards(const BezierCurve& curve) {
  const Rational bound = Rational::from_double(chord_distance_bound(curve));
  return square(bound) >= square(chord_factor(curve)) * squared_difference(curve) ||
         square(bound) >= squared_distance_from_chord(curve) || is_at_least_across_and_beyond(bound, curve);
}
bool polygon_bound_is_rounded_upwards(const BezierCurve& curve) {
  const auto n = static_cast<std::int64_t>(degree_of(curve));
  const Rational factor((n / 2) * (n - n / 2), 2 * n);
  return square(Rational::from_double(polygon_distance_bound(curve))) >=
         square(factor) * squared_difference(curve);
}

constexpr double smallest = std::numeric_limits<double>::denorm_min();

TEST(BezierFlatness, BoundsAreRoundedUpwards) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (std::size_t degree = 2; degree <= 7; ++degree) {
    for (std::size_t dimension = 1; dimension <= 4; ++dimension) {
      for (const int power : {0, -1068, 990}) {  // among subnormal numbers, too
        for (int trial = 0; trial < 10; ++trial) {
          BezierCurve curve(dimension);
          for (auto& c : curve) {
            for (std::size_t i = 0; i <= degree; ++i) c.push_back(std::ldexp(coordinate(random), power));
          }
          EXPECT_TRUE(chord_bound_is_rounded_upwards(curve)) << degree << ' ' << dimension << ' ' << power;
          EXPECT_TRUE(polygon_bound_is_rounded_upwards(curve)) << degree << ' ' << dimension << ' ' << power;
        }
      }
    }
  }
}

// What is rounded away counts: over Q, second differences of 4 |x|, of 2^-54, and of the smallest number.
TEST(BezierFlatness, BoundsOfDifferencesThatAreRounded) {
  for (const double x : {0.1, 0.3, 0.7, 1.0, 1.1}) {
    const BezierCurve zigzag{{x, -x, x}, {x / 3, -x / 3, x / 3}};
    EXPECT_TRUE(polygon_bound_is_rounded_upwards(zigzag)) << x;
    EXPECT_TRUE(chord_bound_is_rounded_upwards(zigzag)) << x;
  }
  const BezierCurve nearly_even{{1, -std::ldexp(1.0, -55), -1}};
  EXPECT_GT(squared_difference(nearly_even), Rational(0));
  EXPECT_TRUE(polygon_bound_is_rounded_upwards(nearly_even));
  const BezierCurve least{{0, 0, smallest}};
  EXPECT_TRUE(polygon_bound_is_rounded_upwards(least)) << "a quarter of the smallest number";
}

// A chord along the diagonal; beyond its end the curve comes close to its control points.
TEST(BezierFlatness, BeyondTheEndsOfADiagonalChord) {
  constexpr int degree = 30;
  std::vector<double> c(degree + 1, 3);
  c.front() = 0;
  c.back() = 1;
  // At t = 1/2 the weights of the ends are 2^-30, all others' value is 3.
  const double there = 3 - std::ldexp(1.0, -degree) * (3 + 2);
  EXPECT_GE(chord_distance_bound({c, c}), (there - 1) * std::sqrt(2.0));
  EXPECT_TRUE(chord_bound_is_rounded_upwards({c, c}));
}

// 63 second differences across a diagonal chord are D = 2^-20 (1, -1), one is more by 2^-53, which doubles do
// not see: 64 * 63/8 of it is more than the slack beyond the ends.
TEST(BezierFlatness, RoundingAcrossAChordCounts) {
  constexpr int degree = 64;
  BezierCurve curve(2);
  for (int i = 0; i <= degree; ++i) {
    const double along = i == 0 ? 1 : (i == 1 ? 0 : -1);
    const double across = std::ldexp(i * (degree - i) / 2.0, -20) + (i == 1 ? std::ldexp(1.0, -54) : 0);
    curve[0].push_back(along + across);
    curve[1].push_back(along - across);
  }
  EXPECT_TRUE(chord_bound_is_rounded_upwards(curve));
}

TEST(BezierFlatness, ClosedCurves) {  // chords of length 0: p(1/2) is 3/4 of the way to both inner points
  const double bound = chord_distance_bound({{1, 5, 5, 1}, {2, 5, 5, 2}});
  EXPECT_GE(bound, 0.75 * 5);
  EXPECT_LE(bound, 5 + 1e-12) << "the control points' distance";
}

// Degree 6000 from -2^1000 to 2^1000: n (n-1)/8 D is beyond the doubles, D = 4 2^1000 is not. By hand:
// 6000 * 5999/8 * 4 = 17997000, between 4^12 and 4^13.
TEST(BezierFlatness, LevelsOfHighDegrees) {
  BezierCurve curve(1);
  for (int i = 0; i <= 6000; ++i) curve[0].push_back(std::ldexp(i % 2 == 0 ? 1.0 : -1.0, 1000));
  EXPECT_EQ(levels_needed(curve, std::ldexp(1.0, 1000)), 13);
  EXPECT_EQ(levels_needed(curve, 1), 513);
  for (double& x : curve[0]) x = std::ldexp(x, -1000);
  EXPECT_EQ(levels_needed(curve, 1), 13);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_THROW((void)levels_needed({{largest, -largest, largest}}, 1), std::invalid_argument);
}

// In d equal coordinates a point is moved sqrt(d) times as far as in one; k halvings move it k times as far.
TEST(BezierFlatness, RoundingOfHalvings) {
  const std::vector<double> c{0.1, 0.7, -0.3, 0.5};
  const double once = rounding_of_halvings({c}, 1);
  EXPECT_GE(once, 3 * 0.7 * std::ldexp(1.0, -53));
  EXPECT_LE(once, 3 * 0.7 * std::ldexp(1.0, -53) * (1 + 1e-12));
  EXPECT_NEAR(rounding_of_halvings({c, c, c, c}, 1) / once, 2, 1e-12);
  EXPECT_NEAR(rounding_of_halvings({c}, 9) / once, 9, 1e-12);
  EXPECT_EQ(rounding_of_halvings({c}, 0), 0);
}

// Points +-1 in turn against +-(1 + e): D grows by 4 e, n (n-1)/8 D by 10 e for degree 5, and the curve is
// moved by up to e itself. Degree 2: the factor counts as 1.
TEST(BezierFlatness, RoundingOfBound) {
  const double e = std::ldexp(1.0, -10);
  EXPECT_GE(rounding_of_bound({{1 + e, -1 - e, 1 + e, -1 - e, 1 + e, -1 - e}}, e), 11 * e);
  EXPECT_LE(rounding_of_bound({{1 + e, -1 - e, 1 + e, -1 - e, 1 + e, -1 - e}}, e), 11 * e * (1 + 1e-9));
  EXPECT_GE(rounding_of_bound({{1 + e, -1 - e, 1 + e}}, e), 5 * e);
}

}  // namespace
}  // namespace subdiv
