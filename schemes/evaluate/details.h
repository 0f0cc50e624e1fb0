#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "schemes/evaluate/control_polygon.h"

namespace subdiv {

/// Multi-resolution design (js-report 10): point `index` of level `level` is moved by `displacement` before
/// the next step is taken. Level 0 is the control polygon.
template <class Point>
struct Detail {
  int level = 0;        ///< from 0, the control polygon
  long long index = 0;  ///< of the point at that level
  Point displacement;   ///< what is added to it
};

/// Details in the order in which evaluation meets them, by level and index. Several at the same place add up.
template <class Point>
class Details {
 public:
  Details() = default;
  /// In any order: they are sorted.
  explicit Details(std::vector<Detail<Point>> details) : details_(std::move(details)) {
    std::stable_sort(details_.begin(), details_.end(), precedes);
  }

  [[nodiscard]] bool empty() const { return details_.empty(); }
  /// The finest level with a detail; -1 when there is none.
  [[nodiscard]] int last_level() const { return details_.empty() ? -1 : details_.back().level; }
  [[nodiscard]] std::span<const Detail<Point>> all() const { return details_; }

  /// The details of one level.
  [[nodiscard]] std::span<const Detail<Point>> at_level(int level) const {
    const auto begin = std::partition_point(details_.begin(), details_.end(),
                                            [&](const auto& d) { return d.level < level; });
    const auto end =
        std::partition_point(begin, details_.end(), [&](const auto& d) { return d.level == level; });
    return all().subspan(static_cast<std::size_t>(begin - details_.begin()),
                         static_cast<std::size_t>(end - begin));
  }

  /// Moves a point of a level by the details that stand at its index.
  static void apply(std::span<const Detail<Point>> level, long long index, Point& point) {
    auto at =
        std::partition_point(level.begin(), level.end(), [&](const auto& d) { return d.index < index; });
    for (; at != level.end() && at->index == index; ++at) point = point + at->displacement;
  }

 private:
  static bool precedes(const Detail<Point>& a, const Detail<Point>& b) {
    return std::tie(a.level, a.index) < std::tie(b.level, b.index);
  }
  std::vector<Detail<Point>> details_;
};

/// Throws std::out_of_range that names the first detail beyond the depth or beyond the points of its level.
template <class Point>
void require_places(const Details<Point>& details, const Topology& topology, int arity, int depth) {
  for (const Detail<Point>& d : details.all()) {
    const bool level = d.level >= 0 && d.level <= depth;
    const std::size_t count = level ? refined_points(topology, arity, d.level) : 0;
    if (!level || d.index < 0 || static_cast<std::size_t>(d.index) >= count) {
      throw std::out_of_range("detail at level " + std::to_string(d.level) + ", point " +
                              std::to_string(d.index) + ": " +
                              (level ? "the level has " + std::to_string(count) + " points"
                                     : "the levels are 0 to " + std::to_string(depth)));
    }
  }
}

}  // namespace subdiv
