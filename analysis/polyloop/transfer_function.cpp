#include "analysis/polyloop/transfer_function.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "schemes/algebra/field_polynomial.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

/// |w|^2 as a polynomial in the cosine.
UnivariatePolynomial power_polynomial(const Laurent<Rational>& weights) {
  const UnivariatePolynomial c({Rational(0), Rational(1)});
  const auto constant = [](const Rational& q) { return UnivariatePolynomial(q); };
  return power_at_cosine(map_coefficients(weights, constant), c);
}

template <class R>
R power_of(R x, long n) {
  R result(1);
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = result * x;
    if (n > 1) x = x * x;
  }
  return result;
}

struct Part {
  UnivariatePolynomial power;
  long times;
};

/// The zeros in (-1, 1) of the derivative of the product, apart from its own zeros: those of the sum of n_i
/// h_i' / h_i.
std::vector<Algebraic> inner_extrema(const std::vector<Part>& parts) {
  UnivariatePolynomial sum;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const UnivariatePolynomial slope = parts[i].power.derivative();
    UnivariatePolynomial term = divide(slope, gcd(parts[i].power, slope)).first *
                                UnivariatePolynomial(Rational(static_cast<std::int64_t>(parts[i].times)));
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == i) continue;
      const UnivariatePolynomial& h = parts[j].power;
      term *= divide(h, gcd(h, h.derivative())).first;
    }
    sum += term;
  }
  std::vector<Algebraic> result;
  if (sum.degree() < 1) return result;
  for (RealRoot& root : real_roots(sum)) {
    if (Algebraic(-1) < root.value && root.value < Algebraic(1)) result.push_back(std::move(root.value));
  }
  return result;
}

Interval value_at(const std::vector<Part>& parts, const Algebraic& c, long precision) {
  Interval value(1);
  for (const Part& part : parts)
    value = value * power_of(part.power.evaluate(c.to_interval(precision)), part.times);
  return value;
}

bool few_factors(const std::vector<Part>& parts, const Algebraic& c) {
  constexpr long most = 200;
  long degree = 0;
  for (const Part& part : parts) degree += part.times * std::max(1L, part.power.degree());
  return c.degree() <= 2 && degree <= most;
}

Algebraic exact_value(const std::vector<Part>& parts, const Algebraic& c) {
  Algebraic value(1);
  for (const Part& part : parts) {
    Algebraic h(0);
    for (long i = part.power.degree(); i >= 0; --i) h = h * c + Algebraic(part.power.coefficient(i));
    value = value * power_of(h, part.times);
  }
  return value;
}

/// Whether |w|^2 at a is greater than at b; undecided where neither enclosures nor exact numbers can tell.
Decision exceeds(const std::vector<Part>& parts, const Algebraic& a, const Algebraic& b) {
  constexpr long most = 1024;
  for (long precision = Interval::default_precision; precision <= most; precision *= 2) {
    const Interval at_a = value_at(parts, a, precision);
    const Interval at_b = value_at(parts, b, precision);
    if (certainly_less(at_b, at_a)) return Decision::yes;
    if (certainly_at_most(at_a, at_b)) return Decision::no;
  }
  if (!few_factors(parts, a) || !few_factors(parts, b)) return Decision::undecided;
  return exact_value(parts, a) > exact_value(parts, b) ? Decision::yes : Decision::no;
}

/// The largest of |w|^2 at several cosines that cannot be told apart.
Interval largest_of(const std::vector<Part>& parts, const std::vector<Algebraic>& cosines) {
  constexpr long precision = 2 * Interval::default_precision;
  const Interval first = value_at(parts, cosines.front(), precision);
  Rational lower = first.lower();
  Rational upper = first.upper();
  for (const Algebraic& c : cosines) {
    const Interval value = value_at(parts, c, precision);
    lower = std::max(lower, value.lower());
    upper = std::max(upper, value.upper());
  }
  return Interval::hull(lower, upper);
}

constexpr int cosine_variable = symbol_variable;

/// Signs of 1 - |w|^2 on [-1, 1] at one value of the parameter.
template <OrderedField F>
FieldPolynomial<F> at_parameter(const Polynomial& p, int parameter, const F& x) {
  std::vector<F> coefficients;
  for (const Polynomial& c : p.coefficients_in(cosine_variable))
    coefficients.push_back(specialize(c, parameter, x));
  return FieldPolynomial<F>(std::move(coefficients));
}

/// Distinct zeros in the open interval (-1, 1).
template <OrderedField F>
int inner_zeros(const FieldPolynomial<F>& p) {
  int count = count_roots(p, F(-1), F(1));
  for (const F& end : {F(-1), F(1)}) {
    if (is_zero(p.evaluate(end))) --count;
  }
  return count;
}

template <OrderedField F>
bool positive_somewhere(const FieldPolynomial<F>& p) {
  for (long i = 1;; ++i) {  // one of degree + 1 points is no zero
    const int sign = p.evaluate(F(Rational(i, p.degree() + 3))).sign();
    if (sign != 0) return sign > 0;
  }
}

template <OrderedField F>
bool is_nonnegative(const FieldPolynomial<F>& p) {
  if (p.is_zero()) return true;
  for (const auto& [factor, multiplicity] : square_free_factors(p)) {
    if (multiplicity % 2 == 1 && inner_zeros(factor) > 0) return false;
  }
  return positive_somewhere(p);
}

/// Positive on [-1, 1).
template <OrderedField F>
bool is_positive_before_one(const FieldPolynomial<F>& p) {
  if (p.is_zero() || is_zero(p.evaluate(F(-1))) || inner_zeros(p) > 0) return false;
  return positive_somewhere(p);
}

Polynomial room(const Laurent<Polynomial>& weights) {
  return Polynomial(1) - power_at_cosine(weights, Polynomial::variable(cosine_variable));
}

void append_roots(const Polynomial& p, int parameter, std::vector<Algebraic>& roots) {
  if (!p.is_zero()) append_real_roots(p, parameter, roots);
}

/// Where the set of a condition on the signs of p over [-1, 1] can change.
std::vector<Algebraic> critical_values(const Polynomial& p, int parameter) {
  std::vector<Algebraic> critical;
  if (p.is_zero()) return critical;
  std::vector<Polynomial> factors;
  for (const auto& [factor, multiplicity] : factor(p).factors) factors.push_back(factor);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Polynomial& f = factors[i];
    append_roots(f.substitute(cosine_variable, Polynomial(1)), parameter, critical);
    append_roots(f.substitute(cosine_variable, Polynomial(-1)), parameter, critical);
    if (!f.uses(cosine_variable)) continue;
    if (f.degree(cosine_variable) > 1)
      append_roots(resultant(f, f.derivative(cosine_variable), cosine_variable), parameter, critical);
    for (std::size_t j = 0; j < i; ++j) {
      if (factors[j].uses(cosine_variable))
        append_roots(resultant(f, factors[j], cosine_variable), parameter, critical);
    }
  }
  return critical;
}

template <class Holds>
RealSet solve(const Laurent<Polynomial>& weights, int parameter, const Holds& holds) {
  const Polynomial p = room(weights);
  return solve_by_cells(critical_values(p, parameter), [&](const Algebraic& x) {
    return x.is_rational() ? holds(at_parameter(p, parameter, x.to_rational()))
                           : holds(at_parameter(p, parameter, x));
  });
}

/// A stretch of cosines with bounds of |w|^2.
struct Cell {
  Rational lower;
  Rational upper;
  Interval value;
};

}  // namespace

LargestGain largest_gain(const std::vector<FilterPart>& filters) {
  std::vector<Part> parts;
  for (const FilterPart& filter : filters) parts.push_back({power_polynomial(filter.weights), filter.times});
  Algebraic best(1);
  std::vector<Algebraic> others = inner_extrema(parts);
  std::ranges::sort(others, std::greater<>());
  others.emplace_back(-1);
  std::vector<Algebraic> rivals;
  for (const Algebraic& c : others) {
    const Decision greater = exceeds(parts, c, best);
    if (greater == Decision::undecided) rivals.push_back(c);
    if (greater != Decision::yes) continue;
    best = c;
    std::erase_if(rivals, [&](const Algebraic& r) { return exceeds(parts, r, best) == Decision::no; });
  }
  const std::string how = "zeros of the derivative, isolated";
  if (!rivals.empty()) {
    rivals.push_back(best);
    return {certified(sqrt(largest_of(parts, rivals)), how), std::nullopt};
  }
  if (few_factors(parts, best)) return {exact(sqrt(exact_value(parts, best)), how), best};
  const Interval value = sqrt(value_at(parts, best, 2 * Interval::default_precision));
  return {certified(value, how), best};
}

LargestGain largest_gain(const Laurent<Rational>& weights) {
  return largest_gain(std::vector<FilterPart>{{weights, 1}});
}

Enclosure largest_gain(const std::vector<IntervalFilterPart>& parts) {
  const auto value = [&](const Interval& c) {
    Interval product(1);
    for (const IntervalFilterPart& part : parts) {
      product = product * power_of(power_at_cosine(part.weights, c), part.times);
    }
    return product;
  };
  const auto cell = [&](const Rational& lower, const Rational& upper) {
    return Cell{lower, upper, value(Interval::hull(lower, upper))};
  };
  const auto less = [](const Cell& a, const Cell& b) { return a.value.upper() < b.value.upper(); };
  std::priority_queue<Cell, std::vector<Cell>, decltype(less)> open(less);
  Rational reached = std::max(value(Interval(-1)).lower(), value(Interval(1)).lower());
  open.push(cell(Rational(-1), Rational(1)));
  constexpr int most = 20000;
  const Rational width(1, 1000000);
  Status status = Status::out_of_depth;
  for (int i = 0; i < most; ++i) {
    const Cell top = open.top();
    if (top.value.upper() <= reached * (Rational(1) + width)) {
      status = Status::closed;
      break;
    }
    open.pop();
    const Rational middle = (top.lower + top.upper) / Rational(2);
    reached = std::max(reached, value(Interval(middle)).lower());
    open.push(cell(top.lower, middle));
    open.push(cell(middle, top.upper));
  }
  const Rational upper = std::max(open.top().value.upper(), reached);
  const Interval gain = sqrt(Interval::hull(std::max(reached, Rational(0)), upper));
  Enclosure result = certified(gain, "halving of the cosines");
  result.status = status;
  return result;
}

Decision amplifies(const Enclosure& gain) {
  if (gain.lower > Rational(1)) return Decision::yes;
  return gain.upper <= Rational(1) ? Decision::no : Decision::undecided;
}

RealSet stable_range(const Laurent<Polynomial>& weights, int parameter) {
  return solve(weights, parameter, [](const auto& p) { return is_nonnegative(p); });
}

RealSet damping_range(const Laurent<Polynomial>& weights, int parameter) {
  return solve(weights, parameter, [](const auto& p) { return is_positive_before_one(p); });
}

}  // namespace subdiv
