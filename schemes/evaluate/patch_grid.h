#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace subdiv {

/// The points and small faces into which `depth` splits cut one face of 3 or 4 corners: a grid of N = 2^depth
/// steps a side, with corner 0 at (0, 0), corner 1 at (N, 0), corner 2 at (N, N), corner 3 at (0, N), or
/// corner 2 at (0, N) for a triangle.
///
/// Points are numbered so that what one writer owns stands together: those inside, row by row; those inside
/// side 0, then side 1, .., each from its first corner to its second (side q runs from corner q to the next);
/// the corners. Small faces are numbered row by row, a triangle's upward and downward ones in turn.
struct PatchGrid {
  int sides = 4;                           ///< of the face: 3 or 4
  int steps = 1;                           ///< N
  std::vector<std::array<int, 2>> points;  ///< places in the grid, in the order of their numbers
  /// Of each small face its corners' point numbers, counter-clockwise, `sides` of them; for quads and upward
  /// triangles the first half-edge runs from grid point (a, b) to (a + 1, b).
  std::vector<int> cells;
  /// Of each small half-edge (its place in `cells`) the opposite one in the patch; -1 - q on side q.
  std::vector<int> opposites;
  /// The small half-edge on side q at step t, counted from the side's first corner: side_half_edges[q N + t].
  std::vector<int> side_half_edges;

  /// The number of points that lie on no side.
  [[nodiscard]] int inner_points() const {
    return sides == 4 ? (steps - 1) * (steps - 1) : (steps - 1) * (steps - 2) / 2;
  }
  [[nodiscard]] int side_points() const { return steps - 1; }
  [[nodiscard]] int faces() const { return steps * steps; }
  [[nodiscard]] std::size_t size() const { return points.size(); }
};

/// Throws std::invalid_argument unless sides is 3 or 4 and 0 <= depth <= 12.
[[nodiscard]] PatchGrid patch_grid(int sides, int depth);

}  // namespace subdiv
