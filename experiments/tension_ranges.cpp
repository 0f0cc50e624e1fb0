#include "experiments/tension_ranges.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/contraction_range.h"
#include "analysis/contraction_set.h"
#include "analysis/hoelder.h"
#include "analysis/transition_matrices.h"
#include "analysis/unstable_conditions.h"
#include "experiments/report/figure_style.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function w = Function::variable(0);
const std::string four_point_definition =
    "Four-point scheme (-w, 0, 1/2+w, 1, 1/2+w, 0, -w), for all control polygons: ";
const std::string dual_definition =
    "Dual four-point scheme, rule (-7w, 3/4+9w, 1/4+3w, -5w) and its mirror image (Dyn, Floater & Hormann "
    "2005), for all control polygons: ";

const std::string section = "jsplines 2";

const std::array table{
    finding("smooth.four-point.c1.lower", section,
            four_point_definition + "infimum of the w > 0 with C1 limits."),
    finding("smooth.four-point.c1.upper", section,
            four_point_definition + "end of the exact range of C1 limits."),
    finding("smooth.four-point.c0.upper", section,
            four_point_definition + "end of the w > 0 with continuous limits."),
    ClaimHead{"smooth.dfh.c2.range", "jsplines", "2 (js-report 2)",
              "their method generates C2 curves for a large range of parameter values", ClaimKind::exact,
              dual_definition + "the exact set of w with C2 limits."},
    finding("smooth.dfh.c2.upper", section, dual_definition + "end of the w > 0 with C2 limits."),
    finding("smooth.dfh.c1.upper", section, dual_definition + "end of the w > 0 with C1 limits."),
    finding("smooth.dfh.c2.single", section, dual_definition + "the w with C2 limits outside that interval."),
    finding("smooth.dfh.c2.single.exponent", section,
            dual_definition + "Hoelder exponent of the limits there."),
};

const ClaimHead& claim(const char* id) { return head(table, id); }

/// Transition matrices divided by 2^(n-1-m), so that C^m asks for a joint spectral radius below 1; T_1 = F
/// T_0 F for the reversal F, and (T_0 F)^2 = T_0 T_1.
struct Family {
  std::vector<Matrix<Function>> matrices;
  Matrix<Function> mirror;
  Matrix<Function> flipped;  // T_0 F
};

Family family(const Mask<Function>& mask, int order) {
  const NormalForm<Function> form = normal_form(mask);
  const Function scale(pow(Rational(2), order - (form.factors - 1)));
  Family result;
  for (const Matrix<Function>& t : transition_matrices(form)) {
    result.matrices.emplace_back(t.unaryExpr([&](const Function& f) { return f * scale; }));
  }
  result.mirror = reversal(result.matrices[0].rows());
  result.flipped = result.matrices[0] * result.mirror;
  return result;
}

struct ExactRange {
  RealInterval range;  // outside it the words 0 and 01 forbid C^m
  bool proved = false;
};

/// The interval with C^m limits as far as it lies above `from`: necessary by the words 0 and 01, and proved
/// by polytopes up to the very end.
ExactRange exact_range(const Mask<Function>& mask, int order, const std::optional<Rational>& from = {}) {
  const Family f = family(mask, order);
  const RealSet first = contraction_set(f.matrices[0]);
  const RealSet second = contraction_set(f.flipped);
  const RealSet both = intersection(first, second);
  if (both.parts.size() != 1 || !both.parts[0].lower || !both.parts[0].upper) {
    throw std::logic_error("the words 0 and 01 do not leave one bounded interval: " + both.to_string());
  }
  ExactRange result{both.parts[0]};
  RealInterval proved = result.range;
  if (from) proved.lower = Algebraic(*from);
  // The word that forbids C^m first is the one whose own set has the same upper end.
  const bool by_second = second.parts.back().upper == result.range.upper;
  const Matrix<Function>& leading = by_second ? f.flipped : f.matrices[0];
  result.proved = prove_contraction(f.matrices, leading, f.mirror, proved).has_value();
  return result;
}

Smoothness limits_of(const Mask<Rational>& mask) { return smoothness_report(normal_form(mask)).limits; }

/// The general algorithm just inside and outside of an end.
template <class Scheme>
void check_around(const Scheme& scheme, const Algebraic& end, int order) {
  const Rational middle = end.to_interval().midpoint();
  const Rational step(1, 20000);
  const bool inside = limits_of(scheme(middle - step)).continuity >= order;
  const bool outside = limits_of(scheme(middle + step)).continuity_limit < order;
  if (!inside || !outside) throw std::logic_error("two routes disagree at the end " + end.to_string());
}

template <class Scheme>
void add_upper_end(Results& results, const char* id, const Scheme& scheme, const ExactRange& range, int order,
                   const std::string& note) {
  if (!range.proved) throw std::logic_error(std::string(id) + ": no proof up to the end");
  check_around(scheme, *range.range.upper, order);
  results.claims.push_back(
      settle(claim(id), exact(*range.range.upper, "polytopes over Q(w) up to the end"), note));
}

void add_four_point(Results& results) {
  const auto scheme = [](const Rational& at) { return four_point(at); };
  const ExactRange c1 = exact_range(four_point(w), 1);
  results.claims.push_back(
      settle(claim("smooth.four-point.c1.lower"), exact(*c1.range.lower, "word 0"),
             "For w <= 0 a product has an eigenvalue of modulus 1 or more. The shifts of a basis function "
             "that interpolates are independent, so limits are no smoother than the scheme."));
  add_upper_end(results, "smooth.four-point.c1.upper", scheme, c1, 1,
                "The real root of 32w^3+4w-1 (Hechler, Moessner & Reif 2009): there the product of both "
                "matrices gets the eigenvalue 1. J_0 has w = 1/16.");
  add_upper_end(results, "smooth.four-point.c0.upper", scheme,
                exact_range(four_point(w), 0, Rational(1, 100)), 0,
                "Proved from w = 1/100 on; below that limits are C1.");
}

/// The w at which shifts of the dual scheme's basis function may be dependent.
std::vector<Algebraic> unstable_tensions() {
  std::vector<Algebraic> found;
  for (const UnstableCondition& c : unstable_conditions(normal_form(dyn_floater_hormann(w)).b)) {
    for (const Polynomial& equation : c.equations) append_real_roots(equation, 0, found);
  }
  return found;
}

void add_dual(Results& results) {
  const auto scheme = [](const Rational& at) { return dyn_floater_hormann(at); };
  constexpr int order = 2;
  const ExactRange c2 = exact_range(dyn_floater_hormann(w), order);
  std::vector<Rational> single;
  for (const Algebraic& at : unstable_tensions()) {
    const Rational tension = at.to_rational();
    if (!c2.range.contains(at) && limits_of(scheme(tension)).continuity >= order) single.push_back(tension);
  }
  if (single.size() != 1)
    throw std::logic_error("not one dual four-point scheme with dependent shifts is C2");
  const SmoothnessReport<Rational> report = smoothness_report(normal_form(scheme(single[0])));
  const RealSet interval{{c2.range}};
  results.claims.push_back(settle_statement(
      claim("smooth.dfh.c2.range"), c2.proved, interval.to_string() + " and " + single[0].to_string(),
      "The range 0 < w < 1/48 that Dyn, Floater & Hormann prove lies inside; up to 0.02146 their scheme is "
      "C2, and no further (smooth.dfh.c2.upper)."));
  add_upper_end(results, "smooth.dfh.c2.upper", scheme, c2, order,
                "A root of 327680w^4+25600w^3+352w^2+24w-1: there the product of both matrices gets the "
                "eigenvalue 1.");
  add_upper_end(results, "smooth.dfh.c1.upper", scheme,
                exact_range(dyn_floater_hormann(w), 1, Rational(1, 100)), 1,
                "Proved from w = 1/100 on; below that limits are C2.");
  results.claims.push_back(settle(
      claim("smooth.dfh.c2.single"), exact(single[0], "reduction of dependent shifts"),
      fmt::format("1-z+z^2 divides the symbol there: the shifts of the basis function are dependent, "
                  "and limits are those of another scheme. Third differences of the control points, "
                  "scaled by 4 at each level, grow nevertheless (joint spectral radius {}). -1/16, "
                  "the other w with dependent shifts, has no C2 limits, nor has w = 0, Chaikin's scheme.",
                  report.scheme.radius.value.exact)));
  results.claims.push_back(settle(claim("smooth.dfh.c2.single.exponent"), report.limits.exponent));
}

// ---- Figures ---------------------------------------------------------------------------------------------

template <class Scheme>
Series exponent_series(const std::string& name, const Scheme& scheme, int first, int last,
                       const Rational& step) {
  constexpr int digits = 12;
  JointSpectralRadiusBudget budget;
  budget.vertices = 400;  // what is not closed with these is enclosed well enough for a figure
  Series series{name, {"w", "exponent"}, {}};
  for (int i = first; i <= last; ++i) {
    const Rational at = step * Rational(i);
    const Enclosure exponent = smoothness(normal_form(scheme(at)), budget).exponent;
    series.rows.push_back({to_significant(at, digits), to_significant(exponent.midpoint(), digits)});
  }
  return series;
}

/// The midpoint of a claim that is settled already.
std::string value_of(const Results& results, const std::string& id) {
  const auto found = std::ranges::find_if(results.claims, [&](const Claim& c) { return c.head.id == id; });
  if (found == results.claims.end()) throw std::logic_error("no claim " + id);
  constexpr int digits = 12;
  return to_significant((found->lower.value() + found->upper.value()) / Rational(2), digits);
}

/// A vertical line at an exact limit, and the height that the exponent has there.
std::string limit_line(const std::string& at, int order) {
  return style::upright(at) + style::across(std::to_string(order));
}

FigureText limit_text(const std::string& at, int order, double height) {
  return {fmt::format("C^{} ends", order), Rational::parse(at).to_double(), height, "left offset 0.5,0"};
}

void add_figures(Results& results) {
  const auto tension = [](const Rational& at) { return four_point(at); };
  const auto dual = [](const Rational& at) { return dyn_floater_hormann(at); };
  // Steps that meet w = 1/16 and 3/8, and w = 1/128 and -1/28, where the exponents have corners.
  results.series.push_back(exponent_series("four-point-exponent", tension, -39, 39, Rational(1, 80)));
  results.series.push_back(exponent_series("dfh-exponent", dual, -36, 50, Rational(1, 896)));
  results.series.push_back(
      {"dfh-limits",
       {"w", "exponent"},
       {{value_of(results, "smooth.dfh.c2.single"), value_of(results, "smooth.dfh.c2.single.exponent")}}});
  const std::string four_point_end = value_of(results, "smooth.four-point.c1.upper");
  const std::string dual_c2_end = value_of(results, "smooth.dfh.c2.upper");
  const std::string dual_c1_end = value_of(results, "smooth.dfh.c1.upper");
  results.figures.push_back({"four-point-exponent",
                             "Hoelder exponent of the four-point scheme",
                             "tension w",
                             "Hoelder exponent",
                             {{"four-point-exponent", "w", "exponent", ""}},
                             limit_line(four_point_end, 1) + "set yrange [0:2.1]; set xtics 0.25",
                             {"smooth.four-point.", "smooth.named.four-point.tension"},
                             {limit_text(four_point_end, 1, 1.9)}});
  results.figures.push_back({"dfh-exponent",
                             "Hoelder exponent of the dual four-point scheme of Dyn, Floater & Hormann",
                             "tension w",
                             "Hoelder exponent",
                             {{"dfh-exponent", "w", "exponent", "scheme"},
                              {"dfh-limits", "w", "exponent", "its limits at w = -1/28", style::points(1)}},
                             limit_line(dual_c2_end, 2) + limit_line(dual_c1_end, 1) +
                                 "set xrange [-0.045:0.075]; set yrange [0.8:3]; set xtics 0.02",
                             {"smooth.dfh."},
                             {limit_text(dual_c2_end, 2, 2.85), limit_text(dual_c1_end, 1, 2.85)}});
}

}  // namespace

std::span<const ClaimHead> tension_range_heads() { return table; }

Results run_tension_ranges() {
  Results results;
  add_four_point(results);
  add_dual(results);
  add_figures(results);
  return results;
}

}  // namespace subdiv
