#include "experiments/basis_fit.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/basis_function.h"
#include "analysis/bspline_distance.h"
#include "analysis/uniform_bspline.h"
#include "experiments/report/figure_style.h"
#include "optimize/objectives.h"
#include "schemes/algebra/univariate.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int digits = 15;
const Range fit_range{Rational(-17, 10), Rational(58, 10)};

/// A target of section 4 (or 9), and what the documents print of its fits.
struct Target {
  std::string name;  // in claim ids
  int degree;
  std::string text;
  std::string document;
  std::string section;
  std::optional<std::string> l1;
  std::optional<std::string> linf;
};

const std::array targets{
    Target{"b2", 2, "the quadratic B-spline", "jsplines", "4 (js-report 4)", ".689", ".639"},
    Target{"b4", 4, "the quartic B-spline", "jsplines", "4 (js-report 4)", "1.27", "1.27"},
    Target{"linear", 1, "the hat function", "js-report", "9", ".304763", ".152773"},
};

const std::array norms{Norm::l1, Norm::linf, Norm::l2};

std::string claim_id(const Target& target, Norm norm, bool continuum) {
  return fmt::format("fit.{}.{}{}", target.name, to_string(norm), continuum ? ".continuum" : "");
}

std::vector<ClaimHead> make_heads() {
  std::vector<ClaimHead> heads;
  for (const Target& target : targets) {
    for (const Norm norm : norms) {
      const std::optional<std::string> printed = norm == Norm::l1     ? target.l1
                                                 : norm == Norm::linf ? target.linf
                                                                      : std::nullopt;
      const std::string name = to_string(norm);
      heads.push_back(
          {claim_id(target, norm, false), printed ? target.document : "subdivlab",
           printed ? target.section : target.document + " " + target.section, printed, ClaimKind::rounded,
           fmt::format(
               "s in [-1.7, 5.8] that minimises the {} distance of the 1531 coefficients of the level-8 "
               "iterate of S(z), coefficient i at (i - 765)/256, from {} there.",
               name, target.text)});
      heads.push_back(
          {claim_id(target, norm, true), "subdivlab", target.document + " " + target.section, std::nullopt,
           ClaimKind::rounded,
           fmt::format("s in [-1.7, 5.8] that minimises the {} distance of the limit function phi_s from {} "
                       "over the real line.",
                       name, target.text)});
    }
  }
  heads.push_back({"fit.samples", "jsplines", "4", "1531", ClaimKind::exact,
                   "The number of coefficients of the level-8 iterate of S(z)."});
  heads.push_back(
      {"fit.l2.polynomial", "jsplines", "4 (js-report 4)", "the resulting optimization problem is polynomial",
       ClaimKind::exact,
       "The sum of the squared differences of those coefficients from the quadratic B-spline, as a "
       "function of s: its denominator and its degree."});
  heads.push_back(
      {"fit.b2.edge-bound", "jsplines", "4", "never exceeds a fifth of the maximum edge length",
       ClaimKind::bound,
       "The largest distance, at equal parameters, between the curves that *J_.689 and B2 make of "
       "one control polygon, in units of its longest edge, over all control polygons."});
  heads.push_back({"fit.b2.edge-bound.sharp", "subdivlab", "jsplines 4", std::nullopt, ClaimKind::rounded,
                   "The least constant for which that bound holds: the supremum over t of the sum of "
                   "|coefficients| when the difference is written as a combination of edges."});
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

Scheme<RationalFunction> family() {
  return stationary<RationalFunction>("*J", jspline(RationalFunction::variable(0)));
}

Summary fit(const Target& target, Norm norm, bool continuum) {
  Objective objective;
  objective.kind = Objective::Kind::fit_bspline;
  objective.degree = target.degree;
  constexpr int printed_level = 8;
  objective.level = continuum ? 0 : printed_level;
  objective.continuum = continuum;
  return minimise(family(), objective, norm, {fit_range}, {"s"});
}

/// Settled by the minimiser when the minimum is proved; undecided otherwise.
Claim settle_fit(const std::string& id, const Summary& summary, const std::string& note) {
  if (summary.minimiser.empty()) throw std::logic_error("no minimiser for " + id + ": " + summary.message);
  Enclosure minimiser = summary.minimiser[0];
  if (summary.termination != Termination::proved) {
    minimiser.rigour = Rigour::approximate;
    return settle_as(head(table(), id), Verdict::undecided, minimiser, summary.message);
  }
  return settle(head(table(), id), minimiser, note);
}

/// What a reader of a printed optimum should know of the limit function's own.
std::string continuum_note(const std::optional<std::string>& printed, const Summary& continuum) {
  if (continuum.minimiser.empty()) return "";
  const Rational own = continuum.minimiser[0].midpoint();
  std::string note = fmt::format("The limit function's own optimum is {}.", to_significant(own, 10));
  if (printed && abs(own - printed_value(*printed)) > printed_tolerance(*printed)) {
    note += fmt::format(
        " The printed digits are those of the level-8 iterate: a document that compared the limit functions "
        "would print {} instead of {}.",
        to_significant(own, static_cast<int>(printed->size()) - 1), *printed);
  }
  return note;
}

void add_fits(Results& results, const Target& target) {
  for (const Norm norm : norms) {
    const Summary discrete = fit(target, norm, false);
    const Summary continuum = fit(target, norm, true);
    const ClaimHead& of_iterate = head(table(), claim_id(target, norm, false));
    results.claims.push_back(
        settle_fit(of_iterate.id, discrete, continuum_note(of_iterate.printed, continuum)));
    const std::string least =
        fmt::format("The {} there is {}.", norm == Norm::l2 ? "squared distance" : "distance",
                    to_significant(continuum.minimum.midpoint(), 10));
    results.claims.push_back(settle_fit(claim_id(target, norm, true), continuum, least));
  }
}

void add_samples(Results& results) {
  const Objective objective = parse_objective("fit-bspline:degree=2");
  const Problem problem = make_problem(family(), objective, Norm::l2, {fit_range}, {"s"});
  results.claims.push_back(settle(head(table(), "fit.samples"),
                                  exact(Rational(static_cast<std::int64_t>(problem.residuals.size())))));
  RationalFunction squares;
  for (const RationalFunction& r : problem.residuals) squares += r * r;
  const bool is_polynomial = squares.denominator().is_constant();
  const UnivariatePolynomial sum(squares.numerator(), 0);
  const int critical = count_roots(sum.derivative(), fit_range.lower, fit_range.upper);
  results.claims.push_back(settle_statement(
      head(table(), "fit.l2.polynomial"), is_polynomial,
      fmt::format("a polynomial of degree {}", sum.degree()),
      fmt::format("Critical points in [-1.7, 5.8]: {}. For the limit functions the problem is rational: the "
                  "inner products have a denominator of degree 4.",
                  critical)));
}

void add_edge_bound(Results& results) {
  const Rational printed(1, 5);
  const Enclosure bound = bspline_edge_bound(Rational::parse("0.689"), 2);
  const Verdict verdict = bound.upper <= printed  ? Verdict::reproduced
                          : bound.lower > printed ? Verdict::refuted
                                                  : Verdict::undecided;
  results.claims.push_back(settle_as(
      head(table(), "fit.b2.edge-bound"), verdict, bound,
      fmt::format("True, and far from sharp, as the document suspects: the least constant is {}, {} "
                  "times smaller.",
                  to_significant(bound.midpoint(), 8), to_significant(printed / bound.midpoint(), 3))));
  results.claims.push_back(
      settle(head(table(), "fit.b2.edge-bound.sharp"), bound,
             "Collinear edges of equal length, directed by the signs of the coefficients, "
             "attain it."));
}

/// phi_s for the fitted s beside the B-spline, and their difference, at multiples of 1/32.
void add_curves(Results& results, const std::string& name, const Rational& s, int degree,
                const std::string& label) {
  constexpr int level = 5;
  const Laurent<Rational> values = basis_values(stationary<Rational>("*J", jspline(s)), level);
  const UniformBspline target(degree);
  Series series{name, {"t", "phi", "target", "difference"}, {}};
  constexpr int unit = 1 << level;
  for (int i = -3 * unit; i <= 3 * unit; ++i) {
    const Rational t(i, unit);
    const Rational b = target.value(t);
    series.rows.push_back({to_significant(t, digits), to_significant(values[i], digits),
                           to_significant(b, digits), to_significant(values[i] - b, digits)});
  }
  results.series.push_back(std::move(series));
  results.figures.push_back({name,
                             fmt::format("Basis function of {} and the B-spline of degree {}", label, degree),
                             "parameter t (in spans of the curve)",
                             "weight of the control point",
                             {{name, "t", "target", fmt::format("B_{}", degree), style::target},
                              {name, "t", "phi", label, style::curve(0, 1.5)},
                              {name, "t", "difference", "difference", style::curve(1, 1.5)}},
                             "",
                             {fmt::format("fit.{}.", degree == 1 ? "linear" : fmt::format("b{}", degree))}});
}

/// The objectives of the documents at one s, divided so that they approach norms over the line: (sum of
/// |differences|)/256 and the largest |difference|.
std::pair<Rational, Rational> objectives_at(const Rational& s, int degree) {
  constexpr int level = 8;
  const Laurent<Rational> iterate = iterated_symbol(stationary<Rational>("*J", jspline(s)), level);
  const UniformBspline target(degree);
  const Rational spacing = Rational::power_of_two(-level);
  Rational l1;
  Rational linf;
  for (int i = iterate.first(); i <= iterate.last(); ++i) {
    const Rational difference = abs(iterate[i] - target.value(Rational(i) * spacing));
    l1 += difference * spacing;
    linf = std::max(linf, difference);
  }
  return {l1, linf};
}

/// The objectives for B2 against s, with their minima marked.
void add_objectives(Results& results, const Claim& best_l1, const Claim& best_linf) {
  const auto row_at = [&](const Rational& s) {
    const auto [l1, linf] = objectives_at(s, 2);
    return std::vector<std::string>{to_significant(s, digits), to_significant(l1, digits),
                                    to_significant(linf, digits)};
  };
  Series series{"fit-b2-objective", {"s", "l1", "linf"}, {}};
  constexpr int steps = 56;
  for (int i = 0; i <= steps; ++i) series.rows.push_back(row_at(Rational(3, 10) + Rational(i, 80)));
  const auto at_minimum = [&](const Claim& c) {
    const Rational middle = (c.lower.value() + c.upper.value()) / Rational(2);
    return row_at(Rational::parse(to_significant(middle, digits)));
  };
  const std::vector<std::string> left = at_minimum(best_l1);
  const std::vector<std::string> right = at_minimum(best_linf);
  results.series.push_back(std::move(series));
  results.series.push_back({"fit-b2-optimum-l1", {"s", "l1"}, {{left[0], left[1]}}});
  results.series.push_back({"fit-b2-optimum-linf", {"s", "linf"}, {{right[0], right[2]}}});
  results.figures.push_back({"fit-b2-objective",
                             "How far *J_s (level 8) is from the quadratic B-spline; points: the optima",
                             "parameter s",
                             "distance of weights",
                             {{"fit-b2-objective", "s", "l1", "L^1 (area between)"},
                              {"fit-b2-objective", "s", "linf", "L^{∞} (largest)"},
                              {"fit-b2-optimum-l1", "s", "l1", "", style::points(0)},
                              {"fit-b2-optimum-linf", "s", "linf", "", style::points(1)}},
                             "",
                             {"fit.b2."}});
}

const Claim& settled(const Results& results, const std::string& id) {
  for (const Claim& claim : results.claims) {
    if (claim.head.id == id) return claim;
  }
  throw std::logic_error("no claim " + id);
}

}  // namespace

std::span<const ClaimHead> basis_fit_heads() { return table(); }

Results run_basis_fit() {
  Results results;
  for (const Target& target : targets) add_fits(results, target);
  add_samples(results);
  add_edge_bound(results);
  add_curves(results, "fit-b2", Rational::parse("0.689"), 2, "*J_.689");
  add_curves(results, "fit-b4", Rational::parse("1.27"), 4, "*J_1.27");
  add_curves(results, "fit-linear", Rational::parse("0.304763"), 1, "*J_.304763");
  add_objectives(results, settled(results, "fit.b2.l1"), settled(results, "fit.b2.linf"));
  return results;
}

}  // namespace subdiv
