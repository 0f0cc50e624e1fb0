#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "schemes/evaluate/control_polygon.h"
#include "schemes/evaluate/details.h"
#include "schemes/evaluate/refinement_rule.h"

namespace subdiv {

/// One step of a scheme on a whole polygon. A closed one of n points becomes one of m n. An open one keeps as
/// many added points at both ends as its own determine, and point 0 of the result is the refined point 0.
/// Throws std::out_of_range when an open polygon has too few added points for the curve itself.
template <class R, class Point>
ControlPolygon<Point> refine_once(const Mask<R>& mask, const ControlPolygon<Point>& controls) {
  const auto rules = refinement_rules(mask);
  const Topology& coarse = controls.topology;
  const long long m = mask.arity;
  const auto spans = static_cast<long long>(coarse.spans());
  const auto reaches = [&](long long i) {
    const long long r = ((i % m) + m) % m;
    const auto& rule = rules[static_cast<std::size_t>(r)];
    const long long q = (i - r) / m;
    return q + rule.first >= -static_cast<long long>(coarse.before) &&
           q + rule.last() <= spans + static_cast<long long>(coarse.after);
  };
  long long first = 0;
  long long last = m * spans - (coarse.closed ? 1 : 0);
  if (!coarse.closed && coarse.points > 0) {
    while (reaches(first - 1)) --first;
    while (reaches(last + 1)) ++last;
  }
  ControlPolygon<Point> fine;
  for (long long i = first; coarse.points > 0 && i <= last; ++i) {
    const long long r = ((i % m) + m) % m;
    const auto& rule = rules[static_cast<std::size_t>(r)];
    const long long from = (i - r) / m + rule.first;
    Point sum = rule.weights.front() * controls.at(from);
    for (std::size_t k = 1; k < rule.weights.size(); ++k)
      sum = sum + rule.weights[k] * controls.at(from + static_cast<long long>(k));
    fine.points.push_back(std::move(sum));
  }
  fine.topology = {fine.points.size(), coarse.closed, static_cast<std::size_t>(-first),
                   static_cast<std::size_t>(last - m * spans + (coarse.closed ? 1 : 0))};
  return fine;
}

/// `depth` steps, level by level: every intermediate polygon is formed (Split & Tweak, js-report 1). Details
/// move points of their level before the next step. Throws as refine_once and require_places do.
template <class R, class Point>
ControlPolygon<Point> refine_level_by_level(const Scheme<R>& scheme, ControlPolygon<Point> controls,
                                            int depth, const Details<Point>& details = {}) {
  require_places(details, controls.topology, scheme.arity(), depth);
  for (int k = 0;; ++k) {
    for (const Detail<Point>& d : details.at_level(k)) {
      Point& point = controls.points[controls.topology.slot(d.index)];
      point = point + d.displacement;
    }
    if (k == depth) return controls;
    controls = refine_once(scheme.step(static_cast<std::size_t>(k)), controls);
  }
}

/// The points of the curve alone, without those that only carry its ends.
template <class Point>
std::vector<Point> curve_points(const ControlPolygon<Point>& polygon) {
  const auto begin = polygon.points.begin() + static_cast<std::ptrdiff_t>(polygon.topology.before);
  return {begin, polygon.points.end() - static_cast<std::ptrdiff_t>(polygon.topology.after)};
}

}  // namespace subdiv
