#include "experiments/two_parameter_smoothness.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/contraction_set.h"
#include "analysis/hoelder.h"
#include "analysis/three_tap_smoothness.h"
#include "analysis/unstable_conditions.h"
#include "analysis/unstable_shifts.h"
#include "schemes/algebra/specialize.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string limits_definition =
    "The exact set of b for which all limits of *J_{a,b} are C1 on the line ";
const std::string scheme_definition =
    "The exact set of b for which the second differences of *J_{a,b}, scaled by 2 at each level, tend to "
    "zero "
    "on the line ";

const std::string section = "jsplines 6";

const std::array table{
    finding("smooth.ab.c2", section,
            "All (a, b) for which the limits of *J_{a,b} are C2 for all control polygons."),
    finding("smooth.ab.c2.scheme", section,
            "All (a, b) for which third differences of *J_{a,b}, scaled by 4 at each level, tend to zero."),
    finding(
        "smooth.ab.unstable", section,
        "All (a, b) at which the integer shifts of the basis function of *J_{a,b} are linearly dependent."),
    finding("smooth.ab.line.quadratic", section, limits_definition + "a = 2."),
    finding("smooth.ab.line.even", section, limits_definition + "a = b - 1."),
    finding("smooth.ab.line.cycle", section, limits_definition + "2a + b = 9."),
    finding("smooth.ab.line.cycle.scheme", section, scheme_definition + "2a + b = 9."),
};

const ClaimHead& claim(const char* id) { return head(table, id); }

void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error("smoothness of J_{a,b}: " + what);
}

const Function b = Function::variable(0);

/// A line of masks J_{a(b),b} whose symbol 2 ((1+z)/2)^2 beta(z) reduces: beta(z) t(z) = c(z) t(z^2), c the
/// product of ((1+z)/2)^(n-2) and p + (1-2p) z + p z^2. Its limits are combinations, with the coefficients
/// of t, of those of the scheme with the symbol 2 ((1+z)/2)^2 c(z), solved for all p in
/// three_tap_smoothness.h.
struct Line {
  Function a;
  Laurent<Function> t;
  int factors = 2;  // n
  Function p;
};

Laurent<Function> three_taps(const Function& p) { return {0, {p, Function(1) - Function(2) * p, p}}; }

Laurent<Function> average() { return {0, {fraction<Function>(1, 2), fraction<Function>(1, 2)}}; }

/// beta(z), divided by nothing but ((1+z)/2)^2 even where more factors 1+z are there.
Laurent<Function> beta_of(const Function& a) {
  const auto quotient = divide_exactly(jspline(a, b).symbol, pow(smoothing_factor<Function>(2), 2));
  require(quotient.has_value(), "a factor (1+z)^2");
  return shift(Laurent<Function>(2) * *quotient, -quotient->first());
}

void check_reduction(const Line& line) {
  const Laurent<Function> reduced = pow(average(), line.factors - 2) * three_taps(line.p);
  require(beta_of(line.a) * line.t == reduced * upsample(line.t, 2), "a reduction");
}

const std::array<Line, 3>& lines() {
  static const std::array<Line, 3> all{
      Line{Function(2), average(), 3, (b - Function(1)) / Function(4)},
      Line{b - Function(1), three_taps((b - Function(1)) / Function(8)), 2, (b - Function(1)) / Function(8)},
      Line{(Function(9) - b) / Function(2),
           Laurent<Function>(0,
                             {fraction<Function>(1, 3), fraction<Function>(1, 3), fraction<Function>(1, 3)}),
           2, (b - Function(1)) / Function(8)}};
  return all;
}

/// The x with x = 1 + p / slope for some p in the set.
RealSet stretched(RealSet set, const Rational& slope) {
  const auto place = [&](const Algebraic& p) { return Algebraic(1) + p / Algebraic(slope); };
  for (RealInterval& part : set.parts) {
    if (part.lower) part.lower = place(*part.lower);
    if (part.upper) part.upper = place(*part.upper);
  }
  return set;
}

/// The b with C^order limits on a line: p = slope (b - 1).
RealSet limits_on(const Line& line, int order) {
  return stretched(three_tap_continuity_set(line.factors, order), line.p.derivative(0).constant());
}

/// The general algorithm just inside and outside of the ends of a line's C1 range.
void check_around(const Line& line, const RealSet& set, bool of_limits) {
  for (const Algebraic& end : {*set.parts[0].lower, *set.parts[0].upper}) {
    for (const Rational& at : {end.to_rational() - Rational(1, 50), end.to_rational() + Rational(1, 50)}) {
      const auto report = smoothness_report(normal_form(jspline(specialize(line.a, 0, at), at)));
      const Smoothness& found = of_limits ? report.limits : report.scheme;
      const bool inside = set.contains(Algebraic(at));
      require(inside ? found.continuity >= 1 : found.continuity_limit < 1,
              "two routes at b = " + at.to_string());
    }
  }
}

void add_lines(Results& results) {
  const std::array<std::pair<const char*, std::string>, 3> claims{
      std::pair{
          "smooth.ab.line.quadratic",
          std::string("1+z^2 divides the symbol: limits are those of 2((1+z)/2)^3 (p + (1-2p) z + p z^2), p "
                      "= (b-1)/4, and C2 for 1 < b < 5. The scheme is C1 on the same set.")},
      std::pair{
          "smooth.ab.line.even",
          std::string("The symbol is 2((1+z)/2)^2 g(z^2), g(z) = p + (1-2p) z + p z^2, p = (b-1)/8: limits "
                      "are those of 2((1+z)/2)^2 g(z). The scheme is C1 on the same set.")},
      std::pair{
          "smooth.ab.line.cycle",
          std::string("1-z+z^2 divides the symbol: limits are those of 2((1+z)/2)^2 (p + (1-2p) z + p z^2), "
                      "p = (b-1)/8. For 19/3 <= b < 9 limits are C1 although the scheme is not.")}};
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const Line& line = lines()[i];
    check_reduction(line);
    const RealSet set = limits_on(line, 1);
    check_around(line, set, true);
    if (i < 2) check_around(line, set, false);  // where t vanishes on no cycle the scheme is as smooth
    results.claims.push_back(
        settle_statement(claim(claims[i].first), set.parts.size() == 1, set.to_string(), claims[i].second));
  }
}

// ---- The scheme on the line 2a + b = 9 -------------------------------------------------------------------

/// Transition matrices of beta in the basis t, z t, 1, z with t = 1 + z + z^2: multiples of t stay multiples
/// of t, so that the matrices are block triangular.
struct Blocks {
  std::vector<Matrix<Function>> multiples;  // of t: those of p + (1-2p) z + p z^2
  std::vector<Matrix<Function>> rest;       // modulo t
};

bool vanishes(const Matrix<Function>& m) { return m == zero_matrix<Function>(m.rows(), m.cols()); }

Blocks cycle_blocks(const Line& line) {
  const NormalForm<Function> form{2, 2, 0, beta_of(line.a)};
  Matrix<Function> basis = zero_matrix<Function>(4, 4);
  basis << Function(1), Function(0), Function(1), Function(0), Function(1), Function(1), Function(0),
      Function(1), Function(1), Function(1), Function(0), Function(0), Function(0), Function(1), Function(0),
      Function(0);
  Blocks result;
  for (const Matrix<Function>& t : transition_matrices(form)) {
    Matrix<Function> inner = zero_matrix<Function>(4, 4);
    const Matrix<Function> image = t * basis;
    for (Eigen::Index j = 0; j < inner.cols(); ++j) {
      inner.col(j) = solve(basis, Vector<Function>(image.col(j))).value();
    }
    require(vanishes(inner.bottomLeftCorner(2, 2)), "an invariant subspace");
    result.multiples.emplace_back(inner.topLeftCorner(2, 2));
    result.rest.emplace_back(inner.bottomRightCorner(2, 2));
  }
  return result;
}

/// rho(beta) is the larger of the radii of both blocks. Modulo t every matrix is |1 - 3p| times an isometry
/// of |x_0 + x_1 w|, w a root of t.
RealSet scheme_on_cycle() {
  const Line& line = lines()[2];
  const Blocks blocks = cycle_blocks(line);
  std::vector<Matrix<Function>> expected;
  for (const Matrix<Function>& t : three_tap_matrices()) {
    expected.emplace_back(t.unaryExpr([&](const Function& f) { return specialize(f, 0, line.p); }));
  }
  require(blocks.multiples == expected, "the matrices of the reduced scheme");
  Matrix<Function> form(2, 2);
  form << Function(2), Function(-1), Function(-1), Function(2);
  const Function scale = Function(1) - Function(3) * line.p;
  for (const Matrix<Function>& t : blocks.rest) {
    const Matrix<Function> image = t.transpose() * form * t;
    const Matrix<Function> isometry = form * (scale * scale);
    require(image == isometry, "an isometry");
  }
  return intersection(limits_on(line, 1), contraction_set(Matrix<Function>::Constant(1, 1, scale)));
}

void add_cycle_scheme(Results& results) {
  const RealSet set = scheme_on_cycle();
  check_around(lines()[2], set, false);
  results.claims.push_back(settle_statement(claim("smooth.ab.line.cycle.scheme"), set.parts.size() == 1,
                                            set.to_string(),
                                            "With p = (b-1)/8 the joint spectral radius is the larger of "
                                            "|1-3p| and that of p + (1-2p) z + p z^2."));
}

// ---- Where limits are C2 ---------------------------------------------------------------------------------

bool vanish_at(const UnstableCondition& c, const Function& a, const Function& second) {
  const std::vector<Function> place{a, second};
  return std::ranges::all_of(c.equations, [&](const Polynomial& equation) {
    return equation.evaluate(std::span<const Function>(place)).is_zero();
  });
}

/// Equations of degree 1 whose common solutions are a line (one equation) or a point (two).
bool are_linear(const UnstableCondition& c, std::size_t count) {
  if (c.equations.size() != count) return false;
  Matrix<Rational> slopes(static_cast<Eigen::Index>(count), 2);
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 2; ++k) {
      const Polynomial slope = c.equations[i].derivative(k);
      if (!slope.is_constant()) return false;
      slopes(static_cast<Eigen::Index>(i), k) = slope.constant();
    }
  }
  return null_space(slopes).size() == 2 - count;
}

/// Whether the conditions are the three lines and the one point (4, 9).
bool are_the_three_lines(const std::vector<UnstableCondition>& conditions) {
  const auto is_line = [](const UnstableCondition& c) {
    return are_linear(c, 1) &&
           std::ranges::any_of(lines(), [&](const Line& line) { return vanish_at(c, line.a, b); });
  };
  const auto is_point = [](const UnstableCondition& c) { return are_linear(c, 2) && vanish_at(c, 4, 9); };
  return std::ranges::count_if(conditions, is_line) == 3 &&
         std::ranges::count_if(conditions, is_point) == 1 && conditions.size() == 4;
}

/// The places on the lines where the outer coefficients vanish, b = 1, at which the shifts are independent
/// all the same: conditions over Q(a, b) cannot tell.
std::vector<Rational> independent_ends() {
  std::vector<Rational> result;
  for (const int at : {2, 0, 4}) {  // of a, on a = 2, a = b - 1, 2a + b = 9
    const bool independent =
        independent_form(normal_form(jspline<Rational>(at, 1))).independent == Decision::yes;
    if (independent) result.emplace_back(at);
  }
  return result;
}

void add_c2(Results& results) {
  const Function x = Function::variable(0);
  const Function y = Function::variable(1);
  const std::vector<UnstableCondition> conditions = unstable_conditions(normal_form(jspline(x, y)).b);
  results.claims.push_back(settle_statement(
      claim("smooth.ab.unstable"),
      are_the_three_lines(conditions) && independent_ends() == std::vector<Rational>{0},
      "a = 2; a = b-1 but for (0, 1); 2a+b = 9; (4, 9)",
      "On the first two lines the symbol has roots z and -z, on the third and at (4, 9) it vanishes at the "
      "negatives of the primitive roots of unity of order 3 and 5. At (0, 1), linear subdivision, the outer "
      "coefficients vanish and with them the roots: hat functions are independent."));

  // A third factor 1+z is there only for a = b: the next sum rule, b(-1) = b - a.
  const Laurent<Function> symbol = normal_form(jspline(x, y)).b;
  const bool third_factor =
      evaluate(symbol, Function(-1)) == y - x || evaluate(symbol, Function(-1)) == x - y;
  const std::string diagonal = stretched(three_tap_continuity_set(4, 2), Rational(1, 2)).to_string();
  const RealSet quadratic = limits_on(lines()[0], 2);
  const RealSet even = limits_on(lines()[1], 2);
  const RealSet cycle = limits_on(lines()[2], 2);
  const auto single = [](const RealSet& set, int at) {
    return set.parts.size() == 1 && set.parts[0].is_point() && *set.parts[0].lower == Algebraic(at);
  };
  // The single points: (2, 3), which lies on a = 2 as well, and (3, 3) on the diagonal.
  const bool elsewhere = single(even, 3) && single(cycle, 3) && quadratic.contains(3);
  const bool point = smoothness_report(normal_form(jspline<Rational>(4, 9))).limits.continuity_limit < 2;
  results.claims.push_back(settle_statement(
      claim("smooth.ab.c2"), third_factor && elsewhere && point,
      fmt::format("a = b in {}, or a = 2 and b in {}", diagonal, quadratic.to_string()),
      "Where the shifts are independent, C2 limits need a third factor 1+z of the symbol, which is there for "
      "a "
      "= b only: J_s. The shifts are dependent on three lines and at (4, 9), where limits are those of a "
      "simpler scheme: on a = 2 they are C2 for 1 < b < 5; on a = b-1 and 2a+b = 9 only at (2, 3) and (3, "
      "3), "
      "which belong to the sets named already; at (4, 9) they are piecewise linear."));
  results.claims.push_back(settle_statement(claim("smooth.ab.c2.scheme"), third_factor,
                                            "a = b in " + diagonal,
                                            "Third differences obey a scheme of their own for a = b only."));
}

}  // namespace

std::span<const ClaimHead> two_parameter_smoothness_heads() { return table; }

Results run_two_parameter_smoothness() {
  Results results;
  add_c2(results);
  add_lines(results);
  add_cycle_scheme(results);
  return results;
}

}  // namespace subdiv
