#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/sum_rules.h"

namespace subdiv {

/// What a scheme does to polynomials, decided by moments: index i after k steps stands at t = i / m^k, the
/// basis function phi is the limit of the unit impulse at index 0, and a step with symbol a(z) has the mean
/// mu_e = (1/m) sum i^e a_i.

/// The support of the limit: phi = 0 outside [first, second]. A stationary scheme's is [first, last] / (m -
/// 1).
template <class R>
std::pair<Rational, Rational> basis_support(const Scheme<R>& scheme) {
  const Rational m(scheme.arity());
  const Laurent<R>& last = scheme.last().symbol;
  std::pair<Rational, Rational> support{Rational(last.first()) / (m - Rational(1)),
                                        Rational(last.last()) / (m - Rational(1))};
  for (std::size_t k = scheme.steps.size() - 1; k-- > 0;) {
    const Laurent<R>& a = scheme.steps[k].symbol;
    support = {(Rational(a.first()) + support.first) / m, (Rational(a.last()) + support.second) / m};
  }
  return support;
}

namespace detail {

/// mu_e = (1/m) sum over i of i^e a_i, e = 0 .. degree.
template <class R>
std::vector<R> step_moments(const Mask<R>& mask, int degree) {
  std::vector<R> result;
  for (int e = 0; e <= degree; ++e) {
    R total(0);
    for (int r = 0; r < mask.arity; ++r) total = total + residue_moment(mask, r, e);
    result.push_back(fraction<R>(1, mask.arity) * total);
  }
  if (!(result[0] == R(1)))
    throw std::domain_error("moments need masks whose coefficients add up to the arity");
  return result;
}

/// sum over j = first .. e of binomial(e, j) x_j y_{e-j}: moments of a sum of independent variables.
template <class R>
R add_moments(const std::vector<R>& x, const std::vector<R>& y, int e, int first) {
  R total(0);
  Rational binomial(1);
  for (int j = 0; j <= e; ++j) {
    const R weight = from_rational<R>(binomial);
    if (j >= first)
      total = total + weight * x[static_cast<std::size_t>(j)] * y[static_cast<std::size_t>(e - j)];
    binomial *= Rational(e - j, j + 1);
  }
  return total;
}

}  // namespace detail

/// The moments M_e = integral of t^e phi(t) dt, e = 0 .. degree, of a scheme whose steps all have a(1) = m
/// (std::domain_error otherwise): phi is the density of the sum of X_k / m^(k+1), k = 0, 1, .., where X_k
/// takes the value i with the (signed) weight a_i / m of step k. So M_e = m^-e sum of binomial(e, j) mu_j
/// M'_{e-j} with M' those of the scheme without its first step.
template <ExactRing R>
std::vector<R> basis_moments(const Scheme<R>& scheme, int degree) {
  const Rational m(scheme.arity());
  std::vector<R> mu = detail::step_moments(scheme.last(), degree);
  std::vector<R> moments{R(1)};
  for (int e = 1; e <= degree; ++e) {  // M' = M: the term j = 0 goes to the left side
    const Rational factor = Rational(1) / (pow(m, e) - Rational(1));
    moments.push_back(from_rational<R>(factor) * detail::add_moments(mu, moments, e, 1));
  }
  for (std::size_t k = scheme.steps.size() - 1; k-- > 0;) {
    mu = detail::step_moments(scheme.steps[k], degree);
    std::vector<R> coarser;
    for (int e = 0; e <= degree; ++e) {
      coarser.push_back(from_rational<R>(pow(m, -e)) * detail::add_moments(mu, moments, e, 0));
    }
    moments = std::move(coarser);
  }
  return moments;
}

/// The parametric shift tau = M_1: control point i belongs to the parameter i + tau, in that the data P_i = i
/// + tau have the limit t (a scheme of at least two sum rules). 0 for primal symmetric schemes, 1/2 for
/// binary dual ones with a mask on -n .. n+1. For one repeated step tau = a'(1) / (m (m-1)); the shift a'(1)
/// / m of Conti & Hormann (Polynomial reproduction for univariate subdivision schemes of any arity, 2011) is
/// (m-1) tau.
template <ExactRing R>
R parametric_shift(const Scheme<R>& scheme) {
  return basis_moments(scheme, 1)[1];
}

/// The largest d such that polynomials of degree d are combinations of the integer shifts of phi, by sum
/// rules of every step: their least order minus 1. -1 when even constants are lost.
template <ExactRing R>
int generation_degree(const Scheme<R>& scheme) {
  for (const Mask<R>& step : scheme.steps) {
    if (violated_affine_invariance(step)) return -1;
  }
  return sum_rule_order(scheme) - 1;
}

/// The largest d such that the limit of the data P_i = p(i + tau) is p for every polynomial p of degree at
/// most d: all of them are generated, and the moments about tau vanish, M_e = tau^e for e <= d. For one
/// repeated step this is Conti & Hormann 2011, theorem 4.3. A mixed scheme can reproduce more than its steps
/// do.
template <ExactRing R>
int reproduction_degree(const Scheme<R>& scheme) {
  const int generation = generation_degree(scheme);
  if (generation < 1) return generation;
  const std::vector<R> moments = basis_moments(scheme, generation);
  R power = moments[1];
  int degree = 1;
  while (degree < generation) {
    power = power * moments[1];
    if (!(moments[static_cast<std::size_t>(degree) + 1] == power)) break;
    ++degree;
  }
  return degree;
}

/// Whether one step reproduces degree d by itself, from the residue classes alone: sum over i = r mod m of
/// i^e a_i is c^e for every r and e <= d, with c = a'(1) / m.
template <ExactRing R>
bool step_reproduces(const Mask<R>& mask, int degree) {
  R centre(0);
  for (int r = 0; r < mask.arity; ++r) centre = centre + residue_moment(mask, r, 1);
  centre = fraction<R>(1, mask.arity) * centre;
  for (int r = 0; r < mask.arity; ++r) {
    R power(1);
    for (int e = 0; e <= degree; ++e) {
      if (!(residue_moment(mask, r, e) == power)) return false;
      power = power * centre;
    }
  }
  return true;
}

}  // namespace subdiv
