#include "analysis/contraction_set.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "analysis/circle_crossings.h"
#include "analysis/eigenvalues.h"
#include "analysis/sign_on_interval.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

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
  append_real_roots(poles, 0, critical);
  for (const auto& [base, multiplicity] : factor(characteristic_equation(matrix)).factors) {
    append_crossings(base, radius, 0, critical);
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
