#include "analysis/mesh/mode_equation.h"

#include <algorithm>
#include <stdexcept>

#include "analysis/eigenvalues.h"
#include "analysis/mesh/strong_components.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function w = Function::variable(symbol_variable);

Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> pattern(const Matrix<Function>& matrix) {
  return matrix.unaryExpr([](const Function& f) { return !f.is_zero(); });
}

constexpr int least_reach_free_valence = 11;

/// The block of all modes k != 0 with w free, from a valence at which the sectors that a rule reads around a
/// place do not meet on the far side; there every entry is the common value that mode k != 0 does not see.
Matrix<Function> turning_block(const FanMatrix<Function>& fan) {
  constexpr int reach = 4;
  const int valence = fan.valence;
  if (valence < least_reach_free_valence) throw std::logic_error("sectors may meet on the far side");
  const auto sector = [&](int j) -> const Matrix<Function>& {
    return fan.blocks[static_cast<std::size_t>((j + valence) % valence)];
  };
  const Matrix<Function>& far = sector(reach + 1);
  if (sector(-reach - 1) != far) throw std::logic_error("a rule reaches more than 4 sectors away");
  Matrix<Function> result = zero_matrix<Function>(fan.places(), fan.places());
  for (int j = -reach; j <= reach; ++j) {
    Function power(1);
    for (int i = 0; i < j; ++i) power *= w;
    for (int i = 0; i < -j; ++i) power /= w;
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const Function entry = sector(j).data()[i] - far.data()[i];
      if (!entry.is_zero()) result.data()[i] += entry * power;
    }
  }
  return result;
}

/// T_j(c), Chebyshev's: cos(j t) for c = cos t.
Polynomial chebyshev(std::size_t j) {
  const Polynomial c = Polynomial::variable(turn_variable);
  Polynomial before(1);
  Polynomial current = c;
  if (j == 0) return before;
  for (std::size_t i = 1; i < j; ++i) {
    Polynomial next = Polynomial(2) * c * current - before;
    before = std::exchange(current, std::move(next));
  }
  return current;
}

/// A Laurent polynomial in w with the same value at 1/w, as one in c = (w + 1/w)/2.
Function in_cosine(const Function& f) {
  const Polynomial below = f.denominator();
  const long middle = below.degree(symbol_variable);  // the denominator is w^middle times a free factor
  const std::vector<Polynomial> parts = below.coefficients_in(symbol_variable);
  for (long i = 0; i < middle; ++i) {
    if (!parts[static_cast<std::size_t>(i)].is_zero()) throw std::logic_error("no Laurent polynomial in w");
  }
  std::vector<Polynomial> above = f.numerator().coefficients_in(symbol_variable);
  above.resize(std::max(above.size(), static_cast<std::size_t>(2 * middle + 1)));
  const auto centre = static_cast<std::size_t>(middle);
  if (above.size() != 2 * centre + 1) throw std::logic_error("a mode prefers an orientation");
  Polynomial sum = above[centre];
  for (std::size_t j = 1; j <= centre; ++j) {
    if (!(above[centre + j] == above[centre - j])) throw std::logic_error("a mode prefers an orientation");
    sum += Polynomial(2) * above[centre + j] * chebyshev(j);
  }
  return Function(sum) / Function(parts[centre]);
}

/// The factors of det(x I - block) for the diagonal blocks, whose coefficients `convert` rewrites.
template <class Convert>
ModeEquation equation_of(const Matrix<Function>& matrix, const Convert& convert) {
  ModeEquation result;
  const Function x = Function::variable(eigenvalue_variable);
  for (const auto& component : strong_components(pattern(matrix))) {
    const std::vector<Function> coefficients = characteristic_polynomial(diagonal_block(matrix, component));
    Function sum(0);
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + convert(coefficients[i]);
    for (auto& [base, multiplicity] : factor(sum.numerator()).factors) {
      if (!base.uses(eigenvalue_variable)) continue;
      const auto known = std::find_if(result.factors.begin(), result.factors.end(),
                                      [&, &p = base](const auto& f) { return f.first == p; });
      if (known == result.factors.end()) {
        result.factors.emplace_back(std::move(base), multiplicity);
      } else {
        known->second += multiplicity;
      }
    }
  }
  return result;
}

}  // namespace

long ModeEquation::degree() const {
  long sum = 0;
  for (const auto& [base, multiplicity] : factors) sum += base.degree(eigenvalue_variable) * multiplicity;
  return sum;
}

Polynomial ModeEquation::product() const {
  Polynomial result(1);
  for (const auto& [base, multiplicity] : factors) result *= pow(base, static_cast<unsigned>(multiplicity));
  return result;
}

ModeEquation turning_modes(const FanMatrix<RationalFunction>& fan) {
  return equation_of(turning_block(fan), in_cosine);
}

ModeEquation turning_modes(const MeshScheme<RationalFunction>& scheme) {
  return turning_modes(fan_matrix(scheme, least_reach_free_valence, eigenvalue_rings(scheme)));
}

ModeEquation invariant_mode(const MeshScheme<RationalFunction>& scheme, int valence) {
  return invariant_mode(fan_matrix(scheme, valence, eigenvalue_rings(scheme)));
}

ModeEquation invariant_mode(const FanMatrix<RationalFunction>& fan) {
  return equation_of(invariant_block(fan), [](const Function& f) { return f; });
}

ModeEquation invariant_modes(const MeshScheme<RationalFunction>& scheme) {
  const auto block = [&](int valence) {
    return invariant_block(fan_matrix(scheme, valence, eigenvalue_rings(scheme)));
  };
  const int first = 5;
  const int second = 10;
  const int third = 7;
  const Matrix<Function> a = block(first);
  const Matrix<Function> b = block(second);
  const Matrix<Function> check = block(third);
  // a + (1/n - 1/5) (b - a)/(1/10 - 1/5)
  const auto at = [&](const Function& h, Eigen::Index i) {
    const Function slope = (b.data()[i] - a.data()[i]) * fraction<Function>(-second, 1);
    return a.data()[i] + (h - fraction<Function>(1, first)) * slope;
  };
  Matrix<Function> result = a;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result.data()[i] = at(Function::variable(valence_variable), i);
    if (!(at(fraction<Function>(1, third), i) == check.data()[i])) {
      throw std::logic_error("the invariant mode is not linear in 1/n");
    }
  }
  return equation_of(result, [](const Function& f) { return f; });
}

}  // namespace subdiv
