#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include "schemes/mesh/fan.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// Steps along the two directions of the regular lattice of quads or triangles.
struct LatticeOffset {
  int a = 0;  ///< along the first direction
  int b = 0;  ///< along the second
  friend bool operator==(const LatticeOffset&, const LatticeOffset&) = default;
};

/// The lattice offset of a place around a regular vertex (4 or 6 sectors), the directions of which are those
/// of sector 0.
[[nodiscard]] inline LatticeOffset lattice_offset(int sides, const FanPlace& place) {
  constexpr std::array<LatticeOffset, 4> square{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  constexpr std::array<LatticeOffset, 6> hexagon{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
  const std::size_t n = sides == 4 ? square.size() : hexagon.size();
  const auto direction = [&](int sector) {
    const std::size_t k = static_cast<std::size_t>(sector) % n;
    return sides == 4 ? square.at(k) : hexagon.at(k);
  };
  const LatticeOffset u = direction(place.sector);
  const LatticeOffset v = direction(place.sector + 1);
  return {place.a * u.a + place.b * v.a, place.a * u.b + place.b * v.b};
}

/// The mask of a scheme on the regular lattice: P'(x) = sum over y of c(x - 2 y) P(y), x and y lattice points
/// of the fine and the coarse level; c(o) = 0 unless both components of o lie in -reach - 1 .. reach + 1.
template <class R>
class LatticeMask {
 public:
  /// All coefficients 0, for offsets whose components lie in -last .. last.
  explicit LatticeMask(int last)
      : last_(last),
        values_(static_cast<std::size_t>(2 * last + 1) * static_cast<std::size_t>(2 * last + 1), R(0)) {}

  [[nodiscard]] int last() const { return last_; }
  [[nodiscard]] const R& operator()(int a, int b) const { return values_[slot(a, b)]; }
  [[nodiscard]] R& operator()(int a, int b) { return values_[slot(a, b)]; }
  /// Whether an offset lies in -last .. last in both components.
  [[nodiscard]] bool contains(int a, int b) const {
    return -last_ <= a && a <= last_ && -last_ <= b && b <= last_;
  }
  friend bool operator==(const LatticeMask& a, const LatticeMask& b) {
    return a.last_ == b.last_ && a.values_ == b.values_;
  }

 private:
  [[nodiscard]] std::size_t slot(int a, int b) const {
    return static_cast<std::size_t>(a + last_) * static_cast<std::size_t>(2 * last_ + 1) +
           static_cast<std::size_t>(b + last_);
  }
  int last_;
  std::vector<R> values_;
};

/// The same mask with the least `last`, at least 1: an exact ring knows which coefficients are 0.
template <class R>
LatticeMask<R> trimmed(const LatticeMask<R>& mask) {
  int last = 1;
  for (int i = -mask.last(); i <= mask.last(); ++i) {
    for (int j = -mask.last(); j <= mask.last(); ++j) {
      if (!is_zero(mask(i, j))) last = std::max({last, std::abs(i), std::abs(j)});
    }
  }
  LatticeMask<R> result(last);
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j) result(i, j) = mask(i, j);
  }
  return result;
}

/// Read off the scheme's rules around a regular vertex.
template <class R>
LatticeMask<R> lattice_mask(const MeshScheme<R>& scheme) {
  const bool quads = scheme.split == MeshSplit::quads;
  const int sides = quads ? 4 : 3;
  const int regular = quads ? 4 : 6;
  const int rings = scheme.reach + 3;
  const MeshTopology mesh = fan_topology(sides, regular, rings);
  const std::vector<FanPlace> places = sector_places(sides, rings);
  LatticeMask<R> mask(scheme.reach + 1);
  const auto read = [&](LatticeOffset fine, const Stencil<R>& stencil) {
    for (const auto& [vertex, weight] : stencil.terms()) {
      if (is_zero(weight)) continue;
      LatticeOffset coarse;
      if (vertex > 0) {
        const auto count = static_cast<int>(places.size());
        FanPlace place = places[static_cast<std::size_t>((vertex - 1) % count)];
        place.sector = (vertex - 1) / count;
        coarse = lattice_offset(sides, place);
      }
      mask(fine.a - 2 * coarse.a, fine.b - 2 * coarse.b) = weight;
    }
  };
  int first = -1;  // from the vertex along the first direction, and along the second
  for_each_outgoing(mesh, 0, [&](int h) {
    if (mesh.target(h) == 1) first = h;
  });
  read({0, 0}, scheme.vertex_rule(mesh, 0));
  read({1, 0}, scheme.edge_rule(mesh, first));
  read({0, 1}, scheme.edge_rule(mesh, mesh.turn_left(first)));
  read({1, 1}, quads ? scheme.face_rule(mesh, mesh.face(first)) : scheme.edge_rule(mesh, mesh.next(first)));
  return mask;
}

}  // namespace subdiv
