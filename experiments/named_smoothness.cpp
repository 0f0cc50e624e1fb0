#include "experiments/named_smoothness.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/difference_family.h"
#include "analysis/hoelder.h"
#include "analysis/reif.h"
#include "analysis/three_tap_smoothness.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int smoothing_factors = 4;  // of the symbol of J_s, for all s

/// A curve of the documents. Steps before the repeating one change the control polygon only: the smoothness
/// is that of the limits of *J_s.
struct NamedCurve {
  const char* id;
  const char* document;
  const char* section;
  const char* printed;
  const char* curve;
  const char* s;  // of the repeating step
  int order;      // the continuity that is claimed
};

const std::vector<NamedCurve>& named_curves() {
  static const std::vector<NamedCurve> curves{
      {"smooth.named.four-point", "jsplines", "3 (js-report 3)", "*J0 is the C1 four-point curve", "*J_0",
       "0", 1},
      {"smooth.named.average", "jsplines", "3 (js-report 3)", "*J4/8 is the C2 curve of [Ros04]", "*J_{1/2}",
       "1/2", 2},
      {"smooth.named.cubic", "jsplines", "3 (js-report 3)", "*J8/8 is the C2 uniform cubic B-spline curve",
       "*J_1", "1", 2},
      {"smooth.named.quintic", "jsplines", "3 (js-report 3)",
       "*J12/8 is the C4 quintic uniform B-spline curve", "*J_{3/2}", "3/2", 4},
      {"smooth.named.b2", "jsplines", "4 (js-report 4)", "*J.689, which approximates it, is C2", "*J_{0.689}",
       "0.689", 2},
      {"smooth.named.b2.conclusion", "jsplines", "12",
       "We propose *J.69 as a C2 approximation of quadratic B-splines", "*J_{0.69}", "0.69", 2},
      {"smooth.named.b4", "jsplines", "4 (js-report 4)",
       "*J1.27 is a C3 curve that closely approximates the quartic B-spline curve", "*J_{1.27}", "1.27", 3},
      {"smooth.named.vertex.r", "jsplines", "6 (js-report 6)",
       "Jr, with r = –33/26, which, when followed by a series of J1.5 steps, produces to a C4 quintic "
       "B-spline "
       "curve",
       "{J_{-33/26}, *J_{3/2}}", "3/2", 4},
      {"smooth.named.vertex.ab", "jsplines", "12 (js-report 6)",
       "two subdivision schemes that generate C4 curves: {J–7/4, 59/52, *J1.5}", "{J_{-7/4,59/52}, *J_{3/2}}",
       "3/2", 4},
      {"smooth.named.edge.j1", "jsplines", "7 (js-report 7)",
       "the C2 curve produced using a Jr step with r=2/3 followed by a series of J1 steps", "{J_{2/3}, *J_1}",
       "1", 2},
      {"smooth.named.edge.s", "jsplines", "7 (js-report 7)", "the C2 *Js with s=0.751", "*J_{0.751}", "0.751",
       2},
      {"smooth.named.edge.r", "jsplines", "7 (js-report 7)",
       "the C4 curve produced using a Jr step, with r = 29/59, followed by a series of J1.5 steps",
       "{J_{29/59}, *J_{3/2}}", "3/2", 4},
      {"smooth.named.area.model-s", "jsplines", "8 (js-report 8)",
       "Adjusting s in *Js will typically produce a C2 curve", "*J_{0.476}", "0.476", 2},
      {"smooth.named.area.model-r", "jsplines", "8 (js-report 8)",
       "Adjusting r, or a and b, while keeping s=1.5 will produce a C4 curve", "{J_{a,b}, *J_{3/2}}", "3/2",
       4},
      {"smooth.named.area.rs.js-report", "js-report", "8", "J0.836 followed by *J-0.531 yields a C1 curve",
       "{J_{0.836}, *J_{-0.531}}", "-0.531", 1},
      {"smooth.named.area.rs.jsplines", "jsplines", "8", "{ J0.84, *J–0.53 }, which yields a C1 curve",
       "{J_{0.84}, *J_{-0.53}}", "-0.53", 1},
      {"smooth.named.area.exact.js-report", "js-report", "8",
       "a step of J-0.0053,1.0276 followed by *J0.4666, which produces a C2 curve",
       "{J_{-0.0053,1.0276}, *J_{0.4666}}", "0.4666", 2},
      {"smooth.named.area.exact.jsplines", "jsplines", "8",
       "{ J–0.0053,1.03, *J0.47 }, which produces a C2 curve", "{J_{-0.0053,1.03}, *J_{0.47}}", "0.47", 2},
  };
  return curves;
}

std::vector<ClaimHead> make_heads() {
  std::vector<ClaimHead> heads;
  for (const NamedCurve& named : named_curves()) {
    heads.push_back(
        {named.id, named.document, named.section, named.printed, ClaimKind::exact,
         fmt::format("The Hoelder exponent of the limits of *J_s, s = {}, the repeating step of {}.", named.s,
                     named.curve)});
  }
  heads.push_back(
      {"smooth.named.four-point.tension", "jsplines", "2 (js-report 2)",
       "The smoothness of the curves generated with this subdivision scheme is at most C1", ClaimKind::exact,
       "Four-point scheme (-w, 0, 1/2+w, 1, 1/2+w, 0, -w): are there C2 limits for some w? By the number of "
       "factors (1+z) of the symbol over Q(w), and by Reif's condition."});
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

/// The exponent by the general algorithm and by the closed form; std::logic_error when they disagree.
std::pair<Smoothness, Enclosure> smoothness_of(const Rational& s) {
  const Algebraic tap((s - Rational(1)) / Rational(2));
  const Smoothness general = smoothness_report(normal_form(jspline(s))).limits;
  Enclosure closed_form = three_tap_exponent(smoothing_factors, tap);
  const int order = three_tap_continuity(smoothing_factors, tap);
  const bool meet =
      general.exponent.lower <= closed_form.upper && closed_form.lower <= general.exponent.upper;
  if (!meet || general.continuity != order || general.continuity_limit != order) {
    throw std::logic_error("two routes to the smoothness of *J_s disagree at s = " + s.to_string());
  }
  return {general, std::move(closed_form)};
}

Claim settle_named(const NamedCurve& named) {
  const auto [general, exponent] = smoothness_of(Rational::parse(named.s));
  const std::string attained = general.attained == Decision::yes  ? "attained"
                               : general.attained == Decision::no ? "not attained"
                                                                  : "attained or not: open";
  constexpr int shown = 12;
  return settle_as(
      head(table(), named.id), general.continuity >= named.order ? Verdict::reproduced : Verdict::refuted,
      exponent,
      fmt::format("Limits are C{} and not C{}; Hoelder exponent {}{}, {}.", general.continuity,
                  general.continuity + 1, exponent.exact,
                  exponent.lower == exponent.upper ? "" : " = " + to_significant(exponent.midpoint(), shown),
                  attained));
}

/// C^2 limits of a scheme with independent shifts need three factors (1+z): the symbol has two, and four at
/// w = 1/16 only.
Claim settle_tension() {
  const Mask<RationalFunction> mask = four_point(RationalFunction::variable(0));
  constexpr int order = 2;
  bool none = normal_form(mask).factors == order && reif_set(mask, order).is_empty();
  for (const Algebraic& w : divisible_parameters(mask, order)) {
    none = none && smoothness(normal_form(four_point(w.to_rational()))).continuity_limit < order;
  }
  return settle_statement(
      head(table(), "smooth.named.four-point.tension"), none, none ? "true" : "false",
      "The symbol has a third factor 1+z at w = 1/16 only. There the exponent is 2 and not attained, so that "
      "limits are C1 and their first derivatives not even Lipschitz; elsewhere the scheme, which "
      "interpolates "
      "and so has independent shifts, lacks a sum rule that C2 limits need. Reif's condition for C2 holds "
      "for "
      "no w. C1 limits exist exactly for 0 < w < 0.1927 (smooth.four-point.c1).");
}

}  // namespace

std::span<const ClaimHead> named_smoothness_heads() { return table(); }

Results run_named_smoothness() {
  Results results;
  for (const NamedCurve& named : named_curves()) results.claims.push_back(settle_named(named));
  results.claims.push_back(settle_tension());
  return results;
}

}  // namespace subdiv
