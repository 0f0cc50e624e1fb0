#include "experiments/mesh_smoothness_limit.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/mesh/mode_equation.h"
#include "experiments/mesh_smoothness_text.h"
#include "schemes/algebra/univariate.h"
#include "schemes/mesh/jspline_mesh.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Polynomial x = Polynomial::variable(eigenvalue_variable);

/// The factors without x - 1, which must be one of them.
ModeEquation without_one(ModeEquation equation) {
  const auto one = std::ranges::find_if(equation.factors, [](const auto& f) {
    Polynomial quotient;
    return divides(x - Polynomial(1), f.first, quotient) && quotient.is_constant();
  });
  if (one == equation.factors.end() || one->second != 1) throw std::logic_error("1 is not simple");
  equation.factors.erase(one);
  return equation;
}

// ---- Catmull and Clark's scheme at every valence
// -----------------------------------------------------------

/// All eigenvalues but the two of the quadratic, which divides once, are rational and at most 1/8 in modulus.
bool is_all_but_small(const ModeEquation& equation, const Polynomial& quadratic) {
  Polynomial rest = equation.product();
  if (!divides(quadratic, rest, rest)) return false;
  return std::ranges::all_of(factor(rest).factors, [](const auto& f) {
    if (!f.first.uses(eigenvalue_variable)) return true;
    if (f.first.degree(eigenvalue_variable) != 1) return false;
    const std::vector<Polynomial> c = f.first.coefficients_in(eigenvalue_variable);
    if (!c[0].is_constant() || !c[1].is_constant()) return false;
    const Rational root = c[0].constant() / c[1].constant();
    return root <= Rational(1, 8) && Rational(-1, 8) <= root;
  });
}

/// With c = cos(2 pi k/n) and h = 1/n, the large eigenvalues are the roots of
///
///   q(x, c) = 16 x^2 - (10 + 2 c) x + 1 in mode k, real because (5 + c)^2 - 16 = (c + 9)(c + 1) >= 0,
///   p(x, h) = 16 x^2 - (12 - 28 h) x + 1 - 3 h in mode 0.
///
/// In mode 1, c >= -1/2: q(2/5) < 0 < q(1), so that 2/5 < lambda < 1, and the other root is 1/(16 lambda).
/// q falls as c grows, and its vertex (5 + c)/16 lies below 2/5: modes k > 1 have smaller roots. p - q = (28
/// h
/// - 2 (1 - c)) x - 3 h, and 1 - c <= 2 pi^2 h^2 < 20 h^2: at x = lambda this is more than h ((28 - 40 h) 2/5
/// - 3) > 0 for h <= 1/3. So p(lambda) > 0, right of the vertex of p: real roots of p, which are not
/// negative, are smaller; complex ones have the modulus sqrt(1 - 3 h)/4.
bool catmull_clark_holds() {
  const Polynomial c = Polynomial::variable(turn_variable);
  const Polynomial h = Polynomial::variable(valence_variable);
  const Polynomial q = Polynomial(16) * x * x - (Polynomial(10) + Polynomial(2) * c) * x + Polynomial(1);
  const Polynomial p =
      Polynomial(16) * x * x - (Polynomial(12) - Polynomial(28) * h) * x + Polynomial(1) - Polynomial(3) * h;
  const MeshScheme<Function> scheme = catmull_clark<Function>();
  if (!is_all_but_small(turning_modes(scheme), q)) return false;
  if (!is_all_but_small(without_one(invariant_modes(scheme)), p)) return false;
  const auto value = [](const Polynomial& f, int variable, const Rational& at, const Rational& root) {
    return f.substitute(variable, Polynomial(at))
        .substitute(eigenvalue_variable, Polynomial(root))
        .constant();
  };
  const Rational split(2, 5);
  const Rational none(0);
  const Rational least_turn(-1, 2);
  const Rational third(1, 3);
  // q is linear in c: its signs at both ends of [-1/2, 1] are its signs between.
  const bool lambda_lies_right = value(q, turn_variable, least_turn, split) < none &&
                                 value(q, turn_variable, Rational(1), split) < none &&
                                 none < value(q, turn_variable, least_turn, Rational(1)) &&
                                 none < value(q, turn_variable, Rational(1), Rational(1));
  const bool vertices_lie_left = Rational(6, 16) < split && Rational(12, 32) < split;
  const bool mode_0_is_behind = none < (Rational(28) - Rational(40) * third) * split - Rational(3) &&
                                certainly_less(pi() * pi(), Interval(10));
  return lambda_lies_right && vertices_lie_left && mode_0_is_behind;
}

// ---- The limit of the upper ends
// ---------------------------------------------------------------------------

/// The largest eigenvalue at s = 1 and how it moves with s.
struct Leader {
  Algebraic value;
  Algebraic slope;
};

/// Nothing unless the eigenvalue is simple and larger than all others in modulus, and no leading coefficient
/// vanishes at s = 1: then it is a differentiable function of s there, and stays the largest.
std::optional<Leader> leader(const ModeEquation& equation, int variable, const Rational& limit) {
  std::optional<Leader> result;
  std::vector<Algebraic> roots;
  for (const auto& [base, multiplicity] : equation.factors) {
    const Polynomial f = base.substitute(variable, Polynomial(limit));
    const UnivariatePolynomial here(f.substitute(0, Polynomial(1)), eigenvalue_variable);
    if (here.degree() != base.degree(eigenvalue_variable)) return std::nullopt;
    long count = 0;
    for (const RealRoot& root : real_roots(here)) {
      count += root.multiplicity;
      roots.push_back(root.value);
      if (result && !(result->value < root.value)) continue;
      if (root.multiplicity * multiplicity != 1) return std::nullopt;
      const auto at = [&](const Polynomial& g) {
        std::vector<Algebraic> point(max_parameters, Algebraic(0));
        point[0] = Algebraic(1);
        point[eigenvalue_variable] = root.value;
        return g.evaluate<Algebraic>(point);
      };
      result = Leader{root.value, -at(f.derivative(0)) / at(f.derivative(eigenvalue_variable))};
    }
    if (count != here.degree()) return std::nullopt;  // complex roots: none here
  }
  if (!result) return result;
  const auto equal = std::ranges::count(roots, result->value);
  const bool largest = std::ranges::all_of(
      roots, [&](const Algebraic& r) { return r == result->value || abs(r) < result->value; });
  return equal == 1 && largest ? result : std::nullopt;
}

Claim upper_limit(const ClaimHead& head, const MeshScheme<Function>& scheme) {
  const auto turning = leader(turning_modes(scheme), turn_variable, Rational(1));
  const auto invariant = leader(without_one(invariant_modes(scheme)), valence_variable, Rational(0));
  if (!turning || !invariant || !(turning->value == invariant->value) ||
      !(turning->slope < invariant->slope)) {
    throw std::logic_error("mode 0 is not proved to overtake mode 1");
  }
  return settle(head, exact(Rational(1), "implicit differentiation over algebraic numbers"),
                fmt::format("As n grows, the largest eigenvalues of modes 0 and 1 at s = 1 have the same "
                            "limit {}, simple in both modes; their derivatives by s tend to {} = {:.4f} and "
                            "{} = {:.4f}. For every s above 1 and near it, mode 0 thus exceeds mode 1 at all "
                            "large n, whereas at s = 1 the condition holds at every n "
                            "(mesh.catmull-clark.all-valences).",
                            turning->value.to_string(), invariant->slope.to_string(),
                            invariant->slope.to_interval().to_double(), turning->slope.to_string(),
                            turning->slope.to_interval().to_double()));
}

}  // namespace

std::vector<ClaimHead> valence_limit_heads() {
  const std::string limit =
      "The limit, as the valence grows, of the upper end of the interval of s around 1 for which it holds.";
  return {finding("mesh.catmull-clark.all-valences", "jsplines 10",
                  "Catmull-Clark. " + eigenvalue_condition +
                      "Every valence n >= 3: from the factors over Q(cos(2 pi k/n)) and Q(1/n)."),
          finding("mesh.valence-limit.directional.upper", "jsplines 10",
                  directional_scheme + eigenvalue_condition + limit),
          finding("mesh.valence-limit.literal.upper", "jsplines 10",
                  literal_scheme + eigenvalue_condition + limit)};
}

void add_valence_limits(Results& results, std::span<const ClaimHead> heads) {
  results.claims.push_back(settle_statement(
      head(heads, "mesh.catmull-clark.all-valences"), catmull_clark_holds(), "true",
      "lambda is the larger root of 16 x^2 - (10 + 2 c) x + 1, c = cos(2 pi/n); mode 0 has 16 x^2 - (12 - "
      "28/n) x + 1 - 3/n; all others but those of modes k > 1 are 1/8 or less."));
  const Function s = Function::variable(0);
  results.claims.push_back(upper_limit(head(heads, "mesh.valence-limit.directional.upper"), jspline_mesh(s)));
  results.claims.push_back(
      upper_limit(head(heads, "mesh.valence-limit.literal.upper"), jspline_mesh_literal(s)));
}

}  // namespace subdiv
