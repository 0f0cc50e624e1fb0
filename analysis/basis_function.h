#pragma once

#include <stdexcept>
#include <vector>

#include "analysis/limit_mask.h"

namespace subdiv {

/// Basis function phi of a scheme: the limit of the unit impulse at index 0, phi(t) = sum a_i phi(m t - i).
/// The impulse's refined point i after k steps stands at i / m^k, so phi has support [first, last] / (m - 1)
/// for a stationary scheme.

/// phi^(d) at the integers, for d >= 0 below the order of sum rules: coefficient k of the result is
/// phi^(d)(k), the derivative mask at index 0 read backwards. Normalised so that sum over k of phi^(d)(-k)
/// k^d / d! = 1 and the lower moments vanish. The derivative must exist at integers; throws std::domain_error
/// when the equations do not determine it.
template <class R>
Laurent<R> integer_values(const Mask<R>& mask, int derivative = 0) {
  return reverse(derivative_mask(mask, derivative));
}

/// phi^(d) at all points i / m^level: coefficient i of the result. Works for mixed schemes: the steps are
/// those of the scheme, each derivative brings a factor m a step.
template <ExactRing R>
Laurent<R> basis_values(const Scheme<R>& scheme, int level, int derivative = 0) {
  const int m = scheme.arity();
  const int steps = std::max(level, static_cast<int>(scheme.steps.size()) - 1);
  Laurent<R> values = integer_values(scheme.last(), derivative);
  // phi_0(i / m^k) = m^(d k) sum over j of s_j phi_k(i - j), s the symbol of the first k steps.
  values = from_rational<R>(pow(Rational(m), static_cast<long>(derivative) * steps)) *
           (iterated_symbol(scheme, steps) * values);
  for (int k = steps; k > level; --k) values = residue_class(values, 0, m);
  return values;
}

/// The integral of phi from -infinity to t at t = i / m^level for a stationary scheme with integral 1:
/// element j stands for i = lowest + j, where lowest / m^level is the left end of the support; before it the
/// integral is 0, after the last element it is 1. I(t) = (1/m) sum a_i I(m t - i).
template <class R>
struct BasisIntegral {
  int lowest = 0;         ///< index of the left end of the support
  int level = 0;          ///< of the abscissae i / m^level
  std::vector<R> values;  ///< one for each index from lowest on

  /// The integral from -infinity to i / m^level, for any i.
  [[nodiscard]] R at(int i) const {
    if (i < lowest) return R(0);
    const auto j = static_cast<std::size_t>(i - lowest);
    return j < values.size() ? values[j] : R(1);
  }
};

/// The table of a level >= 0. Throws std::domain_error where that equation has no or no unique solution.
template <ExactRing R>
BasisIntegral<R> basis_integral(const Mask<R>& mask, int level) {
  const int m = mask.arity;
  const Laurent<R>& a = mask.symbol;
  const int low = floor_divide(a.first(), m - 1);
  const int high = -floor_divide(-a.last(), m - 1);
  const Eigen::Index n = high - low + 1;
  // At integers: m I(k) = sum over l of a_{m k - l} I(l), I(low) = 0, and I(l) = 1 from l = high on.
  Matrix<R> system = zero_matrix<R>(n + 2, n);
  Vector<R> right = Vector<R>::Constant(n + 2, R(0));
  for (int k = low; k <= high; ++k) {
    system(k - low, k - low) = R(0) - R(m);
    for (int i = a.first(); i <= a.last(); ++i) {
      const int l = m * k - i;
      if (l > high) {
        right(k - low) = right(k - low) - a[i];
      } else if (l >= low) {
        system(k - low, l - low) = system(k - low, l - low) + a[i];
      }
    }
  }
  system(n, 0) = R(1);
  system(n + 1, n - 1) = R(1);
  right(n + 1) = R(1);
  const auto at_integers = solve(system, right);
  if (!at_integers) throw std::domain_error("the refinement equation does not determine the integral");
  BasisIntegral<R> result{low, 0, std::vector<R>(at_integers->data(), at_integers->data() + n)};
  for (int step = 1; step <= level; ++step) {
    BasisIntegral<R> next{result.lowest * m, step, {}};
    const int last = (low + static_cast<int>(n) - 1) * static_cast<int>(pow(Rational(m), step).to_integer());
    int spacing = 1;  // index distance of an integer step on the coarser level
    for (int j = 1; j < step; ++j) spacing *= m;
    for (int i = next.lowest; i <= last; ++i) {
      // I(i / m^step) = (1/m) sum a_j I(i / m^(step-1) - j).
      R value(0);
      for (int j = a.first(); j <= a.last(); ++j) value = value + a[j] * result.at(i - j * spacing);
      next.values.push_back(value * fraction<R>(1, m));
    }
    result = std::move(next);
  }
  return result;
}

}  // namespace subdiv
