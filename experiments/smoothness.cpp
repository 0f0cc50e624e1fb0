#include "experiments/smoothness.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/eigenvalues.h"
#include "analysis/iterate_norm.h"
#include "analysis/iterate_norm_range.h"
#include "analysis/reif.h"
#include "analysis/subdivision_matrix.h"
#include "experiments/report/figure_style.h"
#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::string reif_definition =
    "Reif's condition: the spectrum begins 1, 1/2, .., (1/2)^m, each present, and all other eigenvalues are "
    "strictly below "
    "(1/2)^m in modulus. Exact set of s for m = ";
const std::string norm_definition =
    "Some k has norm_k < 1: the maximum over residues modulo 2^k of the sums of absolute coefficients of the "
    "k-th iterate of "
    "2^m S(z) / (1+z)^(m+1), proved for all s up to the printed end. m = ";
const std::string first_definition = "The least k with norm_k < 1 at ";

const std::array table{
    ClaimHead{"smooth.eigenvalues", "jsplines", "3 (js-report 3)",
              "1, 1/2, 1/4, 1/8, (2-s)/8, (s-1)/16, (s-1)/16, 0, 0", ClaimKind::exact,
              "Factored characteristic polynomial over Q(s) of the vertex-centred 9 x 9 subdivision matrix."},
    ClaimHead{"smooth.necessary.c1.lower", "jsplines", "3 (js-report 3)", "-2", ClaimKind::exact,
              reif_definition + "1."},
    ClaimHead{"smooth.necessary.c1.upper", "jsplines", "3 (js-report 3)", "6", ClaimKind::exact,
              reif_definition + "1."},
    ClaimHead{"smooth.necessary.c2.lower", "jsplines", "3 (js-report 3)", "0", ClaimKind::exact,
              reif_definition + "2."},
    ClaimHead{"smooth.necessary.c2.upper", "jsplines", "3 (js-report 3)", "4", ClaimKind::exact,
              reif_definition + "2."},
    ClaimHead{"smooth.necessary.c3.lower", "jsplines", "3 (js-report 3)", "1", ClaimKind::exact,
              reif_definition + "3."},
    ClaimHead{"smooth.necessary.c3.upper", "jsplines", "3 (js-report 3)", "3", ClaimKind::exact,
              reif_definition + "3."},
    ClaimHead{"smooth.necessary.c4", "jsplines", "3 (js-report 3)", "3/2", ClaimKind::exact,
              reif_definition + "4: a single point."},
    ClaimHead{"smooth.sufficient.c1.lower", "jsplines", "3 (js-report 3)", "-1.7", ClaimKind::bound,
              norm_definition + "1."},
    ClaimHead{"smooth.sufficient.c1.upper", "jsplines", "3 (js-report 3)", "5.8", ClaimKind::bound,
              norm_definition + "1."},
    ClaimHead{"smooth.sufficient.c2.lower", "jsplines", "3 (js-report 3)", "0", ClaimKind::exact,
              norm_definition + "2."},
    ClaimHead{"smooth.sufficient.c2.upper", "jsplines", "3 (js-report 3)", "4", ClaimKind::exact,
              norm_definition + "2."},
    ClaimHead{"smooth.sufficient.c3.lower", "jsplines", "3 (js-report 3)", "1", ClaimKind::exact,
              norm_definition + "3."},
    ClaimHead{"smooth.sufficient.c3.upper", "jsplines", "3 (js-report 3)", "2.8", ClaimKind::bound,
              norm_definition + "3."},
    ClaimHead{"smooth.sufficient.c4", "jsplines", "3 (js-report 3)", "3/2", ClaimKind::exact,
              "The only s at which (1+z)^5 divides S(z), with norm_k < 1 for some k there. m = 4."},
    ClaimHead{"smooth.first-power.c1.lower", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              first_definition + "s = -1.7 for m = 1."},
    ClaimHead{"smooth.first-power.c1.upper", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              first_definition + "s = 5.8 for m = 1."},
    ClaimHead{"smooth.first-power.c3.upper", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              first_definition + "s = 2.8 for m = 3."},
    ClaimHead{"smooth.one-power.c1.lower", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              "Lower end of the interval on which norm_20 < 1, m = 1."},
    ClaimHead{"smooth.one-power.c1.upper", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              "Upper end of the interval on which norm_20 < 1, m = 1."},
    ClaimHead{"smooth.one-power.c3.upper", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              "Upper end of the interval on which norm_20 < 1, m = 3."},
    ClaimHead{"smooth.abstract.c2", "js-report", "abstract", "C2 curve for 0<s<1", ClaimKind::exact,
              "norm_k < 1 for m = 2, some k and all 0 < s < 1."},
    ClaimHead{"smooth.abstract.c3", "js-report", "abstract", "C3 curve for 1<=s<3/2", ClaimKind::exact,
              "Does Reif's necessary condition for m = 3 hold for all 1 <= s < 3/2?"},
    ClaimHead{"smooth.abstract.c4", "js-report", "abstract", "C4 curve for s=3/2", ClaimKind::exact,
              "Equality of the Laurent polynomials of J_{3/2} and the quintic B-spline."},
};

using Function = RationalFunction;

constexpr int largest_power = 20;
constexpr int digits = 15;
const Function s = Function::variable(0);
const std::vector<std::string> name_s{"s"};

void add_eigenvalues(Results& results) {
  const ParametricSpectrum spectrum =
      eigenvalues(subdivision_matrix(jspline(s), vertex_window(jspline(s), 1)));
  const std::vector<std::pair<Function, int>> printed{
      {Function(1), 1},
      {fraction<Function>(1, 2), 1},
      {fraction<Function>(1, 4), 1},
      {fraction<Function>(1, 8), 1},
      {(Function(2) - s) / Function(8), 1},
      {(s - Function(1)) / Function(16), 2},
      {Function(0), 2},
  };
  const bool same = spectrum.factors.empty() &&
                    std::ranges::is_permutation(spectrum.values, printed, [](const auto& x, const auto& y) {
                      return x.first == y.first && x.second == y.second;
                    });
  results.claims.push_back(
      settle_statement(head(table, "smooth.eigenvalues"), same, to_string(spectrum, name_s)));
}

/// The ends of a set that must be one open interval (or one point).
const RealInterval& only_part(const RealSet& set) {
  if (set.parts.size() != 1 || !set.parts[0].lower || !set.parts[0].upper) {
    throw std::logic_error("Reif's condition does not hold on one bounded interval: " + set.to_string());
  }
  return set.parts[0];
}

void add_necessary(Results& results) {
  const std::string method = "exact eigenvalues over Q(s)";
  for (int order = 1; order <= 3; ++order) {
    const RealSet set = reif_set(jspline(s), order);
    const RealInterval& part = only_part(set);
    const std::string id = fmt::format("smooth.necessary.c{}", order);
    const std::string note = "Exact set: " + set.to_string() + ".";
    results.claims.push_back(settle(head(table, id + ".lower"), exact(*part.lower, method), note));
    results.claims.push_back(settle(head(table, id + ".upper"), exact(*part.upper, method), note));
  }
  const RealSet fourth = reif_set(jspline(s), 4);
  const RealInterval& point = only_part(fourth);
  if (!point.is_point()) throw std::logic_error("Reif's condition for C^4 holds on more than a point");
  results.claims.push_back(
      settle(head(table, "smooth.necessary.c4"), exact(*point.lower, method),
             "At s = 2 the eigenvalue 1/16 is double, so that point does not belong to the set."));
}

/// The certified intervals against k for C^1 .. C^3, interior point 5/4, and their series.
std::vector<NormRange> norm_ranges(int continuity) {
  NormRangeOptions options;
  options.interior = Rational(5, 4);
  options.max_power = largest_power;
  return iterate_norm_ranges(difference_family(jspline(s), continuity), options);
}

const NormRange& range_of(const std::vector<NormRange>& ranges, int power) {
  const auto found = std::ranges::find(ranges, power, &NormRange::power);
  if (found == ranges.end()) throw std::logic_error(fmt::format("no certified interval for k = {}", power));
  return *found;
}

Laurent<Rational> difference_symbol_at(const Rational& at, int continuity) {
  const auto symbol = difference_symbol(jspline(at), continuity);
  if (!symbol) throw std::logic_error("the symbol lacks factors (1+z)");
  return *symbol;
}

/// The least k with norm_k < 1 at a rational s, by exact norms.
int first_power(const Rational& at, int continuity) {
  const std::vector<Rational> norms = iterate_norms(difference_symbol_at(at, continuity), 2, largest_power);
  const auto below = std::ranges::find_if(norms, [](const Rational& norm) { return norm < Rational(1); });
  if (below == norms.end()) throw std::logic_error("no norm below 1 at s = " + at.to_string());
  return static_cast<int>(below - norms.begin());
}

/// A printed end that some k certifies: the end of that k's interval, and what other powers give.
void add_certified_end(Results& results, const std::vector<NormRange>& ranges, int continuity, bool is_lower,
                       const Rational& printed) {
  const std::string side = is_lower ? "lower" : "upper";
  const int power = first_power(printed, continuity);
  const auto end = [&](int k) -> const Enclosure& {
    const NormRange& range = range_of(ranges, k);
    return is_lower ? range.lower.value : range.upper.value;
  };
  const auto shown = [&](int k) { return to_significant(end(k).midpoint(), 7); };
  std::string note = fmt::format(
      "k = {} is the first power that reaches it, with the interval's end at {}; k = {} stops at {}, "
      "k = {} reaches {}.",
      power, shown(power), power - 1, shown(power - 1), largest_power, shown(largest_power));
  results.claims.push_back(
      settle_bound(head(table, fmt::format("smooth.sufficient.c{}.{}", continuity, side)),
                   is_lower ? BoundSide::at_most : BoundSide::at_least, end(power), note));
  results.claims.push_back(settle(head(table, fmt::format("smooth.first-power.c{}.{}", continuity, side)),
                                  exact(Rational(power), "exact norms of iterates at the printed end")));
  results.claims.push_back(
      settle(head(table, fmt::format("smooth.one-power.c{}.{}", continuity, side)), end(largest_power)));
}

/// An open end that is reached: norm_k < 1 is proved right up to it.
void add_sharp_end(Results& results, const NormRange& range, int continuity, bool is_lower) {
  const RangeEnd& end = is_lower ? range.lower : range.upper;
  const ClaimHead& claim =
      head(table, fmt::format("smooth.sufficient.c{}.{}", continuity, is_lower ? "lower" : "upper"));
  const std::string note =
      fmt::format("norm_{} < 1 is proved right up to the end, where it is at least 1.", range.power);
  if (end.sharp) {
    results.claims.push_back(settle(claim, end.value, note));
  } else {
    results.claims.push_back(
        settle_as(claim, Verdict::undecided, end.value, "The end is enclosed, not proved to be reached."));
  }
}

void add_fourth(Results& results) {
  const std::vector<Algebraic> divisible = divisible_parameters(jspline(s), 4);
  const bool single = divisible.size() == 1 && divisible[0].is_rational();
  if (!single) throw std::logic_error("(1+z)^5 divides S(z) at other than one rational s");
  const Rational at = divisible[0].to_rational();
  const int power = first_power(at, 4);
  results.claims.push_back(settle(head(table, "smooth.sufficient.c4"), exact(at, "exact division"),
                                  fmt::format("norm_{} < 1 there.", power)));
}

void add_ranges(Results& results) {
  std::map<int, std::vector<NormRange>> ranges;
  for (int c = 1; c <= 3; ++c) ranges[c] = norm_ranges(c);
  add_certified_end(results, ranges[1], 1, true, Rational(-17, 10));
  add_certified_end(results, ranges[1], 1, false, Rational(58, 10));
  add_sharp_end(results, range_of(ranges[2], 1), 2, true);
  add_sharp_end(results, range_of(ranges[2], 1), 2, false);
  add_sharp_end(results, range_of(ranges[3], 1), 3, true);
  // The lower end of C^3 is not an end of its own series: only the upper one is printed as a rounded bound.
  add_certified_end(results, ranges[3], 3, false, Rational(28, 10));
  add_fourth(results);

  const NormRange& second = range_of(ranges[2], 1);
  const bool abstract_c2 = second.lower.sharp && second.lower.value.upper <= Rational(0) &&
                           second.contains(Rational(1)) && second.contains(Rational(1, 2));
  results.claims.push_back(settle_statement(head(table, "smooth.abstract.c2"), abstract_c2, "true",
                                            "C2 holds on the larger range 0 < s < 4, and on no larger one "
                                            "(smooth.exact.c2.lower, smooth.exact.c2.upper)."));

  Series series{"certified-interval",
                {"k", "C1 lower", "C1 upper", "C2 lower", "C2 upper", "C3 lower", "C3 upper"},
                {}};
  for (int k = 1; k <= largest_power; ++k) {
    std::vector<std::string> row{std::to_string(k)};
    for (int c = 1; c <= 3; ++c) {
      const NormRange& range = range_of(ranges[c], k);
      // Inner sides, rounded inwards: what is printed is proved.
      row.push_back(to_significant(range.lower.value.upper, digits, range.lower.sharp ? 0 : 1));
      row.push_back(to_significant(range.upper.value.lower, digits, range.upper.sharp ? 0 : -1));
    }
    series.rows.push_back(std::move(row));
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(
      {"certified-interval",
       "Intervals of s (between two lines) on which the k-th power proves that *J_s is C^m",
       "power k",
       "parameter s",
       {{"certified-interval", "k", "C1 lower", "C^1", style::marked(0)},
        {"certified-interval", "k", "C1 upper", "", style::marked(0)},
        {"certified-interval", "k", "C2 lower", "C^2", style::marked(1)},
        {"certified-interval", "k", "C2 upper", "", style::marked(1)},
        {"certified-interval", "k", "C3 lower", "C^3", style::marked(2)},
        {"certified-interval", "k", "C3 upper", "", style::marked(2)}},
       "set yrange [-2.5:6.5]; set ytics 1",
       {"smooth.sufficient.", "smooth.first-power.", "smooth.one-power."}});
}

/// norm_k against k at the ends that the papers print.
void add_norms(Results& results) {
  const std::vector<std::pair<std::string, std::pair<Rational, int>>> curves{
      {"C1 s=-1.7", {Rational(-17, 10), 1}},
      {"C1 s=-1.9", {Rational(-19, 10), 1}},
      {"C1 s=5.8", {Rational(58, 10), 1}},
      {"C3 s=2.8", {Rational(28, 10), 3}},
      {"C3 s=2.95", {Rational(295, 100), 3}}};
  Series series{"norm-of-powers", {"k"}, {}};
  Figure figure{"norm-of-powers",
                "Norm of the k-th power of the difference scheme of *J_s: below 1 it proves C^m",
                "power k",
                "norm",
                {},
                "set logscale y\n" + style::across("1"),
                {"smooth.sufficient."}};
  for (const auto& [label, where] : curves) {
    series.columns.push_back(label);
    figure.curves.push_back({series.name, "k", label,
                             fmt::format("C^{}, s = {}", where.second, to_decimal(where.first, 2)),
                             style::marked(figure.curves.size())});
  }
  for (int k = 1; k <= largest_power; ++k) {
    std::vector<std::string> row{std::to_string(k)};
    for (const auto& [label, where] : curves) {
      const Enclosure norm = iterate_norm_enclosure(difference_symbol_at(where.first, where.second), 2, k);
      constexpr int certain_digits = 12;
      row.push_back(to_significant(norm.midpoint(), certain_digits));
    }
    series.rows.push_back(std::move(row));
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
}

void add_abstract(Results& results) {
  const RealSet third = reif_set(jspline(s), 3);
  const bool cubic = jspline(Rational(1)) == bspline<Rational>(3);
  const bool holds = third.contains(Algebraic(1));
  results.claims.push_back(settle_statement(
      head(table, "smooth.abstract.c3"), holds, "s = 1: " + std::string(holds ? "holds" : "fails"),
      std::string(cubic ? "*J_1 is the cubic B-spline, which is C2 and not C3: " : "") +
          "Reif's necessary condition for C3 holds exactly on " + third.to_string() +
          ", so that s = 1 does not belong to the C3 range; section 3 of the same report says so (1 < s)."));
  const bool quintic = jspline(Rational(3, 2)) == bspline<Rational>(5);
  results.claims.push_back(
      settle_statement(head(table, "smooth.abstract.c4"), quintic, quintic ? "true" : "false"));
}

}  // namespace

std::span<const ClaimHead> smoothness_heads() { return table; }

Results run_smoothness() {
  Results results;
  add_eigenvalues(results);
  add_necessary(results);
  add_ranges(results);
  add_norms(results);
  add_abstract(results);
  return results;
}

}  // namespace subdiv
