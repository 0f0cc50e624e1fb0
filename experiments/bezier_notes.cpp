#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "experiments/data.h"
#include "experiments/drawing.h"
#include "experiments/lecture_note_parts.h"
#include "schemes/evaluate/bezier_drawing.h"
#include "schemes/evaluate/de_casteljau.h"

namespace subdiv::notes {
namespace {

const std::string polar =
    ": the value of the cubic's polar form, which is symmetric, affine in each of its three arguments and "
    "the "
    "cubic where they are equal, at ";

ClaimHead point_head(const char* id, const char* printed, const char* place) {
  return {id, "notes", "1", printed, ClaimKind::exact, std::string(printed) + polar + place + "."};
}

const std::array table{
    point_head("notes.bezier.p01", "P01 = (P0 + P1)/2", "(0, 0, 1/2)"),
    point_head("notes.bezier.p12", "P12 = (P1 + P2)/2", "(0, 1/2, 1)"),
    point_head("notes.bezier.p23", "P23 = (P2 + P3)/2", "(1/2, 1, 1)"),
    point_head("notes.bezier.p012", "P012 = (P01 + P12)/2", "(0, 1/2, 1/2)"),
    point_head("notes.bezier.p123", "P123 = (P12 + P23)/2", "(1/2, 1/2, 1)"),
    point_head("notes.bezier.p0123", "P0123 = (P012 + P123)/2", "(1/2, 1/2, 1/2)"),
    ClaimHead{
        "notes.bezier.halves", "notes", "1, figure 1",
        "The Bezier curve with control points P0, P1, P2, P3 is the union of two Bezier curves",
        ClaimKind::exact,
        "With p the cubic: the curve of P0, P01, P012, P0123 is p(t/2) and that of P0123, P123, P23, P3 "
        "is p((1+t)/2), identities of polynomials in t and P0 .. P3."},
    ClaimHead{"notes.bezier.iterated", "notes", "1",
              "iterated to obtain a splitting into four, eight, sixteen, or even more short curves",
              ClaimKind::exact,
              "After 2, 3, 4 and 5 rounds of splitting, part m of 2^k is p((m+t)/2^k), as polynomials."},
    finding(
        "notes.bezier.degrees", "notes 1",
        "De Casteljau's split at 1/2 for the degrees 1 .. 12: both halves are the curve, as polynomials."),
    ClaimHead{"notes.bezier.polygon", "notes", "1",
              "These short curves can be approximated by the control polygon", ClaimKind::exact,
              "How the distance from the control polygon, bounded by the largest second difference D = "
              "max |P_{i-1} - 2 P_i + P_{i+1}|, changes with a split."},
    finding("notes.bezier.polygon.distance", "notes 1",
            "The largest distance of a cubic from its control polygon, over D."),
    finding("notes.bezier.chord.distance", "notes 1",
            "The largest distance of a cubic p(t) from the point of its chord at t, over D."),
    finding("notes.bezier.rate", "notes 1",
            "The largest D of the halves of a cubic over its own, for the worst cubic."),
    ClaimHead{"notes.bezier.divisions", "notes", "1", "all those divisions are by two", ClaimKind::exact,
              "Each of the six points of a split is half the sum of two points computed before."},
    ClaimHead{
        "notes.bezier.shifts", "notes", "1", "as bit shifts (if integers are used)", ClaimKind::exact,
        "Whether x >> 1 is the half of x, as the split asks, for all integers of either sign: for -64 .. 64, "
        "hence for all, as adding 2 to x adds 1 to both."},
    finding("notes.bezier.shifts.multiples", "notes 1",
            "The least m > 0 such that a split by shifts is exact for all control points whose coordinates "
            "are multiples of m."),
    finding("notes.bezier.shifts.error", "notes 1",
            "The largest distance, in a coordinate, of P0123 by shifts from the exact one, over all integer "
            "control points; residues modulo 8 decide."),
    ClaimHead{
        "notes.bezier.exponent", "notes", "1", "as decrementing the exponent", ClaimKind::exact,
        "Doubles of exponent field 2 .. 2046, either sign: x/2 has the same significand and an exponent "
        "field less by one. For each field at three significands; both sides are affine in the "
        "significand."},
    finding("notes.bezier.exponent.least", "notes 1",
            "The least double from which on decrementing the exponent field halves all of them."),
    finding("figure.notes.bezier", "notes 1, figure 1",
            "The cubic of figure-bezier.csv: the area between the curve and its chord, by integration; it is "
            "the sum of those of both halves and of the triangle P0, P0123, P3."),
    finding("figure.notes.adaptive", "notes 1",
            "The cubic of figure-hairpin.csv, halved until every chord is within 0.02 of the curve: the "
            "number of chords."),
    finding("figure.notes.adaptive.uniform", "notes 1",
            "The same with equal parts, as deep as the deepest of them: the number of chords."),
};

const ClaimHead& claim(const std::string& id) { return head(table, id); }
Claim statement(const std::string& id, bool holds, const std::string& text, const std::string& note = "") {
  return settle_statement(claim(id), holds, text, note);
}
Claim number(const std::string& id, const Rational& value, const std::string& note = "") {
  return settle(claim(id), exact(value, "rational arithmetic"), note);
}

/// Coefficients of t^0, t^1, .. of a curve.
using Curve = std::vector<Combination>;
using Points = std::vector<Combination>;

Rational binomial(int n, int k) {
  Rational result(1);
  for (int i = 0; i < k; ++i) result *= Rational(n - i, i + 1);
  return result;
}

/// The Bezier curve by powers of t: c_k = binomial(n, k) times the k-th forward difference of P_0.
Curve by_powers(const Points& points) {
  const int n = static_cast<int>(points.size()) - 1;
  Curve curve;
  for (int k = 0; k <= n; ++k) {
    Combination difference;
    for (int i = 0; i <= k; ++i) {
      const Rational sign((k - i) % 2 == 0 ? 1 : -1);
      difference += Rational(sign * binomial(k, i)) * points[static_cast<std::size_t>(i)];
    }
    curve.push_back(binomial(n, k) * difference);
  }
  return curve;
}

/// p(begin + width t).
Curve restricted(const Curve& p, const Rational& begin, const Rational& width) {
  Curve result;
  for (int k = 0; k < static_cast<int>(p.size()); ++k) {
    Combination sum;
    for (int j = k; j < static_cast<int>(p.size()); ++j)
      sum += Rational(binomial(j, k) * pow(begin, j - k)) * p[static_cast<std::size_t>(j)];
    result.push_back(pow(width, k) * sum);
  }
  return result;
}

/// The polar form of a cubic: t^k becomes the k-th elementary symmetric function over binomial(3, k).
Combination polar_form(const Curve& p, const Rational& a, const Rational& b, const Rational& c) {
  const Rational third(1, 3);
  return p.at(0) + Rational((a + b + c) * third) * p.at(1) +
         Rational((a * b + b * c + c * a) * third) * p.at(2) + Rational(a * b * c) * p.at(3);
}

Combination half_of(const Combination& a, const Combination& b) { return Rational(1, 2) * (a + b); }

std::pair<Points, Points> halves(const Points& points) { return split_bezier(points, half_of); }

// ---- The split

void add_points(Results& results) {
  const Points p = control_points(3);
  const Curve curve = by_powers(p);
  const Combination p01 = half_of(p[0], p[1]);
  const Combination p12 = half_of(p[1], p[2]);
  const Combination p23 = half_of(p[2], p[3]);
  const Combination p012 = half_of(p01, p12);
  const Combination p123 = half_of(p12, p23);
  const Combination p0123 = half_of(p012, p123);
  const auto add = [&](const char* id, const Combination& point, int zeros, int middles, int ones) {
    std::vector<Rational> at;
    at.insert(at.end(), static_cast<std::size_t>(zeros), Rational(0));
    at.insert(at.end(), static_cast<std::size_t>(middles), Rational(1, 2));
    at.insert(at.end(), static_cast<std::size_t>(ones), Rational(1));
    results.claims.push_back(
        statement(id, polar_form(curve, at.at(0), at.at(1), at.at(2)) == point, to_string(point)));
  };
  add("notes.bezier.p01", p01, 2, 1, 0);
  add("notes.bezier.p12", p12, 1, 1, 1);
  add("notes.bezier.p23", p23, 0, 1, 2);
  add("notes.bezier.p012", p012, 1, 2, 0);
  add("notes.bezier.p123", p123, 0, 2, 1);
  add("notes.bezier.p0123", p0123, 0, 3, 0);
  const Rational half(1, 2);
  const bool same = by_powers({p[0], p01, p012, p0123}) == restricted(curve, Rational(0), half) &&
                    by_powers({p0123, p123, p23, p[3]}) == restricted(curve, half, half);
  results.claims.push_back(statement("notes.bezier.halves", same, "p(t/2) and p((1+t)/2)"));
  const auto [first, second] = halves(p);
  results.claims.push_back(
      statement("notes.bezier.divisions",
                first == Points{p[0], p01, p012, p0123} && second == Points{p0123, p123, p23, p[3]},
                "six halves of sums"));
}

void add_iterated(Results& results) {
  const Curve curve = by_powers(control_points(3));
  std::vector<Points> parts{control_points(3)};
  bool same = true;
  constexpr int rounds = 5;
  for (int k = 1; k <= rounds; ++k) {
    std::vector<Points> finer;
    for (const Points& part : parts) {
      auto [first, second] = halves(part);
      finer.push_back(std::move(first));
      finer.push_back(std::move(second));
    }
    parts = std::move(finer);
    const Rational width = pow(Rational(2), -k);
    for (std::size_t m = 0; m < parts.size(); ++m)
      same = same &&
             by_powers(parts[m]) == restricted(curve, Rational(static_cast<std::int64_t>(m)) * width, width);
  }
  results.claims.push_back(statement("notes.bezier.iterated", same, "p((m+t)/2^k)"));
  bool degrees = true;
  constexpr int most = 12;
  for (int n = 1; n <= most; ++n) {
    const Curve p = by_powers(control_points(n));
    const auto [first, second] = halves(control_points(n));
    const Rational half(1, 2);
    degrees = degrees && by_powers(first) == restricted(p, Rational(0), half) &&
              by_powers(second) == restricted(p, half, half);
  }
  results.claims.push_back(statement("notes.bezier.degrees", degrees, "true"));
}

// ---- Flatness

/// The second differences of points as combinations of those of P_0, P_1, ..: at z^i, P_i - 2 P_{i+1} +
/// P_{i+2}.
std::vector<Combination> second_differences(const Points& points) {
  const Combination of_control_points(0, {1, -2, 1});
  std::vector<Combination> result;
  for (std::size_t i = 0; i + 2 < points.size(); ++i) {
    const auto quotient =
        divide_exactly(points[i] - Rational(2) * points[i + 1] + points[i + 2], of_control_points);
    if (!quotient) throw std::logic_error("a second difference of averages is one of second differences");
    result.push_back(*quotient);
  }
  return result;
}

/// The largest sum of absolute weights in the second differences of the halves.
Rational growth_of_differences() {
  Rational largest(0);
  const auto [first, second] = halves(control_points(3));
  for (const Points& half : {first, second}) {
    for (const Combination& difference : second_differences(half)) {
      Rational sum(0);
      for (const Rational& w : difference.coefficients()) sum += w.sign() < 0 ? -w : w;
      largest = std::max(largest, sum);
    }
  }
  return largest;
}

/// The cubic with all second differences 1, P_i = i^2/2, at t.
Rational parabola(const Rational& t) { return Rational(3) * t * t + Rational(3, 2) * t; }

void add_flatness(Results& results) {
  const Rational rate = growth_of_differences();
  results.claims.push_back(number(
      "notes.bezier.rate", rate,
      "The second differences of the halves are combinations of the whole's with positive weights of sum "
      "1/4 at most: a parabola attains it. Distances from chord and polygon fall to a quarter with each "
      "split."));
  // Convex on each leg of the polygon, so that its corners decide.
  Rational polygon(0);
  for (int i = 0; i <= 3; ++i)
    polygon = std::max(polygon, parabola(Rational(i, 3)) - Rational(static_cast<std::int64_t>(i) * i, 2));
  results.claims.push_back(number(
      "notes.bezier.polygon.distance", polygon,
      "Nairn, Peters & Lutterkort 1999: curve minus polygon at t is a sum of second differences with "
      "weights that are not negative, as Bernstein polynomials of convex functions do not lie below "
      "them; so it is largest when all are D, and then at a corner. Degree n: floor(n/2) ceil(n/2)/(2n)."));
  const Rational half(1, 2);
  const Rational chord = half * parabola(Rational(1)) - parabola(half);
  results.claims.push_back(number(
      "notes.bezier.chord.distance", chord,
      "The error of linear interpolation is at most |p''|/8, and |p''| <= 6 D; attained when all second "
      "differences are equal. Degree n: n (n-1)/8 (Filip, Magedson & Markot 1986)."));
  results.claims.push_back(statement("notes.bezier.polygon",
                                     rate == Rational(1, 4) && polygon == Rational(1, 3),
                                     "after k splits at most D/(3 4^k)"));
}

// ---- Halving in machine numbers

void add_shifts(Results& results) {
  bool floors = true;
  bool halves = true;
  constexpr int range = 64;
  for (int x = -range; x <= range; ++x) {
    const Rational half(x, 2);
    floors = floors && Rational(x >> 1) == (x % 2 == 0 ? half : Rational(half - Rational(1, 2)));
    halves = halves && Rational(x >> 1) == half;
  }
  if (!floors) throw std::logic_error("shifts do not round down");
  results.claims.push_back(statement(
      "notes.bezier.shifts", halves, "x/2 for even x, (x-1)/2 for odd x",
      "A shift halves even integers alone; odd ones it rounds down, and sums of two coordinates are odd or "
      "even. Splits stay exact for all control points whose coordinates are multiples of m only if 8 divides "
      "m for one split (notes.bezier.shifts.multiples), 8^k for k of them; some other points split exactly, "
      "too, as 0, 2, 4, 6 do. What a split loses is notes.bezier.shifts.error."));
  const auto middle = [](int a, int b) { return (a + b) >> 1; };
  constexpr int residues = 8;
  Rational largest(0);
  for (int a = 0; a < residues; ++a) {
    for (int b = 0; b < residues; ++b) {
      for (int c = 0; c < residues; ++c) {
        for (int d = 0; d < residues; ++d) {
          const int bc = middle(b, c);
          const int by_shifts = middle(middle(middle(a, b), bc), middle(bc, middle(c, d)));
          largest = std::max(largest, Rational(a + 3 * b + 3 * c + d, 8) - Rational(by_shifts));
        }
      }
    }
  }
  results.claims.push_back(number("notes.bezier.shifts.error", largest));
  // Sums of multiples of m for all of which the halves are whole: those of one point alone decide, as the
  // points of a split are sums of their shares.
  const auto exact_for_multiples = [](int m) {
    bool exact = true;
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<Rational> points(4, Rational(0));
      points[i] = Rational(m);
      (void)split_bezier(points, [&](const Rational& a, const Rational& b) {
        const Rational half = (a + b) / Rational(2);
        exact = exact && half.is_integer();
        return half;
      });
    }
    return exact;
  };
  int m = 1;
  while (!exact_for_multiples(m)) ++m;
  results.claims.push_back(number(
      "notes.bezier.shifts.multiples", Rational(m),
      "P0123 has an eighth of P0, so that its multiples alone do. The second half of m, 0, 0, 0 is m/8, 0, "
      "0, 0: k splits ask for multiples of 8^k."));
}

bool halved_by_exponent(std::uint64_t bits) {
  constexpr int significand_bits = 52;
  const std::uint64_t less = bits - (std::uint64_t{1} << static_cast<unsigned>(significand_bits));
  return std::bit_cast<double>(less) * 2 == std::bit_cast<double>(bits) &&
         std::signbit(std::bit_cast<double>(less)) == std::signbit(std::bit_cast<double>(bits));
}

void add_exponents(Results& results) {
  constexpr std::uint64_t one = 1;
  constexpr unsigned significand_bits = 52;
  constexpr std::uint64_t last_field = 2046;
  const std::array<std::uint64_t, 3> significands{0, 1, (one << significand_bits) - 1};
  const auto holds_for = [&](std::uint64_t field) {
    bool holds = true;
    for (const std::uint64_t sign : {std::uint64_t{0}, one << 63U}) {
      for (const std::uint64_t s : significands)
        holds = holds && halved_by_exponent(sign | (field << significand_bits) | s);
    }
    return holds;
  };
  std::uint64_t first = last_field + 1;
  while (first > 0 && holds_for(first - 1)) --first;
  constexpr std::uint64_t expected = 2;  // 2^(2 - 1023) = 2^-1021
  results.claims.push_back(
      statement("notes.bezier.exponent", first <= expected, fmt::format("fields {} .. {}", first, last_field),
                "Only for normal numbers whose half is normal: see notes.bezier.exponent.least."));
  results.claims.push_back(statement(
      "notes.bezier.exponent.least", first == expected, "2^-1021",
      "From 2^-1022 on to below 2^-1021 the field becomes 0, which stands for another form without a leading "
      "1: the result is not x/2. Smaller numbers, and 0, have no exponent to decrement. Division by two is "
      "exact down to 2^-1021, too; below, it rounds odd multiples of 2^-1074."));
}

// ---- Figures

using Plane = std::vector<std::pair<Rational, Rational>>;

/// Twice the area to the left between the cubic and its chord: the integral of p x p' for P0 at the origin.
Rational doubled_area(const Plane& p) {
  std::array<std::pair<Rational, Rational>, 4> c;  // by powers of t, P0 at the origin
  const std::array<std::array<int, 4>, 4> bernstein{
      {{1, 0, 0, 0}, {-3, 3, 0, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}}};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      c[k].first += Rational(bernstein[k][i]) * (p[i].first - p[0].first);
      c[k].second += Rational(bernstein[k][i]) * (p[i].second - p[0].second);
    }
  }
  Rational sum(0);
  for (int i = 1; i < 4; ++i) {
    for (int k = 1; k < 4; ++k) {
      const auto& [ax, ay] = c[static_cast<std::size_t>(i)];
      const auto& [bx, by] = c[static_cast<std::size_t>(k)];
      sum += Rational(k, i + k) * (ax * by - ay * bx);
    }
  }
  return sum;
}

Plane middle_split(const Plane& p, bool second) {
  const auto parts = split_bezier(p, [](const auto& a, const auto& b) {
    return std::pair{Rational((a.first + b.first) / Rational(2)),
                     Rational((a.second + b.second) / Rational(2))};
  });
  return second ? parts.second : parts.first;
}

BezierCurve in_double(const Plane& p) {
  BezierCurve curve(2);
  for (const auto& [x, y] : p) {
    curve[0].push_back(x.to_double());
    curve[1].push_back(y.to_double());
  }
  return curve;
}

PlanePoints drawn(const BezierPolyline& line) {
  PlanePoints points;
  for (std::size_t i = 0; i < line.coordinates[0].size(); ++i)
    points.emplace_back(Rational::from_double(line.coordinates[0][i]),
                        Rational::from_double(line.coordinates[1][i]));
  return points;
}

constexpr std::size_t most_segments = 4096;

PlanePoints smooth_curve(const Plane& p) {
  constexpr int depth = 7;
  return drawn(draw_to_depth({in_double(p)}, depth, most_segments));
}

void add_split_figure(Results& results) {
  const Plane p = polygon_from_data("figure-bezier.csv");
  const Plane first = middle_split(p, false);
  const Plane second = middle_split(p, true);
  const auto& [ax, ay] = p.front();
  const auto& [bx, by] = first.back();
  const auto& [cx, cy] = p.back();
  const Rational triangle = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const Rational whole = doubled_area(p);
  if (!(whole == doubled_area(first) + doubled_area(second) + triangle))
    throw std::logic_error("the halves of a curve have another area");
  results.claims.push_back(number("figure.notes.bezier", whole / Rational(2),
                                  "Negative: the curve and its chord back run clockwise."));
  const auto dots = [](const Plane& points) { return Stroke{"", points, false, style::dot}; };
  Drawing drawing{"figure-notes-bezier",
                  "A Bezier curve is two Bezier curves (notes figure 1)",
                  {},
                  {"figure.notes.bezier", "notes.bezier.p01", "notes.bezier.p12", "notes.bezier.p23",
                   "notes.bezier.p012", "notes.bezier.p123", "notes.bezier.p0123", "notes.bezier.halves"}};
  drawing.panels.push_back(
      {"the cubic",
       {{"", p, false, style::polygon}, {"", smooth_curve(p), false, style::curve(0)}, dots(p)}});
  const auto& [x1, y1] = p[1];
  const auto& [x2, y2] = p[2];
  const Plane between{first[1], {(x1 + x2) / Rational(2), (y1 + y2) / Rational(2)}, second[2]};
  drawing.panels.push_back({"its halves",
                            {{"", p, false, style::polygon},
                             {"", between, false, style::polygon},
                             {"", first, false, style::in_colour(style::vermilion, 1.2)},
                             {"", second, false, style::in_colour(style::green, 1.2)},
                             {"", smooth_curve(first), false, style::in_colour(style::vermilion, 3)},
                             {"", smooth_curve(second), false, style::in_colour(style::green, 3)},
                             dots(between),
                             dots(first),
                             dots(second)}});
  const auto named = [](const std::pair<Rational, Rational>& point, const char* name, const char* place) {
    return FigureText{name, point.first.to_double(), point.second.to_double(), place};
  };
  const char* above = "center offset 0,0.8";
  const char* below = "center offset 0,-0.8";
  for (Panel& panel : drawing.panels)
    panel.texts = {named(p[0], "P0", "left offset 0.9,-0.2"), named(p[1], "P1", above),
                   named(p[2], "P2", above), named(p[3], "P3", "right offset -0.9,-0.2")};
  for (const FigureText& text :
       {named(first[1], "P01", "right offset -0.6,0.4"), named(between[1], "P12", above),
        named(second[2], "P23", "left offset 0.8,0"), named(first[2], "P012", "right offset -0.5,0.5"),
        named(second[1], "P123", "left offset 0.4,0.6"), named(first[3], "P0123", below)})
    drawing.panels[1].texts.push_back(text);
  add_drawing(results, drawing);
}

void add_adaptive_figure(Results& results) {
  const Plane p = polygon_from_data("figure-hairpin.csv");
  constexpr double tolerance = 0.02;
  const BezierPolyline line = draw_to_tolerance({in_double(p)}, tolerance, most_segments);
  const auto count = static_cast<std::int64_t>(line.segments);
  const std::int64_t uniform = std::int64_t{1} << static_cast<unsigned>(line.deepest);
  results.claims.push_back(number(
      "figure.notes.adaptive", Rational(count),
      fmt::format("Hausdorff distance from the curve at most {:.4f}, rounding included.", line.bound)));
  results.claims.push_back(number("figure.notes.adaptive.uniform", Rational(uniform)));
  Drawing drawing{"figure-notes-adaptive",
                  "Chords within 0.02 of a cubic: points gather where it turns",
                  {},
                  {"figure.notes.adaptive", "figure.notes.adaptive.uniform"}};
  drawing.panels.push_back({fmt::format("{} chords; {} of equal parts", count, uniform),
                            {{"", p, false, style::polygon},
                             {"", drawn(line), false, style::curve(0)},
                             {"", drawn(line), false, style::points(1, 0.4)}}});
  add_drawing(results, drawing);
}

}  // namespace

std::span<const ClaimHead> bezier_heads() { return table; }

Results run_bezier() {
  Results results;
  add_points(results);
  add_iterated(results);
  add_flatness(results);
  add_shifts(results);
  add_exponents(results);
  add_split_figure(results);
  add_adaptive_figure(results);
  return results;
}

}  // namespace subdiv::notes
