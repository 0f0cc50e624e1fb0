#include "analysis/adjustable_speed/speed_spectrum.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "analysis/adjustable_speed/speed_matrix.h"
#include "analysis/decision.h"
#include "analysis/sign_on_interval.h"
#include "schemes/algebra/turn.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

// Of the identities: q, D, c; x is x_7. At one valence D is a polynomial in q.
const Function q = Function::variable(0);
const Function s = Function(1) - q;
const Function D = Function::variable(1);
const Function c = Function::variable(2);
const Function x = Function::variable(eigenvalue_variable);

const Function bound(18);  // of E

constexpr int far = 11;  // a valence at which no sector is read from both sides

Polynomial monic_quadratic(const ModeEquation& equation) {
  for (const auto& [factor, multiplicity] : equation.factors) {
    if (factor.degree(eigenvalue_variable) != 2) continue;
    const Polynomial leading = factor.coefficients_in(eigenvalue_variable)[2];
    if (multiplicity != 1 || !leading.is_constant()) break;
    return factor * Polynomial(Rational(1) / leading.constant());
  }
  throw std::logic_error("a mode of adjustable speed has one quadratic factor");
}

/// A polynomial at x_0 = s, x_1, x_2, x_5 and x.
Function value(const Polynomial& p, const Function& first, const Function& second, const Function& turn,
               const Function& at) {
  const std::array<Function, max_parameters> values{s,           first, second,      Function(0),
                                                    Function(0), turn,  Function(0), at};
  return p.evaluate<Function>(values);
}

}  // namespace

SpeedComparison speed_comparison() {
  const SpeedQuadratics quadratics = speed_quadratics();
  const Function one(1);
  const Function beta = Function(18) * s * q * (s * s + q) / D;
  const Function gamma = Function(9) * s * s * q * q / D;
  SpeedComparison result;
  result.P = value(quadratics.invariant, beta, gamma, Function(0), x);
  result.P_mirrored = value(quadratics.invariant, beta, gamma, Function(0), -x);
  result.Q = value(quadratics.turning, Function(0), Function(0), c, x);
  result.E = D * (one - c);
  result.alpha = Function(9) * q * (one + q) + s * (bound - result.E);
  result.a = s * q * result.alpha / D;
  result.b = Function(9) * s * q * q * q * q * (one + q) / D;
  result.G = (bound - result.E) * (bound - result.E) - Function(9) * (one + c) * (one + q) * result.alpha;
  return result;
}

namespace {

Function denominator_at(int valence) {
  return Function(9) + Function(valence - 4) * (Function(1) + q) * (Function(1) + q);
}

/// f with D and c replaced.
Function at(const Function& f, const Function& denominator, const Function& turn) {
  const std::array<Function, max_parameters> values{q,           denominator, turn,        Function(0),
                                                    Function(0), Function(0), Function(0), x};
  return f.evaluate<Function>(values);
}

Interval enclosed_bound() { return Interval(bound.constant()); }

bool positive_inside(const Function& f) { return is_positive(f, open_interval(Rational(0), Rational(1))); }

/// That D stands for what the rules have at valences.
bool weights_have_this_denominator() {
  return std::ranges::all_of(std::array{3, 4, 5, 8, 20}, [](int n) {
    const VertexWeights<Function> weights = vertex_weights(s, n);
    const Function d = denominator_at(n);
    return weights.beta * d == Function(18) * s * q * (s * s + q) &&
           weights.gamma * d == Function(9) * s * s * q * q;
  });
}

/// D over an interval of q.
Interval denominator_at(int valence, const Interval& at_q) {
  const Interval sum = Interval(1) + at_q;
  return Interval(9) + Interval(valence - 4) * sum * sum;
}

/// The set of speeds in (0, 1) with the answer yes. It can only change at roots of the critical polynomials
/// (in x_0 = q), where the question is asked over an enclosure and may stay open: they do not belong to the
/// set then.
RealSet speeds_with(const std::vector<Polynomial>& critical,
                    const std::function<Decision(const Interval& q)>& ask) {
  std::vector<Algebraic> roots;
  for (const Polynomial& p : critical) append_real_roots(p, 0, roots);
  std::vector<Algebraic> ends{Algebraic(0), Algebraic(1)};
  for (const Algebraic& root : roots) {
    if (Algebraic(0) < root && root < Algebraic(1)) ends.push_back(Algebraic(1) - root);
  }
  return solve_by_cells(ends, [&](const Algebraic& speed) {
    if (!(Algebraic(0) < speed && speed < Algebraic(1))) return false;
    const Decision answer = ask(Interval(1) - speed.to_interval());
    if (answer == Decision::undecided && std::ranges::find(ends, speed) == ends.end())
      throw std::logic_error("between critical speeds the answer is open");
    return answer == Decision::yes;
  });
}

/// The polynomial in q that vanishes where one in q and c does for c or a conjugate of it.
Polynomial eliminated(const Function& f, const Algebraic& turn) {
  Polynomial minimal;
  const std::vector<Rational> coefficients = turn.minimal_polynomial();
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    minimal += Polynomial(coefficients[i]) * pow(Polynomial::variable(2), static_cast<unsigned>(i));
  }
  return resultant(f.numerator(), minimal, 2);
}

}  // namespace

SpeedQuadratics speed_quadratics() {
  const Function sigma = Function::variable(0);
  const VertexWeights<Function> free{Function::variable(1), Function::variable(2)};
  const FanMatrix<Function> fan = speed_matrix(sigma, far, free);
  return {monic_quadratic(invariant_mode(fan)), monic_quadratic(turning_modes(fan))};
}

bool identities_hold(const SpeedComparison& k) {
  const Function one(1);
  const Function trace = q * (s * s * (one + c) + Function(2) * q);
  const std::array<Function, max_parameters> at_quotient{q,           D,           c,           Function(0),
                                                         Function(0), Function(0), Function(0), k.b / k.a};
  const Function s4 = s * s * s * s;
  const Function q3 = q * q * q;
  return k.Q == x * x - trace * x + q3 * q && k.P - k.Q == k.a * x - k.b &&
         k.a * q * q - k.b == s * s * q3 * (bound - k.E) / D &&
         k.a * k.a * k.Q.evaluate<Function>(at_quotient) == s4 * q3 * q3 * k.G / (D * D) &&
         trace * trace - Function(4) * q3 * q ==
             q * q * s * s * (one + c) * (s * s * (one + c) + Function(4) * q);
}

bool product_is_small(const SpeedComparison& k, const RationalFunction& denominator) {
  const Function b = at(k.b, denominator, c);
  return positive_inside(b) && positive_inside(Function(2) * q * q * q * q - b);
}

bool mirrored_is_larger(const SpeedComparison& k, const RationalFunction& denominator,
                        const RationalFunction& turn) {
  const Function e = (k.P_mirrored - k.Q).derivative(eigenvalue_variable);
  return k.P_mirrored - k.Q == e * x - k.b && positive_inside(at(e * q * q - k.b, denominator, turn));
}

bool mode_0_is_compared() {
  const SpeedComparison k = speed_comparison();
  const Function least = denominator_at(3);
  if (!weights_have_this_denominator() || !identities_hold(k) || !product_is_small(k, least)) return false;
  // e q^2 - b grows with c, and is affine in 1/D with a negative slope.
  const Function e = (k.P_mirrored - k.Q).derivative(eigenvalue_variable);
  const Function excess = e * q * q - k.b;
  const Function slope = excess.derivative(1) * D * D;  // by D: minus the one in 1/D
  const bool affine = slope.derivative(1).is_zero() && excess.derivative(2).derivative(2).is_zero();
  return affine && positive_inside(slope) && positive_inside(excess.derivative(2)) &&
         mirrored_is_larger(k, Function(9), Function(-1)) &&
         mirrored_is_larger(k, least, fraction<Function>(-1, 2));
}

bool lambda_is_subdominant() {
  if (!mode_0_is_compared()) return false;
  const SpeedComparison k = speed_comparison();
  // Q(1) = 1 - T + q^4 falls with c; at c = 1 it is s^2 (1 + q^2).
  const Function one(1);
  const std::array<Function, max_parameters> at_one{q,           D,           one,         Function(0),
                                                    Function(0), Function(0), Function(0), one};
  if (!(k.Q.evaluate<Function>(at_one) == s * s * (one + q * q))) return false;
  constexpr int bounded_from = 5;
  for (int n = 3; n < bounded_from; ++n) {
    const Interval largest(std::max(9, 4 * n - 7));
    if (!certainly_less(largest * (Interval(1) - cosine_of_turn<Interval>(1, n)), enclosed_bound()))
      return false;
  }
  return certainly_less(Interval(8) * pi() * pi() / Interval(bounded_from), enclosed_bound());
}

RealSet speeds_with_mode_2_next(int valence) {
  constexpr int most = 40;
  if (valence < 5 || valence > most) throw std::invalid_argument("valences from 5 to 40");
  const Algebraic turn = cosine_of_turn<Algebraic>(2, valence);
  const Interval enclosed = cosine_of_turn<Interval>(2, valence);
  const SpeedComparison k = speed_comparison();
  const Function d = denominator_at(valence);
  const auto critical = [&](const Function& f) { return eliminated(at(f, d, c), turn); };
  return speeds_with({critical(k.alpha), critical(bound - k.E), critical(k.G)}, [&](const Interval& at_q) {
    const std::array<Interval, 3> values{at_q, denominator_at(valence, at_q), enclosed};
    const Interval E = k.E.evaluate<Interval>(values);
    const Interval alpha = k.alpha.evaluate<Interval>(values);
    const Interval G = k.G.evaluate<Interval>(values);
    if (certainly_less(E, enclosed_bound()) || (certainly_positive(alpha) && certainly_negative(G)))
      return Decision::yes;
    const bool exceeded = certainly_negative(alpha) || (certainly_positive(alpha) && certainly_positive(G) &&
                                                        certainly_less(enclosed_bound(), E));
    return exceeded ? Decision::no : Decision::undecided;
  });
}

bool mode_2_is_next_from(int first) {
  constexpr int bounded_from = 18;
  if (!mode_0_is_compared()) return false;
  if (!certainly_less(Interval(32) * pi() * pi() / Interval(bounded_from), enclosed_bound())) return false;
  for (int n = first; n < bounded_from; ++n) {
    const RealSet speeds = speeds_with_mode_2_next(n);
    if (speeds.parts.size() != 1) return false;
    const RealInterval& all = speeds.parts[0];
    if (!all.lower || !all.upper || !(*all.lower == Algebraic(0)) || !(*all.upper == Algebraic(1)))
      return false;
  }
  return true;
}

bool mode_2_exceeds_square() {
  const Function sigma = Function::variable(0);
  const Function v = Function::variable(1);
  const Function rest = Function(1) - sigma;
  const Function W = rest + sigma * v;
  const Function lambda = rest * W;
  const Function turn = v * v / W - Function(1);
  const Polynomial Q = speed_quadratics().turning;
  const auto at_mode = [&](const Function& mode_turn, const Function& place) {
    const std::array<Function, max_parameters> values{sigma,       Function(0), Function(0), Function(0),
                                                      Function(0), mode_turn,   Function(0), place};
    return Q.evaluate<Function>(values);
  };
  if (!at_mode(turn, lambda).is_zero()) return false;
  const Function once = v - Function(1);
  const auto least = [](const Function& y) { return y * y + Function(2) * y - Function(1); };
  const Function last = sigma * once * once + least(v);
  const Function expected =
      Function(0) - sigma * sigma * rest * rest * rest * once * once * (Function(1) + rest * rest) * last;
  if (!(at_mode(Function(2) * turn * turn - Function(1), lambda * lambda) == expected)) return false;
  // The last factor is least(v) or more; v^2 < 2 (1 - s + s v) keeps v below 2.
  return is_positive(least(Function::variable(0)), closed_interval(Rational(1, 2), Rational(2)));
}

RealSet speeds_with_next_below_square_at_3() {
  const SpeedComparison k = speed_comparison();
  const Function d = denominator_at(3);
  const Function turn = fraction<Function>(-1, 2);
  const Polynomial Q = at(k.Q, d, turn).numerator();
  const Function square = x * x;
  const auto at_place = [&](const Function& f, const Function& place) {
    const std::array<Function, max_parameters> values{q,           d,           turn,        Function(0),
                                                      Function(0), Function(0), Function(0), place};
    return f.evaluate<Function>(values);
  };
  const Function C = at_place(k.P, Function(0));
  // Positive for both roots of P inside lambda^2 (Jury), for q^3 and for q^4/lambda, the other root of Q.
  const std::array<Function, 6> conditions{at_place(k.P, square), at_place(k.P_mirrored, square),
                                           square * square - C,   square * square + C,
                                           square - q * q * q,    square * x - q * q * q * q};
  std::vector<Polynomial> critical;
  for (const Function& condition : conditions)
    critical.push_back(resultant(condition.numerator(), Q, eigenvalue_variable));
  return speeds_with(critical, [&](const Interval& at_q) {
    const Interval speed = Interval(1) - at_q;
    const Interval half(Rational(1, 2));
    const Interval trace = at_q * (speed * speed * half + Interval(2) * at_q);
    const Interval lambda = (trace + sqrt(trace * trace - Interval(4) * pow(at_q, 4))) * half;
    std::array<Interval, max_parameters> values;
    values[0] = at_q;
    values[eigenvalue_variable] = lambda;
    Decision answer = Decision::yes;
    for (const Function& condition : conditions) {
      const Interval found = condition.evaluate<Interval>(values);
      if (certainly_negative(found)) return Decision::no;
      if (!certainly_positive(found)) answer = Decision::undecided;
    }
    return answer;
  });
}

}  // namespace subdiv
