#include "analysis/reif.h"

#include <algorithm>
#include <utility>

#include "analysis/circle_crossings.h"
#include "analysis/eigenvalues.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

template <OrderedField F>
bool holds_at(const std::vector<RationalFunction>& characteristic, const F& value, int parameter, int arity,
              int order) {
  std::vector<F> coefficients;
  for (const RationalFunction& c : characteristic) coefficients.push_back(specialize(c, parameter, value));
  return satisfies_reif(FieldPolynomial<F>(std::move(coefficients)), arity, order);
}

}  // namespace

RealSet reif_set(const Mask<RationalFunction>& mask, int order, int parameter) {
  const Matrix<RationalFunction> matrix = subdivision_matrix(mask);
  const std::vector<RationalFunction> characteristic = characteristic_polynomial(matrix);
  const Polynomial equation = characteristic_equation(matrix);
  std::vector<Algebraic> poles;
  for (const RationalFunction& c : mask.symbol.coefficients()) {
    append_real_roots(c.denominator(), parameter, poles);
  }
  const auto is_pole = [&](const Algebraic& x) {
    return std::find(poles.begin(), poles.end(), x) != poles.end();
  };

  for (int k = 0; k <= order; ++k) {
    const Polynomial absent = at_eigenvalue(equation, pow(Rational(mask.arity), -k));
    if (absent.is_zero()) continue;
    // The eigenvalue m^-k is present at single values of the parameter, if at all.
    std::vector<Algebraic> candidates;
    append_real_roots(absent, parameter, candidates);
    return solve_by_cells(std::move(candidates), [&](const Algebraic& x) {
      if (is_pole(x)) return false;
      if (x.is_rational()) return holds_at(characteristic, x.to_rational(), parameter, mask.arity, order);
      return holds_at(characteristic, x, parameter, mask.arity, order);
    });
  }

  std::vector<Algebraic> critical = poles;
  const Rational radius = pow(Rational(mask.arity), -order);
  for (const auto& [base, multiplicity] : factor(equation).factors) {
    append_crossings(base, radius, parameter, critical);
  }
  return solve_by_cells(std::move(critical), [&](const Algebraic& x) {
    // An irrational x is a pole or a crossing: an eigenvalue that depends on x is not strictly inside the
    // circle.
    if (!x.is_rational() || is_pole(x)) return false;
    return holds_at(characteristic, x.to_rational(), parameter, mask.arity, order);
  });
}

}  // namespace subdiv
