#include "schemes/evaluate/bezier_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "schemes/evaluate/de_casteljau.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

std::size_t degree_of(const BezierCurve& curve) { return curve.front().size() - 1; }

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
  const int levels = levels_needed(curve, std::max(tolerance / 2, std::numeric_limits<double>::denorm_min()));
  const double moved = rounding_of_bound(curve, rounding_of_halvings(curve, levels));
  if (moved > tolerance / 2) {
    // Twice this asks for no more levels, so that rounding takes no more. It is not the least that can be
    // kept. Three digits are off by less than a hundredth.
    constexpr double more_than_digits = 2.02;
    throw InputError(fmt::format(
        "a tolerance of {} cannot be promised: with it, rounding of these coordinates may take up to {:.3g}; "
        "a tolerance of {:.3g} can be kept",
        tolerance, moved, more_than_digits * moved));
  }
  return levels;
}

}  // namespace

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
        if (!(std::abs(c[i]) <= most)) {  // NaN, too
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
      const double bound = chord_distance_bound(part) + rounding_of_halvings(curve, halvings);
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
      line.bound = std::max(line.bound, polygon_distance_bound(part) + rounding_of_halvings(curve, depth));
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
