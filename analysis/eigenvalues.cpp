#include "analysis/eigenvalues.h"

#include <algorithm>
#include <stdexcept>

#include <acb_poly.h>

#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// By decreasing modulus, then decreasing real part, then decreasing imaginary part; overlapping enclosures
/// count as equal.
bool comes_before(const Eigenvalue& a, const Eigenvalue& b) {
  const auto order = [](const Interval& x, const Interval& y) {
    return x.overlaps(y) ? 0 : (certainly_less(y, x) ? -1 : 1);
  };
  const int by_modulus = order(a.modulus(), b.modulus());
  if (by_modulus != 0) return by_modulus < 0;
  const int by_real = order(a.real, b.real);
  return by_real != 0 ? by_real < 0 : order(a.imaginary, b.imaginary) < 0;
}

Eigenvalue exact_eigenvalue(const Algebraic& x, int multiplicity) {
  return {x, x.to_interval(), Interval(0), multiplicity};
}

/// Complex balls that isolate all roots of a square-free polynomial with real coefficients; real roots are
/// marked.
class RootFinder {
 public:
  explicit RootFinder(const FieldPolynomial<Algebraic>& p)
      : source_(p), count_(p.degree()), roots_(_acb_vec_init(count_)) {
    acb_poly_init(poly_);
  }
  RootFinder(const RootFinder&) = delete;
  RootFinder& operator=(const RootFinder&) = delete;
  ~RootFinder() {
    acb_poly_clear(poly_);
    _acb_vec_clear(roots_, count_);
  }

  [[nodiscard]] std::vector<Eigenvalue> find(int multiplicity) {
    for (long precision = 2 * Interval::default_precision;; precision *= 2) {
      load(precision);
      if (acb_poly_find_roots(roots_, poly_, nullptr, 0, precision) != count_) continue;
      if (acb_poly_validate_real_roots(roots_, poly_, precision) == 0) continue;
      std::vector<Eigenvalue> result;
      for (long i = 0; i < count_; ++i) {
        Eigenvalue root{std::nullopt, Interval(0).with_precision(precision), Interval(0), multiplicity};
        arb_set(root.real.raw(), acb_realref(roots_ + i));
        if (arb_contains_zero(acb_imagref(roots_ + i)) == 0) {
          root.imaginary = Interval(0).with_precision(precision);
          arb_set(root.imaginary.raw(), acb_imagref(roots_ + i));
        }
        result.push_back(std::move(root));
      }
      return result;
    }
  }

 private:
  void load(long precision) {
    for (long i = 0; i <= count_; ++i) {
      const Interval c = source_.coefficients()[static_cast<std::size_t>(i)].to_interval(precision);
      acb_t value;
      acb_init(value);
      acb_set_arb(value, c.raw());
      acb_poly_set_coeff_acb(poly_, i, value);
      acb_clear(value);
    }
  }

  const FieldPolynomial<Algebraic>& source_;
  long count_;
  acb_ptr roots_;
  acb_poly_t poly_;
};

/// The roots of a square-free polynomial of degree 1, or of degree 2 with real roots, in closed form.
std::vector<Algebraic> exact_roots(const FieldPolynomial<Algebraic>& p) {
  const std::vector<Algebraic>& c = p.coefficients();
  if (p.degree() == 1) return {-c[0] / c[1]};
  if (p.degree() != 2) return {};
  const Algebraic discriminant = c[1] * c[1] - Algebraic(4) * c[0] * c[2];
  if (discriminant.sign() < 0) return {};
  const Algebraic twice = Algebraic(2) * c[2];
  return {(-c[1] + sqrt(discriminant)) / twice, (-c[1] - sqrt(discriminant)) / twice};
}

/// Appends the roots of a square-free factor: rational ones are recognised in their enclosures and verified
/// exactly.
void append_roots(const FieldPolynomial<Algebraic>& factor, int multiplicity,
                  std::vector<Eigenvalue>& result) {
  FieldPolynomial<Algebraic> rest = factor;
  for (const Eigenvalue& root : RootFinder(factor).find(multiplicity)) {
    if (!root.is_real()) continue;
    const Algebraic candidate(simplest_between(root.real.lower(), root.real.upper()));
    if (!factor.evaluate(candidate).is_zero()) continue;
    result.push_back(exact_eigenvalue(candidate, multiplicity));
    rest = divide(rest, FieldPolynomial<Algebraic>({-candidate, Algebraic(1)})).first;
  }
  const std::vector<Algebraic> closed = exact_roots(rest);
  for (const Algebraic& root : closed) result.push_back(exact_eigenvalue(root, multiplicity));
  if (closed.empty() && rest.degree() > 0) {
    for (Eigenvalue& root : RootFinder(rest).find(multiplicity)) result.push_back(std::move(root));
  }
}

void sort_by_modulus(std::vector<Eigenvalue>& spectrum) {
  std::stable_sort(spectrum.begin(), spectrum.end(),
                   [](const Eigenvalue& a, const Eigenvalue& b) { return comes_before(a, b); });
}

Rational absolute(const RationalFunction& constant) { return abs(constant.constant()); }

bool comes_before(const std::pair<RationalFunction, int>& a, const std::pair<RationalFunction, int>& b) {
  if (a.first.is_constant() != b.first.is_constant()) return a.first.is_constant();
  if (!a.first.is_constant()) return a.first.to_string() < b.first.to_string();
  if (absolute(a.first) != absolute(b.first)) return absolute(a.first) > absolute(b.first);
  return a.first.constant() > b.first.constant();
}

Polynomial least_common_multiple(const Polynomial& a, const Polynomial& b) {
  return (RationalFunction(a) / RationalFunction(b)).numerator() * b;
}

std::string with_multiplicity(const std::string& text, int multiplicity) {
  return multiplicity == 1 ? text : text + " (" + std::to_string(multiplicity) + ")";
}

}  // namespace

Interval Eigenvalue::modulus() const {
  return is_real() ? abs(real) : sqrt(real * real + imaginary * imaginary);
}

std::string Eigenvalue::to_string(int digits) const {
  if (exact) return exact->to_string();
  std::string text = to_significant(real.midpoint(), digits);
  if (is_real()) return text;
  const Rational height = imaginary.midpoint();
  return text + (height.sign() < 0 ? "-" : "+") + to_significant(abs(height), digits) + "i";
}

std::vector<Eigenvalue> eigenvalues(const Matrix<Rational>& matrix) {
  const UnivariatePolynomial p(characteristic_polynomial(matrix));
  std::vector<Eigenvalue> result;
  for (const RealRoot& root : real_roots(p))
    result.push_back(exact_eigenvalue(root.value, root.multiplicity));
  for (const ComplexRoot& root : complex_roots(p)) {
    if (!root.imaginary.is_exactly_zero()) {
      result.push_back({std::nullopt, root.real, root.imaginary, root.multiplicity});
    }
  }
  sort_by_modulus(result);
  return result;
}

std::vector<Eigenvalue> eigenvalues(const Matrix<Algebraic>& matrix) {
  const auto end = matrix.data() + matrix.size();
  if (std::all_of(matrix.data(), end, [](const Algebraic& x) { return x.is_rational(); })) {
    return eigenvalues(
        Matrix<Rational>(matrix.unaryExpr([](const Algebraic& x) { return x.to_rational(); })));
  }
  const FieldPolynomial<Algebraic> p(characteristic_polynomial(matrix));
  std::vector<Eigenvalue> result;
  for (const auto& [factor, multiplicity] : square_free_factors(p)) {
    append_roots(factor, multiplicity, result);
  }
  sort_by_modulus(result);
  return result;
}

Polynomial characteristic_equation(const Matrix<RationalFunction>& matrix) {
  const std::vector<RationalFunction> coefficients = characteristic_polynomial(matrix);
  Polynomial denominator(1);
  for (const RationalFunction& c : coefficients)
    denominator = least_common_multiple(denominator, c.denominator());
  Polynomial result;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i].numerator().uses(eigenvalue_variable)) {
      throw std::domain_error("the variable of eigenvalues occurs in the matrix");
    }
    const RationalFunction c = coefficients[i] * RationalFunction(denominator);
    const Polynomial integral = c.numerator() * Polynomial(Rational(1) / c.denominator().constant());
    result += integral * pow(Polynomial::variable(eigenvalue_variable), static_cast<unsigned>(i));
  }
  return result;
}

ParametricSpectrum eigenvalues(const Matrix<RationalFunction>& matrix) {
  ParametricSpectrum result;
  for (const auto& [base, multiplicity] : factor(characteristic_equation(matrix)).factors) {
    const long degree = base.degree(eigenvalue_variable);
    if (degree == 1) {
      const std::vector<Polynomial> c = base.coefficients_in(eigenvalue_variable);
      result.values.emplace_back(-RationalFunction(c[0]) / RationalFunction(c[1]), multiplicity);
    } else if (degree > 1) {
      result.factors.emplace_back(base, multiplicity);
    }
  }
  std::sort(result.values.begin(), result.values.end(),
            [](const auto& a, const auto& b) { return comes_before(a, b); });
  return result;
}

std::string to_string(const ParametricSpectrum& spectrum, std::span<const std::string> names) {
  std::string text;
  const auto append = [&text](const std::string& item) { text += text.empty() ? item : ", " + item; };
  for (const auto& [value, multiplicity] : spectrum.values) {
    append(with_multiplicity(value.to_string(names), multiplicity));
  }
  for (const auto& [factor, multiplicity] : spectrum.factors) {
    append(with_multiplicity("roots of " + factor.to_string(names), multiplicity));
  }
  return text;
}

}  // namespace subdiv
