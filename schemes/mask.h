#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/laurent.h"

namespace subdiv {

/// One refinement step P'_i = sum over j of a_{i - m j} P_j, m the arity, a_i the coefficients of the symbol
/// a(z) = sum a_i z^i. The sum of all a_i is m for an affinely invariant step. Index i of the refined
/// sequence belongs to abscissa i / m (up to the scheme's parametric shift), so that a primal scheme has its
/// vertex rule at a_0.
template <class R>
struct Mask {
  int arity = 2;      ///< m
  Laurent<R> symbol;  ///< a(z)

  friend bool operator==(const Mask&, const Mask&) = default;
};

/// A subdivision scheme: its steps in order, the last of which repeats for ever. One step makes a stationary
/// scheme; several make a mixed ({J_r, *J_s}) or non-stationary one. All steps have the same arity.
template <class R>
struct Scheme {
  std::string name;            ///< for messages and titles
  std::vector<Mask<R>> steps;  ///< at least one

  [[nodiscard]] bool is_stationary() const { return steps.size() == 1; }
  [[nodiscard]] int arity() const { return steps.front().arity; }
  /// The mask of step k = 0, 1, 2, ..
  [[nodiscard]] const Mask<R>& step(std::size_t k) const { return steps[std::min(k, steps.size() - 1)]; }
  /// The step that repeats.
  [[nodiscard]] const Mask<R>& last() const { return steps.back(); }
};

/// A scheme of one mask.
template <class R>
Scheme<R> stationary(std::string name, Mask<R> mask) {
  return {std::move(name), {std::move(mask)}};
}

/// {first, *rest}: anticipation steps followed by a scheme. Throws std::domain_error when the arities differ.
template <class R>
Scheme<R> mixed(const Scheme<R>& first, const Scheme<R>& rest) {
  if (first.arity() != rest.arity())
    throw std::domain_error("steps of a mixed scheme must have the same arity");
  Scheme<R> result{first.name + "+" + rest.name, first.steps};
  result.steps.insert(result.steps.end(), rest.steps.begin(), rest.steps.end());
  return result;
}

/// The scheme that goes on after the first k steps.
template <class R>
Scheme<R> after_steps(const Scheme<R>& scheme, std::size_t k) {
  const std::size_t done = std::min(k, scheme.steps.size() - 1);
  return {scheme.name, {scheme.steps.begin() + static_cast<std::ptrdiff_t>(done), scheme.steps.end()}};
}

/// The symbol of k steps at once: a_{k-1}(z) a_{k-2}(z^m) ... a_0(z^(m^(k-1))); its coefficient i is the
/// value at i / m^k of the sequence refined k times from a unit impulse. k = 0 gives 1.
template <class R>
Laurent<R> iterated_symbol(const Scheme<R>& scheme, int k) {
  Laurent<R> result(1);
  for (int i = 0; i < k; ++i) {
    const Mask<R>& mask = scheme.step(static_cast<std::size_t>(i));
    result = mask.symbol * upsample(result, mask.arity);
  }
  return result;
}

/// The mask's coefficients sent into another ring.
template <class R, class Map>
auto map_coefficients(const Mask<R>& mask, Map map) {
  using S = decltype(map(mask.symbol[0]));
  return Mask<S>{mask.arity, map_coefficients(mask.symbol, map)};
}

/// The same scheme over another ring: the map is applied to each coefficient.
template <class R, class Map>
auto map_coefficients(const Scheme<R>& scheme, Map map) {
  using S = decltype(map(scheme.steps[0].symbol[0]));
  Scheme<S> result{scheme.name, {}};
  for (const Mask<R>& mask : scheme.steps) result.steps.push_back(map_coefficients(mask, map));
  return result;
}

/// One refinement of a finitely supported sequence of values (zero outside): a(z) P(z^m).
template <class R>
Laurent<R> refine_sequence(const Mask<R>& mask, const Laurent<R>& control) {
  return mask.symbol * upsample(control, mask.arity);
}

}  // namespace subdiv
