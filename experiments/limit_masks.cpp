#include "experiments/limit_masks.h"

#include <array>

#include <fmt/format.h>

#include "analysis/limit_mask.h"
#include "analysis/open_ends.h"
#include "analysis/retrofit.h"
#include "experiments/report/figure_style.h"
#include "schemes/algebra/univariate.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::string left_eigenvector =
    "Left eigenvector of the subdivision matrix of J_s, over Q(s), for the eigenvalue ";
const std::string radius =
    "The iteration P <- P + (C - L P) converges for all bounded data exactly when the spectral radius of I - "
    "L over the "
    "infinite matrix, the maximum of |1 - L(e^{iw})| over all w, is below 1. ";

const std::array table{
    ClaimHead{"limit.mask", "jsplines", "5 (js-report 5)",
              "{(s-1)s, 2s(8-s), 72+2(s-9)s, 2s(8-s), (s-1)s}/(12(6+s))", ClaimKind::exact,
              left_eigenvector + "1, sum 1."},
    ClaimHead{"limit.mask.quintic", "jsplines", "6", "1/120, 13/60, 11/20, 13/60, 1/120", ClaimKind::exact,
              "The limit mask at s = 3/2."},
    ClaimHead{"tangent.mask", "jsplines", "9 (js-report 11)", "{1-s, 2(s-4), 0, -2(s-4), -(1-s)}/12",
              ClaimKind::exact,
              left_eigenvector + "1/2, normalised to d/dt at unit spacing of control points."},
    ClaimHead{"open.clamped.p-1", "jsplines", "9 (js-report 11)", "(9-s)/4 P0 + (s-3)/2 P1 + (1-s)/4 P2",
              ClaimKind::exact,
              "The added point P(-1) for which the limit starts at P0 with the tangent P1 - P0, for all s."},
    ClaimHead{"open.clamped.p-2", "jsplines", "9 (js-report 11)", "(12-s)/2 P0 + (s-8) P1 + (6-s)/2 P2",
              ClaimKind::exact,
              "The added point P(-2) for which the limit starts at P0 with the tangent P1 - P0, for all s."},
    ClaimHead{"open.reflected", "jsplines", "9", "P(-1) = 2 P0 - P1, P(-2) = 2 P0 - P2", ClaimKind::exact,
              "With these added points the limit mask at P0 gives P0, for all s."},
    ClaimHead{"open.spans", "jsplines", "9 (js-report 11)", "2 points added at each end, 5 spans dropped",
              ClaimKind::exact,
              "The reach of limit and tangent masks beyond P0, and the spans of the closed loop that touch "
              "added points."},
    ClaimHead{"open.opposite.js-report", "js-report", "11",
              "the masks for the opposite end of the curve are identical", ClaimKind::exact,
              "The clamping masks of the last control points, in the order of the indices, against those of "
              "the first."},
    ClaimHead{"open.opposite.jsplines", "jsplines", "9",
              "the masks for the opposite end of the curve are mirror images", ClaimKind::exact,
              "The clamping masks of the last control points, in the order of the indices, against those of "
              "the first."},
    ClaimHead{"retrofit.range.lower", "jsplines", "5 (js-report 5)", "-0.86", ClaimKind::rounded,
              radius + "Lower end of the range of s."},
    ClaimHead{"retrofit.range.lower.exact", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              radius + "Lower end of the range of s, in closed form."},
    ClaimHead{"retrofit.range.upper", "jsplines", "5 (js-report 5)", "2", ClaimKind::exact,
              radius + "Upper end of the range of s."},
    ClaimHead{"retrofit.finite", "jsplines", "5",
              "the iterative retrofitting will diverge for these values of s", ClaimKind::exact,
              "On a closed loop of n points only the frequencies 2 pi k / n occur: does the iteration "
              "diverge for every n outside "
              "the infinite range?"},
    ClaimHead{
        "retrofit.finite.even", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
        "The range of s for closed loops of every even number n >= 4 of points. It contains that of the "
        "infinite matrix and "
        "lies in that of the frequencies 0 and pi; every such n has a frequency in [pi/3, pi/2] and one in "
        "[pi/2, 2 pi/3]."},
    ClaimHead{"retrofit.finite.n3", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "The range of s for closed loops of 3 points."},
    ClaimHead{"retrofit.finite.n5", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "The range of s for closed loops of 5 points."},
    ClaimHead{"retrofit.finite.n7", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "The range of s for closed loops of 7 points."},
    ClaimHead{"retrofit.singular.even", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "Values of s at which the direct solve L P = C is singular for loops of 4 points."},
    ClaimHead{"retrofit.singular.n3", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "Values of s at which the direct solve L P = C is singular for loops of 3 points."},
    ClaimHead{"retrofit.singular.n5", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "Values of s at which the direct solve L P = C is singular for loops of 5 points."},
    ClaimHead{"retrofit.singular.n7", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
              "Values of s at which the direct solve L P = C is singular for loops of 7 points."},
};

using Function = RationalFunction;

const std::vector<std::string> name_s{"s"};
const Function s = Function::variable(0);

std::string mask_text(const Laurent<Function>& mask) {
  std::string text;
  for (int j = mask.first(); j <= mask.last(); ++j) {
    text += (text.empty() ? "{" : ", ") + mask[j].to_factored_string(name_s);
  }
  return text + "}";
}

/// "(9-s)/4 P0 + ..": a combination of control points as text.
std::string combination_text(const Laurent<Function>& weights) {
  std::string text;
  for (int j = weights.first(); j <= weights.last(); ++j) {
    text += fmt::format("{}({}) P{}", text.empty() ? "" : " + ", weights[j].to_factored_string(name_s), j);
  }
  return text;
}

Claim equality(const std::string& id, bool holds, std::string found, std::string note = "") {
  return settle_statement(head(table, id), holds, std::move(found), std::move(note));
}

void add_masks(Results& results, const Laurent<Function>& limit, const Laurent<Function>& tangent) {
  const Function scale = Function(1) / (Function(12) * (Function(6) + s));
  const Function outer = (s - Function(1)) * s * scale;
  const Function inner = Function(2) * s * (Function(8) - s) * scale;
  const Function centre = (Function(72) + Function(2) * (s - Function(9)) * s) * scale;
  const Laurent<Function> printed_limit(-2, {outer, inner, centre, inner, outer});
  results.claims.push_back(equality("limit.mask", limit == printed_limit, mask_text(limit)));

  const Laurent<Rational> quintic = limit_mask(jspline(Rational(3, 2)));
  const Laurent<Rational> printed_quintic(
      -2, {Rational(1, 120), Rational(13, 60), Rational(11, 20), Rational(13, 60), Rational(1, 120)});
  const auto as_function = [](const Rational& q) { return Function(q); };
  results.claims.push_back(equality("limit.mask.quintic", quintic == printed_quintic,
                                    mask_text(map_coefficients(quintic, as_function))));

  const Function twelfth = fraction<Function>(1, 12);
  const Function far = (Function(1) - s) * twelfth;
  const Function near = Function(2) * (s - Function(4)) * twelfth;
  const Laurent<Function> printed_tangent(-2, {far, near, Function(0), -near, -far});
  results.claims.push_back(equality("tangent.mask", tangent == printed_tangent, mask_text(tangent)));
}

void add_open_ends(Results& results, const Laurent<Function>& limit, const Laurent<Function>& tangent) {
  const std::vector<Laurent<Function>> start = clamped_end(limit, tangent);
  const Laurent<Function> printed_1(
      0, {(Function(9) - s) / Function(4), (s - Function(3)) / Function(2), (Function(1) - s) / Function(4)});
  const Laurent<Function> printed_2(
      0, {(Function(12) - s) / Function(2), s - Function(8), (Function(6) - s) / Function(2)});
  results.claims.push_back(
      equality("open.clamped.p-1", start.at(0) == printed_1, combination_text(start.at(0))));
  results.claims.push_back(
      equality("open.clamped.p-2", start.at(1) == printed_2, combination_text(start.at(1)),
               "At s = 0 and s = 1 the masks reach less far, and these points are one choice of several."));

  const Laurent<Function> first_point = apply_at_end(limit, reflected_end<Function>(2));
  results.claims.push_back(equality("open.reflected", first_point == Laurent<Function>(1),
                                    "limit point: " + combination_text(first_point)));

  const int added = -limit.first();
  const int spans = dropped_spans(added);
  results.claims.push_back(
      equality("open.spans", added == 2 && spans == 5,
               fmt::format("{} points added at each end, {} spans dropped", added, spans)));

  // The other end, written in increasing order of the indices: weights of P(n-3), P(n-2), P(n-1).
  const std::vector<Laurent<Function>> end = clamped_end(mirrored(limit, 0), mirrored(tangent, 1));
  const bool same_counted_from_the_end = end == start;
  const bool same_in_index_order = start.at(0).coefficients() == reverse(start.at(0)).coefficients();
  results.claims.push_back(equality("open.opposite.js-report", same_in_index_order,
                                    "P(n) = " + combination_text(reverse(start.at(0))) +
                                        ", P0 standing for P(n-1), P-1 for P(n-2), P-2 for P(n-3)",
                                    "The masks of the two ends are mirror images of each other; they are "
                                    "identical only if the points of the second end are "
                                    "counted backwards from the last one."));
  results.claims.push_back(
      equality("open.opposite.jsplines", same_counted_from_the_end && !same_in_index_order, "mirror images"));
}

/// "-0.866, 2.10": the irrational ends of a set as decimals, for readers.
std::string decimals(const RealSet& set) {
  constexpr int digits = 12;
  std::string text;
  for (const RealInterval& part : set.parts) {
    for (const auto& end : {part.lower, part.upper}) {
      if (!end || end->is_rational()) continue;
      text += (text.empty() ? "" : ", ") + to_significant(end->to_interval().midpoint(), digits);
    }
  }
  return text.empty() ? "" : "In decimals: " + text + ".";
}

std::string list_text(const std::vector<Algebraic>& values) {
  std::string text;
  for (const Algebraic& x : values) text += (text.empty() ? "" : ", ") + x.to_string();
  return text.empty() ? "none" : text;
}

/// f <= 0 on [lower, upper], with zeros at the ends at most.
bool is_nonpositive(const Function& f, const Rational& lower, const Rational& upper) {
  const UnivariatePolynomial sign((f.numerator() * f.denominator()), 0);
  for (const RealRoot& root : real_roots(sign)) {
    if (Algebraic(lower) < root.value && root.value < Algebraic(upper)) return false;
  }
  return sign.evaluate((lower + upper) / Rational(2)).sign() < 0;
}

/// Even loops of n >= 4 points converge nowhere but in the infinite range: the frequencies 0 and pi alone
/// leave that range and one more interval (9/2, x), x < 21/2, on which L(e^{iw}) <= 0 for all cos w in [-1/2,
/// 0] up to s = 8, and for all cos w in [0, 1/2] from there on: L is a convex quadratic in cos w there, so
/// the ends decide.
bool even_loops_have_infinite_range(const Laurent<Function>& limit, const RealSet& infinite) {
  const RealSet two = retrofit_range_of_loops(limit, 2);
  const Rational from(9, 2);
  const Rational middle(8);
  const Rational to(21, 2);
  if (two.parts.size() != 2 || RealSet{{two.parts[0]}}.to_string() != infinite.to_string()) return false;
  if (*two.parts[1].lower < Algebraic(from) || *two.parts[1].upper > Algebraic(to)) return false;
  const auto at_cosine = [&](const Function& c) { return symbol_at_cosine(limit, c); };
  const Function half = fraction<Function>(1, 2);
  const bool convex = limit.last() == 2 && is_nonpositive(-limit[2], from, to);
  return convex && is_nonpositive(at_cosine(Function(0)), from, to) &&
         is_nonpositive(at_cosine(-half), from, middle) && is_nonpositive(at_cosine(half), middle, to);
}

void add_retrofit_ranges(Results& results, const Laurent<Function>& limit) {
  const RealSet infinite = retrofit_range(limit);
  const bool one_interval = infinite.parts.size() == 1 && infinite.parts[0].lower && infinite.parts[0].upper;
  if (!one_interval) throw std::logic_error("the retrofit range is no single bounded interval");
  const Enclosure lower = exact(*infinite.parts[0].lower, "exact spectral radius over Q(s)");
  const Enclosure upper = exact(*infinite.parts[0].upper, "exact spectral radius over Q(s)");
  results.claims.push_back(
      settle(head(table, "retrofit.range.lower"), lower,
             "The lower end is " + lower.exact + " = " + to_significant(lower.lower, 10) +
                 "..., which rounds to -0.87; at s = -0.86 the iteration still converges."));
  results.claims.push_back(settle(head(table, "retrofit.range.lower.exact"), lower));
  results.claims.push_back(settle(head(table, "retrofit.range.upper"), upper));

  const std::string infinite_text = infinite.to_string();
  bool wider = false;
  for (const int n : {3, 5, 7}) {
    const RealSet range = retrofit_range_of_loops(limit, n);
    const std::string text = range.to_string();
    wider = wider || text != infinite_text;
    results.claims.push_back(equality(fmt::format("retrofit.finite.n{}", n), true, text, decimals(range)));
    results.claims.push_back(
        equality(fmt::format("retrofit.singular.n{}", n), true, list_text(singular_for_loops(limit, n))));
  }
  results.claims.push_back(
      equality("retrofit.finite", !wider, wider ? "false for odd n" : "true",
               "The iteration converges on closed loops of 3, 5 and 7 points for values of s outside " +
                   infinite_text +
                   " (see retrofit.finite.n3, retrofit.finite.n5 and retrofit.finite.n7): an odd loop lacks "
                   "the frequency pi. The papers' own "
                   "example of a retrofitted "
                   "triangle is such a loop. For even loops the infinite range is exact."));
  results.claims.push_back(
      equality("retrofit.finite.even", even_loops_have_infinite_range(limit, infinite), infinite_text,
               "Loops of 2 points converge for " + retrofit_range_of_loops(limit, 2).to_string() + "."));
  results.claims.push_back(equality("retrofit.singular.even", true, list_text(singular_for_loops(limit, 4))));
}

/// The rate at which retrofitting converges, for the infinite matrix and small odd loops.
void add_rates(Results& results) {
  constexpr int digits = 15;
  Series series{"retrofit-rate", {"s", "infinite", "n=3", "n=5", "n=7"}, {}};
  for (int i = -20; i <= 50; ++i) {
    const Rational at(i, 20);
    const Laurent<Rational> mask = limit_mask(jspline(at));
    std::vector<std::string> row{to_significant(at, digits)};
    const auto cell = [](const Algebraic& x) { return to_significant(x.to_interval().midpoint(), digits); };
    row.push_back(cell(contraction_rate(mask)));
    for (const int n : {3, 5, 7}) row.push_back(cell(contraction_rate_of_loops(mask, n)));
    series.rows.push_back(std::move(row));
  }
  results.series.push_back(std::move(series));
  results.figures.push_back({"retrofit-rate",
                             "Factor by which one retrofitting step for *J_s reduces the error",
                             "parameter s",
                             "factor of a step",
                             {{"retrofit-rate", "s", "infinite", "infinite, even"},
                              {"retrofit-rate", "s", "n=3", "loop of 3"},
                              {"retrofit-rate", "s", "n=5", "loop of 5"},
                              {"retrofit-rate", "s", "n=7", "loop of 7"}},
                             "set yrange [0:1.4]; " + style::across("1"),
                             {"retrofit."}});
}

}  // namespace

std::span<const ClaimHead> limit_mask_heads() { return table; }

Results run_limit_masks() {
  Results results;
  const Mask<Function> mask = jspline(s);
  const Laurent<Function> limit = limit_mask(mask);
  const Laurent<Function> tangent = tangent_mask(mask);
  add_masks(results, limit, tangent);
  add_open_ends(results, limit, tangent);
  add_retrofit_ranges(results, limit);
  add_rates(results);
  return results;
}

}  // namespace subdiv
