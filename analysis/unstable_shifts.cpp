#include "analysis/unstable_shifts.h"

#include <cstdint>
#include <numeric>

#include <flint/fmpz_poly.h>

#include "analysis/jsr/ball_matrix.h"

namespace subdiv {
namespace {

/// Cycles of more roots than this are not enumerated: there are about m^k / k of length k.
constexpr int longest_cycle = 11;

/// Whether two polynomials (coefficients of z^0, z^1, ..) certainly have no common root: their Sylvester
/// matrix is regular.
bool certainly_coprime(const std::vector<Interval>& p, const std::vector<Interval>& q) {
  const auto rows = static_cast<long>(p.size() + q.size()) - 2;
  if (rows < 0) return false;
  BallMatrix sylvester(rows, rows);
  for (long i = 0; i + 1 < static_cast<long>(q.size()); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j)
      acb_set_arb(sylvester.at(i, i + static_cast<long>(j)), p[j].raw());
  }
  for (long i = 0; i + 1 < static_cast<long>(p.size()); ++i) {
    const long row = i + static_cast<long>(q.size()) - 1;
    for (std::size_t j = 0; j < q.size(); ++j)
      acb_set_arb(sylvester.at(row, i + static_cast<long>(j)), q[j].raw());
  }
  acb_t determinant;
  acb_init(determinant);
  acb_mat_det(determinant, sylvester.raw(), Interval::default_precision);
  const bool regular = acb_contains_zero(determinant) == 0;
  acb_clear(determinant);
  return regular;
}

/// b at e^(2 pi i numerator / denominator).
bool may_vanish(const std::vector<Interval>& b, std::int64_t numerator, std::int64_t denominator) {
  constexpr long precision = Interval::default_precision;
  acb_t root;
  acb_t value;
  acb_init(root);
  acb_init(value);
  arb_set_si(acb_realref(root), 2 * numerator);
  arb_div_si(acb_realref(root), acb_realref(root), denominator, precision);
  acb_exp_pi_i(root, root, precision);
  for (std::size_t i = b.size(); i-- > 0;) {
    acb_mul(value, value, root, precision);
    acb_add_arb(value, value, b[i].raw(), precision);
  }
  const bool result = acb_contains_zero(value) != 0;
  acb_clear(root);
  acb_clear(value);
  return result;
}

bool may_vanish_on_a_set_of_roots(const Laurent<Interval>& b, int arity) {
  std::vector<std::vector<Interval>> parts;
  for (int r = 0; r < arity; ++r) {
    const Laurent<Interval> part = residue_class(b, r, arity);
    if (part.is_zero()) continue;
    std::vector<Interval> coefficients;
    for (int i = 0; i <= part.last(); ++i) coefficients.push_back(part[i]);
    parts.push_back(std::move(coefficients));
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (certainly_coprime(parts[i], parts[j])) return false;
    }
  }
  return true;
}

/// On a cycle of length k: w = e^(2 pi i e / (m^k - 1)); one of the zeros that it asks for is w e^(2 pi i /
/// m).
bool may_vanish_on_a_cycle(const Laurent<Interval>& b, int arity) {
  std::vector<Interval> reversed(b.coefficients().rbegin(), b.coefficients().rend());
  if (certainly_coprime(b.coefficients(), reversed)) return false;  // no roots on the unit circle
  const int longest = (b.size() - 1) / (arity - 1);
  if (longest > longest_cycle) return true;
  std::int64_t power = 1;
  for (int k = 1; k <= longest; ++k) {
    power *= arity;
    const std::int64_t order = power - 1;
    for (std::int64_t e = 1; e < order; ++e) {
      if (may_vanish(b.coefficients(), e * arity + order, order * arity)) return true;
    }
  }
  return false;
}

int totient(int n) {
  int result = n;
  for (int p = 2; p * p <= n; ++p) {
    if (n % p != 0) continue;
    while (n % p == 0) n /= p;
    result -= result / p;
  }
  return n > 1 ? result - result / n : result;
}

}  // namespace

Laurent<Rational> cyclotomic_polynomial(int d) {
  fmpz_poly_t phi;
  fmpz_poly_init(phi);
  fmpz_poly_cyclotomic(phi, static_cast<ulong>(d));
  std::vector<Rational> coefficients;
  for (long i = 0; i < fmpz_poly_length(phi); ++i) coefficients.emplace_back(fmpz_poly_get_coeff_si(phi, i));
  fmpz_poly_clear(phi);
  return {0, std::move(coefficients)};
}

std::vector<int> cycle_orders(int arity, int degree) {
  std::vector<int> result;
  // phi(d) >= sqrt(d / 2).
  const int most = degree / (arity - 1);
  for (int d = 2; d <= 2 * most * most; ++d) {
    if (std::gcd(d, arity) == 1 && totient(d) <= most) result.push_back(d);
  }
  return result;
}

Decision have_independent_shifts(const NormalForm<Interval>& form) {
  if (form.b.size() < 2) return Decision::yes;
  const bool possible =
      may_vanish_on_a_set_of_roots(form.b, form.arity) || may_vanish_on_a_cycle(form.b, form.arity);
  return possible ? Decision::undecided : Decision::yes;
}

}  // namespace subdiv
