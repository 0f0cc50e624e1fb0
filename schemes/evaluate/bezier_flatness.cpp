#include "schemes/evaluate/bezier_flatness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>

namespace subdiv {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
constexpr double smallest = std::numeric_limits<double>::denorm_min();

std::size_t degree_of(const BezierCurve& curve) { return curve.front().size() - 1; }

double largest_coordinate(const BezierCurve& curve) {
  double largest = 0;
  for (const std::vector<double>& c : curve) {
    for (const double x : c) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

double root_of_dimension(const BezierCurve& curve) {
  return std::sqrt(static_cast<double>(curve.size())) * (1 + 4 * unit);
}

/// n (n-1)/8.
double chord_factor(const BezierCurve& curve) {
  const auto n = static_cast<double>(degree_of(curve));
  return n * (n - 1) / 8;
}

double times_above(double a, double b) { return a * b * (1 + 4 * unit) + smallest; }

/// The length of a vector whose coordinates are off by at most `error`, rounded upwards.
double length_above(const std::vector<double>& v, double error) {
  double scale = 0;
  for (const double x : v) scale = std::max(scale, std::abs(x));
  if (std::isinf(scale)) return scale;
  double squares = 0;
  for (const double x : v) squares += scale > 0 ? (x / scale) * (x / scale) : 0;
  const auto dimension = static_cast<double>(v.size());
  const double slack = 1 + (2 * dimension + 16) * unit;
  return (scale * std::sqrt(squares) + std::sqrt(dimension) * error) * slack + smallest;
}

/// Differences of three coordinates, or of two and a part of a chord, are off by at most this.
double difference_error(const BezierCurve& curve) { return 16 * unit * largest_coordinate(curve); }

std::vector<double> second_difference(const BezierCurve& curve, std::size_t i) {
  std::vector<double> difference;
  for (const std::vector<double>& c : curve) difference.push_back((c[i - 1] - c[i]) - (c[i] - c[i + 1]));
  return difference;
}

/// D, rounded upwards.
double largest_second_difference(const BezierCurve& curve) {
  const double error = difference_error(curve);
  double largest = 0;
  for (std::size_t i = 1; i < degree_of(curve); ++i)
    largest = std::max(largest, length_above(second_difference(curve, i), error));
  return largest;
}

double inner_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += a[c] * b[c];
  return sum;
}

/// The bound by second differences across the chord, rounded upwards: each is a multiple of the chord, any
/// one will do, and a rest. Nothing for chords of length 0.
std::optional<double> distance_from_line_and_beyond(const BezierCurve& curve) {
  const std::size_t n = degree_of(curve);
  std::vector<double> chord;
  for (const std::vector<double>& c : curve) chord.push_back(c[n] - c[0]);
  double scale = 0;
  for (const double x : chord) scale = std::max(scale, std::abs(x));
  if (!(scale > 0)) return std::nullopt;
  for (double& x : chord) x /= scale;
  const double squares = inner_product(chord, chord);
  const double error = 4 * static_cast<double>(curve.size()) * difference_error(curve);
  double across = 0;
  double beyond = 0;
  for (std::size_t i = 1; i < n; ++i) {
    std::vector<double> rest = second_difference(curve, i);
    const double along = inner_product(rest, chord) / squares;
    std::vector<double> from_first;
    std::vector<double> from_last;
    for (std::size_t c = 0; c < curve.size(); ++c) {
      rest[c] -= along * chord[c];
      from_first.push_back(curve[c][i] - curve[c][0]);
      from_last.push_back(curve[c][i] - curve[c][n]);
    }
    across = std::max(across, length_above(rest, error));
    beyond = std::max({beyond, -inner_product(from_first, chord), inner_product(from_last, chord)});
  }
  beyond = times_above(beyond, 1 / std::sqrt(squares)) + error * root_of_dimension(curve);
  return times_above(chord_factor(curve), across) + beyond * (1 + 4 * unit);
}

/// h, rounded upwards. Any place on the chord bounds the distance from it, so that the nearest one need not
/// be exact.
double largest_distance_from_chord(const BezierCurve& curve) {
  const std::size_t n = degree_of(curve);
  const double error = difference_error(curve);
  double scale = 0;
  for (const std::vector<double>& c : curve) scale = std::max(scale, std::abs(c[n] - c[0]));
  double largest = 0;
  std::vector<double> rest(curve.size());
  for (std::size_t i = 1; i < n; ++i) {
    double product = 0;
    double squares = 0;
    for (const std::vector<double>& c : curve) {
      const double chord = scale > 0 ? (c[n] - c[0]) / scale : 0;
      product += scale > 0 ? (c[i] - c[0]) / scale * chord : 0;
      squares += chord * chord;
    }
    const double place = squares > 0 ? product / squares : 0;
    const double s = place > 0 ? std::min(place, 1.0) : 0;  // 0 for a NaN of huge quotients, too
    for (std::size_t c = 0; c < curve.size(); ++c)
      rest[c] = (curve[c][i] - curve[c][0]) - s * (curve[c][n] - curve[c][0]);
    largest = std::max(largest, length_above(rest, error));
  }
  return largest;
}

}  // namespace

double chord_distance_bound(const BezierCurve& curve) {
  if (degree_of(curve) < 2) return 0;
  const double bound = std::min(times_above(chord_factor(curve), largest_second_difference(curve)),
                                largest_distance_from_chord(curve));
  return std::min(bound, distance_from_line_and_beyond(curve).value_or(bound));
}

double polygon_distance_bound(const BezierCurve& curve) {
  const std::size_t n = degree_of(curve);
  if (n < 2) return 0;
  const std::size_t middle = n / 2;
  const std::size_t product = middle * (n - middle);
  return times_above(static_cast<double>(product) / (2 * static_cast<double>(n)),
                     largest_second_difference(curve));
}

int levels_needed(const BezierCurve& curve, double tolerance) {
  if (!(tolerance > 0)) throw std::invalid_argument("a tolerance must be positive");
  if (degree_of(curve) < 2) return 0;
  constexpr double per_level = 4;
  double difference = largest_second_difference(curve);
  if (!std::isfinite(difference)) throw std::invalid_argument("second differences of a curve are too large");
  int levels = 0;
  // High degrees take the bound beyond the doubles, from where no division leads back; D is not.
  for (; std::isinf(times_above(chord_factor(curve), difference)); difference /= per_level) ++levels;
  for (double bound = times_above(chord_factor(curve), difference); bound > tolerance; bound /= per_level)
    ++levels;
  return levels;
}

double rounding_of_halvings(const BezierCurve& curve, int halvings) {
  if (halvings == 0) return 0;
  const double once = largest_coordinate(curve) * unit + smallest;
  const auto averages = static_cast<double>(degree_of(curve)) * halvings;
  return times_above(averages * once, root_of_dimension(curve));
}

double rounding_of_bound(const BezierCurve& curve, double error) {
  const double of_differences =
      4 * error + times_above(difference_error(curve), 2 * root_of_dimension(curve));
  return error + times_above(std::max(1.0, chord_factor(curve)), of_differences);
}

}  // namespace subdiv
