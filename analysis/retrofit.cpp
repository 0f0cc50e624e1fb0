#include "analysis/retrofit.h"

#include <algorithm>

#include "schemes/algebra/field_polynomial.h"
#include "schemes/algebra/specialize.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// The variable that stands for cos w.
constexpr int cosine_variable = symbol_variable;

/// |p(e^{iw})|^2 as a polynomial in cos w.
template <class R>
R power_spectrum(const Laurent<R>& p, const R& cosine) {
  return symbol_at_cosine(p * reverse(p), cosine);
}

/// I - L.
template <class R>
Laurent<R> iteration(const Laurent<R>& limit_mask) {
  return Laurent<R>(1) - limit_mask;
}

/// A function of the parameter and the cosine, ready for questions about its sign.
struct CosineFunction {
  Polynomial numerator;
  Polynomial denominator;           // of the parameter alone; vanishes at every real pole of the mask
  std::vector<Polynomial> factors;  // irreducible, of the numerator
  int parameter;
};

CosineFunction make_cosine_function(const RationalFunction& f, int parameter) {
  CosineFunction result{f.numerator(), f.denominator(), {}, parameter};
  if (f.is_zero()) return result;
  for (const auto& [base, multiplicity] : factor(f.numerator()).factors) result.factors.push_back(base);
  return result;
}

std::vector<Algebraic> poles(const CosineFunction& f) {
  std::vector<Algebraic> result;
  append_real_roots(f.denominator, f.parameter, result);
  return result;
}

/// 1 - |1 - L|^2: positive where the iteration shrinks a frequency.
CosineFunction shrinking(const Laurent<RationalFunction>& limit_mask, int parameter) {
  const RationalFunction cosine = RationalFunction::variable(cosine_variable);
  return make_cosine_function(RationalFunction(1) - power_spectrum(iteration(limit_mask), cosine), parameter);
}

/// |L|^2: positive where a frequency can be solved for.
CosineFunction solvable(const Laurent<RationalFunction>& limit_mask, int parameter) {
  const RationalFunction cosine = RationalFunction::variable(cosine_variable);
  return make_cosine_function(power_spectrum(limit_mask, cosine), parameter);
}

template <OrderedField F>
FieldPolynomial<F> in_cosine(const Polynomial& p, int parameter, const F& x) {
  std::vector<F> coefficients;
  for (const Polynomial& c : p.coefficients_in(cosine_variable))
    coefficients.push_back(specialize(c, parameter, x));
  return FieldPolynomial<F>(std::move(coefficients));
}

/// f > 0 for all cosines in [-1, 1] at one value of the parameter.
template <OrderedField F>
bool positive_at(const CosineFunction& f, const F& x) {
  const int below = specialize(f.denominator, f.parameter, x).sign();
  const FieldPolynomial<F> above = in_cosine(f.numerator, f.parameter, x);
  if (above.evaluate(F(0)).sign() * below <= 0) return false;
  return std::none_of(f.factors.begin(), f.factors.end(), [&](const Polynomial& factor) {
    return count_roots(in_cosine(factor, f.parameter, x), F(-1), F(1)) > 0;
  });
}

RealSet positive_everywhere(const CosineFunction& f) {
  std::vector<Algebraic> critical = poles(f);
  for (const Polynomial& factor : f.factors) {
    // A root enters [-1, 1] through an end, or as a double root.
    append_real_roots(factor.substitute(cosine_variable, Polynomial(1)), f.parameter, critical);
    append_real_roots(factor.substitute(cosine_variable, Polynomial(-1)), f.parameter, critical);
    if (factor.degree(cosine_variable) > 1) {
      const Polynomial both = resultant(factor, factor.derivative(cosine_variable), cosine_variable);
      append_real_roots(both, f.parameter, critical);
    }
  }
  return solve_by_cells(std::move(critical), [&](const Algebraic& x) {
    return x.is_rational() ? positive_at(f, x.to_rational()) : positive_at(f, x);
  });
}

/// T_n(c) - 1 without repeated roots: the roots are the cosines of 2 pi k / n.
UnivariatePolynomial loop_polynomial(int n) {
  if (n < 1) throw std::domain_error("a closed loop has at least one point");
  const UnivariatePolynomial x({Rational(0), Rational(1)});
  UnivariatePolynomial before(1);
  UnivariatePolynomial current = x;
  for (int k = 1; k < n; ++k) {
    UnivariatePolynomial next = UnivariatePolynomial(2) * x * current - before;
    before = std::move(current);
    current = std::move(next);
  }
  const UnivariatePolynomial p = current - UnivariatePolynomial(1);
  return divide(p, gcd(p, p.derivative())).first;
}

std::vector<Algebraic> loop_cosines(int n) {
  std::vector<Algebraic> result;
  for (RealRoot& root : real_roots(loop_polynomial(n))) result.push_back(std::move(root.value));
  return result;
}

/// The parameter values at which f vanishes at a frequency of the loop: roots of resultants.
std::vector<Algebraic> zeros_on_loop(const CosineFunction& f, int n) {
  const UnivariatePolynomial frequencies = loop_polynomial(n);
  Polynomial in_c;
  for (long i = 0; i <= frequencies.degree(); ++i) {
    in_c += Polynomial(frequencies.coefficient(i)) *
            pow(Polynomial::variable(cosine_variable), static_cast<unsigned>(i));
  }
  std::vector<Algebraic> result;
  for (const Polynomial& factor : f.factors) {
    append_real_roots(factor.uses(cosine_variable) ? resultant(factor, in_c, cosine_variable) : factor,
                      f.parameter, result);
  }
  return result;
}

template <class R>
R evaluate(const UnivariatePolynomial& p, const R& x) {
  R value(0);
  for (long i = p.degree(); i >= 0; --i) value = value * x + R(p.coefficient(i));
  return value;
}

/// The sign of p(x), decided by enclosures and, for zero, by divisibility by the minimal polynomial.
int sign_at(const UnivariatePolynomial& p, const Algebraic& x) {
  if (divide(p, UnivariatePolynomial(x.minimal_polynomial())).second.is_zero()) return 0;
  for (long precision = Interval::default_precision;; precision *= 2) {
    const Interval value = p.evaluate(x.to_interval(precision));
    if (!value.contains_zero()) return certainly_positive(value) ? 1 : -1;
  }
}

/// The largest |1 - L| over some cosines, as a function of the cosine.
class Modulus {
 public:
  explicit Modulus(const Laurent<Rational>& limit_mask) : symmetric_(limit_mask == reverse(limit_mask)) {
    const UnivariatePolynomial x({Rational(0), Rational(1)});
    const auto error =
        map_coefficients(iteration(limit_mask), [](const Rational& q) { return UnivariatePolynomial(q); });
    value_ = symmetric_ ? symbol_at_cosine(error, x) : power_spectrum(error, x);
  }
  [[nodiscard]] Algebraic largest(const std::vector<Algebraic>& cosines) const {
    Algebraic result(0);
    for (const Algebraic& c : cosines) {
      const Algebraic size = abs(evaluate(value_, c));
      if (result < size) result = size;
    }
    return symmetric_ ? result : sqrt(result);
  }
  /// The ends of [-1, 1] and the stationary points within.
  [[nodiscard]] std::vector<Algebraic> candidates() const {
    std::vector<Algebraic> result{Algebraic(-1), Algebraic(1)};
    if (value_.degree() < 2) return result;
    for (RealRoot& root : real_roots(value_.derivative())) {
      if (abs(root.value) < Algebraic(1)) result.push_back(std::move(root.value));
    }
    return result;
  }

 private:
  bool symmetric_;
  UnivariatePolynomial value_;  // 1 - L for a symmetric mask, else its squared modulus
};

}  // namespace

RealSet retrofit_range(const Laurent<RationalFunction>& limit_mask, int parameter) {
  return positive_everywhere(shrinking(limit_mask, parameter));
}

RealSet solvable_range(const Laurent<RationalFunction>& limit_mask, int parameter) {
  return positive_everywhere(solvable(limit_mask, parameter));
}

RealSet alternation_dominates(const Laurent<RationalFunction>& limit_mask, int parameter) {
  const RationalFunction cosine = RationalFunction::variable(cosine_variable);
  const Laurent<RationalFunction> error = iteration(limit_mask);
  const RationalFunction lead = power_spectrum(error, RationalFunction(-1)) - power_spectrum(error, cosine);
  return positive_everywhere(make_cosine_function(lead / (cosine + RationalFunction(1)), parameter));
}

RealSet retrofit_range_of_loops(const Laurent<RationalFunction>& limit_mask, int n, int parameter) {
  const CosineFunction f = shrinking(limit_mask, parameter);
  const std::vector<Algebraic> cosines = loop_cosines(n);
  std::vector<Algebraic> critical = zeros_on_loop(f, n);
  append_real_roots(f.denominator, parameter, critical);
  return solve_by_cells(std::move(critical), [&](const Algebraic& x) {
    if (!x.is_rational()) return false;  // irrational: critical, some frequency does not shrink
    const Rational value = x.to_rational();
    const int below = specialize(f.denominator, parameter, value).sign();
    const UnivariatePolynomial above(in_cosine(f.numerator, parameter, value).coefficients());
    return std::all_of(cosines.begin(), cosines.end(),
                       [&](const Algebraic& c) { return sign_at(above, c) * below > 0; });
  });
}

std::vector<Algebraic> singular_for_loops(const Laurent<RationalFunction>& limit_mask, int n, int parameter) {
  const CosineFunction f = solvable(limit_mask, parameter);
  std::vector<Algebraic> zeros = zeros_on_loop(f, n);
  const std::vector<Algebraic> excluded = poles(f);
  std::erase_if(zeros, [&](const Algebraic& x) {
    return std::find(excluded.begin(), excluded.end(), x) != excluded.end();
  });
  std::sort(zeros.begin(), zeros.end());
  zeros.erase(std::unique(zeros.begin(), zeros.end()), zeros.end());
  return zeros;
}

Algebraic contraction_rate(const Laurent<Rational>& limit_mask) {
  const Modulus modulus(limit_mask);
  return modulus.largest(modulus.candidates());
}

Algebraic contraction_rate_of_loops(const Laurent<Rational>& limit_mask, int n) {
  return Modulus(limit_mask).largest(loop_cosines(n));
}

}  // namespace subdiv
