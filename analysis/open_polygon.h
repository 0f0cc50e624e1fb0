#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/open_ends.h"
#include "schemes/evaluate/control_polygon.h"
#include "schemes/evaluate/refinement_rule.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"

namespace subdiv {

/// How an open curve of the points P_0 .. P_{n-1} ends (js-report 11; jsplines 9).
/// clamped: the limit starts at P_0 with the tangent P_1 - P_0 (d/dt at unit spacing of control points), and
/// ends at P_{n-1} with the tangent P_{n-1} - P_{n-2}.
/// reflected: P_{-k} = 2 P_0 - P_k, and so at the other end; masks symmetric about index 0 then make the
/// limit start at P_0 and end at P_{n-1}.
enum class OpenEnd { clamped, reflected };

/// The points to add at both ends, as many as the curve depends on (vertex_reach). Element k - 1 of `start`
/// is P_{-k}, coefficient j the weight of P_j; element k - 1 of `finish` is P_{n-1+k}, coefficient j the
/// weight of P_{n-1-j}. Equal for schemes with symmetric masks.
template <class R>
struct EndWeights {
  std::vector<Laurent<R>> start;   ///< ahead of P_0
  std::vector<Laurent<R>> finish;  ///< behind P_{n-1}

  friend bool operator==(const EndWeights&, const EndWeights&) = default;
};

namespace detail {

/// Two added points, P_{-1} and P_{-2}, are enough for two conditions; more are reflected.
constexpr int points_that_clamp = 2;

/// The added points that meet the conditions and are nearest to the reflected ones: of all solutions the one
/// with the least sum of squares of the weights' differences. Only the first `unknowns` points move. Nothing
/// when the conditions contradict each other.
template <ExactRing R>
std::optional<std::vector<Laurent<R>>> nearest_to_reflected(const std::vector<EndCondition<R>>& conditions,
                                                            int count, int unknowns) {
  std::vector<Laurent<R>> points = reflected_end<R>(std::max(count, points_to_add(conditions)));
  const auto rows = static_cast<Eigen::Index>(conditions.size());
  std::vector<Laurent<R>> missing;
  int last = 0;
  for (const EndCondition<R>& c : conditions) {
    missing.push_back(c.target - apply_at_end(c.mask, points));
    last = std::max(last, missing.back().last());
  }
  Matrix<R> system = zero_matrix<R>(rows, unknowns + last + 1);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    for (int k = 1; k <= unknowns; ++k) system(row, k - 1) = conditions[i].mask[-k];
    for (int j = 0; j <= last; ++j) system(row, unknowns + j) = missing[i][j];
  }
  const auto [reduced, pivots] = row_reduce(std::move(system));
  if (!pivots.empty() && pivots.back() >= unknowns) return std::nullopt;
  // Independent rows a x = b: the solution of least norm is x = a^T y with (a a^T) y = b.
  const auto rank = static_cast<Eigen::Index>(pivots.size());
  Matrix<R> gram = zero_matrix<R>(rank, rank);
  for (Eigen::Index r = 0; r < rank; ++r) {
    for (Eigen::Index c = 0; c < rank; ++c) {
      for (int k = 0; k < unknowns; ++k) gram(r, c) = gram(r, c) + reduced(r, k) * reduced(c, k);
    }
  }
  for (int j = 0; rank > 0 && j <= last; ++j) {
    const auto y = solve<R>(gram, reduced.col(unknowns + j).head(rank));
    for (int k = 0; k < unknowns; ++k) {
      R weight(0);
      for (Eigen::Index r = 0; r < rank; ++r) weight = weight + reduced(r, k) * y.value()(r);
      points[static_cast<std::size_t>(k)] += Laurent<R>::monomial(j, weight);
    }
  }
  points.resize(static_cast<std::size_t>(count));
  return points;
}

/// The clamped end of a scheme with this limit and tangent mask. Throws InputError when there is none.
template <ExactRing R>
std::vector<Laurent<R>> clamped_points(const Laurent<R>& limit, const Laurent<R>& tangent, int count) {
  const std::vector<EndCondition<R>> conditions{{limit, Laurent<R>(1)},
                                                {tangent, Laurent<R>(0, {R(0) - R(1), R(1)})}};
  const int reach = points_to_add(conditions);
  if (auto points = nearest_to_reflected(conditions, count, std::min(points_that_clamp, reach)))
    return std::move(*points);
  if (auto points = nearest_to_reflected(conditions, count, reach)) return std::move(*points);
  throw InputError(
      "no points before the first one make the limit start there with the tangent of the first edge: the "
      "limit and tangent masks contradict each other");
}

}  // namespace detail

namespace detail {

/// Throws InputError unless every mask is symmetric about index 0.
template <class R>
void require_symmetric(const Scheme<R>& scheme) {
  for (const Mask<R>& step : scheme.steps) {
    if (step.symbol == reverse(step.symbol)) continue;
    throw InputError("reflected ends of " + scheme.name +
                     ": a mask is not symmetric about index 0, so that the curve would not end at the last "
                     "points; choose clamped ends");
  }
}

}  // namespace detail

/// The added points of a scheme over an exact field, by its own masks. Where the conditions of clamped ends
/// leave a choice (J_s at s = 0 and s = 1), the points nearest to the reflected ones are taken; those beyond
/// the second are reflected. Throws InputError where clamped ends do not exist: no limit or tangent mask, or
/// masks that contradict each other; and for reflected ends of masks that are not symmetric about index 0.
template <ExactRing R>
EndWeights<R> end_weights(const Scheme<R>& scheme, OpenEnd end) {
  const IndexWindow window = vertex_reach(scheme);
  const int before = -window.first;
  const int after = window.last;
  if (end == OpenEnd::reflected) {
    detail::require_symmetric(scheme);
    return {reflected_end<R>(before), reflected_end<R>(after)};
  }
  try {
    const Laurent<R> limit = vertex_limit_mask(scheme);
    const Laurent<R> tangent = vertex_tangent_mask(scheme);
    return {detail::clamped_points(limit, tangent, before),
            detail::clamped_points(mirrored(limit, 0), mirrored(tangent, 1), after)};
  } catch (const std::domain_error& error) {
    throw InputError("clamped ends of " + scheme.name + ": " + error.what());
  }
}

/// The same for a described scheme, by formulas in all its real parameters that hold wherever they exist:
/// those of the papers for J_s at all s, s = 0 and s = 1 included. Where a formula has no value, or none is
/// found, by the scheme's own masks. free_values[i] stands for free parameter i. R: Rational, Algebraic or
/// RationalFunction. Throws as above and as instantiate does.
template <ExactRing R>
EndWeights<R> end_weights(const SchemeDescription& scheme, OpenEnd end, std::span<const R> free_values = {});

/// The exact weights rounded to double. Throws InputError when parameters are free, and for clamped ends of
/// masks that are not known exactly.
[[nodiscard]] EndWeights<double> end_weights_in_double(const SchemeDescription& scheme, OpenEnd end);

/// The least number of own points that the weights refer to; at least 2, so that there is a span.
template <class R>
std::size_t least_points(const EndWeights<R>& weights) {
  int last = 1;
  for (const auto& end : {weights.start, weights.finish}) {
    for (const Laurent<R>& point : end) last = std::max(last, point.last());
  }
  return static_cast<std::size_t>(last) + 1;
}

/// The open polygon of the points P_0 .. P_{n-1} with the added points at both ends. R acts on points from
/// the left. Throws InputError when there are fewer than least_points(weights) points: an added point would
/// depend on points beyond the other end.
template <class R, class Point>
ControlPolygon<Point> with_ends(const std::vector<Point>& points, const EndWeights<R>& weights) {
  const std::size_t least = least_points(weights);
  if (points.size() < least) {
    throw InputError("an open curve with these ends needs at least " + std::to_string(least) +
                     " control points, there are " + std::to_string(points.size()) +
                     ": the points added at one end would lie beyond the other");
  }
  const auto weighed = [&](const Laurent<R>& w, auto place) {
    Point sum = w[0] * points[place(0)];
    for (int j = 1; j <= w.last(); ++j) sum = sum + w[j] * points[place(static_cast<std::size_t>(j))];
    return sum;
  };
  const std::size_t n = points.size();
  std::vector<Point> all;
  for (auto w = weights.start.rbegin(); w != weights.start.rend(); ++w)
    all.push_back(weighed(*w, [](std::size_t j) { return j; }));
  all.insert(all.end(), points.begin(), points.end());
  for (const Laurent<R>& w : weights.finish)
    all.push_back(weighed(w, [n](std::size_t j) { return n - 1 - j; }));
  return open_polygon(std::move(all), weights.start.size(), weights.finish.size());
}

}  // namespace subdiv
