#include "experiments/family.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/matrix.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::array table{
    ClaimHead{"family.members.four-point", "jsplines", "1 (js-report 1)", "J0 is the 4-point scheme",
              ClaimKind::exact,
              "J_0 and the four-point scheme with w = 1/16 are the same Laurent polynomial."},
    ClaimHead{"family.members.cubic", "jsplines", "1 (js-report 1)",
              "J1 is the uniform cubic B-spline scheme", ClaimKind::exact,
              "J_1 and 2((1+z)/2)^4, centred, are the same Laurent polynomial."},
    ClaimHead{"family.members.quintic", "jsplines", "3 (js-report 3)",
              "s=3/2 corresponds to uniform quintic b-spline subdivision", ClaimKind::exact,
              "J_{3/2} and 2((1+z)/2)^6, centred, are the same Laurent polynomial."},
    ClaimHead{"family.members.average", "js-report", "1",
              "J1/2 is the Jarek refinement, which averages the four-point and cubic b-spline",
              ClaimKind::exact, "J_{1/2} is half the sum of the masks of J_0 and J_1."},
    ClaimHead{"family.parameters", "js-report", "1",
              "all seven coefficients may be defined in terms of two parameters a and b", ClaimKind::exact,
              "Stencils (alpha, beta, chi) and (delta, epsilon, phi, gamma) under alpha = chi, delta = "
              "gamma, epsilon = "
              "phi, alpha+beta+chi = 1, delta+epsilon+phi+gamma = 1: the dimension of the solutions, and "
              "that (a, b) runs "
              "through all of them."},
    ClaimHead{"family.symbol", "jsplines", "3, equation (1) (js-report 3)",
              "(s-1)/16 + s/8 z + (9-s)/16 z^2 + (1-s/4) z^3 + (9-s)/16 z^4 + s/8 z^5 + (s-1)/16 z^6",
              ClaimKind::exact,
              "The column of P_0 in the rules for even and odd points, for all s, times z^3."},
    ClaimHead{"family.symbol.factors", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact,
              "The multiplicity of 1+z in the symbol over Q(s) and the remaining factor, and at which s it "
              "has more."},
    ClaimHead{"family.linear", "jsplines", "11", "a linear subdivision J0,1", ClaimKind::exact,
              "J_{0,1} is 2((1+z)/2)^2, centred: old points stay, new points are mid-edge points."},
    ClaimHead{"family.blend.even", "jsplines", "6",
              "a: each even vertex is a combination of the old vertex and its cubic B-spline tuck",
              ClaimKind::exact,
              "The even rule of J_{a,b} is (1-a) times the identity plus a times (1, 6, 1)/8."},
    ClaimHead{"family.blend.odd", "jsplines", "6",
              "b: each odd vertex is a combination of the mid-edge point and its four-point tuck",
              ClaimKind::exact,
              "The odd rule of J_{a,b} is b times (1, 1)/2 plus (1-b) times (-1, 9, 9, -1)/16."},
    ClaimHead{"family.maillot-stam", "jsplines", "2", "they used α=1–s as the blending parameter",
              ClaimKind::exact, "J_s = alpha J_0 + (1-alpha) J_1 with alpha = 1-s, over Q(s)."},
    ClaimHead{"family.affine-once", "jsplines", "3 (js-report 3)", "Js(0P)=Ls(J0(0P),J1(0P))",
              ClaimKind::exact, "One step of J_s is the blend (1-s) J_0 + s J_1, over Q(s)."},
    ClaimHead{"family.not-affine-in-iterates", "jsplines", "3 (js-report 3)",
              "in general, kJs(0P)≠Ls(kJ0(0P), kJ1(0P))", ClaimKind::exact,
              "The degree in s of the symbol of k steps of J_s minus the blend of k steps of J_0 and of J_1, "
              "for k = 1 .. 6; "
              "for every k >= 2 by its leading coefficient."},
    ClaimHead{"family.support", "jsplines", "2", "our curves still maintain local control", ClaimKind::exact,
              "The support of the basis function of *J_s: the symbol of k steps over Q(s) has the powers "
              "-3(2^k - 1) .. "
              "3(2^k - 1), each standing at i / 2^k."},
    ClaimHead{"family.anticipation-support", "jsplines", "6",
              "retain local control: precede the series of Js steps by a "
              "single anticipation step Ja,b",
              ClaimKind::exact,
              "The support of the basis function of {J_{a,b}, *J_s}: the symbol of k steps over Q(a, b, s)."},
    ClaimHead{"family.even-degree", "jsplines", "4 (js-report 4)",
              "It does not reproduce even degree B-splines exactly", ClaimKind::exact,
              "Whether some *J_s produces uniform B-spline curves of even degree: with t(z) = (1+z)/2 and "
              "the quartic "
              "B-spline's symbol B(z), whether t(z) S_2(z) = t(z^2) B(z) / z."},
    ClaimHead{
        "family.even-degree.basis", "subdivlab", "jsplines 4", std::nullopt, ClaimKind::exact,
        "No basis function of *J_s is a uniform B-spline of even degree: the number of mask coefficients."},
    ClaimHead{"family.lane-riesenfeld", "jsplines", "4 (js-report 4)",
              "First double the vertices by inserting mid-edge points, then take the dual d-1 times",
              ClaimKind::exact,
              "(1+z)^2/2 times ((1+z)/2)^(d-1) is the symbol 2((1+z)/2)^(d+1) of degree d, for d = 1 .. 12."},
    ClaimHead{
        "family.smoothing-step", "jsplines", "4",
        "a pair of dual operations: each vertex moves towards the average of its two neighboring vertices",
        ClaimKind::exact,
        "((1+z)/2)^2, centred, is half the identity plus half the average of the two neighbours."},
};

const ClaimHead& claim(const std::string& id) { return head(table, id); }

using Function = RationalFunction;
using Symbol = Laurent<Function>;

Function variable(int i) { return Function::variable(i); }
Function ratio(long p, long q) { return fraction<Function>(p, q); }

/// (1+z)/2.
Symbol average() { return Symbol(0, {ratio(1, 2), ratio(1, 2)}); }

/// The symbol of the rules P'_{2j} = sum even_k P_{j+k}, P'_{2j+1} = sum odd_k P_{j+k}: point P_0 enters
/// P'_{2j} with even_{-j}.
Symbol symbol_of_rules(const Symbol& even, const Symbol& odd) {
  return upsample(reverse(even), 2) + shift(upsample(reverse(odd), 2), 1);
}

Claim identity(const std::string& id, bool holds) {
  return settle_statement(claim(id), holds, holds ? "true" : "false");
}

/// "(-1/16, 0, 9/16, 1, 9/16, 0, -1/16)".
std::string mask_text(const Symbol& symbol) {
  std::string text;
  for (const Function& c : symbol.coefficients()) text += (text.empty() ? "(" : ", ") + c.to_string();
  return text + ")";
}

Claim same_mask(const std::string& id, const Symbol& found, const Symbol& expected) {
  return settle_statement(claim(id), found == expected, mask_text(found));
}

std::vector<Claim> members() {
  const Function three_halves = ratio(3, 2);
  const Symbol blend = ratio(1, 2) * (jspline<Function>(0).symbol + jspline<Function>(1).symbol);
  return {
      same_mask("family.members.four-point", jspline<Function>(0).symbol, four_point(ratio(1, 16)).symbol),
      same_mask("family.members.cubic", jspline<Function>(1).symbol, bspline<Function>(3).symbol),
      same_mask("family.members.quintic", jspline(three_halves).symbol, bspline<Function>(5).symbol),
      same_mask("family.members.average", jspline(ratio(1, 2)).symbol, blend),
      same_mask("family.linear", jspline<Function>(0, 1).symbol, bspline<Function>(1).symbol)};
}

/// Rows of equations in (alpha, beta, chi, delta, epsilon, phi, gamma), without right sides.
Matrix<Rational> stencil_equations() {
  Matrix<Rational> equations = zero_matrix<Rational>(5, 7);
  constexpr std::array<std::array<int, 7>, 5> rows{{{1, 0, -1, 0, 0, 0, 0},
                                                    {0, 0, 0, 1, 0, 0, -1},
                                                    {0, 0, 0, 0, 1, -1, 0},
                                                    {1, 1, 1, 0, 0, 0, 0},
                                                    {0, 0, 0, 1, 1, 1, 1}}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      equations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
    }
  }
  return equations;
}

Claim parameters() {
  const Function a = variable(0);
  const Function b = variable(1);
  const std::size_t dimension = null_space(stencil_equations()).size();
  // alpha = a/8 and gamma = (b-1)/16 determine a and b, so (a, b) -> stencils is one to one; it meets every
  // equation.
  const Symbol mask = jspline(a, b).symbol;
  const Symbol even = residue_class(mask, 0, 2);
  const Symbol odd = residue_class(mask, 1, 2);
  const bool meets = even[-1] == even[1] && odd[-2] == odd[1] && odd[-1] == odd[0] &&
                     sum(even) == Function(1) && sum(odd) == Function(1);
  const bool one_to_one = ratio(8, 1) * even[1] == a && ratio(16, 1) * odd[1] + Function(1) == b;
  return settle_statement(claim("family.parameters"), dimension == 2 && meets && one_to_one,
                          std::to_string(dimension) + " parameters, (a, b) one to one");
}

Claim printed_symbol() {
  const Function s = variable(0);
  const Function outer = (s - Function(1)) / Function(16);
  const Function side = s / Function(8);
  const Function inner = (Function(9) - s) / Function(16);
  const Function centre = Function(1) - s / Function(4);
  const Symbol printed(0, {outer, side, inner, centre, inner, side, outer});
  const Symbol even(-1, {s / Function(8), (Function(8) - Function(2) * s) / Function(8), s / Function(8)});
  const Symbol odd(-1, {outer, inner, inner, outer});
  const Symbol from_rules = symbol_of_rules(even, odd);
  return identity("family.symbol", shift(from_rules, 3) == printed && from_rules == jspline(s).symbol);
}

Claim factors() {
  const Function s = variable(0);
  const Symbol one_plus_z = smoothing_factor<Function>(2);
  const auto [multiplicity, rest] = divide_out(jspline(s).symbol, one_plus_z);
  const Function at_minus_one = evaluate(rest, Function(-1));
  const bool only_there =
      at_minus_one.numerator() == at_minus_one.numerator().coefficients_in(0).at(1) *
                                      (Polynomial::variable(0) - Polynomial(Rational(3, 2)));
  const auto [at_three_halves, cofactor] = divide_out(jspline(ratio(3, 2)).symbol, one_plus_z);
  const bool holds = multiplicity == 4 && only_there && at_three_halves == 6 && cofactor.size() == 1;
  return settle_statement(claim("family.symbol.factors"), holds,
                          "(1+z)^4 ((s-1) + (4-2s) z + (s-1) z^2) / (16 z^3)",
                          "The quadratic factor is (4s-6)/16 at z = -1, so it takes up another 1+z at s = "
                          "3/2 alone, and there it takes up two: "
                          "(1+z)^6/32, the quintic B-spline.");
}

std::vector<Claim> blends() {
  const Function a = variable(0);
  const Function b = variable(1);
  const Function s = variable(0);
  const Symbol mask = jspline(a, b).symbol;
  const Symbol cubic_tuck(-1, {ratio(1, 8), ratio(6, 8), ratio(1, 8)});
  const Symbol mid_edge(-1, {ratio(1, 2), ratio(1, 2)});
  const Symbol four_point_tuck(-2, {ratio(-1, 16), ratio(9, 16), ratio(9, 16), ratio(-1, 16)});
  const Symbol even = (Function(1) - a) * Symbol(1) + a * cubic_tuck;
  const Symbol odd = b * mid_edge + (Function(1) - b) * four_point_tuck;
  const Function alpha = Function(1) - s;
  const Symbol four_point_step = four_point(ratio(1, 16)).symbol;
  const Symbol cubic_step = bspline<Function>(3).symbol;
  const bool blended = jspline(s).symbol == alpha * four_point_step + (Function(1) - alpha) * cubic_step;
  return {identity("family.blend.even", residue_class(mask, 0, 2) == even),
          identity("family.blend.odd", residue_class(mask, 1, 2) == odd),
          identity("family.maillot-stam", blended), identity("family.affine-once", blended)};
}

/// The highest degree in s of a coefficient; -1 for the zero polynomial.
long degree_in_s(const Symbol& symbol) {
  long degree = -1;
  for (const Function& c : symbol.coefficients()) {
    if (!c.is_zero()) degree = std::max(degree, c.numerator().degree(0));
  }
  return degree;
}

Claim not_affine() {
  const Function s = variable(0);
  const Scheme<Function> blend = stationary<Function>("*J_s", jspline(s));
  const Scheme<Function> four = stationary<Function>("*J_0", jspline<Function>(0));
  const Scheme<Function> cubic = stationary<Function>("*J_1", jspline<Function>(1));
  bool holds = true;
  constexpr int most_steps = 6;
  for (int k = 1; k <= most_steps; ++k) {
    const Symbol difference = iterated_symbol(blend, k) -
                              ((Function(1) - s) * iterated_symbol(four, k) + s * iterated_symbol(cubic, k));
    holds = holds && degree_in_s(difference) == (k == 1 ? -1 : k);
  }
  // S_s = A + s D: the coefficient of s^k of k steps is D(z) D(z^2) .. D(z^(2^(k-1))), not zero because D is
  // not.
  holds = holds && !(jspline<Function>(1).symbol - jspline<Function>(0).symbol).is_zero();
  return settle_statement(
      claim("family.not-affine-in-iterates"), holds, "degree k in s for k >= 2, equal for k = 1",
      "With D = J_1 - J_0 the coefficient of s^k after k steps is D(z) D(z^2) .. D(z^(2^(k-1))), a "
      "product of polynomials that are not zero; a blend has degree 1 in s.");
}

bool has_full_support(const Scheme<Function>& scheme) {
  constexpr int most_steps = 5;
  for (int k = 1; k <= most_steps; ++k) {
    const Symbol symbol = iterated_symbol(scheme, k);
    const int end = 3 * ((1 << k) - 1);
    if (symbol.first() != -end || symbol.last() != end) return false;
  }
  return true;
}

std::vector<Claim> supports() {
  const Scheme<Function> repeated = stationary<Function>("*J_s", jspline(variable(2)));
  const Scheme<Function> anticipated =
      mixed(stationary<Function>("J_{a,b}", jspline(variable(0), variable(1))), repeated);
  return {
      settle_statement(claim("family.support"), has_full_support(repeated), "[-3, 3]",
                       "A control point moves the curve over three spans to either side (two for s = 1)."),
      settle_statement(
          claim("family.anticipation-support"), has_full_support(anticipated), "[-3, 3]",
          "An anticipation step has the same support as the steps that follow, so nothing is lost.")};
}

/// (1+z)(1 - z + .. + z^(n-1)) = 1 + z^n for odd n: on closed loops of n points, where z^n = 1, taking
/// mid-edge points has an inverse.
bool mid_edges_are_invertible(int n) {
  std::vector<Function> alternating;
  for (int i = 0; i < n; ++i) alternating.emplace_back(i % 2 == 0 ? 1 : -1);
  return smoothing_factor<Function>(2) * Symbol(0, alternating) == Symbol(1) + Symbol::monomial(n);
}

std::vector<Claim> even_degree() {
  const Symbol t = average();
  const Symbol quartic = bspline<Function>(4).symbol;
  bool spline = t * jspline<Function>(2).symbol == shift(upsample(t, 2) * quartic, -1);
  for (const int n : {3, 5, 7, 9}) spline = spline && mid_edges_are_invertible(n);

  const Function s = variable(0);
  const Symbol at_one = jspline<Function>(1).symbol;
  const Function outer = jspline(s).symbol[3];
  bool parity =
      jspline(s).symbol.size() == 7 && outer == (s - Function(1)) / Function(16) && at_one.size() == 5;
  constexpr int most = 12;
  for (int d = 0; d <= most; d += 2) parity = parity && bspline<Function>(d).symbol.size() == d + 2;
  return {
      settle_statement(claim("family.even-degree"), !spline, "t(z) S_2(z) = t(z^2) B_4(z) / z",
                       "*J_2 is a quartic B-spline scheme in disguise: its curve is exactly the uniform "
                       "quartic B-spline curve of the "
                       "polygon's mid-edge points, because (1+z)/2 S_2(z) = (1+z^2)/2 B_4(z)/z and the "
                       "factors telescope over the "
                       "steps. On closed loops with an odd number of points every polygon is the mid-edge "
                       "polygon of another, so "
                       "there *J_2 produces every uniform quartic B-spline curve. What holds is less: no "
                       "*J_s has an even degree "
                       "B-spline as its basis function (family.even-degree.basis)."),
      settle_statement(
          claim("family.even-degree.basis"), parity, "7 coefficients, 5 at s = 1; degree d has d + 2",
          "A B-spline has linearly independent shifts, so its mask is unique; the mask of degree d has d + 2 "
          "coefficients, an even number for even d, and that of J_s has 7, or 5 at s = 1.")};
}

std::vector<Claim> smoothing() {
  const Symbol t = average();
  const Symbol doubling(0, {ratio(1, 2), Function(1), ratio(1, 2)});
  bool holds = true;
  constexpr int most = 12;
  for (int d = 1; d <= most; ++d) {
    const Symbol symbol = doubling * pow(t, d - 1);
    holds = holds && shift(symbol, bspline<Function>(d).symbol.first()) == bspline<Function>(d).symbol;
  }
  const Symbol neighbours(-1, {ratio(1, 2), Function(0), ratio(1, 2)});
  const Symbol step = ratio(1, 2) * Symbol(1) + ratio(1, 2) * neighbours;
  return {identity("family.lane-riesenfeld", holds),
          identity("family.smoothing-step", shift(t * t, -1) == step)};
}

}  // namespace

std::span<const ClaimHead> family_heads() { return table; }

Results run_family() {
  Results results;
  const auto add = [&](std::vector<Claim> claims) {
    for (Claim& c : claims) results.claims.push_back(std::move(c));
  };
  add(members());
  add({parameters(), printed_symbol(), factors(), not_affine()});
  add(blends());
  add(supports());
  add(even_degree());
  add(smoothing());
  return results;
}

}  // namespace subdiv
