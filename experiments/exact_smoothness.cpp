#include "experiments/exact_smoothness.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/contraction_set.h"
#include "analysis/hoelder.h"
#include "analysis/reif.h"
#include "analysis/three_tap_smoothness.h"
#include "analysis/unstable_conditions.h"
#include "optimize/popping_schedule.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

constexpr int smoothing_factors = 4;  // of the symbol of J_s, for all s
constexpr int highest_order = 4;      // of continuity, reached at one s

const std::string exact_definition =
    "The exact set of s for which the limits of *J_s are C^m for all control polygons: rho(s) < 2^(3-m), rho "
    "the joint spectral radius of the two transition matrices of (s-1)/2 + (2-s) z + (s-1)/2 z^2. m = ";
const std::string mixed_definition =
    "The open interval every compact part K of which is mixed: whatever s in K each level takes, the limits "
    "are C^m. One norm in which both transition matrices stay below 2^(3-m) for all s in K proves it. m = ";

std::vector<ClaimHead> make_heads() {
  std::vector<ClaimHead> heads;
  const auto printed = [&](const char* id, const char* section, const char* text, const std::string& what) {
    heads.push_back({id, "jsplines", section, text, ClaimKind::exact, what});
  };
  const auto found = [&](const std::string& id, const char* section, const std::string& definition) {
    heads.push_back(finding(id, section, definition));
  };
  printed(
      "smooth.conjecture", "3 (js-report 3)",
      "we strongly suspect that the true sufficient bounds extend to match the necessary bounds for "
      "continuity in the limit",
      "Is the exact set of s with C^m limits, from the joint spectral radius, the set of Reif's necessary "
      "condition, for m = 1 .. 4? Both over Q(s), for all s at once.");
  const std::string list = "Is the printed set a part of the exact one?";
  printed("smooth.list.c1", "3 (js-report 3)", "for –1.7 ≤ s < 0 and 4 ≤ s ≤ 5.8, *Js is C1", list);
  printed("smooth.list.c2", "3 (js-report 3)", "for 0 < s ≤ 1 and 2.8 < s < 4, *Js is C2", list);
  printed("smooth.list.c3", "3 (js-report 3)", "for 1 < s < 3/2 and 3/2 < s ≤ 2.8, *Js is C3", list);
  for (int m = 0; m < highest_order; ++m) {
    for (const char* side : {"lower", "upper"}) {
      found(fmt::format("smooth.exact.c{}.{}", m, side), "jsplines 3",
            exact_definition + std::to_string(m) + ".");
    }
  }
  found("smooth.exact.c4", "jsplines 3", exact_definition + "4: the only point.");
  found("smooth.unstable", "jsplines 3",
        "All s at which the integer shifts of the basis function are linearly dependent, so that limits can "
        "be smoother than differences of control points tell.");
  for (int m = 0; m < highest_order; ++m) {
    found(fmt::format("smooth.mixed.c{}", m), "jsplines 11", mixed_definition + std::to_string(m) + ".");
  }
  printed(
      "popping.schedule.c2", "11", "we strongly suspect that the smoothness of the curve is at least C2",
      "The largest norm of a transition matrix over all s in [1/5, 1/2], which holds every s_k of the "
      "schedule, in the norm whose unit ball is conv +-{(1,0), (0,1), (1,1)}: below 2 the limits are C2.");
  found("popping.schedule.exponent", "jsplines 11",
        "A Hoelder exponent that the limits of the schedule have: 3 - log2 of the growth of the products of "
        "that norm over the levels.");
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

const ClaimHead& claim(const std::string& id) { return head(table(), id); }

void require(bool agree, const std::string& what) {
  if (!agree) throw std::logic_error("two routes disagree: " + what);
}

Algebraic tap(const Rational& s) { return Algebraic((s - Rational(1)) / Rational(2)); }

/// The set of s = 1 + 2p for a set of taps p.
RealSet in_s(RealSet set) {
  const auto parameter = [](const Algebraic& p) { return Algebraic(1) + Algebraic(2) * p; };
  for (RealInterval& part : set.parts) {
    if (part.lower) part.lower = parameter(*part.lower);
    if (part.upper) part.upper = parameter(*part.upper);
  }
  return set;
}

RealSet exact_set(int order) { return in_s(three_tap_continuity_set(smoothing_factors, order)); }

const RealInterval& only_part(const RealSet& set) {
  const bool bounded = set.parts.size() == 1 && set.parts[0].lower && set.parts[0].upper;
  if (!bounded) throw std::logic_error("C^m does not hold on one bounded interval: " + set.to_string());
  return set.parts[0];
}

bool same(const RealSet& a, const RealSet& b) {
  return std::ranges::equal(a.parts, b.parts, [](const RealInterval& x, const RealInterval& y) {
    return x.lower == y.lower && x.upper == y.upper && x.lower_closed == y.lower_closed &&
           x.upper_closed == y.upper_closed;
  });
}

/// The general algorithm, which knows nothing of closed forms, just inside and outside of an exact end.
void check_around(const Rational& end, int order) {
  for (const Rational& s : {end - Rational(1, 100), end + Rational(1, 100)}) {
    const Smoothness found = smoothness(normal_form(jspline(s)));
    const bool inside = exact_set(order).contains(Algebraic(s));
    require(inside ? found.continuity >= order : found.continuity_limit < order,
            fmt::format("C^{} at s = {}", order, s.to_string()));
  }
}

// ---- Exact ranges ----------------------------------------------------------------------------------------

void add_conjecture(Results& results) {
  bool equal = true;
  std::string text;
  for (int m = 1; m <= highest_order; ++m) {
    equal = equal && same(exact_set(m), reif_set(jspline(Function::variable(0)), m));
    text += fmt::format("{}C{} {}", m == 1 ? "" : ", ", m, exact_set(m).to_string());
  }
  results.claims.push_back(settle_statement(
      claim("smooth.conjecture"), equal, text,
      "The conjecture is true, with both ends of every range excluded. The differences of the third divided "
      "differences are refined by two 2 x 2 matrices; the hexagon conv +-{(1,0), (0,1), (1,1)} is the unit "
      "ball of a norm in which both are at most 2-s (s <= 1), (3-s)/2, (s-1)/2 (2 <= s <= 3) and s-2 (s >= "
      "3). "
      "These numbers are below 4, 2 and 1 exactly for -2 < s < 6, 0 < s < 4 and 1 < s < 3, so that one step "
      "in this norm proves what powers in the maximum norm approach only. For s <= 1 and s >= 2 they are the "
      "joint spectral radius itself; on [1, 3/2] a diamond and on [3/2, 2] an octagon give it. The shifts of "
      "the basis function are dependent at s = 2 and s = 3 only, where limits are combinations of B-splines "
      "of degree 4 and 3: the ranges hold for the scheme and for its limits alike."));
}

RealSet open_or_closed(const Rational& lower, const Rational& upper, bool lower_closed, bool upper_closed) {
  return {{RealInterval{Algebraic(lower), Algebraic(upper), lower_closed, upper_closed}}};
}

bool is_part(const RealSet& small, const RealSet& large) { return same(intersection(small, large), small); }

void add_list(Results& results) {
  const Rational half3(3, 2);
  const Rational c3_end(14, 5);
  const bool c1 = is_part(open_or_closed(Rational(-17, 10), 0, true, false), exact_set(1)) &&
                  is_part(open_or_closed(4, Rational(29, 5), true, true), exact_set(1));
  const bool c2 = is_part(open_or_closed(0, 1, false, true), exact_set(2)) &&
                  is_part(open_or_closed(c3_end, 4, false, false), exact_set(2));
  const bool c3 = is_part(open_or_closed(1, half3, false, false), exact_set(3)) &&
                  is_part(open_or_closed(half3, c3_end, false, true), exact_set(3));
  const auto text = [](bool holds) { return std::string(holds ? "true" : "false"); };
  results.claims.push_back(
      settle_statement(claim("smooth.list.c1"), c1, text(c1),
                       "The list leaves out s = 0, the four-point scheme, which is C1."));
  results.claims.push_back(
      settle_statement(claim("smooth.list.c2"), c2, text(c2), "For 2.8 < s < 3 the limits are C3 as well."));
  results.claims.push_back(settle_statement(claim("smooth.list.c3"), c3, text(c3)));
}

void add_exact_ranges(Results& results) {
  const std::string method = "joint spectral radius in closed form";
  for (int m = 0; m < highest_order; ++m) {
    const RealSet set = exact_set(m);
    const RealInterval& part = only_part(set);
    const std::string note = "Exact set: " + set.to_string() + ".";
    const std::string id = fmt::format("smooth.exact.c{}", m);
    results.claims.push_back(settle(claim(id + ".lower"), exact(*part.lower, method), note));
    results.claims.push_back(settle(claim(id + ".upper"), exact(*part.upper, method), note));
    check_around(part.lower->to_rational(), m);
    check_around(part.upper->to_rational(), m);
  }
  const RealSet fourth = exact_set(highest_order);
  require(only_part(fourth).is_point(), "C^4 holds at one s");
  results.claims.push_back(settle(claim("smooth.exact.c4"), exact(*only_part(fourth).lower, method),
                                  "The quintic B-spline. At s = 2, the only other s with the exponent 4, "
                                  "third derivatives are Lipschitz continuous and not differentiable."));
}

// ---- Dependent shifts
// --------------------------------------------------------------------------------------

void add_unstable(Results& results) {
  std::vector<Algebraic> found;
  for (const UnstableCondition& c : unstable_conditions(normal_form(jspline(Function::variable(0))).b)) {
    for (const Polynomial& equation : c.equations) append_real_roots(equation, 0, found);
  }
  bool alike = true;
  for (const Algebraic& s : found) {
    const SmoothnessReport<Rational> report = smoothness_report(normal_form(jspline(s.to_rational())));
    alike = alike && report.reduction.independent == Decision::no &&
            report.scheme.exponent.exact == report.limits.exponent.exact &&
            report.reduction.form.b == Laurent<Rational>(1);
  }
  const bool two_and_three = found == std::vector<Algebraic>{2, 3};
  results.claims.push_back(settle_statement(claim("smooth.unstable"), two_and_three && alike, "s = 2, s = 3",
                                            "The basis function is (B_4(x-1/2) + B_4(x+1/2))/2 at s = 2 and "
                                            "(B_3(x-1) + B_3(x) + B_3(x+1))/3 at s = "
                                            "3, B_d the uniform B-spline of degree d; the exponents 4 and 3 "
                                            "of the limits are those of the scheme."));
}

// ---- Sequences of different s ----------------------------------------------------------------------------

/// The hexagon's norm is a convex function of s, because the matrices are affine in s: where it takes the
/// bound at both ends and less between, it is below the bound exactly in the open interval.
void add_mixed(Results& results) {
  for (int m = 0; m < highest_order; ++m) {
    const RealSet set = exact_set(m);
    const Rational lower = only_part(set).lower->to_rational();
    const Rational upper = only_part(set).upper->to_rational();
    const auto norm = [](const Rational& a, const Rational& b) {
      return three_tap_common_norm(tap(a).to_rational(), tap(b).to_rational());
    };
    const Rational bound = pow(Rational(2), highest_order - 1 - m);
    const Rational middle = (lower + upper) / Rational(2);
    const bool holds =
        norm(lower, lower) == bound && norm(upper, upper) == bound && norm(middle, middle) < bound;
    results.claims.push_back(settle_statement(
        claim(fmt::format("smooth.mixed.c{}", m)), holds, set.to_string(),
        fmt::format("The same range as for one s: the hexagon's norm is below {0} exactly there. If it is at "
                    "most c on K, differences of the divided differences of order {1} fall like max(1/2, "
                    "c/{0})^k, up to a power of k, so that those of order 0 .. {1} converge uniformly.",
                    bound.to_string(), m)));
  }
}

void add_schedule(Results& results) {
  const Rational first = popping_schedule(1)[0].parameter.lower;
  const Rational limit = popping_limit().upper;
  const Rational norm = three_tap_common_norm(tap(first).to_rational(), tap(limit).to_rational());
  const bool contracts = norm < Rational(2);
  results.claims.push_back(settle_as(
      claim("popping.schedule.c2"), contracts ? Verdict::reproduced : Verdict::undecided,
      exact(norm, "polytope for all s"),
      "Proved. s_k rises from 1/5 to its limit 1/2, and for every s in [1/5, 1/2] both transition matrices "
      "are at most 9/5 < 2 in one and the same norm, so that the differences of the second divided "
      "differences fall at least like (9/10)^k: second derivatives are continuous. Smoothness of each single "
      "s_k would not do for that, but this holds for any order of s from a closed part of (0, 4)."));
  results.claims.push_back(
      settle(claim("popping.schedule.exponent"), three_tap_exponent(smoothing_factors, tap(limit)),
             "Third differences grow at most like the product of 2 - s_j, and that by a bounded factor more "
             "than (3/2)^k, because 1/2 - s_k <= (3/10) (3/4)^(k-1) has a finite sum: second derivatives are "
             "Hoelder continuous of the order 1 - log2(3/2) = 0.415."));
}

}  // namespace

std::span<const ClaimHead> exact_smoothness_heads() { return table(); }

Results run_exact_smoothness() {
  Results results;
  add_conjecture(results);
  add_list(results);
  add_exact_ranges(results);
  add_unstable(results);
  add_mixed(results);
  add_schedule(results);
  return results;
}

}  // namespace subdiv
