#include "analysis/quad_topology.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace subdiv {
namespace {

/// Sets that merge.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size), sets_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t sets() const { return sets_; }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i == j) return;
    parent_[i] = j;
    --sets_;
  }

 private:
  std::vector<std::size_t> parent_;
  std::size_t sets_;
};

/// One side of a quad: its vertices in rising order, whether the quad runs through it the other way round,
/// and the places of the corners (4 x quad + corner) at the lower and the higher vertex.
struct Side {
  std::array<std::size_t, 2> ends;
  bool reversed;
  std::array<std::size_t, 2> corners;
};

std::vector<Side> sorted_sides(std::size_t vertices, std::span<const std::array<std::size_t, 4>> quads) {
  std::vector<Side> sides;
  sides.reserve(4 * quads.size());
  for (std::size_t f = 0; f < quads.size(); ++f) {
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t next = (c + 1) % 4;
      const std::size_t a = quads[f][c];
      const std::size_t b = quads[f][next];
      if (a >= vertices) throw std::out_of_range("vertex " + std::to_string(a) + " of a quad does not exist");
      const std::size_t place = 4 * f;
      sides.push_back(a <= b ? Side{{a, b}, false, {place + c, place + next}}
                             : Side{{b, a}, true, {place + next, place + c}});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) { return x.ends < y.ends; });
  return sides;
}

/// Loops of border edges; every border vertex of a manifold has two of them.
std::size_t count_loops(std::size_t vertices, const std::vector<std::array<std::size_t, 2>>& borders) {
  Partition joined(vertices);
  std::vector<bool> on_border(vertices, false);
  for (const auto& [a, b] : borders) {
    joined.join(a, b);
    on_border[a] = on_border[b] = true;
  }
  std::size_t loops = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (on_border[v] && joined.find(v) == v) ++loops;
  }
  return loops;
}

}  // namespace

QuadTopology quad_topology(std::size_t vertices, std::span<const std::array<std::size_t, 4>> quads) {
  const std::vector<Side> sides = sorted_sides(vertices, quads);
  QuadTopology result{vertices, 0, quads.size(), 0, 0, true, true};
  Partition joined(vertices);
  Partition fans(4 * quads.size());  // corners around one vertex, joined where their quads share an edge
  std::vector<std::array<std::size_t, 2>> borders;
  for (std::size_t i = 0; i < sides.size(); ++result.edges) {
    const Side& side = sides[i];
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].ends == side.ends) ++end;
    joined.join(side.ends[0], side.ends[1]);
    if (side.ends[0] == side.ends[1] || end - i > 2) result.manifold = false;
    if (end - i == 1) borders.push_back(side.ends);
    if (end - i == 2) {
      const Side& other = sides[i + 1];
      if (side.corners[0] / 4 == other.corners[0] / 4) result.manifold = false;
      if (side.reversed == other.reversed) result.oriented = false;
      for (std::size_t k = 0; k < 2; ++k) fans.join(side.corners[k], other.corners[k]);
    }
    i = end;
  }
  std::vector<std::pair<std::size_t, std::size_t>> fan_at;  // vertex, fan
  for (std::size_t corner = 0; corner < 4 * quads.size(); ++corner) {
    if (fans.find(corner) == corner) fan_at.emplace_back(quads[corner / 4][corner % 4], corner);
  }
  std::sort(fan_at.begin(), fan_at.end());
  for (std::size_t i = 1; i < fan_at.size(); ++i) {
    if (fan_at[i].first == fan_at[i - 1].first) result.manifold = false;
  }
  result.borders = count_loops(vertices, borders);
  result.components = joined.sets();
  return result;
}

}  // namespace subdiv
