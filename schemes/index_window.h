#pragma once

namespace subdiv {

/// Consecutive indices first .. last of control points.
struct IndexWindow {
  int first = 0;  ///< the smallest
  int last = -1;  ///< the largest; first - 1 when there are none

  [[nodiscard]] int size() const { return last - first + 1; }
  friend bool operator==(const IndexWindow&, const IndexWindow&) = default;
};

}  // namespace subdiv
