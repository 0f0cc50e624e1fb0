#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/hausdorff_distance.h"
#include "analysis/limit_points.h"
#include "analysis/uniform_bspline.h"
#include "experiments/area_schemes.h"
#include "experiments/polygon_curves.h"
#include "experiments/simple_polygons.h"

namespace subdiv {
namespace {

constexpr int level = 6;
constexpr int spacing = 1 << level;  // points of a curve for each control point

const ClaimHead& head_of(const std::string& id) { return head(polygon_curve_heads(), id); }

/// For r = 0 .. spacing - 1 the weights of P_{i+j} in the point of a curve at i + r/spacing.
using CurveMasks = std::vector<Laurent<Rational>>;

CurveMasks jspline_masks(const Rational& s) {
  CurveMasks masks;
  for (int r = 0; r < spacing; ++r) masks.push_back(point_mask(repeated_jspline(s), level, r));
  return masks;
}

CurveMasks quadratic_bspline_masks() {
  const UniformBspline basis(2);
  CurveMasks masks;
  for (int r = 0; r < spacing; ++r) {
    std::vector<Rational> weights;
    for (int j = -1; j <= 2; ++j) weights.push_back(basis.value(Rational(r, spacing) - Rational(j)));
    masks.emplace_back(-1, std::move(weights));
  }
  return masks;
}

/// The weights as seen by a polygon, enclosed or rounded.
template <class R, class Convert>
std::vector<Laurent<R>> converted(const CurveMasks& masks, Convert convert) {
  std::vector<Laurent<R>> result;
  for (const Laurent<Rational>& mask : masks) result.push_back(map_coefficients(mask, convert));
  return result;
}

template <class R, class Convert>
std::vector<ControlPolygon<R>> coordinates(const PlanePolygon& polygon, Convert convert) {
  std::vector<R> x;
  std::vector<R> y;
  for (const auto& [px, py] : polygon) {
    x.push_back(convert(px));
    y.push_back(convert(py));
  }
  return {closed_polygon(std::move(x)), closed_polygon(std::move(y))};
}

Interval enclosed(const Rational& x) { return Interval(x); }
double rounded(const Rational& x) { return x.to_double(); }

/// How far one curve is from another at the same parameters.
struct Difference {
  Interval sum = Interval(0);
  Interval largest = Interval(0);
};

/// `masks` are those of one curve minus those of the other.
Difference difference(const std::vector<Laurent<Interval>>& masks, const PlanePolygon& polygon) {
  const auto values = coordinates<Interval>(polygon, enclosed);
  Difference result;
  Interval largest_square(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (const Laurent<Interval>& mask : masks) {
      const Interval x = apply_mask(mask, values[0], static_cast<long long>(i));
      const Interval y = apply_mask(mask, values[1], static_cast<long long>(i));
      const Interval square = x * x + y * y;
      result.sum += sqrt(square);
      largest_square = max(largest_square, square);
    }
  }
  result.largest = sqrt(largest_square);
  return result;
}

bool is_less(const Interval& a, const Interval& b) {
  if (certainly_less(a, b)) return true;
  if (certainly_less(b, a)) return false;
  throw std::logic_error("two distances of curves cannot be told apart");
}

Polyline curve(const std::vector<Laurent<double>>& masks, const PlanePolygon& polygon) {
  const auto values = coordinates<double>(polygon, rounded);
  std::vector<std::vector<double>> result(2);
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      for (const Laurent<double>& mask : masks)
        result[c].push_back(apply_mask(mask, values[c], static_cast<long long>(i)));
    }
  }
  return make_polyline(std::move(result), true);
}

CurveMasks minus(const CurveMasks& a, const CurveMasks& b) {
  CurveMasks result;
  for (std::size_t r = 0; r < a.size(); ++r) result.push_back(a[r] - b[r]);
  return result;
}

void add_quadratic_fits(Results& results) {
  const CurveMasks target = quadratic_bspline_masks();
  const CurveMasks by_l1 = jspline_masks(Rational::parse("0.689"));
  const CurveMasks by_linf = jspline_masks(Rational::parse("0.639"));
  const auto off_l1 = converted<Interval>(minus(by_l1, target), enclosed);
  const auto off_linf = converted<Interval>(minus(by_linf, target), enclosed);
  const auto target_curve = converted<double>(target, rounded);
  const auto l1_curve = converted<double>(by_l1, rounded);
  const auto linf_curve = converted<double>(by_linf, rounded);
  constexpr double tolerance = 1e-6;
  int l1_nearer = 0;
  int linf_nearer = 0;
  int l1_matches = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const Difference l1 = difference(off_l1, polygon);
    const Difference linf = difference(off_linf, polygon);
    l1_nearer += is_less(l1.sum, linf.sum) ? 1 : 0;
    linf_nearer += is_less(linf.largest, l1.largest) ? 1 : 0;
    const Polyline b2 = curve(target_curve, polygon);
    const auto distance = [&](const std::vector<Laurent<double>>& masks) {
      return hausdorff_distance(curve(masks, polygon), b2, tolerance).upper;
    };
    l1_matches += distance(l1_curve) < distance(linf_curve) ? 1 : 0;
  }
  const auto total = static_cast<int>(simple_polygons().size());
  results.claims.push_back(settle_share(head_of("fit.tendency.l1.js-report"), l1_nearer, total));
  results.claims.push_back(
      settle_share(head_of("fit.tendency.l1.jsplines"), l1_matches, total, "", Rigour::approximate));
  results.claims.push_back(settle_share(head_of("fit.tendency.linf"), linf_nearer, total));
}

/// The integral of the squared curvature times the length: turning angles over the mean length of their
/// edges.
double bending(const Polyline& polyline) {
  const std::vector<double>& x = polyline.coordinates[0];
  const std::vector<double>& y = polyline.coordinates[1];
  const std::size_t n = x.size();
  double energy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = (i + n - 1) % n;
    const std::size_t b = (i + 1) % n;
    const double before = std::hypot(x[i] - x[a], y[i] - y[a]);
    const double after = std::hypot(x[b] - x[i], y[b] - y[i]);
    const double cross = (x[i] - x[a]) * (y[b] - y[i]) - (y[i] - y[a]) * (x[b] - x[i]);
    const double dot = (x[i] - x[a]) * (x[b] - x[i]) + (y[i] - y[a]) * (y[b] - y[i]);
    const double angle = std::atan2(cross, dot);
    energy += angle * angle / ((before + after) / 2);
  }
  return energy * length(polyline);
}

/// On how many polygons the first scheme has the smaller bending energy.
int better_shaped(const Scheme<Rational>& first, const Scheme<Rational>& second) {
  constexpr int fine = 7;
  const auto energy = [](const Scheme<Rational>& scheme, const Polyline& controls) {
    return bending(refine(map_coefficients(scheme, rounded), controls, fine));
  };
  return static_cast<int>(std::ranges::count_if(simple_polygons(), [&](const PlanePolygon& polygon) {
    const Polyline controls = in_double(polygon);
    return energy(first, controls) < energy(second, controls);
  }));
}

void add_shapes(Results& results) {
  const auto total = static_cast<int>(simple_polygons().size());
  const Rational quintic(3, 2);
  const auto with_step = [&](const Rational& r) { return anticipated_jspline(r, r, quintic); };
  const Scheme<Rational> edges = with_step(Rational(29, 59));
  const Scheme<Rational> vertices = with_step(Rational(-33, 26));
  const Scheme<Rational> exactly_vertices = anticipated_jspline(Rational(-7, 4), Rational(59, 52), quintic);
  results.claims.push_back(settle_share(head_of("edge.tendency.shape"), better_shaped(edges, vertices), total,
                                        "", Rigour::approximate));
  results.claims.push_back(settle_share(head_of("vertex.tendency.rounded"),
                                        better_shaped(vertices, exactly_vertices), total, "",
                                        Rigour::approximate));
}

/// Hausdorff distances of limit curves of *J_s from their control polygons.
std::vector<double> distances_from_controls(const Rational& s) {
  constexpr double tolerance = 1e-6;
  const auto masks = converted<double>(jspline_masks(s), rounded);
  std::vector<double> result;
  for (const PlanePolygon& polygon : simple_polygons())
    result.push_back(hausdorff_distance(curve(masks, polygon), in_double(polygon), tolerance).upper);
  return result;
}

void add_closeness(Results& results) {
  const std::vector<double> fixed = distances_from_controls(Rational(3, 8));
  const std::vector<double> four_point = distances_from_controls(Rational(0));
  const std::vector<double> cubic = distances_from_controls(Rational(1));
  int both = 0;
  int less_than_four_point = 0;
  int less_than_cubic = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    less_than_four_point += fixed[i] < four_point[i] ? 1 : 0;
    less_than_cubic += fixed[i] < cubic[i] ? 1 : 0;
    both += fixed[i] < four_point[i] && fixed[i] < cubic[i] ? 1 : 0;
  }
  results.claims.push_back(
      settle_share(head_of("popping.fixed.close"), both, static_cast<int>(fixed.size()),
                   fmt::format("It is smaller than that of *J_0 on {}, and than that of *J_1 on {}.",
                               less_than_four_point, less_than_cubic),
                   Rigour::approximate));
}

}  // namespace

Results run_polygon_fits() {
  Results results;
  add_quadratic_fits(results);
  add_shapes(results);
  add_closeness(results);
  return results;
}

}  // namespace subdiv
