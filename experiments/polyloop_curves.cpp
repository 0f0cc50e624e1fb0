#include "experiments/polyloop_curves.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/difference_family.h"
#include "analysis/hausdorff_distance.h"
#include "analysis/hoelder.h"
#include "analysis/limit_points.h"
#include "analysis/three_tap_smoothness.h"
#include "analysis/uniform_bspline.h"
#include "experiments/area_schemes.h"
#include "experiments/polyloop_shapes.h"
#include "schemes/bspline.h"

namespace subdiv {
namespace {

const std::string share_of = "Share, over " + simple_polygons_text() + ", of those ";
const std::string by_masks = "By limit masks of *J_s, s = 1 - (old parameter)/8: ";
const std::string five = "Polygons of level 5, exact in doubles. ";
const std::string hausdorff =
    "The Hausdorff distance between L and the curve's polygon of level 5, by bounds that are refined until "
    "they decide by a margin far above rounding. ";
const std::string jerk =
    "The normal jerk of edge BC is the part of -A + 3B - 3C + D across it; polygons of level 5, compared by "
    "a margin far above rounding. ";
const std::string area_error =
    "E = area of the limit curve / area of the polygon - 1, exact by the area mask. ";

ClaimHead printed(std::string id, std::string section, std::string text, std::string definition,
                  ClaimKind kind = ClaimKind::exact) {
  return {std::move(id), "polyloops", std::move(section), std::move(text), kind, std::move(definition)};
}
ClaimHead tendency(std::string id, std::string section, std::string text, std::string definition) {
  return printed(std::move(id), std::move(section), std::move(text), std::move(definition),
                 ClaimKind::tendency);
}
ClaimHead own_share(std::string id, std::string section, std::string definition) {
  ClaimHead result = finding(std::move(id), std::move(section), std::move(definition));
  result.kind = ClaimKind::tendency;
  return result;
}

std::vector<ClaimHead> make_heads() {
  return {
      printed("polyloops.rd.mid-edges", "3.1",
              "the final curve Jrd interpolates the mid-edge points of L, but not the vertices of L",
              "The quadratic B-spline curve's weights of control points at mid-edges and vertices."),
      tendency("polyloops.j0.far", "3.1", "the final curve J0 is relatively far from sharp vertices of L",
               by_masks + share_of +
                   "on which the largest distance of a vertex from its limit point is greater for J0 than "
                   "for J2, J4, J5, J6 and J8, exact."),
      printed("polyloops.j0.mid-edges", "3.1", "does not interpolate the edge midpoints",
              by_masks + "the limit point of the middle of an edge, for J0."),
      printed("polyloops.j0.inside", "3.1", "It tends to push the vertices inside the turns",
              by_masks + "the limit point of vertex B under J0, between A and C."),
      printed("polyloops.j0.first-push", "3.1",
              "the first iteration of the push/pull pushes its original vertices far inwards the turn",
              "The share of the whole way of a vertex to its limit under J0 that the first step makes: is it "
              "more than half?"),
      printed("polyloops.j2.osculates", "3.1", "J2 osculates the edges at their midpoints",
              by_masks +
                  "does J2 touch the edges there: is the limit point of the middle of an edge that point?"),
      finding("polyloops.j2.osculates.tangent", "polyloops 3.1",
              "The tangent mask of *J_{3/4} at the middle of an edge, of P_{-2} .. P_3, exact."),
      finding("polyloops.j2.osculates.square", "polyloops 3.1",
              "On a square with edges 1: how far J2 passes outside the middle of an edge, in exact "
              "arithmetic."),
      printed("polyloops.j2.different", "3.1", "it is different and smoother than Jrd: different",
              "Are the limit curves on the square the same, by weights at all parameters i/2?"),
      printed("polyloops.j2.smoother", "3.1", "it is different and smoother than Jrd: smoother",
              "The Hoelder exponent of the limits of *J_{3/4}, against that of the quadratic B-spline."),
      printed("polyloops.j8.interpolates", "3.1", "it interpolates the vertices of L",
              by_masks + "the limit point of a vertex, for J8."),
      printed("polyloops.j8.less-smooth", "3.1", "but appears less smooth",
              "The Hoelder exponents of the limits of J0, J2, J4, J5, J6 and J8: is that of J8 the least?"),
      printed("polyloops.j4.compromise", "3.1", "is a compromise between J0 and J8",
              "Is a step of J4 the average of those of J0 and J8?"),
      tendency("polyloops.j4.area", "3.1", "Usually, L and J4 have nearly equal areas",
               area_error + share_of + "with |E| < 1/20 for J4."),
      own_share("polyloops.j4.area.least", "polyloops 3.1",
                area_error + share_of + "for which |E| of J4 is the least among J0, J2, J4, J5, J6 and J8."),
      tendency("polyloops.j5.hausdorff", "3.1",
               "It is a better approximation of L than J4 when the quality of an approximation is measured "
               "by the Hausdorff distance",
               hausdorff + share_of + "for which J5 is nearer to L than J4."),
      printed("polyloops.j5.square", "3.1",
              "L is a better low-resolution approximation of J5 than it is of other subdivision curves",
              hausdorff + "On the square, the chapter's own polygon: is J5 the nearest of J0, J2, J4, J5, J6 "
                          "and J8?"),
      finding("polyloops.j5.square.best", "polyloops 3.1",
              "The s in (0, 3/4) at which *J_s on a square leaves as much between a corner and its limit "
              "point as between the middle of an edge and the limit point there, as old parameter 8 (1 - "
              "s)."),
      tendency("polyloops.j5.others", "3.1",
               "L is a better low-resolution approximation of J5 than it is of other subdivision curves",
               hausdorff + share_of + "for which J5 is the nearest of J0, J2, J4, J5, J6 and J8."),
      tendency("polyloops.j5.popping", "3.1",
               "yields a less visible popping artifact that the other subdivision schemes discussed so far",
               "The largest distance of a point of level k from its place on the polygon of level k - 1 "
               "under linear refinement. Share, over " +
                   simple_polygons_text() +
                   " and the levels 1 to 4, of those pairs for which that of J5 is the least of J0, J2, J4, "
                   "J5, J6 and J8."),
      tendency("polyloops.jerk.j0", "3.2", "the jerk of J0 (green) is barely visible",
               jerk + share_of +
                   "on which the largest normal jerk of J0 is below a twentieth of that of J8, in one "
                   "scale."),
      tendency("polyloops.jerk.j8", "3.2", "the jerk of J8 (red) is significant and irregularly distributed",
               jerk + share_of +
                   "on which the largest normal jerk of J8 is above twice its mean, and this ratio above "
                   "those of J0, J2, J4, J5 and J6."),
      own_share("polyloops.jerk.rising", "polyloops 3.2",
                jerk + share_of + "on which the largest normal jerk rises along J0, J2, J4, J5, J6, J8."),
      tendency("polyloops.jm.jerk", "3.2", "The intermediate curve Jm has no noticeable jerk",
               jerk + share_of +
                   "on which the largest normal jerk of Jm, J(2) first and J(-2) last, is below a tenth of "
                   "that of J8."),
      own_share("polyloops.jm.jerk.least", "polyloops 3.2",
                jerk + share_of + "on which the largest normal jerk of Jm is below that of J0."),
      own_share("polyloops.jm.jerk.reversed", "polyloops 3.2",
                jerk + share_of +
                    "on which the largest normal jerk of the steps in reversed order, J(-2) J(-2) J(-2) J(0) "
                    "J(2), is below those of J0 and of Jm."),
      tendency("polyloops.jm.between", "3.2",
               "The intermediate curve Jm (shown in brown above between J0 and J8",
               share_of + "on which the area of Jm lies between those of J0 and J8, exact by area masks."),
      tendency("polyloops.jm.pleasant", "3.2",
               "produces more pleasant shapes than the other subdivision schemes",
               five +
                   "A curve is better shaped when its bending energy times its length, the integral of the "
                   "squared curvature (by circles) times the length, is smaller. " +
                   share_of + "for which that of Jm is the least, J0, J2, J4, J5, J6 and J8 the others."),
  };
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

using Measure = std::vector<double>;  // of every polygon of the family
constexpr int smoothing_factors = 4;  // (1 + z) in the symbol of J_s

const std::vector<std::string> stationary_names{"J0", "J2", "J4", "J5", "J6", "J8"};
int family_size() { return static_cast<int>(simple_polygons().size()); }

Claim statement(const std::string& id, bool holds, std::string exact, std::string note = "") {
  return settle_statement(head(table(), id), holds, std::move(exact), std::move(note));
}
Claim share(const std::string& id, std::ptrdiff_t count, std::string note = "") {
  return settle_share(head(table(), id), static_cast<int>(count), family_size(), std::move(note),
                      Rigour::certified);
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
    const bool far =
        std::all_of(stationary_names.begin() + 1, stationary_names.end(),
                    [&](const std::string& other) { return largest_push(vertex(other), polygon) < push; });
    farthest += far ? 1 : 0;
  }
  results.claims.push_back(settle_share(head(table(), "polyloops.j0.far"), farthest, family_size(),
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
  results.claims.push_back(settle(head(table(), "polyloops.j2.osculates.square"), exact(beyond, "limit mask"),
                                  "Within 0.00015 of the edge: what the eye takes for a contact."));

  const Enclosure smooth = exponent("J2");
  const Smoothness quadratic = smoothness_report(normal_form(bspline<Rational>(2))).limits;
  results.claims.push_back(statement(
      "polyloops.j2.different", vertex("J2") != quadratic_at(Rational(0)) && point != middle(),
      mask_text(vertex("J2")) + " against " + mask_text(quadratic_at(Rational(0))) + " at a vertex"));
  const int continuity = three_tap_continuity(smoothing_factors, Algebraic(Rational(-1, 8)));
  results.claims.push_back(
      settle_as(head(table(), "polyloops.j2.smoother"),
                smooth.lower > quadratic.exponent.upper ? Verdict::reproduced : Verdict::refuted, smooth,
                fmt::format("J2 is C{}; Jrd has the exponent {} and is C{}.", continuity,
                            exponent_text(quadratic.exponent), quadratic.continuity)));

  results.claims.push_back(
      statement("polyloops.j8.interpolates", vertex("J8") == Laurent<Rational>(1), mask_text(vertex("J8"))));
  const Enclosure four_point = exponent("J8");
  bool least = true;
  std::string all;
  for (const std::string& name : stationary_names) {
    const Enclosure value = exponent(name);
    least = least && (name == "J8" || four_point.upper < value.lower);
    all += fmt::format("{}{}: {}", all.empty() ? "" : ", ", name, exponent_text(value));
  }
  results.claims.push_back(settle_as(head(table(), "polyloops.j8.less-smooth"),
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
  std::vector<std::vector<Rational>> ratios;
  ratios.reserve(stationary_names.size());
  for (const std::string& name : stationary_names) ratios.push_back(area_ratios(name));
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
      settle_share(head(table(), "polyloops.j4.area"), static_cast<int>(close), family_size()));
  results.claims.push_back(settle_share(head(table(), "polyloops.j4.area.least"), least, family_size()));
  const std::vector<Rational> jm = area_ratios("Jm");
  int between = 0;
  for (std::size_t i = 0; i < jm.size(); ++i) {
    const auto [low, high] = std::minmax(ratios.front()[i], ratios.back()[i]);
    between += low < jm[i] && jm[i] < high ? 1 : 0;
  }
  results.claims.push_back(settle_share(head(table(), "polyloops.jm.between"), between, family_size()));
}

// ---- J5: distances
// -----------------------------------------------------------------------------------------

/// The Hausdorff distances of several curves from a polygon, with bounds as close as a comparison asks.
class Distances {
 public:
  Distances(const PlanePolygon& polygon, const std::vector<std::string>& names)
      : polygon_(in_double(polygon)) {
    for (const std::string& name : names) curves_.push_back({refined(polyloop_curve(name), polygon), {}, 1});
  }

  /// Whether curve a is nearer than b; false where they are equally far, to about 1e-9.
  bool nearer(std::size_t a, std::size_t b) {
    constexpr double finest = 1e-9;
    for (double tolerance = 1e-1; tolerance > finest; tolerance /= 32) {
      const DistanceBounds of_a = bounds(curves_[a], tolerance);
      const DistanceBounds of_b = bounds(curves_[b], tolerance);
      if (of_a.upper + finest < of_b.lower) return true;
      if (of_b.upper + finest < of_a.lower) return false;
    }
    return false;
  }
  bool nearest(std::size_t a) {
    for (std::size_t b = 0; b < curves_.size(); ++b) {
      if (b != a && !nearer(a, b)) return false;
    }
    return true;
  }
  DistanceBounds fine(std::size_t a) {
    constexpr double tolerance = 1e-6;
    return bounds(curves_[a], tolerance);
  }

 private:
  struct Entry {
    Polyline curve;
    DistanceBounds known;
    double tolerance;
  };
  const DistanceBounds& bounds(Entry& entry, double tolerance) {
    if (entry.known.upper == 0 || entry.tolerance > tolerance) {
      entry.known = hausdorff_distance(polygon_, entry.curve, tolerance);
      entry.tolerance = tolerance;
    }
    return entry.known;
  }

  Polyline polygon_;
  std::vector<Entry> curves_;
};

constexpr std::size_t place_of_j4 = 2;
constexpr std::size_t place_of_j5 = 3;

/// On the square with corners (+-1/2, +-1/2) a corner's limit point is at the distance sqrt(2) c(s) from it,
/// and a mid-edge's limit point m(s) beyond the edge: 2 c^2 = m^2.
Algebraic balanced_parameter() {
  const Scheme<RationalFunction> scheme = repeated_jspline(RationalFunction::variable(0));
  const Laurent<RationalFunction> corner = vertex_limit_mask(scheme);
  const Laurent<RationalFunction> side = edge_limit_mask(scheme);
  const auto height = [](const Laurent<RationalFunction>& mask) {
    RationalFunction sum(0);
    for (int j = mask.first(); j <= mask.last(); ++j)
      sum += (residue(j, 4) < 2 ? mask[j] : -mask[j]) * fraction<RationalFunction>(1, 2);
    return sum - fraction<RationalFunction>(1, 2);
  };
  const RationalFunction c = height(corner);
  const RationalFunction m = height(side);
  const RationalFunction balance = RationalFunction(2) * c * c - m * m;
  std::vector<Algebraic> found;
  for (const RealRoot& root : real_roots(UnivariatePolynomial(balance.numerator(), 0))) {
    if (Algebraic(0) < root.value && root.value < Algebraic(Rational(3, 4))) found.push_back(root.value);
  }
  if (found.size() != 1) throw std::logic_error("no single balanced parameter on the square");
  return found.front();
}

void add_distances(Results& results) {
  int nearer = 0;
  std::vector<int> nearest(stationary_names.size(), 0);
  for (const PlanePolygon& polygon : simple_polygons()) {
    Distances distances(polygon, stationary_names);
    nearer += distances.nearer(place_of_j5, place_of_j4) ? 1 : 0;
    for (std::size_t i = 0; i < nearest.size(); ++i) nearest[i] += distances.nearest(i) ? 1 : 0;
  }
  results.claims.push_back(share("polyloops.j5.hausdorff", nearer));

  Distances square(stored_polyloop("square"), stationary_names);
  std::string measured;
  for (std::size_t i = place_of_j4; i <= place_of_j5 + 1; ++i) {
    measured +=
        fmt::format("{}{} {:.4f}", measured.empty() ? "" : ", ", stationary_names[i], square.fine(i).upper);
  }
  results.claims.push_back(statement("polyloops.j5.square", square.nearest(place_of_j5),
                                     square.nearest(place_of_j5) ? "true" : "false",
                                     "J6 is nearer on a square: of edges 5 the distances are " + measured +
                                         ". The best is about J(5.66), see polyloops.j5.square.best."));
  const Algebraic s = balanced_parameter();
  results.claims.push_back(
      settle(head(table(), "polyloops.j5.square.best"),
             exact(Algebraic(8) - Algebraic(8) * s, "exact by limit masks"),
             "A larger s takes the curve farther from the corners, a smaller one farther beyond the edges."));
  std::string counts;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    counts += fmt::format("{}{}: {}", counts.empty() ? "" : ", ", stationary_names[i], nearest[i]);
  }
  results.claims.push_back(share("polyloops.j5.others", nearest[place_of_j5], "Nearest is " + counts + "."));
}

void add_popping(Results& results) {
  constexpr int levels = 4;
  std::vector<std::vector<double>> moved;  // of curve, polygon and level
  for (const std::string& name : stationary_names) {
    std::vector<double>& of_curve = moved.emplace_back();
    for (const PlanePolygon& polygon : simple_polygons()) {
      Polyline parent = in_double(polygon);
      for (int level = 1; level <= levels; ++level) {
        Polyline fine = refined(polyloop_curve(name), polygon, level);
        of_curve.push_back(largest_displacement(parent, fine, 2));
        parent = std::move(fine);
      }
    }
  }
  constexpr double margin = 1e-9;
  std::vector<int> least(moved.size(), 0);
  for (std::size_t i = 0; i < moved.front().size(); ++i) {
    for (std::size_t a = 0; a < moved.size(); ++a) {
      bool below = true;
      for (std::size_t b = 0; b < moved.size(); ++b)
        below = below && (a == b || moved[a][i] + margin < moved[b][i]);
      least[a] += below ? 1 : 0;
    }
  }
  std::string counts;
  for (std::size_t i = 0; i < least.size(); ++i)
    counts += fmt::format("{}{}: {}", counts.empty() ? "" : ", ", stationary_names[i], least[i]);
  results.claims.push_back(settle_share(head(table(), "polyloops.j5.popping"), least[place_of_j5],
                                        levels * family_size(), "The least is that of " + counts + ".",
                                        Rigour::certified));
}

// ---- Jerk and shape
// ----------------------------------------------------------------------------------------

std::vector<NormalJerk> jerks_of(const Scheme<Rational>& scheme) {
  std::vector<NormalJerk> result;
  for (const PlanePolygon& polygon : simple_polygons())
    result.push_back(normal_jerk(refined(scheme, polygon)));
  return result;
}

/// How many of the pairs (a_i, b_i) have a below `factor` b.
int below(const std::vector<NormalJerk>& a, const std::vector<NormalJerk>& b, double factor = 1) {
  constexpr double margin = 1 - 1e-9;
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i].largest < margin * factor * b[i].largest ? 1 : 0;
  return count;
}

/// The least, the median and the greatest of a_i / b_i.
std::string ratios_text(const std::vector<NormalJerk>& a, const std::vector<NormalJerk>& b) {
  Measure ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i].largest / b[i].largest);
  std::ranges::sort(ratios);
  return fmt::format("The ratio runs from {:.3g} to {:.3g}, median {:.3g}.", ratios.front(), ratios.back(),
                     ratios[ratios.size() / 2]);
}

double irregularity(const NormalJerk& of) { return of.largest / of.mean; }

void add_jerks(Results& results) {
  std::vector<std::vector<NormalJerk>> of;
  for (const std::string& name : stationary_names) of.push_back(jerks_of(polyloop_curve(name)));
  const std::vector<NormalJerk>& cubic = of.front();
  const std::vector<NormalJerk>& four_point = of.back();
  const std::vector<NormalJerk> jm = jerks_of(polyloop_curve("Jm"));
  Scheme<Rational> backwards = polyloop_curve("Jm");
  std::ranges::reverse(backwards.steps);
  const std::vector<NormalJerk> reversed = jerks_of(backwards);
  constexpr double barely = 0.05;
  constexpr double unnoticed = 0.1;
  constexpr double margin = 1e-9;
  results.claims.push_back(
      share("polyloops.jerk.j0", below(cubic, four_point, barely),
            ratios_text(cubic, four_point) + " It is about halved by each further level."));
  int irregular = 0;
  int rising = 0;
  int both = 0;
  for (std::size_t i = 0; i < cubic.size(); ++i) {
    const double ratio = irregularity(four_point[i]);
    bool most = ratio > 2 + margin;
    bool rises = true;
    for (std::size_t k = 0; k + 1 < of.size(); ++k) {
      most = most && irregularity(of[k][i]) + margin < ratio;
      rises = rises && of[k][i].largest * (1 + margin) < of[k + 1][i].largest;
    }
    irregular += most ? 1 : 0;
    rising += rises ? 1 : 0;
    both += reversed[i].largest * (1 + margin) < std::min(cubic[i].largest, jm[i].largest) ? 1 : 0;
  }
  results.claims.push_back(share("polyloops.jerk.j8", irregular));
  results.claims.push_back(share("polyloops.jerk.rising", rising));
  results.claims.push_back(share(
      "polyloops.jm.jerk", below(jm, four_point, unnoticed),
      ratios_text(jm, four_point) +
          fmt::format(" Below a twentieth on {}. The limit of Jm is C3, and its jerks fall by 8 with each "
                      "further level in the end; those of J8, of exponent 2, by about 4.",
                      below(jm, four_point, barely))));
  results.claims.push_back(share("polyloops.jm.jerk.least", below(jm, cubic), ratios_text(jm, cubic)));
  results.claims.push_back(
      share("polyloops.jm.jerk.reversed", both,
            "Reversed steps end with J(2) and leave a smaller shape. " + ratios_text(reversed, jm)));
}

/// The integral of the squared curvature times the length, curvatures by circles.
double bending(const Polyline& polyline) {
  const std::vector<double>& x = polyline.coordinates[0];
  const std::vector<double>& y = polyline.coordinates[1];
  const std::size_t n = x.size();
  double energy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = (i + n - 1) % n;
    const std::size_t c = (i + 1) % n;
    const double before = std::hypot(x[i] - x[a], y[i] - y[a]);
    const double after = std::hypot(x[c] - x[i], y[c] - y[i]);
    const double chord = std::hypot(x[c] - x[a], y[c] - y[a]);
    const double twice_area = (x[i] - x[a]) * (y[c] - y[i]) - (y[i] - y[a]) * (x[c] - x[i]);
    const double curvature = 2 * twice_area / (before * after * chord);
    energy += curvature * curvature * (before + after) / 2;
  }
  return energy * length(polyline);
}

void add_shapes(Results& results) {
  std::vector<int> above(stationary_names.size(), 0);
  int least = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const double jm = bending(refined(polyloop_curve("Jm"), polygon));
    bool best = true;
    for (std::size_t i = 0; i < stationary_names.size(); ++i) {
      const bool worse = jm < bending(refined(polyloop_curve(stationary_names[i]), polygon));
      above[i] += worse ? 1 : 0;
      best = best && worse;
    }
    least += best ? 1 : 0;
  }
  std::string counts;
  for (std::size_t i = 0; i < above.size(); ++i)
    counts += fmt::format("{}{} on {}", counts.empty() ? "" : ", ", stationary_names[i], above[i]);
  results.claims.push_back(settle_share(head(table(), "polyloops.jm.pleasant"), least, family_size(),
                                        "Jm has less than " + counts + ".", Rigour::approximate));
}

/// Every curve on every stored polygon: area and distance relative to it, normal jerk.
void add_measures(Results& results) {
  const auto cell = [](double x) { return fmt::format("{:.10g}", x); };
  Series measures{
      "polyloop-measures",
      {"polygon", "curve", "area", "hausdorff lower", "hausdorff upper", "jerk largest", "jerk mean"},
      {}};
  std::vector<std::string> names = stationary_names;
  names.emplace_back("Jm");
  for (const auto& [polygon_name, polygon] : stored_polyloops()) {
    Distances distances(polygon, names);
    const double own = signed_area(in_double(polygon));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Polyline curve = refined(polyloop_curve(names[i]), polygon);
      const NormalJerk of = normal_jerk(curve);
      const DistanceBounds distance = distances.fine(i);
      measures.rows.push_back({polygon_name, names[i], cell(signed_area(curve) / own), cell(distance.lower),
                               cell(distance.upper), cell(of.largest), cell(of.mean)});
    }
  }
  results.series.push_back(std::move(measures));
}

}  // namespace

std::span<const ClaimHead> polyloop_curve_heads() { return table(); }

Results run_polyloop_curves() {
  Results results;
  add_cubic(results);
  add_osculation(results);
  add_areas(results);
  add_distances(results);
  add_popping(results);
  add_jerks(results);
  add_shapes(results);
  add_measures(results);
  return results;
}

}  // namespace subdiv
