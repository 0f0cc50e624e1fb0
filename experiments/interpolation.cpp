#include "experiments/interpolation.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "analysis/basis_function.h"
#include "experiments/report/figure_style.h"
#include "optimize/problem.h"
#include "schemes/algebra/univariate.h"
#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::string one_box = "Range [-1.7, 5.8].";
const std::string vertex_definition =
    "Minimise the maximum norm of (limit mask at an old vertex) - (1 at that vertex, 0 elsewhere). ";
const std::string edge_definition =
    "Minimise the maximum norm of (limit mask at the new mid-edge vertex) - (1/2, 1/2). ";

const std::array table{
    ClaimHead{"vertex.r", "jsplines", "6 (js-report 6)", "-33/26", ClaimKind::exact,
              vertex_definition + "Scheme {J_r, *J_{3/2}}."},
    ClaimHead{"vertex.r.error", "subdivlab", "jsplines 6", std::nullopt, ClaimKind::exact,
              "The least maximum norm that r = -33/26 reaches."},
    ClaimHead{"vertex.ab.a", "jsplines", "6 (js-report 6)", "-7/4", ClaimKind::exact,
              vertex_definition + "Scheme {J_{a,b}, *J_{3/2}}."},
    ClaimHead{"vertex.ab.b", "jsplines", "6 (js-report 6)", "59/52", ClaimKind::exact,
              vertex_definition + "Scheme {J_{a,b}, *J_{3/2}}."},
    ClaimHead{"vertex.ab.interpolates", "jsplines", "6 (js-report 6)",
              "yields exact interpolation of the control vertices", ClaimKind::exact,
              "The limit mask of {J_{-7/4,59/52}, *J_{3/2}} at an old vertex is the identity."},
    ClaimHead{"vertex.exact.a", "subdivlab", "jsplines 6", std::nullopt, ClaimKind::exact,
              "a(s) such that {J_{a,b}, *J_s} interpolates the control vertices for every s: over Q(s)."},
    ClaimHead{"vertex.exact.b", "subdivlab", "jsplines 6", std::nullopt, ClaimKind::exact,
              "b(s) such that {J_{a,b}, *J_s} interpolates the control vertices for every s: over Q(s)."},
    ClaimHead{"edge.j1", "jsplines", "7 (js-report 7)", "2/3", ClaimKind::exact,
              edge_definition + "Scheme {J_r, *J_1}."},
    ClaimHead{"edge.j1.interpolates", "jsplines", "7 (js-report 7)",
              "interpolate the mid-edge points exactly", ClaimKind::exact,
              "The limit mask of {J_{2/3}, *J_1} at the new mid-edge vertex is (1/2, 1/2)."},
    ClaimHead{"edge.s", "jsplines", "7 (js-report 7)", "0.751", ClaimKind::rounded,
              edge_definition + "Scheme *J_s. " + one_box},
    ClaimHead{"edge.s.error", "subdivlab", "jsplines 7", std::nullopt, ClaimKind::rounded,
              "The least maximum norm that *J_s reaches at mid-edges."},
    ClaimHead{"edge.r", "jsplines", "7 (js-report 7)", "29/59", ClaimKind::exact,
              edge_definition + "Scheme {J_r, *J_{3/2}}."},
    ClaimHead{"edge.r.error", "subdivlab", "jsplines 7", std::nullopt, ClaimKind::exact,
              "The least maximum norm that r = 29/59 reaches."},
    ClaimHead{"edge.b2", "jsplines", "7 (js-report 7)", "B2 interpolates the mid-edge points exactly",
              ClaimKind::exact, "The quadratic B-spline's values at its inner knots are (1/2, 1/2)."},
    ClaimHead{"edge.exact.a", "subdivlab", "jsplines 7", std::nullopt, ClaimKind::exact,
              edge_definition + "Scheme {J_{a,b}, *J_{3/2}}: a C^4 curve through the mid-edge points."},
    ClaimHead{"edge.exact.b", "subdivlab", "jsplines 7", std::nullopt, ClaimKind::exact,
              edge_definition + "Scheme {J_{a,b}, *J_{3/2}}: a C^4 curve through the mid-edge points."},
    ClaimHead{"edge.exact.every-s.a", "subdivlab", "jsplines 7", std::nullopt, ClaimKind::exact,
              "a(s) such that {J_{a,b}, *J_s} interpolates the mid-edge points for every s: over Q(s)."},
    ClaimHead{"edge.exact.every-s.b", "subdivlab", "jsplines 7", std::nullopt, ClaimKind::exact,
              "b(s) such that {J_{a,b}, *J_s} interpolates the mid-edge points for every s: over Q(s)."},
    ClaimHead{
        "drift", "jsplines", "5 (js-report 5)",
        "as the value of s increases towards 1.5, the limit curve drifts farther away from the vertices",
        ClaimKind::exact,
        "Worst distance of the limit point from its vertex over all polygons whose second differences are at "
        "most 1: "
        "|m_1 + 2 m_2| + 2 |m_2|, (m_k) the limit mask. Strictly increasing in s on [0, 3/2]."},
};

using Function = RationalFunction;

const std::vector<std::string> name_s{"s"};

Scheme<Function> repeated(const Function& s) { return stationary<Function>("*J", jspline(s)); }
Scheme<Function> anticipated(const Function& a, const Function& b, const Function& s) {
  return mixed(stationary<Function>("J", jspline(a, b)), repeated(s));
}

/// What separates interpolation: the limit mask at old vertices (phase 0) or new mid-edge vertices (phase 1),
/// minus what is wanted there.
std::vector<Function> interpolation_residuals(const Scheme<Function>& scheme, int phase) {
  const Laurent<Function> values = basis_values(scheme, 1);  // phi at half-integers
  const Laurent<Function> mask = residue_class(values, phase, 2);
  const Function half = fraction<Function>(1, 2);
  const Laurent<Function> wanted = phase == 0 ? Laurent<Function>(1) : Laurent<Function>(-1, {half, half});
  return (mask - wanted).coefficients();
}

Summary least_error(const Scheme<Function>& scheme, int phase, int parameters) {
  Problem problem;
  problem.residuals = interpolation_residuals(scheme, phase);
  problem.box.assign(static_cast<std::size_t>(parameters), Range{Rational(-17, 10), Rational(58, 10)});
  if (parameters == 2) problem.box.assign(2, Range{Rational(-10), Rational(10)});
  return minimise(problem);
}

/// a(s), b(s) that make the residuals of {J_{a,b}, *J_s} vanish: they are affine in a and b.
Vector<Function> exact_anticipation(int phase) {
  const Function a = Function::variable(1);
  const Function b = Function::variable(2);
  const std::vector<Function> residuals =
      interpolation_residuals(anticipated(a, b, Function::variable(0)), phase);
  const auto rows = static_cast<Eigen::Index>(residuals.size());
  Matrix<Function> slopes(rows, 2);
  Vector<Function> right(rows);
  const std::vector<Function> origin{Function::variable(0), Function(0), Function(0)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Function& r = residuals[static_cast<std::size_t>(i)];
    slopes(i, 0) = r.derivative(1);
    slopes(i, 1) = r.derivative(2);
    right(i) = -r.evaluate<Function>(origin);
  }
  const auto solution = solve(slopes, right);
  if (!solution) throw std::logic_error("no anticipation step interpolates for every s");
  return *solution;
}

bool all_zero(const std::vector<Function>& residuals) {
  return std::ranges::all_of(residuals, [](const Function& r) { return r.is_zero(); });
}

bool interpolates(const Scheme<Function>& scheme, int phase) {
  return all_zero(interpolation_residuals(scheme, phase));
}

Claim statement(const std::string& id, bool holds, const std::string& note = "") {
  return settle_statement(head(table, id), holds, holds ? "true" : "false", note);
}

/// The pair (a(s), b(s)) as two findings, checked by putting it back.
void add_exact_anticipation(Results& results, int phase, const std::string& id_a, const std::string& id_b) {
  const Vector<Function> ab = exact_anticipation(phase);
  const bool holds = interpolates(anticipated(ab(0), ab(1), Function::variable(0)), phase);
  const std::string note =
      "Valid wherever its denominator does not vanish; the limit curve has the smoothness of *J_s.";
  results.claims.push_back(
      settle_statement(head(table, id_a), holds, ab(0).to_factored_string(name_s), note));
  results.claims.push_back(
      settle_statement(head(table, id_b), holds, ab(1).to_factored_string(name_s), note));
}

void add_vertices(Results& results) {
  const Function r = Function::variable(0);
  const Function b = Function::variable(1);
  const Function quintic = fraction<Function>(3, 2);
  const Summary one = least_error(anticipated(r, r, quintic), 0, 1);
  results.claims.push_back(
      settle(head(table, "vertex.r"), one.minimiser[0], "Unique optimum of an exact LP."));
  results.claims.push_back(settle(head(table, "vertex.r.error"), one.minimum));
  const Summary two = least_error(anticipated(r, b, quintic), 0, 2);
  results.claims.push_back(settle(head(table, "vertex.ab.a"), two.minimiser[0]));
  results.claims.push_back(settle(head(table, "vertex.ab.b"), two.minimiser[1]));
  results.claims.push_back(statement(
      "vertex.ab.interpolates",
      interpolates(anticipated(fraction<Function>(-7, 4), fraction<Function>(59, 52), quintic), 0)));
  add_exact_anticipation(results, 0, "vertex.exact.a", "vertex.exact.b");
}

void add_edges(Results& results) {
  const Function r = Function::variable(0);
  const Function b = Function::variable(1);
  const Function quintic = fraction<Function>(3, 2);
  results.claims.push_back(
      settle(head(table, "edge.j1"), least_error(anticipated(r, r, Function(1)), 1, 1).minimiser[0]));
  const Function two_thirds = fraction<Function>(2, 3);
  results.claims.push_back(
      statement("edge.j1.interpolates", interpolates(anticipated(two_thirds, two_thirds, Function(1)), 1)));
  const Summary stationary_best = least_error(repeated(r), 1, 1);
  results.claims.push_back(settle(head(table, "edge.s"), stationary_best.minimiser[0]));
  results.claims.push_back(settle(head(table, "edge.s.error"), stationary_best.minimum));
  const Summary quintic_best = least_error(anticipated(r, r, quintic), 1, 1);
  results.claims.push_back(
      settle(head(table, "edge.r"), quintic_best.minimiser[0], "Unique optimum of an exact LP."));
  results.claims.push_back(settle(head(table, "edge.r.error"), quintic_best.minimum));
  const Laurent<Rational> quadratic = integer_values(bspline<Rational>(2));
  const Laurent<Rational> halves(0, {Rational(1, 2), Rational(1, 2)});
  results.claims.push_back(statement("edge.b2", quadratic == halves));
  const Summary exact_pair = least_error(anticipated(r, b, quintic), 1, 2);
  const std::string note =
      "The maximum norm is exactly 0: {J_{-2/13,1}, *J_{3/2}} is a C^4 curve through the mid-edge points, "
      "where the papers' C^4 curve passes close to them.";
  const bool reached = exact_pair.minimum.exact == "0";
  results.claims.push_back(settle(head(table, "edge.exact.a"), exact_pair.minimiser[0], reached ? note : ""));
  results.claims.push_back(settle(head(table, "edge.exact.b"), exact_pair.minimiser[1], reached ? note : ""));
  add_exact_anticipation(results, 1, "edge.exact.every-s.a", "edge.exact.every-s.b");
}

/// Is f strictly increasing on [lower, upper]? Its derivative has no root and no pole there, and one positive
/// value.
bool increases(const Function& f, const Rational& lower, const Rational& upper) {
  const Function slope = f.derivative(0);
  const UnivariatePolynomial above(slope.numerator(), 0);
  const UnivariatePolynomial below(slope.denominator(), 0);
  const std::vector<Rational> inside{(lower + upper) / Rational(2)};
  return count_roots(above, lower, upper) == 0 && count_roots(below, lower, upper) == 0 &&
         slope.evaluate<Rational>(inside).sign() > 0;
}

/// Drift of the limit point in units of the largest second difference: the displacement is
/// (m_1 + 2 m_2) D_0 + m_2 (D_{-1} + D_1), D_i the second differences; m_2 changes its sign at s = 1.
void add_drift(Results& results) {
  const Laurent<Function> mask = integer_values(jspline(Function::variable(0)));
  const Function middle = mask[1] + Function(2) * mask[2];
  const Function below_one = middle - Function(2) * mask[2];
  const Function above_one = middle + Function(2) * mask[2];
  const Rational end(3, 2);
  const bool holds = increases(below_one, Rational(0), Rational(1)) && increases(above_one, Rational(1), end);
  results.claims.push_back(settle_statement(
      head(table, "drift"), holds,
      below_one.to_factored_string(name_s) + " for 0 <= s <= 1, " + above_one.to_factored_string(name_s) +
          " for 1 <= s <= 3/2",
      "At s = 3/2 a limit point can lie a quarter of the largest second difference away from its vertex."));
  Series series{"drift", {"s", "drift"}, {}};
  constexpr int steps = 60;
  constexpr int digits = 15;
  for (int i = 0; i <= steps; ++i) {
    const Rational s(i * 3, steps * 2);
    const std::vector<Rational> at{s};
    const Function& drift = s <= Rational(1) ? below_one : above_one;
    series.rows.push_back({to_significant(s, digits), to_significant(drift.evaluate<Rational>(at), digits)});
  }
  results.series.push_back(std::move(series));
  results.figures.push_back({"drift",
                             "How far limit points of *J_s lie from their vertices at most",
                             "parameter s",
                             "distance (second differences)",
                             {{"drift", "s", "drift", ""}},
                             "set yrange [0:*]; set ytics 0.05",
                             {"drift"}});
}

}  // namespace

std::span<const ClaimHead> interpolation_heads() { return table; }

Results run_interpolation() {
  Results results;
  add_vertices(results);
  add_edges(results);
  add_drift(results);
  return results;
}

}  // namespace subdiv
