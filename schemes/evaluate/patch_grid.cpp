#include "schemes/evaluate/patch_grid.h"

#include <map>
#include <stdexcept>
#include <utility>

namespace subdiv {
namespace {

using Place = std::array<int, 2>;

bool inside(int sides, int n, const Place& p) {
  return p[0] > 0 && p[1] > 0 && (sides == 4 ? p[0] < n && p[1] < n : p[0] + p[1] < n);
}

/// The point of side q, t steps from its first corner.
Place on_side(int sides, int n, int q, int t) {
  if (q == 0) return {t, 0};
  if (sides == 3) return q == 1 ? Place{n - t, t} : Place{0, n - t};
  return q == 1 ? Place{n, t} : q == 2 ? Place{n - t, n} : Place{0, n - t};
}

std::vector<Place> ordered_points(int sides, int n) {
  std::vector<Place> points;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      if (inside(sides, n, {i, j})) points.push_back({i, j});
    }
  }
  for (int q = 0; q < sides; ++q) {
    for (int t = 1; t < n; ++t) points.push_back(on_side(sides, n, q, t));
  }
  for (int q = 0; q < sides; ++q) points.push_back(on_side(sides, n, q, 0));
  return points;
}

std::vector<std::vector<Place>> ordered_cells(int sides, int n) {
  std::vector<std::vector<Place>> cells;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < (sides == 4 ? n : n - j); ++i) {
      if (sides == 4) {
        cells.push_back({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        continue;
      }
      cells.push_back({{i, j}, {i + 1, j}, {i, j + 1}});
      if (i + j + 1 < n) cells.push_back({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
    }
  }
  return cells;
}

}  // namespace

PatchGrid patch_grid(int sides, int depth) {
  constexpr int deepest = 12;
  if ((sides != 3 && sides != 4) || depth < 0 || depth > deepest)
    throw std::invalid_argument("a patch has 3 or 4 sides and 0 to 12 splits");
  PatchGrid grid;
  grid.sides = sides;
  grid.steps = 1 << depth;
  const int n = grid.steps;
  grid.points = ordered_points(sides, n);
  std::map<Place, int> number;
  for (std::size_t p = 0; p < grid.points.size(); ++p) number[grid.points[p]] = static_cast<int>(p);

  std::map<std::pair<Place, Place>, int> half_edge;
  std::vector<std::pair<Place, Place>> ends;
  for (const auto& cell : ordered_cells(sides, n)) {
    for (std::size_t c = 0; c < cell.size(); ++c) {
      grid.cells.push_back(number.at(cell[c]));
      ends.emplace_back(cell[c], cell[(c + 1) % cell.size()]);
      half_edge[ends.back()] = static_cast<int>(ends.size()) - 1;
    }
  }
  grid.opposites.assign(ends.size(), -1);
  for (std::size_t h = 0; h < ends.size(); ++h) {
    const auto found = half_edge.find({ends[h].second, ends[h].first});
    if (found != half_edge.end()) grid.opposites[h] = found->second;
  }
  for (int q = 0; q < sides; ++q) {
    for (int t = 0; t < n; ++t) {
      const int h = half_edge.at({on_side(sides, n, q, t), on_side(sides, n, q, t + 1)});
      grid.side_half_edges.push_back(h);
      grid.opposites[static_cast<std::size_t>(h)] = -1 - q;
    }
  }
  return grid;
}

}  // namespace subdiv
