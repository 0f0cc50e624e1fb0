#include "experiments/hoelder_exponents.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/hoelder.h"
#include "analysis/iterate_norm_range.h"
#include "analysis/sign_on_interval.h"
#include "analysis/three_tap_smoothness.h"
#include "experiments/report/figure_style.h"
#include "schemes/algebra/specialize.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

constexpr int smoothing_factors = 4;  // of the symbol of J_s, for all s
constexpr int digits = 15;

const std::string exponent_definition =
    "alpha(s), the largest exponent such that all limits of *J_s are Hoelder continuous of every smaller "
    "order: 3 - log2 rho(s), and 5 at s = 3/2. ";
const std::string section = "jsplines 3";

const std::array table{
    finding("smooth.exponent.formula", section, exponent_definition + "In closed form, -6 < s < 10."),
    finding("smooth.exponent.maximum", section, exponent_definition + "Its largest value."),
    finding("smooth.exponent.minimum.s", section,
            exponent_definition + "Its local minimum between s = 3/2 and s = 2."),
    finding("smooth.exponent.minimum", section, exponent_definition + "Its value at that minimum."),
    finding("smooth.exponent.attained", section,
            "Are the limits of *J_s Hoelder continuous (Lipschitz for an integer) with the very exponent "
            "alpha(s)? Where the exponent is no integer, and at s = 0, 1, 3/2, 2, 3."),
};

const ClaimHead& claim(const char* id) { return head(table, id); }

void require(bool agree, const std::string& what) {
  if (!agree) throw std::logic_error("two routes disagree: " + what);
}

Algebraic tap(const Rational& s) { return Algebraic((s - Rational(1)) / Rational(2)); }

/// The ends of the s with C^order limits.
std::pair<Rational, Rational> exact_ends(int order) {
  const RealSet taps = three_tap_continuity_set(smoothing_factors, order);
  const RealInterval& part = taps.parts.at(0);
  const auto parameter = [](const Algebraic& p) { return Rational(1) + Rational(2) * p.to_rational(); };
  return {parameter(part.lower.value()), parameter(part.upper.value())};
}

// ---- Hoelder exponents -----------------------------------------------------------------------------------

/// The closed forms below, from the radii over each piece's own parameter.
bool has_closed_form(const std::vector<RadiusPiece>& pieces) {
  constexpr std::size_t bent = 2;
  const std::vector<Rational> ends{0, Rational(1, 4), Rational(1, 2), 1};  // p at s = 1, 3/2, 2, 3
  bool holds = pieces.size() == ends.size() + 1;
  for (std::size_t i = 0; holds && i < pieces.size(); ++i) {
    const RadiusPiece& piece = pieces[i];
    holds = i == ends.size() || piece.range.upper == Algebraic(ends[i]);
    const Function s = Function(1) + Function(2) * piece.p;
    if (i < bent) {
      holds = holds && piece.radius == Function(2) - s;
    } else if (i == bent) {
      const Function root = Function(4) * piece.radius - (s - Function(1));
      holds = holds && is_nonnegative(root, piece.parameters) &&
              root * root == (s - Function(1)) * (Function(15) - Function(7) * s);
    } else {
      holds = holds && piece.radius ==
                           (i == bent + 1 ? (s - Function(1)) * fraction<Function>(1, 2) : s - Function(2));
    }
  }
  return holds;
}

/// The tap with the largest radius inside the piece 3/2 < s < 2: the radius rises before it and falls after.
Algebraic worst_tap(const RadiusPiece& piece) {
  const Function slope = piece.radius.derivative(0);
  std::vector<Algebraic> roots;
  append_real_roots(slope.numerator(), 0, roots);
  std::erase_if(roots, [&](const Algebraic& u) {
    return !piece.parameters.contains(u) || u == *piece.parameters.lower || u == *piece.parameters.upper;
  });
  if (roots.size() != 1) throw std::logic_error("the exponent has not one local minimum on (3/2, 2)");
  const bool rises = is_positive(slope, {piece.parameters.lower, roots[0], false, false});
  const bool falls = is_positive(-slope, {roots[0], piece.parameters.upper, false, false});
  if (!rises || !falls) throw std::logic_error("the critical exponent is no minimum");
  return specialize(piece.p, 0, roots[0]);
}

/// The whole numbers among the exponents that the general algorithm decides, and whether they are attained.
bool attainment_is_as_stated() {
  const std::vector<std::pair<Rational, Decision>> whole{{0, Decision::no},
                                                         {1, Decision::yes},
                                                         {Rational(3, 2), Decision::yes},
                                                         {2, Decision::yes},
                                                         {3, Decision::yes}};
  const bool whole_hold = std::ranges::all_of(whole, [](const auto& expected) {
    return smoothness_report(normal_form(jspline(expected.first))).limits.attained == expected.second;
  });
  // Elsewhere the polytopes of every piece have interior points, so that normalised products are bounded.
  const std::vector<RadiusPiece>& pieces = three_tap_radius_pieces();
  return whole_hold && std::ranges::none_of(pieces, [](const RadiusPiece& piece) {
           return find_flaw(piece.polytope, piece.parameters).has_value();
         });
}

void add_exponents(Results& results) {
  const std::vector<RadiusPiece>& pieces = three_tap_radius_pieces();
  constexpr std::size_t bent = 2;
  results.claims.push_back(settle_statement(
      claim("smooth.exponent.formula"), has_closed_form(pieces),
      "3-log2(2-s) for s < 3/2, 5 at 3/2, 3-log2(((s-1)+sqrt((s-1)(15-7s)))/4) for 3/2 < s <= 2, 4-log2(s-1) "
      "for 2 <= s <= 3, 3-log2(s-2) for s >= 3",
      "The maximising products are T_0 up to s = 3/2 and from s = 2 on, and T_0 T_1 between."));
  const Algebraic top = tap(Rational(3, 2));
  results.claims.push_back(settle(claim("smooth.exponent.maximum"),
                                  three_tap_exponent(smoothing_factors, top),
                                  "At s = 3/2 only, the quintic B-spline: towards it from either side the "
                                  "exponent tends to 4, its value at s = 2, which it exceeds nowhere else."));
  const Algebraic worst = worst_tap(pieces[bent]);
  const Algebraic worst_s = Algebraic(1) + Algebraic(2) * worst;
  const Enclosure least = three_tap_exponent(smoothing_factors, worst);
  const Smoothness again = smoothness(normal_form(jspline(worst_s)));
  require(again.exponent.lower <= least.upper && least.lower <= again.exponent.upper, "the local minimum");
  results.claims.push_back(settle(claim("smooth.exponent.minimum.s"), exact(worst_s)));
  results.claims.push_back(settle(claim("smooth.exponent.minimum"), least));
  results.claims.push_back(settle_statement(claim("smooth.exponent.attained"), attainment_is_as_stated(),
                                            "not at s = 0, everywhere else where it is decided",
                                            "At s = 0, the four-point scheme, f' has the modulus of "
                                            "continuity h log(1/h) and is not Lipschitz. The "
                                            "integers 1, 2 and 1 at s = -2, 4 and 6 are left open."));
}

// ---- Figures ---------------------------------------------------------------------------------------------

/// alpha(s) for lower < s < upper, the point 3/2 left out, and close to it on either side.
Series exponent_series(const std::string& name, const Rational& lower, const Rational& upper,
                       const Rational& step) {
  const Rational spline(3, 2);
  const Rational near(1, 1000);
  std::vector<Rational> places{spline - near, spline + near};
  for (Rational s = lower; s <= upper; s += step) {
    if (s != spline) places.push_back(s);
  }
  std::ranges::sort(places);
  Series series{name, {"s", "exponent"}, {}};
  for (const Rational& s : places) {
    const Enclosure exponent = three_tap_exponent(smoothing_factors, tap(s));
    series.rows.push_back({to_significant(s, digits), to_significant(exponent.midpoint(), digits)});
  }
  return series;
}

/// Horizontal bars: at the height m the s with C^m limits, exactly, as printed, and as the k-th power proves.
Series range_series() {
  const std::vector<int> powers{1, 5, 10, 20};
  const std::vector<std::pair<std::string, std::string>> printed{
      {"", ""}, {"-1.7", "5.8"}, {"0", "4"}, {"1", "2.8"}};
  Series series{"smooth-ranges", {"s", "exact", "printed"}, {}};
  for (const int k : powers) series.columns.push_back(fmt::format("k={}", k));
  const auto add_bar = [&](std::size_t column, const std::string& from, const std::string& to,
                           double height) {
    for (const std::string& s : {from, to, std::string()}) {
      std::vector<std::string> row(series.columns.size());
      row[0] = s;
      if (!s.empty()) row[column] = fmt::format("{:.2f}", height);
      series.rows.push_back(std::move(row));
    }
  };
  constexpr double gap = 0.11;
  for (int m = 0; m < smoothing_factors; ++m) {
    const auto [lower, upper] = exact_ends(m);
    add_bar(1, to_significant(lower, digits), to_significant(upper, digits), m);
    const auto& [from, to] = printed[static_cast<std::size_t>(m)];
    if (!from.empty()) add_bar(2, from, to, m - gap);
    NormRangeOptions options;
    options.interior = Rational(5, 4);
    options.max_power = powers.back();
    const std::vector<NormRange> ranges =
        iterate_norm_ranges(difference_family(jspline(Function::variable(0)), m), options);
    for (std::size_t i = 0; i < powers.size(); ++i) {
      const auto found = std::ranges::find(ranges, powers[i], &NormRange::power);
      if (found == ranges.end()) throw std::logic_error("no certified interval for a power");
      // Inner sides, rounded inwards: what is drawn is proved.
      add_bar(i + 3, to_significant(found->lower.value.upper, digits, found->lower.sharp ? 0 : 1),
              to_significant(found->upper.value.lower, digits, found->upper.sharp ? 0 : -1),
              m - gap * static_cast<double>(i + 2));
    }
  }
  return series;
}

void add_figures(Results& results) {
  results.series.push_back(
      exponent_series("smooth-exponent", Rational(-119, 20), Rational(199, 20), Rational(1, 20)));
  results.series.push_back(
      exponent_series("smooth-exponent-zoom", Rational(9, 10), Rational(31, 10), Rational(1, 100)));
  const Algebraic worst = worst_tap(three_tap_radius_pieces()[2]);
  const auto decimal = [](const Rational& x) { return to_significant(x, digits); };
  results.series.push_back(
      {"smooth-exponent-points",
       {"s", "exponent"},
       {{"1.5", decimal(three_tap_exponent(smoothing_factors, tap(Rational(3, 2))).midpoint())},
        {decimal((Algebraic(1) + Algebraic(2) * worst).to_interval().midpoint()),
         decimal(three_tap_exponent(smoothing_factors, worst).midpoint())}}});
  results.series.push_back(range_series());
  results.figures.push_back(
      {"smooth-exponent",
       "Hoelder exponent of *J_s, and ranges of s with C^m limits (bars at the height m)",
       "parameter s",
       "exponent, order m",
       {{"smooth-exponent", "s", "exponent", "exponent"},
        {"smooth-exponent-points", "s", "exponent", "", style::points(0, 0.5)},
        {"smooth-ranges", "s", "exact", "C^m exactly", style::in_colour(style::black, 4)},
        {"smooth-ranges", "s", "printed", "printed", style::marked(1, 0.3)},
        {"smooth-ranges", "s", "k=20", "power 20", style::marked(2, 0.3)},
        {"smooth-ranges", "s", "k=10", "power 10", style::marked(6, 0.3)},
        {"smooth-ranges", "s", "k=5", "power 5", style::marked(4, 0.3)},
        {"smooth-ranges", "s", "k=1", "power 1", style::marked(3, 0.3)}},
       "set xrange [-6.5:10.5]; set yrange [-0.8:5.3]; set xtics 2; set ytics 1",
       {"smooth.exact.", "smooth.sufficient.", "smooth.necessary.", "smooth.exponent."}});
  results.figures.push_back(
      {"smooth-exponent-zoom",
       "Hoelder exponent of *J_s about *J_{3/2}, the quintic B-spline; shapes of its extremal norm",
       "parameter s",
       "exponent",
       {{"smooth-exponent-zoom", "s", "exponent", "exponent"},
        {"smooth-exponent-points", "s", "exponent", "3/2, (11+√2)/7", style::points(1)}},
       "set xrange [0.9:3.1]; set yrange [2.6:5.2]; set xtics 0.5; set ytics 0.5; "
       "set object 1 rectangle from first 1.5, graph 0 to first 2, graph 1 fc rgb '#e4e4e4' fs solid "
       "noborder "
       "behind",
       {"smooth.exponent."},
       {{"diamond", 1.2, 2.75}, {"octagon", 1.75, 2.75}, {"hexagon", 2.55, 2.75}}});
}

}  // namespace

std::span<const ClaimHead> hoelder_exponent_heads() { return table; }

Results run_hoelder_exponents() {
  Results results;
  add_exponents(results);
  add_figures(results);
  return results;
}

}  // namespace subdiv
