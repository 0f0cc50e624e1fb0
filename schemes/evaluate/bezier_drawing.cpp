#include "schemes/evaluate/bezier_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "schemes/evaluate/de_casteljau.h"
#include "schemes/input_error.h"

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

/// What `halvings` of the whole curve may have moved a control point: each of n averages of a halving adds
/// half a unit in the last place, or half the smallest number; averages do not enlarge what is there.
double rounding_after(const BezierCurve& whole, int halvings) {
  if (halvings == 0) return 0;
  const double once = largest_coordinate(whole) * unit + smallest;
  const auto averages = static_cast<double>(degree_of(whole)) * halvings;
  return times_above(averages * once, root_of_dimension(whole));
}

std::pair<BezierCurve, BezierCurve> halves(const BezierCurve& curve) {
  std::pair<BezierCurve, BezierCurve> result;
  for (const std::vector<double>& c : curve) {
    auto [first, second] = split_bezier(c, [](double a, double b) { return (a + b) / 2; });
    result.first.push_back(std::move(first));
    result.second.push_back(std::move(second));
  }
  return result;
}

/// Calls done(part, halvings) for the parts of a curve in their order, and for their halves where the answer
/// is no.
template <class Done>
void for_each_part(const BezierCurve& curve, const Done& done) {
  std::vector<std::pair<BezierCurve, int>> open{{curve, 0}};  // the next part last
  while (!open.empty()) {
    const auto [part, halvings] = std::move(open.back());
    open.pop_back();
    if (done(part, halvings)) continue;
    auto [first, second] = halves(part);
    open.emplace_back(std::move(second), halvings + 1);
    open.emplace_back(std::move(first), halvings + 1);
  }
}

/// Appends points first .. n of a curve.
void append_points(BezierPolyline& line, const BezierCurve& curve, std::size_t first) {
  for (std::size_t c = 0; c < curve.size(); ++c)
    line.coordinates[c].insert(line.coordinates[c].end(),
                               curve[c].begin() + static_cast<std::ptrdiff_t>(first), curve[c].end());
}

BezierPolyline begun(const std::vector<BezierCurve>& curves) {
  BezierPolyline line;
  for (const std::vector<double>& c : curves.front()) line.coordinates.push_back({c.front()});
  return line;
}

/// How a tolerance can be kept: halvings after which every part is flat enough, rounding included.
int certain_levels(const BezierCurve& curve, double tolerance) {
  if (!(tolerance > 0)) throw InputError(fmt::format("a tolerance must be positive, not {}", tolerance));
  if (degree_of(curve) < 2) return 0;
  const int levels = levels_needed(curve, std::max(tolerance / 2, smallest));
  const double differences =
      4 * rounding_after(curve, levels) + times_above(difference_error(curve), 2 * root_of_dimension(curve));
  const double moved =
      rounding_after(curve, levels) + times_above(std::max(1.0, chord_factor(curve)), differences);
  if (moved > tolerance / 2) {
    throw InputError(fmt::format(
        "a tolerance of {} cannot be kept: rounding of coordinates as large as {} alone takes up to {:.3g}; "
        "it is at least {:.3g}",
        tolerance, largest_coordinate(curve), moved, 2 * moved));
  }
  return levels;
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
  require_drawable({curve});
  if (!(tolerance > 0)) throw InputError(fmt::format("a tolerance must be positive, not {}", tolerance));
  if (degree_of(curve) < 2) return 0;
  constexpr double per_level = 4;
  int levels = 0;
  for (double bound = times_above(chord_factor(curve), largest_second_difference(curve)); bound > tolerance;
       bound /= per_level)
    ++levels;
  return levels;
}

void require_drawable(const std::vector<BezierCurve>& curves) {
  if (curves.empty()) throw InputError("no Bezier curve is given");
  constexpr int most_exponent = 1000;
  const double most = std::ldexp(1.0, most_exponent);
  const auto points = curves.front().empty() ? 0 : curves.front().front().size();
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const std::string name = fmt::format("Bezier curve {}", k + 1);
    if (curves[k].empty() || curves[k].size() != curves.front().size())
      throw InputError(name + ": every curve has the same number of coordinates, one at least");
    for (const std::vector<double>& c : curves[k]) {
      if (c.size() != points || c.size() < 2)
        throw InputError(name + ": every coordinate has the same number of control points, two at least");
      for (std::size_t i = 0; i < c.size(); ++i) {
        if (!(std::abs(c[i]) <= most)) {
          throw InputError(fmt::format(
              "{}, control point {}: a coordinate of {}; they are finite and at most 2^{} (about 1e301)",
              name, i + 1, c[i], most_exponent));
        }
      }
    }
  }
}

BezierPolyline draw_to_tolerance(const std::vector<BezierCurve>& curves, double tolerance,
                                 std::size_t most_segments) {
  require_drawable(curves);
  BezierPolyline line = begun(curves);
  for (const BezierCurve& curve : curves) {
    const int enough = certain_levels(curve, tolerance);
    for_each_part(curve, [&](const BezierCurve& part, int halvings) {
      const double bound = chord_distance_bound(part) + rounding_after(curve, halvings);
      if (bound > tolerance) {
        if (halvings > enough) throw std::logic_error("Wang's number of levels is too small");
        return false;
      }
      if (++line.segments > most_segments) {
        throw InputError(fmt::format(
            "a tolerance of {} takes more than {} segments; four times the tolerance takes about half of "
            "them",
            tolerance, most_segments));
      }
      append_points(line, part, degree_of(curve));
      line.deepest = std::max(line.deepest, halvings);
      line.bound = std::max(line.bound, bound);
      return true;
    });
  }
  return line;
}

BezierPolyline draw_to_depth(const std::vector<BezierCurve>& curves, int depth, std::size_t most_segments) {
  require_drawable(curves);
  if (depth < 0) throw InputError(fmt::format("a depth is at least 0, not {}", depth));
  const auto lines = static_cast<double>(curves.size() * degree_of(curves.front()));
  if (std::ldexp(lines, depth) > static_cast<double>(most_segments)) {
    const int possible = std::ilogb(static_cast<double>(most_segments) / lines);
    throw InputError(fmt::format(
        "a depth of {} makes more than {} segments; {}", depth, most_segments,
        possible < 0 ? "the control polygon alone has more" : fmt::format("{} is the most", possible)));
  }
  BezierPolyline line = begun(curves);
  line.deepest = depth;
  for (const BezierCurve& curve : curves) {
    for_each_part(curve, [&](const BezierCurve& part, int halvings) {
      if (halvings < depth) return false;
      append_points(line, part, 1);
      line.segments += degree_of(part);
      line.bound = std::max(line.bound, polygon_distance_bound(part) + rounding_after(curve, depth));
      return true;
    });
  }
  return line;
}

std::vector<BezierCurve> consecutive_curves(const std::vector<std::vector<double>>& coordinates, int degree) {
  if (degree < 1) throw InputError(fmt::format("a degree is at least 1, not {}", degree));
  const auto n = static_cast<std::size_t>(degree);
  const std::size_t points = coordinates.empty() ? 0 : coordinates.front().size();
  if (points < n + 1 || (points - 1) % n != 0) {
    throw InputError(fmt::format(
        "{} control points; consecutive curves of degree {} take 1 + {} k of them: {}, {}, {}, ..", points, n,
        n, n + 1, 2 * n + 1, 3 * n + 1));
  }
  std::vector<BezierCurve> curves;
  for (std::size_t begin = 0; begin + n < points; begin += n) {
    BezierCurve& curve = curves.emplace_back();
    for (const std::vector<double>& c : coordinates) {
      const auto from = c.begin() + static_cast<std::ptrdiff_t>(begin);
      curve.emplace_back(from, from + degree + 1);
    }
  }
  return curves;
}

}  // namespace subdiv
