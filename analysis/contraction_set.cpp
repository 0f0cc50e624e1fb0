#include "analysis/contraction_set.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/eigenvalues.h"
#include "analysis/sign_on_interval.h"
#include "schemes/algebra/specialize.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

void add_roots(const Polynomial& p, std::vector<Algebraic>& values) {
  if (p.is_constant()) return;
  for (RealRoot& root : real_roots(UnivariatePolynomial(p, 0))) values.push_back(std::move(root.value));
}

Polynomial at_eigenvalue(const Polynomial& p, const Rational& value) {
  return p.substitute(eigenvalue_variable, Polynomial(value));
}

/// x^n p(radius^2 / x): its roots are those of p mirrored at the circle of this radius.
Polynomial mirrored(const Polynomial& p, const Rational& radius) {
  const std::vector<Polynomial> c = p.coefficients_in(eigenvalue_variable);
  const std::size_t n = c.size() - 1;
  Polynomial result;
  for (std::size_t i = 0; i <= n; ++i) {
    result += c[i] * Polynomial(pow(radius, 2 * static_cast<long>(i))) *
              pow(Polynomial::variable(eigenvalue_variable), static_cast<unsigned>(n - i));
  }
  return result;
}

template <OrderedField F>
bool contracts_at(const std::vector<RationalFunction>& characteristic, const F& p, const Rational& radius) {
  std::vector<F> coefficients;
  for (const RationalFunction& c : characteristic) coefficients.push_back(specialize(c, 0, p));
  return roots_inside(FieldPolynomial<F>(std::move(coefficients)), F(radius));
}

}  // namespace

RealSet contraction_set(const Matrix<RationalFunction>& matrix, const Rational& radius) {
  const std::vector<RationalFunction> characteristic = characteristic_polynomial(matrix);
  Polynomial poles(1);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) poles *= matrix.data()[i].denominator();
  std::vector<Algebraic> critical;
  add_roots(poles, critical);
  for (const auto& [base, multiplicity] : factor(characteristic_equation(matrix)).factors) {
    add_roots(at_eigenvalue(base, radius), critical);
    add_roots(at_eigenvalue(base, -radius), critical);
    // A factor that is its own mirror image has roots on or outside the circle everywhere: its resultant is
    // 0.
    if (base.degree(eigenvalue_variable) > 1) {
      add_roots(resultant(base, mirrored(base, radius), eigenvalue_variable), critical);
    }
  }
  std::sort(critical.begin(), critical.end());
  critical.erase(std::unique(critical.begin(), critical.end()), critical.end());
  const auto contracts_in_cell = [&](std::size_t i) {
    RealInterval cell;
    if (i > 0) cell.lower = critical[i - 1];
    if (i < critical.size()) cell.upper = critical[i];
    return contracts_at(characteristic, sample(cell), radius);
  };
  std::vector<bool> cells;
  for (std::size_t i = 0; i <= critical.size(); ++i) cells.push_back(contracts_in_cell(i));
  return solve_by_cells(critical, [&](const Algebraic& p) {
    const auto cell = std::lower_bound(critical.begin(), critical.end(), p);
    const auto i = static_cast<std::size_t>(cell - critical.begin());
    if (cell == critical.end() || !(*cell == p)) return static_cast<bool>(cells[i]);
    // The set is open: a point of it has both neighbouring cells in it.
    return cells[i] && cells[i + 1] && !is_zero(specialize(poles, 0, p)) &&
           contracts_at(characteristic, p, radius);
  });
}

RealSet intersection(const RealSet& a, const RealSet& b) {
  std::vector<Algebraic> ends;
  for (const RealSet* set : {&a, &b}) {
    for (const RealInterval& part : set->parts) {
      if (part.lower) ends.push_back(*part.lower);
      if (part.upper) ends.push_back(*part.upper);
    }
  }
  return solve_by_cells(std::move(ends), [&](const Algebraic& p) { return a.contains(p) && b.contains(p); });
}

}  // namespace subdiv
