#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/decision.h"
#include "analysis/enclosure.h"
#include "analysis/real_set.h"
#include "analysis/retrofit.h"
#include "schemes/algebra/univariate.h"
#include "schemes/polyloop/polyloop_operator.h"

namespace subdiv {

/// Smoothing operators as filters (polyloops 2). One that treats every vertex alike and keeps their number,
/// vertex i -> sum of w_j P_{i+j}, multiplies the frequency omega, P_j = e^{i omega j}, by its transfer
/// function w(e^{i omega}): the fraction that is kept, 1 for omega = 0 where the weights sum to 1. With
/// symmetric weights it is real, a polynomial in c = cos omega; tuck(t) has 1 - t (1 - c). On a closed
/// polyloop of n vertices omega = 2 pi k/n.

/// The weights w_j, as a Laurent polynomial; nothing for operators of another kind (refine, tweak).
template <ExactRing R>
std::optional<Laurent<R>> weights_of(const PolyloopOperator<R>& op) {
  const PolyloopOperator<R> least = reduced(op);
  if (least.period != 1 || least.outputs() != 1) return std::nullopt;
  return least.rows.front();
}

/// The transfer function at cos omega = c, over any ring. Throws std::domain_error unless the weights are
/// symmetric, w_{-j} = w_j.
template <class R>
R transfer_at_cosine(const Laurent<R>& weights, const R& c) {
  return symbol_at_cosine(weights, c);
}

/// Its squared modulus, for any weights: (1 + c)/2 for dual.
template <class R>
R power_at_cosine(const Laurent<R>& weights, const R& c) {
  const Laurent<R> products = weights * reverse(weights);
  R value = products[0];
  R before(1);
  R cosine = c;  // cos k omega
  for (int k = 1; k <= products.last(); ++k) {
    value = value + R(2) * products[k] * cosine;
    R next = R(2) * c * cosine - before;
    before = std::move(cosine);
    cosine = std::move(next);
  }
  return value;
}

/// A part of a sequence, applied so many times; the order does not matter to frequencies.
struct FilterPart {
  Laurent<Rational> weights;  ///< w_j at the power j
  long times = 1;             ///< how often it is applied
};

/// The largest modulus of a transfer function over all frequencies, and where it is taken.
struct LargestGain {
  Enclosure gain;  ///< proved
  /// cos omega, the least omega of several; 1 where nothing is amplified. Nothing where the largest of
  /// several candidates could not be told.
  std::optional<Algebraic> cosine;
};

/// Exact where the cosine is rational or quadratic and few factors are multiplied, else certified. Candidates
/// are the ends c = -1, 1 and the zeros of the derivative; of those that 1024 bits cannot tell apart the gain
/// is enclosed together.
[[nodiscard]] LargestGain largest_gain(const std::vector<FilterPart>& parts);
/// Of one filter.
[[nodiscard]] LargestGain largest_gain(const Laurent<Rational>& weights);

/// The largest modulus of the product of filters known as intervals: certified, by halving [-1, 1]; the
/// status is out_of_depth when the relative width 1e-6 is not reached.
struct IntervalFilterPart {
  Laurent<Interval> weights;  ///< w_j at the power j
  long times = 1;             ///< how often it is applied
};
/// Of the product of such filters.
[[nodiscard]] Enclosure largest_gain(const std::vector<IntervalFilterPart>& parts);

/// Whether some frequency is amplified: gain > 1.
[[nodiscard]] Decision amplifies(const Enclosure& largest_gain);

/// The values of the parameter x_i for which no frequency is amplified, |w(e^{i omega})| <= 1 for all omega;
/// the weights are polynomials in it. Decided exactly: the set can change only where a zero of 1 - |w|^2
/// enters [-1, 1], or two meet. Meant for low degrees: signs at irrational values are slow.
[[nodiscard]] RealSet stable_range(const Laurent<Polynomial>& weights, int parameter = 0);

/// The values for which every frequency but 0 is damped, |w| < 1: repeated, the operator takes every closed
/// polyloop to its centroid, at one rate for all numbers of vertices up to a given one.
[[nodiscard]] RealSet damping_range(const Laurent<Polynomial>& weights, int parameter = 0);

/// What an operator leaves as it is: w(z) - 1 = (1 - z)^m q(z), q(1) != 0. On sequences without end these are
/// the polynomials of degree below m, and combinations of j^k x^j for the other zeros x of q.
template <ExactRing R>
std::pair<int, Laurent<R>> fixed_factor(const Laurent<R>& weights) {
  return divide_out(weights - Laurent<R>(1), Laurent<R>(0, {R(1), R(-1)}));
}

}  // namespace subdiv
