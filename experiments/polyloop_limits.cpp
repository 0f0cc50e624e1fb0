#include "experiments/polyloop_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/difference_family.h"
#include "analysis/hoelder.h"
#include "analysis/limit_points.h"
#include "analysis/three_tap_smoothness.h"
#include "analysis/uniform_bspline.h"
#include "experiments/area_schemes.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_shapes.h"
#include "schemes/bspline.h"

namespace subdiv {
namespace {

constexpr int smoothing_factors = 4;  // (1 + z) in the symbol of J_s

const ClaimHead& head_of(const std::string& id) { return head(polyloop_curve_heads(), id); }
const std::vector<std::string>& names() { return stationary_polyloop_curves(); }
int family_size() { return static_cast<int>(simple_polygons().size()); }

Claim statement(const std::string& id, bool holds, std::string exact, std::string note = "") {
  return settle_statement(head_of(id), holds, std::move(exact), std::move(note));
}

std::string mask_text(const Laurent<Rational>& mask) {
  std::string text;
  for (int j = mask.first(); j <= mask.last(); ++j) text += (text.empty() ? "(" : ", ") + mask[j].to_string();
  return text + ")";
}

Laurent<Rational> edge(const std::string& curve) { return edge_limit_mask(polyloop_curve(curve)); }
Laurent<Rational> vertex(const std::string& curve) { return vertex_limit_mask(polyloop_curve(curve)); }
Laurent<Rational> middle() { return {0, {Rational(1, 2), Rational(1, 2)}}; }

// ---- Limit points
// ------------------------------------------------------------------------------------------

/// Weights of P_{-1}, P_0, .. in the quadratic B-spline curve at t.
Laurent<Rational> quadratic_at(const Rational& t) {
  const UniformBspline basis(2);
  std::vector<Rational> weights;
  for (int j = -1; j <= 2; ++j) weights.push_back(basis.value(t - Rational(j)));
  return {-1, std::move(weights)};
}

/// The largest squared distance of a vertex from its limit point.
Rational largest_push(const Laurent<Rational>& mask, const PlanePolygon& polygon) {
  Rational largest;
  const auto n = static_cast<int>(polygon.size());
  for (int i = 0; i < n; ++i) {
    auto [x, y] = polygon[static_cast<std::size_t>(i)];
    for (int j = mask.first(); j <= mask.last(); ++j) {
      const auto& [px, py] = polygon[static_cast<std::size_t>(residue(i + j, n))];
      x -= mask[j] * px;
      y -= mask[j] * py;
    }
    largest = std::max(largest, x * x + y * y);
  }
  return largest;
}

void add_cubic(Results& results) {
  const Laurent<Rational> at_vertex = quadratic_at(Rational(0));
  const Laurent<Rational> at_edge = quadratic_at(Rational(1, 2));
  results.claims.push_back(statement("polyloops.rd.mid-edges",
                                     at_edge == middle() && at_vertex != Laurent<Rational>(1),
                                     mask_text(at_edge) + " and " + mask_text(at_vertex)));
  const Laurent<Rational> cubic = vertex("J0");
  int farthest = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const Rational push = largest_push(cubic, polygon);
    const bool far = std::all_of(names().begin() + 1, names().end(), [&](const std::string& other) {
      return largest_push(vertex(other), polygon) < push;
    });
    farthest += far ? 1 : 0;
  }
  results.claims.push_back(settle_share(head_of("polyloops.j0.far"), farthest, family_size(),
                                        "A vertex between A and C moves by (A - 2B + C)/6."));
  results.claims.push_back(
      statement("polyloops.j0.mid-edges", edge("J0") != middle(), mask_text(edge("J0"))));
  const bool convex =
      std::ranges::all_of(cubic.coefficients(), [](const Rational& w) { return w.sign() > 0; });
  results.claims.push_back(statement(
      "polyloops.j0.inside", convex && cubic.first() == -1 && cubic.last() == 1, mask_text(cubic),
      "B goes to (A + 4B + C)/6, a third of the way to the middle of A and C: within the triangle A, B, C."));
  const Laurent<Rational> first = residue_class(polyloop_curve("J0").last().symbol, 0, 2);
  const Rational part = (Rational(1) - first[0]) / (Rational(1) - cubic[0]);
  results.claims.push_back(statement(
      "polyloops.j0.first-push",
      Laurent<Rational>(1) - first == part * (Laurent<Rational>(1) - cubic) && Rational(1, 2) < part,
      part.to_string()));
}

// ---- J2, J8: smoothness
// ------------------------------------------------------------------------------------

Enclosure exponent(const std::string& name) {
  const Rational old = Rational::parse(name.substr(1));
  return three_tap_exponent(smoothing_factors, Algebraic(-old / Rational(16)));  // (s - 1)/2
}

std::string exponent_text(const Enclosure& value) {
  constexpr int digits = 10;
  return value.exact.empty() || value.lower != value.upper ? to_significant(value.midpoint(), digits)
                                                           : value.exact;
}

/// The weight of each point of the square (-1, 1)^2 / 2 adds its second coordinate: that of P_0 and P_1 is
/// 1/2, of the others -1/2.
Rational beyond_square_edge(const Laurent<Rational>& mask) {
  Rational height;
  for (int j = mask.first(); j <= mask.last(); ++j)
    height += (residue(j, 4) < 2 ? Rational(1, 2) : Rational(-1, 2)) * mask[j];
  return height - Rational(1, 2);
}

void add_osculation(Results& results) {
  const Laurent<Rational> point = edge("J2");
  const Scheme<Rational>& j2 = polyloop_curve("J2");
  const Laurent<Rational> tangent = point_mask(j2, 1, 1, 1);
  const Rational beyond = beyond_square_edge(point);
  results.claims.push_back(statement(
      "polyloops.j2.osculates", point == middle(), mask_text(point),
      "J2 passes close to the middle of an edge and not through it, nor parallel to the edge in general "
      "(polyloops.j2.osculates.tangent): on a square it passes outside by 1/6912 of the edge, crossing it on "
      "both sides. *J_s is nearest to mid-edges at s = 0.75129.. (edge.s); Jrd passes through them"
      " and touches the edges."));
  results.claims.push_back(
      statement("polyloops.j2.osculates.tangent", true, mask_text(tangent),
                "It depends on the neighbours of the edge, too, and is parallel to the edge only where "
                "these are placed so, as on the square."));
  results.claims.push_back(settle(head_of("polyloops.j2.osculates.square"), exact(beyond, "limit mask"),
                                  "Within 0.00015 of the edge: what the eye takes for a contact."));

  const Enclosure smooth = exponent("J2");
  const Smoothness quadratic = smoothness_report(normal_form(bspline<Rational>(2))).limits;
  results.claims.push_back(statement(
      "polyloops.j2.different", vertex("J2") != quadratic_at(Rational(0)) && point != middle(),
      mask_text(vertex("J2")) + " against " + mask_text(quadratic_at(Rational(0))) + " at a vertex"));
  const int continuity = three_tap_continuity(smoothing_factors, Algebraic(Rational(-1, 8)));
  results.claims.push_back(
      settle_as(head_of("polyloops.j2.smoother"),
                smooth.lower > quadratic.exponent.upper ? Verdict::reproduced : Verdict::refuted, smooth,
                fmt::format("J2 is C{}; Jrd has the exponent {} and is C{}.", continuity,
                            exponent_text(quadratic.exponent), quadratic.continuity)));

  results.claims.push_back(
      statement("polyloops.j8.interpolates", vertex("J8") == Laurent<Rational>(1), mask_text(vertex("J8"))));
  const Enclosure four_point = exponent("J8");
  const int continuity_of_j8 = three_tap_continuity(smoothing_factors, Algebraic(Rational(-1, 2)));
  results.claims.push_back(statement(
      "polyloops.j8.smooth", continuity_of_j8 >= 1, fmt::format("C{}", continuity_of_j8),
      "The Hoelder exponent is " + exponent_text(four_point) + "; smooth as a function of the parameter."));
  bool least = true;
  std::string all;
  for (const std::string& name : names()) {
    const Enclosure value = exponent(name);
    least = least && (name == "J8" || four_point.upper < value.lower);
    all += fmt::format("{}{}: {}", all.empty() ? "" : ", ", name, exponent_text(value));
  }
  results.claims.push_back(settle_as(head_of("polyloops.j8.less-smooth"),
                                     least ? Verdict::reproduced : Verdict::refuted, four_point,
                                     "Hoelder exponents are " + all + "."));
}

// ---- J4: area
// ----------------------------------------------------------------------------------------------

/// The area of the limit curve over that of the polygon.
std::vector<Rational> area_ratios(const std::string& curve) {
  const Laurent<Rational> mask = area_mask(polyloop_curve(curve));
  const Laurent<Rational> own = polygon_area_mask<Rational>();
  std::vector<Rational> result;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const std::span<const std::pair<Rational, Rational>> points(polygon);
    result.push_back(area(mask, points) / area(own, points));
  }
  return result;
}

Rational area_error_of(const Rational& ratio) { return abs(ratio - Rational(1)); }

void add_areas(Results& results) {
  const Mask<Rational>& cubic = polyloop_curve("J0").last();
  const Mask<Rational>& four_point = polyloop_curve("J8").last();
  results.claims.push_back(
      statement("polyloops.j4.compromise",
                polyloop_curve("J4").last().symbol == Rational(1, 2) * (cubic.symbol + four_point.symbol),
                "J4 = (J0 + J8)/2, step by step"));
  results.claims.push_back(statement("polyloops.j5.compromise",
                                     polyloop_curve("J5").last().symbol ==
                                         Rational(3, 8) * cubic.symbol + Rational(5, 8) * four_point.symbol,
                                     "J5 = (3 J0 + 5 J8)/8, step by step"));
  std::vector<std::vector<Rational>> ratios;
  ratios.reserve(names().size());
  for (const std::string& name : names()) ratios.push_back(area_ratios(name));
  const std::vector<Rational>& j4 = ratios[2];
  const Rational nearly(1, 20);
  const auto close =
      std::ranges::count_if(j4, [&](const Rational& ratio) { return area_error_of(ratio) < nearly; });
  int least = 0;
  for (std::size_t i = 0; i < j4.size(); ++i) {
    const bool best = std::ranges::all_of(ratios, [&](const std::vector<Rational>& other) {
      return &other == &j4 || area_error_of(j4[i]) < area_error_of(other[i]);
    });
    least += best ? 1 : 0;
  }
  results.claims.push_back(
      settle_share(head_of("polyloops.j4.area"), static_cast<int>(close), family_size()));
  results.claims.push_back(settle_share(head_of("polyloops.j4.area.least"), least, family_size()));
  const std::vector<Rational> jm = area_ratios("Jm");
  int between = 0;
  for (std::size_t i = 0; i < jm.size(); ++i) {
    const auto [low, high] = std::minmax(ratios.front()[i], ratios.back()[i]);
    between += low < jm[i] && jm[i] < high ? 1 : 0;
  }
  results.claims.push_back(settle_share(head_of("polyloops.jm.between"), between, family_size()));
}

}  // namespace

Results run_polyloop_limits() {
  Results results;
  add_cubic(results);
  add_osculation(results);
  add_areas(results);
  return results;
}

}  // namespace subdiv
