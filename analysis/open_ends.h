#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/limit_mask.h"

namespace subdiv {

/// Open curves of a scheme made for infinite polygons: points P_{-1}, P_{-2}, .. are added before the first
/// control point P_0 so that the limit at P_0's parameter and its derivatives there are as wished (js-report
/// 11; jsplines 9). Each added point is a Laurent polynomial: coefficient j is the weight of P_j, j >= 0. At
/// the other end P_{-k} and P_j stand for P_{n-1+k} and P_{n-1-j}: the weights are mirrored, and those of
/// `mirrored` masks.

/// The demand: the mask, applied to added and given points, equals the target combination of P_0, P_1, ..
template <class R>
struct EndCondition {
  Laurent<R> mask;    ///< indices from minus the number of added points on
  Laurent<R> target;  ///< weights of the given points P_0, P_1, ..
};

/// How many added points masks that start at a negative index reach: -first, at least 0.
template <class R>
int points_to_add(const std::vector<EndCondition<R>>& conditions) {
  int count = 0;
  for (const EndCondition<R>& c : conditions) {
    if (!c.mask.is_zero()) count = std::max(count, -c.mask.first());
  }
  return count;
}

/// The added points P_{-1}, P_{-2}, .. (element k - 1 is P_{-k}) that meet all conditions: the solution of
/// the linear system. Throws std::domain_error when there is none or more than one (J_s at s = 0 and s = 1:
/// solve over Q(s) and evaluate there).
template <ExactRing R>
std::vector<Laurent<R>> solve_end(const std::vector<EndCondition<R>>& conditions) {
  const int added = points_to_add(conditions);
  int last = 0;
  for (const EndCondition<R>& c : conditions) last = std::max({last, c.mask.last(), c.target.last()});
  Matrix<R> system = zero_matrix<R>(static_cast<Eigen::Index>(conditions.size()), added);
  for (std::size_t row = 0; row < conditions.size(); ++row) {
    for (int k = 1; k <= added; ++k) system(static_cast<Eigen::Index>(row), k - 1) = conditions[row].mask[-k];
  }
  std::vector<std::vector<R>> weights(static_cast<std::size_t>(added));
  for (int j = 0; j <= last; ++j) {
    Vector<R> right(static_cast<Eigen::Index>(conditions.size()));
    for (std::size_t row = 0; row < conditions.size(); ++row) {
      right(static_cast<Eigen::Index>(row)) = conditions[row].target[j] - conditions[row].mask[j];
    }
    const auto column = solve(system, right);
    if (!column)
      throw std::domain_error("the conditions do not determine the points added at the end of the curve");
    for (int k = 0; k < added; ++k) weights[static_cast<std::size_t>(k)].push_back((*column)(k));
  }
  std::vector<Laurent<R>> result;
  for (std::vector<R>& w : weights) result.emplace_back(0, std::move(w));
  return result;
}

/// The limit starts at P_0 with the tangent P_1 - P_0 (d/dt at unit spacing of control points).
template <ExactRing R>
std::vector<Laurent<R>> clamped_end(const Laurent<R>& limit, const Laurent<R>& tangent) {
  return solve_end<R>({{limit, Laurent<R>(1)}, {tangent, Laurent<R>(0, {R(0) - R(1), R(1)})}});
}

/// P_{-k} = 2 P_0 - P_k: the limit of every scheme with a symmetric limit mask starts at P_0.
template <class R>
std::vector<Laurent<R>> reflected_end(int count) {
  std::vector<Laurent<R>> result;
  for (int k = 1; k <= count; ++k) result.push_back(Laurent<R>(2) - Laurent<R>::monomial(k));
  return result;
}

/// A mask seen from the other end: index j becomes -j; derivatives of odd order change sign.
template <class R>
Laurent<R> mirrored(const Laurent<R>& mask, int derivative) {
  return derivative % 2 == 0 ? reverse(mask) : -reverse(mask);
}

/// A mask applied to P_.. with the added points in place, as a combination of P_0, P_1, ..
template <class R>
Laurent<R> apply_at_end(const Laurent<R>& mask, const std::vector<Laurent<R>>& added) {
  Laurent<R> result;
  for (int j = mask.first(); j <= mask.last(); ++j) {
    if (j < -static_cast<int>(added.size()))
      throw std::domain_error("the mask reaches beyond the added points");
    result += mask[j] * (j < 0 ? added[static_cast<std::size_t>(-j - 1)] : Laurent<R>::monomial(j));
  }
  return result;
}

/// Spans to leave out of a closed curve to open it: n control points with `added` more at both ends make a
/// loop of n + 2 added spans, of which the open curve from P_0 to P_{n-1} keeps n - 1.
constexpr int dropped_spans(int added) { return 2 * added + 1; }

}  // namespace subdiv
