#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "schemes/adjustable_speed/sector_stencil.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// sum += weight point, for points that are arrays of coordinates and for plain numbers.
template <class R, std::size_t dimension>
void add_weighted(std::array<R, dimension>& sum, const R& weight, const std::array<R, dimension>& point) {
  for (std::size_t i = 0; i < dimension; ++i) add_product(sum[i], weight, point[i]);
}
/// The same for plain numbers.
template <class R>
void add_weighted(R& sum, const R& weight, const R& point) {
  add_product(sum, weight, point);
}

/// The control points P of two rings around a vertex of valence n >= 3, numbered as fan_topology(4, n, 2)
/// does: the vertex, then 6 places (sector_places(4, 2)) a sector. P is a number, or an array of numbers.
template <class P>
class SectorNet {
 public:
  static constexpr std::size_t places = 6;  ///< in a sector

  /// 1 + 6 n points.
  SectorNet(int valence, std::vector<P> points) : valence_(valence), points_(std::move(points)) {}

  [[nodiscard]] int valence() const { return valence_; }
  [[nodiscard]] const std::vector<P>& points() const { return points_; }
  [[nodiscard]] const P& centre() const { return points_[0]; }
  /// Sectors are taken modulo n, from -n on.
  [[nodiscard]] const P& at(int sector, int place) const {
    const int turned = (sector + valence_) % valence_;
    return points_[1 + static_cast<std::size_t>(turned) * places + static_cast<std::size_t>(place)];
  }

 private:
  int valence_;
  std::vector<P> points_;
};

/// The stencil's point as sector `sector` of a net sees it. Net is a SectorNet or anything with its centre()
/// and at().
template <class R, class Net>
[[nodiscard]] auto apply(const SectorStencil<R>& stencil, const Net& net, int sector) {
  std::decay_t<decltype(net.centre())> sum{};
  add_weighted(sum, stencil.centre, net.centre());
  for (const auto& term : stencil.terms)
    add_weighted(sum, term.weight, net.at(sector + term.sector, term.place));
  return sum;
}

}  // namespace subdiv
