#include "analysis/jsr/leading_vectors.h"

#include <algorithm>
#include <utility>

#include <Eigen/Eigenvalues>
#include <arb_fmpz_poly.h>

#include "analysis/jsr/leading_eigenpairs.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// Eigenvalues of a modulus so close to the largest count as equal to it.
constexpr double same_modulus = 1e-9;
/// The same for rational eigenvalues, whose exact vectors serve even where floating point sees them badly.
constexpr double similar_modulus = 1e-6;
/// Exact characteristic polynomials are for small matrices.
constexpr Eigen::Index largest_exact = 20;
/// Degree of an algebraic number that is still worth having, before and after the root of the word's length.
constexpr long largest_factor = 6;
constexpr long largest_degree = 32;

Interval root(const Interval& x, std::size_t k) {
  Interval result(x);
  arb_root_ui(result.raw(), x.raw(), k, x.working_precision());
  return result;
}

BallMatrix ball_product(const AdaptedFamily& adapted, const Word& word) {
  BallMatrix result = adapted.balls[static_cast<std::size_t>(word[0])];
  for (std::size_t i = 1; i < word.size(); ++i) {
    result = multiply(adapted.balls[static_cast<std::size_t>(word[i])], result, adapted.precision);
  }
  return result;
}

BallMatrix to_ball(const Vector<Rational>& v, long precision) {
  BallMatrix result(v.size(), 1);
  for (Eigen::Index i = 0; i < v.size(); ++i) acb_set_fmpq(result.at(i, 0), v(i).raw(), precision);
  return result;
}

UnivariatePolynomial exact_polynomial(const Matrix<Rational>& matrix) {
  return UnivariatePolynomial(characteristic_polynomial(matrix));
}

Eigen::Index largest_entry(const Vector<Rational>& v) {
  Eigen::Index largest = 0;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    if (abs(v(i)) > abs(v(largest))) largest = i;
  }
  return largest;
}

template <class R>
Vector<R> divided(Vector<R> v, Eigen::Index by) {
  const R divisor = v(by);
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = v(i) / divisor;
  return v;
}

/// Null vectors of P - lambda for the rational eigenvalues within the tolerance of the largest modulus.
std::vector<LeadingVector> rational_vectors(const MatrixFamily& family, const AdaptedFamily& adapted,
                                            const Word& word, const Rational& modulus) {
  std::vector<LeadingVector> result;
  const Matrix<Rational> p = product(family.exact, word);
  const BallMatrix basis(Eigen::MatrixXcd(adapted.basis.cast<std::complex<double>>()));
  for (const auto& [factor, multiplicity] : factor(exact_polynomial(p))) {
    if (factor.degree() != 1) continue;
    const Rational lambda = -factor.coefficient(0) / factor.coefficient(1);
    if (abs(lambda) < modulus * (Rational(1) - Rational::from_double(similar_modulus))) continue;
    Matrix<Rational> shifted = p;
    for (Eigen::Index i = 0; i < p.rows(); ++i) shifted(i, i) -= lambda;
    for (const Vector<Rational>& v : null_space(shifted)) {
      LeadingVector leading;
      leading.word = word;
      leading.eigenvalue = BallMatrix(1, 1);
      acb_set_fmpq(leading.eigenvalue.at(0, 0), lambda.raw(), family.precision);
      leading.radius = root(Interval(abs(lambda), family.precision), word.size());
      leading.unit = largest_entry(v);
      leading.rational = divided(v, leading.unit);
      if (auto x = solve(basis, to_ball(*leading.rational, family.precision), family.precision)) {
        leading.vector = std::move(*x);
        result.push_back(std::move(leading));
      }
    }
  }
  return result;
}

/// Divides by the entry that is largest in the family's own coordinates, and tells its index.
Eigen::Index normalise(const AdaptedFamily& adapted, BallMatrix& vector) {
  const BallMatrix basis(Eigen::MatrixXcd(adapted.basis.cast<std::complex<double>>()));
  const BallMatrix own = multiply(basis, vector, adapted.precision);
  const Eigen::MatrixXcd middle = own.midpoints();
  // Of entries as good as equal the first, so that the choice does not hang on rounding errors.
  const double largest = middle.cwiseAbs().maxCoeff();
  long index = 0;
  while (std::abs(middle(index, 0)) < largest * (1 - same_modulus)) ++index;
  for (long i = 0; i < vector.rows(); ++i) {
    acb_div(vector.at(i, 0), vector.at(i, 0), own.at(index, 0), adapted.precision);
  }
  return index;
}

/// The primitive integer polynomial with the roots of p.
class IntegerPolynomial {
 public:
  explicit IntegerPolynomial(const UnivariatePolynomial& p) {
    fmpz_poly_init(value_);
    fmpq_poly_get_numerator(value_, p.raw());
  }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }
  [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }
  [[nodiscard]] bool may_vanish_at(acb_srcptr x, long precision) const {
    acb_t y;
    acb_init(y);
    arb_fmpz_poly_evaluate_acb(y, value_, x, precision);
    const bool result = acb_contains_zero(y) != 0;
    acb_clear(y);
    return result;
  }

 private:
  fmpz_poly_t value_;
};

/// All roots of an irreducible polynomial.
std::vector<Algebraic> complex_algebraic_roots(const IntegerPolynomial& p) {
  std::vector<qqbar_struct> raw(static_cast<std::size_t>(fmpz_poly_degree(p.get())));
  for (qqbar_struct& r : raw) qqbar_init(&r);
  constexpr int known_irreducible = 1;
  qqbar_roots_fmpz_poly(raw.data(), p.get(), known_irreducible);
  std::vector<Algebraic> result(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    qqbar_swap(result[i].raw(), &raw[i]);
    qqbar_clear(&raw[i]);
  }
  return result;
}

/// |x| for the root x of an irreducible polynomial that a ball isolates; nothing when it does not.
std::optional<Algebraic> modulus_of_root(const IntegerPolynomial& p, acb_srcptr ball) {
  acb_t conjugate;
  acb_init(conjugate);
  acb_conj(conjugate, ball);
  const std::vector<Algebraic> roots = complex_algebraic_roots(p);
  std::vector<Algebraic> inside;
  std::vector<Algebraic> opposite;
  for (const Algebraic& r : roots) {
    if (acb_overlaps(&r.raw()->enclosure, ball) != 0) inside.push_back(r);
    if (acb_overlaps(&r.raw()->enclosure, conjugate) != 0) opposite.push_back(r);
  }
  acb_clear(conjugate);
  if (inside.size() != 1 || opposite.size() != 1) return std::nullopt;
  if (acb_is_real(ball) != 0) return abs(inside[0]);
  return sqrt(inside[0] * opposite[0]);
}

}  // namespace

std::vector<LeadingVector> leading_vectors(const MatrixFamily& family, const AdaptedFamily& adapted,
                                           const Word& word) {
  const BallMatrix p = ball_product(adapted, word);
  const Eigen::VectorXcd approximate = p.midpoints().eigenvalues();
  const double largest = approximate.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return {};
  std::vector<LeadingVector> result;
  if (!family.exact.empty() && family.dimension() <= largest_exact) {
    result = rational_vectors(family, adapted, word, Rational::from_double(largest));
  }
  for (Eigenpair& pair : leading_eigenpairs(p, same_modulus, family.precision)) {
    const bool known = std::any_of(result.begin(), result.end(), [&](const LeadingVector& v) {
      return acb_overlaps(v.eigenvalue.at(0, 0), pair.value.at(0, 0)) != 0;
    });
    if (known) continue;
    const Eigen::Index unit = normalise(adapted, pair.vector);
    const Interval size = modulus(pair.value.at(0, 0), family.precision);
    if (!pair.vector.is_finite() || !certainly_positive(size)) continue;
    result.push_back(
        {word, std::move(pair.value), root(size, word.size()), std::move(pair.vector), unit, {}});
  }
  return result;
}

std::optional<Algebraic> exact_radius(const MatrixFamily& family, const LeadingVector& leading) {
  if (family.exact.empty() || family.dimension() > largest_exact) return std::nullopt;
  const acb_srcptr ball = leading.eigenvalue.at(0, 0);
  std::optional<IntegerPolynomial> candidate;
  for (const auto& [part, multiplicity] : factor(exact_polynomial(product(family.exact, leading.word)))) {
    if (!IntegerPolynomial(part).may_vanish_at(ball, family.precision)) continue;
    if (candidate) return std::nullopt;
    candidate.emplace(part);
  }
  if (!candidate || fmpz_poly_degree(candidate->get()) > largest_factor) return std::nullopt;
  const std::optional<Algebraic> modulus = modulus_of_root(*candidate, ball);
  if (!modulus || modulus->degree() * static_cast<long>(leading.word.size()) > largest_degree)
    return std::nullopt;
  Algebraic result;
  qqbar_root_ui(result.raw(), modulus->raw(), leading.word.size());
  return result;
}

std::optional<Vector<FieldElement>> exact_vector(const MatrixFamily& family, const LeadingVector& leading,
                                                 const std::shared_ptr<const NumberField>& radius) {
  const auto in_field = [](const auto& a) {
    return a.unaryExpr([](const Rational& q) { return FieldElement(q); });
  };
  if (leading.rational) return Vector<FieldElement>(in_field(*leading.rational));
  if (!leading.is_real()) return std::nullopt;
  const FieldElement generator = FieldElement::generator(radius);
  FieldElement lambda(arb_is_negative(acb_realref(leading.eigenvalue.at(0, 0))) != 0 ? -1 : 1);
  for (std::size_t i = 0; i < leading.word.size(); ++i) lambda *= generator;
  Matrix<FieldElement> shifted = in_field(product(family.exact, leading.word));
  for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted(i, i) -= lambda;
  const std::vector<Vector<FieldElement>> null = null_space(shifted);
  if (null.size() != 1 || null[0](leading.unit).is_zero()) return std::nullopt;
  return divided(null[0], leading.unit);
}

}  // namespace subdiv
