#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "analysis/mesh/lattice_mask.h"
#include "analysis/mesh/mode_matrix.h"

namespace subdiv {

/// A control net in the plane around a vertex of valence n, the points w^j v(a, b) at the places of sector j,
/// w = e^{2 pi i mode/n}, symmetric about the first spoke (mode_matrix.h), the vertex at 0; an eigenvector of
/// subdivision when v' = eigenvalue v. One half of a sector, 0 <= b <= a, is stored.
template <class R>
class CharacteristicNet {
 public:
  /// Without points yet: sides 3 or 4, the valence n, the Fourier mode, and the eigenvalue.
  CharacteristicNet(int sides, int valence, int mode, R eigenvalue)
      : sides_(sides),
        valence_(valence),
        mode_(mode),
        eigenvalue_(std::move(eigenvalue)),
        turn_(turn<R>(mode, valence)) {}

  [[nodiscard]] int sides() const { return sides_; }
  [[nodiscard]] int valence() const { return valence_; }
  [[nodiscard]] int mode() const { return mode_; }
  [[nodiscard]] const R& eigenvalue() const { return eigenvalue_; }
  /// The rings that are known: max(a, b) or a + b (fan.h).
  [[nodiscard]] int rings() const { return rings_; }
  [[nodiscard]] int ring_of(int a, int b) const { return sides_ == 4 ? std::max(a, b) : a + b; }

  /// v in lattice steps from the vertex along the directions of sector 0, in sector 0 (a, b >= 0) and in the
  /// one before it (b < 0; triangles: a + b >= 0).
  [[nodiscard]] PlaneNumber<R> at(int a, int b) const {
    if (b < 0) return conjugate(at(sides_ == 4 ? a : a + b, -b));
    if (b > a) return turn_ * conjugate(at(b, a));
    return values_[slot(a, b)];
  }

  /// Adds the next ring, value(a, b) at its places with 0 <= b <= a; value may ask for inner rings.
  template <class Value>
  void add_ring(Value&& value) {
    const int ring = rings_ + 1;
    values_.resize(slot(ring + 1, 0));
    for (int b = 0; b <= ring; ++b) {
      const int a = sides_ == 4 ? ring : ring - b;
      if (b <= a) values_[slot(a, b)] = value(a, b);
    }
    rings_ = ring;
  }

 private:
  [[nodiscard]] static std::size_t slot(int a, int b) {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(a + 1) / 2 + static_cast<std::size_t>(b);
  }

  int sides_;
  int valence_;
  int mode_;
  int rings_ = 0;
  R eigenvalue_;
  PlaneNumber<R> turn_;
  std::vector<PlaneNumber<R>> values_{PlaneNumber<R>{}};
};

inline double approximate_value(double x) { return x; }
inline double approximate_value(const Interval& x) { return x.to_double(); }

/// Adds rings by the scheme's mask: v(x) = sum over y of c(x - 2 y) v(y)/eigenvalue, for rings beyond 2 reach
/// + 1, where rules are regular: the point at row 2 reach + 2 belongs to a face that no ring of `reach` faces
/// joins to the vertex.
template <class R>
void extend(CharacteristicNet<R>& net, const LatticeMask<R>& mask, int rings) {
  const R inverse = R(1) / net.eigenvalue();
  const int last = mask.last();
  while (net.rings() < rings) {
    net.add_ring([&](int a, int b) {
      PlaneNumber<R> sum;
      for (int i = -last + (a + last) % 2; i <= last; i += 2) {
        for (int j = -last + (b + last) % 2; j <= last; j += 2) {
          const R& weight = mask(i, j);
          if (is_zero(weight)) continue;
          const PlaneNumber<R> point = net.at((a - i) / 2, (b - j) / 2);
          add_product(sum.x, weight, point.x);
          add_product(sum.y, weight, point.y);
        }
      }
      return inverse * sum;
    });
  }
}

/// The net of an eigenpair of a scheme's mode_matrix on eigenvalue_rings(scheme) rings, carried on to
/// `rings` >= 2 reach + 1 rings. fan has 2 reach + 1 rings; matrix is its mode_matrix.
template <class R>
CharacteristicNet<R> characteristic_net(const FanMatrix<R>& fan, const Matrix<R>& matrix, int mode,
                                        const RealEigenpair<R>& pair, const LatticeMask<R>& mask, int rings) {
  const std::vector<FanPlace> places = sector_places(fan.sides, fan.rings);
  Vector<R> all = Vector<R>::Constant(fan.places(), R(0));
  const Eigen::Index core = pair.vector.size();
  all.head(core) = pair.vector;
  // A place beyond the core depends on rings further in alone, so that eigenvalue v_p = sum of T_pq v_q says
  // what v_p is.
  for (Eigen::Index p = core; p < fan.places(); ++p) {
    const FanPlace& place = places[static_cast<std::size_t>(p)];
    const int ring = fan.sides == 4 ? std::max(place.a, place.b) : place.a + place.b;
    const auto inner = static_cast<Eigen::Index>(sector_places(fan.sides, ring - 1).size());
    for (Eigen::Index q = 0; q < inner; ++q) {
      if (!is_zero(matrix(p, q))) all(p) = all(p) + matrix(p, q) * all(q);
    }
    all(p) = all(p) / pair.value;
  }
  // The first spoke is the positive real axis.
  if (approximate_value(all(0)) < 0) all = Vector<R>(all.unaryExpr([](const R& c) { return R(0) - c; }));
  const std::vector<PlaneNumber<R>> values = mode_values(fan.sides, fan.valence, mode, fan.rings, all);
  CharacteristicNet<R> net(fan.sides, fan.valence, mode, pair.value);
  for (int ring = 1; ring <= fan.rings; ++ring) {
    net.add_ring([&](int a, int b) {
      std::size_t p = 0;
      while (places[p].a != a || places[p].b != b) ++p;
      return values[p];
    });
  }
  extend(net, mask, rings);
  return net;
}

}  // namespace subdiv
