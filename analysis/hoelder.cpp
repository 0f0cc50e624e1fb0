#include "analysis/hoelder.h"

#include <algorithm>
#include <string>
#include <utility>

#include <flint/fmpz_poly.h>

#include "analysis/jsr/block_radius.h"
#include "analysis/logarithm.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// The largest integer below x.
int integer_below(const Rational& x) {
  const Rational whole = floor(x);
  return static_cast<int>(whole.to_integer()) - (whole == x ? 1 : 0);
}

/// b(1) = 1 makes the sum of the m^k residue sums of the k-th iterate at least 1: rho >= 1/m.
void raise_to_least_radius(JointSpectralRadius& radius, int arity) {
  const Rational least(1, arity);
  radius.value.lower = std::max(radius.value.lower, least);
  radius.value.upper = std::max(radius.value.upper, least);
}

void decide_continuity(Smoothness& result, int most_factors) {
  const Enclosure& exponent = result.exponent;
  const bool first_sum_rule = result.factors > 0;
  result.continuity = first_sum_rule ? std::max(integer_below(exponent.lower), -1) : -1;
  result.continuity_limit =
      most_factors > 0 ? std::clamp(integer_below(exponent.upper), -1, most_factors - 1) : -1;
  if (result.continuity >= 0) {
    result.converges = Decision::yes;
  } else if (result.continuity_limit < 0) {
    result.converges = Decision::no;
  }
}

bool contains_integer(const Enclosure& x) { return floor(x.upper) >= x.lower; }

/// b replaced by the difference symbol of order j: a(z) m^(j-1) / sigma^j = (sigma/m)^(n-j) b.
template <class R>
std::vector<Matrix<R>> divided_difference_matrices(const NormalForm<R>& form, int order) {
  NormalForm<R> divided = form;
  for (int i = form.factors; i > order; --i) {
    divided.b = fraction<R>(1, form.arity) * (smoothing_factor<R>(form.arity) * divided.b);
  }
  divided.b = R(form.arity) * divided.b;
  return transition_matrices(divided);
}

/// Whether the powers of a matrix with spectral radius 1 are unbounded because an eigenvalue that is a root
/// of unity is defective.
bool has_defective_root_of_unity(const Matrix<Rational>& p) {
  for (const auto& [part, multiplicity] : factor(UnivariatePolynomial(characteristic_polynomial(p)))) {
    if (multiplicity < 2) continue;
    fmpz_poly_t integer;
    fmpz_poly_init(integer);
    fmpq_poly_get_numerator(integer, part.raw());
    const bool root_of_unity = fmpz_poly_is_cyclotomic(integer) != 0;
    fmpz_poly_clear(integer);
    if (!root_of_unity) continue;
    Matrix<Rational> value = zero_matrix<Rational>(p.rows(), p.cols());
    for (long i = part.degree(); i >= 0; --i) {
      value = (value * p).eval();
      for (Eigen::Index k = 0; k < p.rows(); ++k) value(k, k) += part.coefficient(i);
    }
    if (null_space(Matrix<Rational>(value * value)).size() > null_space(value).size()) return true;
  }
  return false;
}

bool some_product_grows(const std::vector<Matrix<Rational>>& family) {
  constexpr int longest = 4;
  const auto letters = static_cast<int>(family.size());
  for (Word word = next_lyndon_word({}, letters, longest); !word.empty();
       word = next_lyndon_word(std::move(word), letters, longest)) {
    if (has_defective_root_of_unity(product(family, word))) return true;
  }
  return false;
}

/// Whether the products of a family of joint spectral radius 1 are bounded.
Decision are_bounded(const std::vector<Matrix<Rational>>& family, long precision, const Deadline& deadline) {
  constexpr Eigen::Index largest = 16;
  constexpr std::size_t most_vertices = 120;
  if (family[0].rows() > largest) return Decision::undecided;
  if (some_product_grows(family)) return Decision::no;
  const BlockRadius radius =
      block_radius(matrix_family(family, precision), most_vertices, deadline, Wanted::closed_polytope);
  return radius.closed && radius.exact == Algebraic(1) ? Decision::yes : Decision::undecided;
}

template <class R>
Decision is_attained(const NormalForm<R>& form, const Smoothness& found, long precision,
                     const Deadline& deadline) {
  if (!found.radius.attained || found.converges != Decision::yes) return Decision::undecided;
  if (!contains_integer(found.exponent)) return found.radius.bounded;
  if constexpr (std::is_same_v<R, Rational>) {
    const Rational exponent = found.exponent.lower;
    if (exponent != found.exponent.upper) return Decision::undecided;
    const auto order = static_cast<int>(exponent.to_integer());
    return are_bounded(divided_difference_matrices(form, order), precision, deadline);
  } else {
    return Decision::undecided;
  }
}

template <class R>
Smoothness analyse(const NormalForm<R>& form, const JointSpectralRadiusBudget& budget) {
  const Deadline deadline(budget.seconds);
  Smoothness result;
  result.factors = form.factors;
  result.radius = joint_spectral_radius(transition_matrices(form), budget);
  raise_to_least_radius(result.radius, form.arity);
  result.exponent =
      minus_logarithm(Rational(form.factors - 1), form.arity, 1, result.radius.value, result.radius.exact);
  // With a further factor b = sigma / m c, rho(b) is the larger of 1/m and rho(c) / m: only above 1/m does it
  // tell the exponent.
  int most_factors = form.factors;
  if (result.radius.value.lower == Rational(1, form.arity) && may_have_more_factors(form)) {
    most_factors += form.degree() / (form.arity - 1);
    result.exponent.upper = std::max(result.exponent.upper, Rational(most_factors));
    result.exponent.status = Status::ambiguous;
  }
  decide_continuity(result, most_factors);
  result.attained = is_attained(form, result, budget.precision, deadline);
  return result;
}

}  // namespace

Smoothness smoothness(const NormalForm<Rational>& form, const JointSpectralRadiusBudget& budget) {
  return analyse(form, budget);
}

Smoothness smoothness(const NormalForm<Algebraic>& form, const JointSpectralRadiusBudget& budget) {
  return analyse(form, budget);
}

Smoothness smoothness(const NormalForm<Interval>& form, const JointSpectralRadiusBudget& budget) {
  return analyse(form, budget);
}

Smoothness at_least(const Smoothness& scheme, int degree, int arity) {
  Smoothness result = scheme;
  // Each step of a reduction lowers the degree, and the exponent is at most the number of factors.
  const int most = degree / (arity - 1);
  result.exponent.upper = std::max(result.exponent.upper, Rational(most));
  result.exponent.rigour = Rigour::certified;
  result.exponent.status = Status::ambiguous;
  result.exponent.exact.clear();
  result.continuity_limit = std::max(result.continuity, most - 1);
  result.attained = Decision::undecided;
  if (result.converges == Decision::no) result.converges = Decision::undecided;
  return result;
}

}  // namespace subdiv
