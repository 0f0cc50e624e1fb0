#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "schemes/mask.h"

namespace subdiv {

/// Sum rules of one refinement step: its symbol is S(z) = (1 + z + ... + z^(m-1))^order cofactor(z), order
/// maximal. Order n is necessary for polynomials of degree below n to lie in the limit space, and for
/// smoothness C^(n-1) of a stationary scheme (Cavaretta, Dahmen & Micchelli 1991; Warren & Weimer,
/// Subdivision Methods for Geometric Design, chapter 3). A smoothing factor (1+z)/2 of the binary literature
/// leaves cofactor / 2^order.
template <class R>
struct SumRules {
  int order = 0;        ///< the number of sum rules
  Laurent<R> cofactor;  ///< S(z) without the smoothing factors
};

/// The symbol must not be zero (std::domain_error).
template <ExactRing R>
SumRules<R> sum_rules(const Mask<R>& mask) {
  auto [order, cofactor] = divide_out(mask.symbol, smoothing_factor<R>(mask.arity));
  return {order, std::move(cofactor)};
}

/// The smallest order of all steps.
template <ExactRing R>
int sum_rule_order(const Scheme<R>& scheme) {
  int order = sum_rules(scheme.last()).order;
  for (const Mask<R>& step : scheme.steps) order = std::min(order, sum_rules(step).order);
  return order;
}

/// The moment of one residue class: sum over i = r mod m of i^exponent a_i, with 0^0 = 1.
template <class R>
R residue_moment(const Mask<R>& mask, int r, int exponent) {
  R total(0);
  for (int i = mask.symbol.first(); i <= mask.symbol.last(); ++i) {
    if (residue(i, mask.arity) != r) continue;
    R power(1);
    for (int e = 0; e < exponent; ++e) power = power * R(i);
    total = total + power * mask.symbol[i];
  }
  return total;
}

/// The sums of a_i over i = r mod m, r = 0 .. m-1: the rules for the m kinds of refined points. All are 1
/// exactly when constants are reproduced (affine invariance, the first sum rule with a(1) = m).
template <class R>
std::vector<R> residue_sums(const Mask<R>& mask) {
  std::vector<R> result;
  for (int r = 0; r < mask.arity; ++r) result.push_back(residue_moment(mask, r, 0));
  return result;
}

/// What is wrong when a step is not affinely invariant, for a message to a user: "the coefficients with index
/// = 1 mod 2 add up to 3/4 instead of 1"; nothing when all residue sums are 1.
template <ExactRing R>
std::optional<std::string> violated_affine_invariance(const Mask<R>& mask) {
  const std::vector<R> sums = residue_sums(mask);
  for (std::size_t r = 0; r < sums.size(); ++r) {
    if (sums[r] == R(1)) continue;
    return "the coefficients with index = " + std::to_string(r) + " mod " + std::to_string(mask.arity) +
           " add up to " + sums[r].to_string() + " instead of 1";
  }
  return std::nullopt;
}

}  // namespace subdiv
