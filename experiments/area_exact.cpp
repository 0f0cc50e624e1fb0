#include <algorithm>

#include <fmt/format.h>

#include "experiments/area.h"
#include "experiments/area_schemes.h"
#include "optimize/common_form.h"
#include "optimize/local_model.h"
#include "optimize/unbounded_bound.h"
#include "schemes/algebra/common_zeros.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

// Parameters of {J_{a,b}, *J_s} in the order of the variables.
constexpr int s_variable = 2;
const std::vector<std::string> names{"a", "b", "s"};
const Range s_range{Rational(-2), Rational(6)};

const ClaimHead& head_of(const std::string& id) { return head(area_heads(), id); }

struct Family {
  std::vector<Function> residuals;  // r_1 .. r_5 at 0 .. 4; r_1 = -(2 r_2 + 3 r_3 + 4 r_4 + 5 r_5)
  CommonForm form;                  // r_k = numerator / denominator, the denominator a polynomial in s
};

Family family() {
  Family result;
  const Scheme<Function> scheme =
      anticipated_jspline(Function::variable(0), Function::variable(1), Function::variable(s_variable));
  result.residuals = area_residuals(scheme);
  const Range any{Rational(-1), Rational(1)};
  result.form = common_form({result.residuals, Norm::linf, {any, any, s_range}, names});
  return result;
}

Claim undecided(const ClaimHead& head, const std::string& note) {
  Claim claim;
  claim.head = head;
  claim.note = note;
  return claim;
}

/// The documents' "exactly".
Claim existence(const Family& f) {
  const ClaimHead& exists = head_of("area.exact.exists");
  const EmptinessProof proof = prove_empty({f.form.numerators, {f.form.denominator}}, names);
  if (!proof.proved) return undecided(exists, "The elimination did not come to an end.");
  const auto cases = std::ranges::count_if(
      proof.cases, [](const std::string& line) { return line.find("no common zero") != std::string::npos; });
  return settle_statement(
      exists, false, "no solution",
      fmt::format("No a, b, s preserve the area of all polygons, not even complex ones: m_5 = {}, and where "
                  "a factor of it "
                  "vanishes elimination leaves polynomials without a common zero ({} cases in all, in exact "
                  "arithmetic). The printed "
                  "parameters leave the area mask off by the amounts of area.exact.residual.js-report and "
                  "area.exact.residual.jsplines; area.exact.residual is the least that is possible.",
                  f.residuals[4].to_factored_string(names), cases));
}

/// The point where -r_1 = -r_2 = -r_3 = r_5 > |r_4|: four residuals attain the maximum, as many as parameters
/// and one.
struct Vertex {
  CompiledModel model;
  CriticalPoint point;
  Interval value;
};

std::optional<Vertex> find_vertex(const Family& f) {
  constexpr long precision = 256;
  const Function& r5 = f.residuals[4];
  LocalModel model{r5, {}, 3};
  for (const int k : {1, 2, 3}) {
    model.kinks.push_back({-f.residuals[static_cast<std::size_t>(k - 1)] - r5, KinkKind::maximum});
  }
  const CompiledModel compiled(model, precision);
  // Newton's iteration starts from the parameters that js-report prints.
  const auto point = compiled.critical_point({-0.0053, 1.0276, 0.4666});
  if (!point) return std::nullopt;
  const Interval value = compiled.base_value(point->x);
  const Interval fourth = TaylorFunction(f.residuals[3], 3, precision).over(point->x).value;
  if (!certainly_less(abs(fourth), value)) return std::nullopt;
  return Vertex{compiled, *point, value};
}

/// p with a = a0 + x_0, b = b0 + x_1.
Polynomial about(const Polynomial& p, const Rational& a0, const Rational& b0) {
  return p.substitute(0, Polynomial::variable(0) + Polynomial(a0))
      .substitute(1, Polynomial::variable(1) + Polynomial(b0));
}

/// Is the vertex the only point, over all real a and b and s in its range, where no |r_k| exceeds its value?
/// With a level above that value: some |r_k| exceeds the level for all a and b when s is not in a narrow
/// strip, and when (a, b) is not in a small box for s in the strip; r_2, r_3, r_4 determine (a, b, s) so well
/// in that box that the points below the level lie in a smaller one; there the vertex is the only minimum.
bool is_least_everywhere(const Family& f, const Vertex& vertex) {
  const Rational strip(1, 1000000);
  const Rational level = vertex.value.upper() * Rational(3, 2);
  std::vector<Rational> centre;
  for (const Interval& x : vertex.point.x) centre.push_back(Rational::from_double(x.to_double()));
  UnboundedProblem problem;
  for (std::size_t k = 1; k < 5; ++k)
    problem.functions.push_back(about(f.form.numerators[k], centre[0], centre[1]));
  constexpr long precision = 160;
  const UnboundedBound bound(problem, precision);
  const Polynomial& q = f.form.denominator;
  constexpr int most_intervals = 20000;
  const Range side{centre[2] - strip, centre[2] + strip};
  const Range any{Rational(-1), Rational(1)};
  if (!is_positive_on(q, {any, any, s_range}, precision, most_intervals)) return false;
  if (!exceeds(bound, q, s_variable, level, s_range.lower, side.lower, most_intervals).proved) return false;
  if (!exceeds(bound, q, s_variable, level, side.upper, s_range.upper, most_intervals).proved) return false;

  const Rational largest_q =
      UnivariatePolynomial(q, s_variable).evaluate(Interval::hull(side.lower, side.upper)).upper();
  const auto radii = bound.radii(side.lower, side.upper, level * largest_q);
  if (!radii) return false;
  Vector<Interval> box(3);
  for (int j = 0; j < 2; ++j) {
    const auto i = static_cast<std::size_t>(j);
    box(j) = Interval::hull(centre[i] - (*radii)[i], centre[i] + (*radii)[i], 2 * precision);
  }
  box(2) = Interval::hull(side.lower, side.upper, 2 * precision);
  const std::vector<Function> middle(f.residuals.begin() + 1, f.residuals.begin() + 4);
  const auto inverse = inverse_bounds(square_system(middle, 2 * precision), box);
  if (!inverse) return false;
  Box neighbourhood;
  for (std::size_t j = 0; j < 3; ++j) {
    const Interval& x = vertex.point.x[j];
    if (!box(static_cast<Eigen::Index>(j)).contains(x)) return false;
    // Residuals below the level differ from those at the vertex by less than twice the level.
    const Rational radius = (*inverse)(static_cast<Eigen::Index>(j)).upper() * level * Rational(2);
    neighbourhood.sides.push_back({x.lower() - radius, x.upper() + radius});
  }
  return vertex.model.is_minimum_over(vertex.point, neighbourhood);
}

void add_least_residual(const Family& f, Results& results) {
  const std::pair<std::string, std::size_t> parameters[] = {{"area.exact.a", 0},
                                                            {"area.exact.b.js-report", 1},
                                                            {"area.exact.b.jsplines", 1},
                                                            {"area.exact.s.js-report", 2},
                                                            {"area.exact.s.jsplines", 2}};
  const auto vertex = find_vertex(f);
  if (!vertex || !is_least_everywhere(f, *vertex)) {
    const std::string note = vertex
                                 ? "A local minimum was found, but that nothing lies below it was not proved."
                                 : "No local minimum was found.";
    results.claims.push_back(undecided(head_of("area.exact.residual"), note));
    for (const auto& [id, j] : parameters) results.claims.push_back(undecided(head_of(id), note));
    return;
  }
  const std::string method = "Krawczyk; linear certificates for all real a and b; Newton bounds";
  const Enclosure least = certified(vertex->value, method);
  const auto point = [&](int digits) {
    const std::vector<Interval>& x = vertex->point.x;
    return fmt::format("a = {}, b = {}, s = {}", to_significant(x[0].midpoint(), digits),
                       to_significant(x[1].midpoint(), digits), to_significant(x[2].midpoint(), digits));
  };
  results.claims.push_back(settle(head_of("area.exact.residual"), least,
                                  fmt::format("Positive, so no scheme of the family preserves all areas "
                                              "exactly; attained at {} alone, where -(m_1 - 1/2) "
                                              "= -m_2 = -m_3 = m_5.",
                                              point(20))));
  const std::string note = fmt::format(
      "There is no exact solution for the printed value to round. The least difference of the masks, {}, is "
      "attained at {}.",
      to_significant(least.midpoint(), 4), point(6));
  for (const auto& [id, j] : parameters) {
    results.claims.push_back(settle(head_of(id), certified(vertex->point.x[j], method), note));
  }
}

void add_printed_residuals(Results& results) {
  const auto residual = [](const char* a, const char* b, const char* s) {
    return exact(largest_area_residual(
        anticipated_jspline(Rational::parse(a), Rational::parse(b), Rational::parse(s))));
  };
  results.claims.push_back(
      settle(head_of("area.exact.residual.js-report"), residual("-0.0053", "1.0276", "0.4666")));
  results.claims.push_back(
      settle(head_of("area.exact.residual.jsplines"), residual("-0.0053", "1.03", "0.47")));
}

}  // namespace

Results run_area_exact() {
  Results results;
  const Family f = family();
  results.claims.push_back(existence(f));
  add_least_residual(f, results);
  add_printed_residuals(results);
  return results;
}

}  // namespace subdiv
