#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/limit_mask.h"
#include "analysis/uniform_bspline.h"
#include "experiments/data.h"
#include "experiments/drawing.h"
#include "experiments/lecture_note_parts.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/polyloop/polyloop_operator.h"

namespace subdiv::notes {
namespace {

const std::string sequences = " For P_0 .. P_n, n = 3 .. 12.";

const std::array table{
    ClaimHead{"notes.doubling", "notes", "2", "P0, P0, P1, P1, P2, P2, .., Pn, Pn", ClaimKind::exact,
              "Doubling as a mask: the symbol 1 + z, with the sequence as it is printed." + sequences},
    ClaimHead{"notes.averaging", "notes", "2",
              "the averaging involves only addition of floats and division by two", ClaimKind::exact,
              "Averaging as a mask of arity 1: (1 + z)/2 but for the numbering."},
    ClaimHead{"notes.bsplines", "notes", "2",
              "one needs to perform one doubling operation and follow it by k averaging steps",
              ClaimKind::exact,
              "Doubling and k averagings composed, for k = 1 .. 10: the symbol is 2 ((1+z)/2)^(k+1), the "
              "B-spline's of degree k. For every k: (1+z) ((1+z)/2)^k is that."},
    ClaimHead{
        "notes.bsplines.same-curve", "notes", "2",
        "The resulting sequence of control points defines the same curve as the initial one",
        ClaimKind::exact,
        "The B-spline B_k, from its truncated powers, is the sum of a_i B_k(2t - i) with the weights a_i "
        "of doubling and k averagings: polynomials on every half unit, k = 1 .. 10."},
    ClaimHead{
        "notes.bsplines.fast", "notes", "2", "converging to the B-spline curve at a very fast rate",
        ClaimKind::exact,
        "The distance of the points, joined, from the curve after j steps, k = 2 .. 10, against D = max "
        "|P_{i-1} - 2 P_i + P_{i+1}|."},
    finding(
        "notes.bsplines.rate", "notes 2",
        "What a step leaves of D, degrees 2 .. 10: the largest sum of absolute coefficients of one parity "
        "in a(z)/(1+z)^2."),
    finding("notes.bsplines.distance", "notes 2",
            "The largest distance of a uniform cubic B-spline from its control polygon, over D."),
    ClaimHead{"notes.degree-1.sequence", "notes", "2, both examples",
              "P0, (P0+P1)/2, P1, (P1+P2)/2, P2, (P2+P3)/2, .., (P{n-1}+Pn)/2, Pn", ClaimKind::exact,
              "Doubling and one averaging, point by point." + sequences},
    ClaimHead{"notes.cubic.sequence.2", "notes", "2",
              "(3P0+P1)/4, (P0+3P1)/4, .., (3P{n-1}+Pn)/2, (P{n-1}+3Pn)/2", ClaimKind::exact,
              "Doubling and two averagings, point by point." + sequences},
    ClaimHead{"notes.cubic.sequence.3", "notes", "2",
              "(P0+P1)/2, (P0+6P1+P2)/8, (P1+P2)/2, .., (P{n-2}+6P{n-1}+Pn)/8, (P{n-1}+Pn)/2",
              ClaimKind::exact, "Doubling and three averagings, point by point." + sequences},
    ClaimHead{"notes.cubic.weights", "notes", "3, figure 3", "1/8,6/8 and 1/8", ClaimKind::exact,
              "A step of cubic B-splines adds the middle of each edge and moves each old point to these "
              "weights of its neighbours and itself: refine, then tweak (1/2, 0), against 2 ((1+z)/2)^4."},
    ClaimHead{"notes.cubic.removed", "notes", "3, figure 3",
              "the first and last vertices, so they are simply removed", ClaimKind::exact,
              "The sequence after three averagings holds n middles and n - 1 moved points, none of P_0 and "
              "P_n." +
                  sequences},
    ClaimHead{"notes.cubic.start", "notes", "3, figure 3",
              "the B-spline curve doesn't start at P0, but rather somewhere close to P1", ClaimKind::exact,
              "Where P_1 moves in the limit: the weights of sum 1 that a step of cubic B-splines keeps."},
    ClaimHead{"notes.cubic.space", "notes", "3, figure 3",
              "the points cover densely the space between the points corresponding to P1 and P3",
              ClaimKind::exact,
              "With P_i at the parameter i: after j steps the points of P_0 .. P_n are at the multiples of "
              "2^-j from 1 - 2^-j to n - 1 + 2^-j; n = 4 in the figure. Counted for n = 2 .. 8, j = 1 .. 5; "
              "the interval and its closed form follow from t -> t + 2^-(j+1) at its begin."},
    ClaimHead{"notes.four-point.weights", "notes", "3 and figure 4", "-1/16, 9/16, 9/16, -1/16",
              ClaimKind::exact,
              "The value at 1/2 of the cubic through values at -1, 0, 1, 2: Lagrange's polynomials; they are "
              "the odd coefficients of the four-point scheme."},
    ClaimHead{"notes.four-point.sequence", "notes", "3",
              "P1, (-P0+9P1+9P2-P3)/16, P2, .., P{n-2}, (-P{n-3}+9P{n-2}+9P{n-1}-Pn)/16, P{n-1}",
              ClaimKind::exact,
              "One step: all consecutive points whose rules reach none but P_0 .. P_n. For n = 3 .. 12."},
    ClaimHead{"notes.four-point.missing", "notes", "3",
              "since P{-1} is not available, we can't compute the point to be inserted just before P1",
              ClaimKind::exact, "The weight of P_{-1} in the point between P_0 and P_1."},
    ClaimHead{
        "notes.four-point.through", "notes", "3",
        "passing (unlike the B-splines) exactly through the specified control points", ClaimKind::exact,
        "The limit masks: the four-point scheme's is P_0 alone, those of the B-splines of degree 2 .. 10 "
        "are not."},
    ClaimHead{
        "notes.four-point.ends", "notes", "3",
        "starts at P2, ends at P{n-2} and passes through all control points in between the two",
        ClaimKind::exact,
        "With P_i at the parameter i: after j steps the points are at the multiples of 2^-j from 2 - "
        "2^(1-j) to n - 2 + 2^(1-j), and P_2 .. P_{n-2} are among them. Counted for n = 4 .. 10, j = 1 .. "
        "5; the interval's begin moves t -> t + 2^-j."},
    finding("notes.four-point.fewest", "notes 3",
            "The least number of control points of an open four-point curve that is no single point."),
    ClaimHead{"notes.four-point.figure", "notes", "3, figure 4",
              "ends at the third from the end (in this case, P5)", ClaimKind::exact,
              "The n for which P_{n-2} is P_5."},
    ClaimHead{
        "figure.notes.degree-1", "notes", "2, figure 2",
        "all the points are densely stretched along the B-spline curve (here: piecewise linear curve "
        "which joins the consecutive control points)",
        ClaimKind::exact,
        "On the stored open polygon figure-open.csv: three steps of degree 1 put a point at every eighth "
        "of every edge, in their order, and none elsewhere: the number of points."},
};

const ClaimHead& claim(const std::string& id) { return head(table, id); }
Claim statement(const std::string& id, bool holds, const std::string& text, const std::string& note = "") {
  return settle_statement(claim(id), holds, text, note);
}
Claim number(const std::string& id, const Rational& value, const std::string& note = "") {
  return settle(claim(id), exact(value, "rational arithmetic"), note);
}

using Points = std::vector<Combination>;
constexpr int fewest = 3;
constexpr int longest = 12;
constexpr int highest_degree = 10;

Points doubled(const Points& points) {
  Points result;
  for (const Combination& p : points) result.insert(result.end(), {p, p});
  return result;
}
Points averaged(const Points& points) {
  Points result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    result.push_back(Rational(1, 2) * (points[i] + points[i + 1]));
  return result;
}
/// Doubling and k averagings.
Points step(Points points, int k) {
  points = doubled(points);
  for (int i = 0; i < k; ++i) points = averaged(points);
  return points;
}

/// (a P_i + b P_{i+1} + ..)/denominator.
Combination printed(int i, const std::vector<Rational>& weights, int denominator) {
  return Rational(1, denominator) * Combination(i, weights);
}

/// Whether make(n), the printed sequence, is what `computed` makes of P_0 .. P_n, for every n.
template <class Computed, class Make>
bool for_all_lengths(const Computed& computed, const Make& make) {
  bool same = true;
  for (int n = fewest; n <= longest; ++n) same = same && computed(control_points(n)) == make(n);
  return same;
}

// ---- B-splines

Points printed_linear(int n) {
  Points points{control_point(0)};
  for (int i = 0; i < n; ++i) points.insert(points.end(), {printed(i, {1, 1}, 2), control_point(i + 1)});
  return points;
}
/// The second of the cubic sequences, its last two points with their denominator.
Points printed_quadratic(int n, int last_denominator) {
  Points points;
  for (int i = 0; i < n; ++i) {
    const int denominator = i + 1 < n ? 4 : last_denominator;
    points.insert(points.end(), {printed(i, {3, 1}, denominator), printed(i, {1, 3}, denominator)});
  }
  return points;
}
Points printed_cubic(int n) {
  Points points{printed(0, {1, 1}, 2)};
  for (int i = 0; i + 2 <= n; ++i)
    points.insert(points.end(), {printed(i, {1, 6, 1}, 8), printed(i + 1, {1, 1}, 2)});
  return points;
}

void add_sequences(Results& results) {
  const auto after = [](int k) { return [k](const Points& points) { return step(points, k); }; };
  results.claims.push_back(
      statement("notes.degree-1.sequence", for_all_lengths(after(1), printed_linear), "true"));
  constexpr int misprint = 2;
  constexpr int correct = 4;
  const bool as_printed = for_all_lengths(after(2), [](int n) { return printed_quadratic(n, misprint); });
  if (!for_all_lengths(after(2), [](int n) { return printed_quadratic(n, correct); }))
    throw std::logic_error("the second cubic sequence has other weights than 3/4 and 1/4");
  results.claims.push_back(statement("notes.cubic.sequence.2", as_printed,
                                     "(3P0+P1)/4, (P0+3P1)/4, .., (3P{n-1}+Pn)/4, (P{n-1}+3Pn)/4",
                                     "The last two points are (3 P_{n-1} + P_n)/4 and (P_{n-1} + 3 P_n)/4, "
                                     "like all others; divided by 2, as "
                                     "printed, they would be twice as far from the origin."));
  results.claims.push_back(
      statement("notes.cubic.sequence.3", for_all_lengths(after(3), printed_cubic), "true"));
  bool removed = true;
  for (int n = fewest; n <= longest; ++n) {
    const Points points = step(control_points(n), 3);
    removed = removed && static_cast<int>(points.size()) == n + (n - 1) &&
              points.front() == printed(0, {1, 1}, 2) && points.back() == printed(n - 1, {1, 1}, 2);
  }
  results.claims.push_back(statement("notes.cubic.removed", removed, "n middles, n - 1 moved points"));
}

PolyloopOperator<Rational> doubling() { return {1, {Laurent<Rational>(1), Laurent<Rational>(1)}, false}; }

void add_operators(Results& results) {
  const auto doubling_mask = mask_of(doubling());
  const bool sequence_doubles = for_all_lengths(doubled, [](int n) {
    Points points;
    for (int i = 0; i <= n; ++i) points.insert(points.end(), {control_point(i), control_point(i)});
    return points;
  });
  const bool doubles = sequence_doubles && doubling_mask && doubling_mask->arity == 2 &&
                       doubling_mask->symbol == Laurent<Rational>(0, {1, 1});
  results.claims.push_back(statement("notes.doubling", doubles, "1 + z"));
  const auto averaging = mask_of(polyloop::dual<Rational>());
  const Mask<Rational> half{1, Laurent<Rational>(0, {Rational(1, 2), Rational(1, 2)})};
  results.claims.push_back(statement("notes.averaging", averaging && same_but_for_numbers(*averaging, half),
                                     "one addition and one halving for a coordinate"));
  bool bsplines = true;
  std::vector<PolyloopOperator<Rational>> steps{doubling()};
  for (int k = 1; k <= highest_degree; ++k) {
    steps.push_back(polyloop::dual<Rational>());
    const auto mask = mask_of(sequence(steps));
    bsplines = bsplines && mask && same_but_for_numbers(*mask, bspline<Rational>(k));
  }
  results.claims.push_back(statement("notes.bsplines", bsplines, "2 ((1+z)/2)^(k+1)"));
  const auto cubic = mask_of(sequence<Rational>(
      {polyloop::refine<Rational>(), polyloop::tweak<Rational>(Rational(1, 2), Rational(0))}));
  const Points one_step = step(control_points(fewest), 3);
  results.claims.push_back(statement(
      "notes.cubic.weights",
      cubic && same_but_for_numbers(*cubic, bspline<Rational>(3)) && one_step[1] == printed(0, {1, 6, 1}, 8),
      "1/8, 6/8, 1/8"));
}

/// p(2t - shift).
UnivariatePolynomial at_double(const UnivariatePolynomial& p, const Rational& shift) {
  const UnivariatePolynomial argument(std::vector<Rational>{-shift, Rational(2)});
  UnivariatePolynomial result;
  for (long i = p.degree(); i >= 0; --i) result = result * argument + UnivariatePolynomial(p.coefficient(i));
  return result;
}

/// The weights of one control point in the sequence after a step of degree k.
std::vector<Rational> weights_of_step(int k) {
  std::vector<Rational> weights;
  const int middle = k + 2;  // far from the ends
  for (const Combination& point : step(control_points(2 * middle), k)) {
    if (!is_zero(point[middle])) weights.push_back(point[middle]);
  }
  return weights;
}

bool is_refinable(int k) {
  const UniformBspline spline(k);
  const std::vector<Rational> weights = weights_of_step(k);
  bool same = static_cast<int>(weights.size()) == k + 2;
  const Rational left = -spline.half_width();
  for (int half = 0; half < 2 * (k + 1); ++half) {
    const Rational lower = left + Rational(half, 2);
    const Rational upper = lower + Rational(1, 2);
    UnivariatePolynomial sum;
    for (int i = 0; i < static_cast<int>(weights.size()); ++i) {
      const Rational shift = Rational(i) + left;
      const UnivariatePolynomial part =
          at_double(spline.piece(Rational(2) * lower - shift, Rational(2) * upper - shift), shift);
      sum += UnivariatePolynomial(weights[static_cast<std::size_t>(i)]) * part;
    }
    same = same && sum == spline.piece(lower, upper);
  }
  return same;
}

/// The distance at a corner of the polygon with all second differences 1, P_i = i^2/2, from its B-spline of
/// degree k >= 2: a parabola parallel to t^2/2.
Rational distance_at_corner(int k) {
  const UniformBspline spline(k);
  Rational sum(0);
  for (int i = -k; i <= k; ++i)
    sum += Rational(static_cast<std::int64_t>(i) * i, 2) * spline.value(Rational(i));
  return sum;
}

void add_convergence(Results& results) {
  bool refinable = true;
  bool quarter = true;
  bool distances = true;
  Rational rate(0);
  for (int k = 1; k <= highest_degree; ++k) {
    refinable = refinable && is_refinable(k);
    if (k == 1) continue;
    const auto rest = divide_exactly(bspline<Rational>(k).symbol, Laurent<Rational>(0, {1, 2, 1}));
    for (const int parity : {0, 1}) {
      Rational weights(0);
      const Laurent<Rational> half = residue_class(rest.value(), parity, 2);
      for (const Rational& w : half.coefficients()) weights += w.sign() < 0 ? -w : w;
      rate = std::max(rate, weights);
      quarter = quarter && weights == Rational(1, 4);
    }
    distances = distances && distance_at_corner(k) == Rational(k + 1, 24);
  }
  results.claims.push_back(statement("notes.bsplines.same-curve", refinable,
                                     "B_k(t) = sum of a_i B_k(2t - i)",
                                     "Open sequences, too: P_0 .. P_n bear n + 1 - k spans, the 2 n + 2 - k "
                                     "points after a step twice as many."));
  results.claims.push_back(number("notes.bsplines.rate", rate));
  results.claims.push_back(number(
      "notes.bsplines.distance", distance_at_corner(3),
      "Curve minus polygon is a sum of second differences with weights that are not negative (B-splines of "
      "convex data do not lie below them), largest when all are D and then, convex between corners, at a "
      "corner. Degree k >= 2: (k+1)/24; degree 1 is its polygon."));
  results.claims.push_back(statement("notes.bsplines.fast", quarter && distances, "(k+1)/24 D/4^j at most",
                                     "Two more binary digits a step."));
}

// ---- Open curves

/// One step of the four-point rule on points whose rules reach nothing else.
Points four_point_step(const Points& points) {
  Points result;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    result.push_back(points[i]);
    if (i + 2 < points.size()) {
      result.push_back(Rational(1, 16) *
                       (Rational(9) * (points[i] + points[i + 1]) - points[i - 1] - points[i + 2]));
    }
  }
  return result;
}

/// The value at 1/2 of the cubic that is 1 at `node` and 0 at the others of -1, 0, 1, 2.
Rational lagrange_at_half(int node) {
  Rational value(1);
  for (int other = -1; other <= 2; ++other) {
    if (other != node) value *= (Rational(1, 2) - Rational(other)) / Rational(node - other);
  }
  return value;
}

/// Whether after each of 5 steps the points of P_0 .. P_n are as many as multiples of 2^-j from begin(j) to
/// n - begin(j).
template <class Step, class Begin>
bool covers(int n, const Step& refine, const Begin& begin) {
  Points points = control_points(n);
  bool same = true;
  constexpr int steps = 5;
  for (int j = 1; j <= steps; ++j) {
    points = refine(points);
    const Rational spans = (Rational(n) - Rational(2) * begin(j)) * pow(Rational(2), j);
    same = same && Rational(static_cast<std::int64_t>(points.size())) == spans + Rational(1);
  }
  return same;
}

void add_cubic_ends(Results& results) {
  const Laurent<Rational> mask = shift(limit_mask(bspline<Rational>(3)), 1);
  const Combination expected = printed(0, {1, 4, 1}, 6);
  results.claims.push_back(statement(
      "notes.cubic.start", mask == expected, to_string(mask),
      "That is P_1 + (P_0 - 2 P_1 + P_2)/6; likewise the curve ends at (P_{n-2} + 4 P_{n-1} + P_n)/6."));
  bool space = true;
  constexpr int most = 8;
  for (int n = 2; n <= most; ++n) {
    space = space && covers(
                         n, [](const Points& points) { return step(points, 3); },
                         [](int j) { return Rational(1) - pow(Rational(2), -j); });
  }
  results.claims.push_back(
      statement("notes.cubic.space", space, "[1, n - 1]", "P_1 to P_{n-1}: P_3 for n = 4."));
}

void add_four_point(Results& results) {
  const Laurent<Rational> symbol = four_point(Rational(1, 16)).symbol;
  bool weights = true;
  // The point between P_0 and P_1 has the index 1 and the coefficient 1 - 2 i of P_i.
  for (int node = -1; node <= 2; ++node) weights = weights && lagrange_at_half(node) == symbol[1 - 2 * node];
  const bool values = lagrange_at_half(-1) == Rational(-1, 16) && lagrange_at_half(0) == Rational(9, 16);
  results.claims.push_back(
      statement("notes.four-point.weights", weights && values, "-1/16, 9/16, 9/16, -1/16"));
  const bool same = for_all_lengths(four_point_step, [](int n) {
    Points points{control_point(1)};
    for (int i = 0; i + 3 <= n; ++i)
      points.insert(points.end(), {printed(i, {-1, 9, 9, -1}, 16), control_point(i + 2)});
    return points;
  });
  results.claims.push_back(statement("notes.four-point.sequence", same, "true"));
  results.claims.push_back(statement("notes.four-point.missing", lagrange_at_half(-1).sign() != 0,
                                     lagrange_at_half(-1).to_string(), "It is not 0."));
  bool through = limit_mask(four_point(Rational(1, 16))) == Laurent<Rational>(1);
  for (int k = 2; k <= highest_degree; ++k)
    through = through && !(limit_mask(bspline<Rational>(k)).coefficients().size() == 1);
  results.claims.push_back(statement("notes.four-point.through", through, "true",
                                     "Of open sequences P_2 .. P_{n-2} alone: notes.four-point.ends."));
}

void add_four_point_ends(Results& results) {
  const auto begin = [](int j) { return Rational(2) - pow(Rational(2), 1 - j); };
  bool ends = true;
  constexpr int most = 10;
  for (int n = 4; n <= most; ++n) {
    ends = ends && covers(n, four_point_step, begin);
    Points points = control_points(n);
    constexpr int steps = 3;
    for (int j = 0; j < steps; ++j) points = four_point_step(points);
    for (int i = 2; i <= n - 2; ++i) {  // (i - begin) 2^j = 2^j (i - 2) + 2
      const auto place = (static_cast<std::size_t>(i - 2) << static_cast<unsigned>(steps)) + 2;
      ends = ends && points.at(place) == control_point(i);
    }
  }
  results.claims.push_back(statement("notes.four-point.ends", ends, "[2, n - 2]",
                                     "After finitely many steps the sequence reaches beyond, to P_1 after "
                                     "one step; in the limit it does not."));
  // How many points so many control points have after 1, 2 and 3 steps: 2 N - 5 of N >= 3.
  const auto sizes = [](int count) {
    std::array<std::size_t, 3> result{};
    Points points = control_points(count - 1);
    for (std::size_t& size : result) {
      points = four_point_step(points);
      size = points.size();
    }
    return result;
  };
  // Those that stay as many at distances 2^-j shrink to a point; more of them grow with every step.
  int count = 4;
  std::string note;
  for (;; ++count) {
    const auto after = sizes(count);
    note += fmt::format("{} control points: {} after 1, 2, 3 steps. ", count, fmt::join(after, ", "));
    if (after[0] < after[1] && after[1] < after[2]) break;
  }
  results.claims.push_back(number("notes.four-point.fewest", Rational(count),
                                  note + "Five stay five, at distances that are halved, and shrink to P_2."));
  constexpr int named = 5;
  results.claims.push_back(statement("notes.four-point.figure", ends, fmt::format("n = {}", named + 2),
                                     "Eight control points, P_0 .. P_7."));
}

void add_figure(Results& results) {
  const PlanePoints polygon = polygon_from_data("figure-open.csv");
  Drawing drawing{"figure-notes-degree-1",
                  "Degree 1: each step adds the middles (notes figure 2)",
                  {},
                  {"figure.notes.degree-1", "notes.degree-1.sequence"}};
  std::vector<std::pair<Rational, Rational>> points = polygon;
  constexpr int steps = 3;
  for (int level = 0; level <= steps; ++level) {
    if (level > 0) {
      PlanePoints fine{points.front()};
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        fine.emplace_back((points[i].first + points[i + 1].first) / Rational(2),
                          (points[i].second + points[i + 1].second) / Rational(2));
        fine.push_back(points[i + 1]);
      }
      points = std::move(fine);
    }
    drawing.panels.push_back(
        {level == 0 ? "control points" : fmt::format("{} step{}", level, level == 1 ? "" : "s"),
         {{"", polygon, false, style::polygon}, {"", points, false, style::points(0, 0.4)}}});
  }
  constexpr std::size_t parts = 8;
  bool eighths = points.size() == parts * (polygon.size() - 1) + 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t edge = std::min(i / parts, polygon.size() - 2);
    const Rational t(static_cast<std::int64_t>(i - edge * parts), static_cast<std::int64_t>(parts));
    const auto& [ax, ay] = polygon[edge];
    const auto& [bx, by] = polygon[edge + 1];
    eighths = eighths && points[i] == std::pair{Rational(ax + t * (bx - ax)), Rational(ay + t * (by - ay))};
  }
  results.claims.push_back(statement("figure.notes.degree-1", eighths, std::to_string(points.size())));
  add_drawing(results, drawing);
}

}  // namespace

std::span<const ClaimHead> spline_heads() { return table; }

Results run_splines() {
  Results results;
  add_sequences(results);
  add_operators(results);
  add_convergence(results);
  add_cubic_ends(results);
  add_four_point(results);
  add_four_point_ends(results);
  add_figure(results);
  return results;
}

}  // namespace subdiv::notes
