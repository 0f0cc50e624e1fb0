#pragma once

#include <array>
#include <cstddef>

#include "analysis/adjustable_speed/characteristic_ring.h"

namespace subdiv {

/// The formulas (9) of Karciauskas & Peters, Adjustable speed surface subdivision (2009), for the Bezier
/// coefficients t_(i, j) of a sector's tensor border, t_00 = (1, 0), as points (x, y cot(pi/n)): with z_0 =
/// h_0/(2 cos(pi/n)), z_1 = h_1 sin(pi/n), z_2 and z_3 like z_0, z_4 like z_1, which (12) says, they are
/// rational in h_0 .. h_4 and cos(2 pi/n). t_(j, i) is the mirror image of t_(i, j) in the bisectrix.
struct BorderPlace {
  std::size_t i;
  std::size_t j;
  const char* printed;
};
inline constexpr std::array border_places{
    BorderPlace{1, 0, "(2 z1 s̄ + z2 c̄, -2 z1 c̄ + z2 s̄)"},
    BorderPlace{2, 0, "(z0 c̄ + z1 s̄, z0 s̄ - z1 c̄)"},
    BorderPlace{3, 0, "(z0 c̄, z0 s̄)"},
    BorderPlace{1, 1, "(2 z4/s̄, 0)"},
    BorderPlace{2, 1, "(z3 c̄ + z4 s̄, z3 s̄ - z4 c̄)"},
    BorderPlace{3, 1, "(z3 c̄, z3 s̄)"},
    BorderPlace{2, 2, "(z3 s̄ - z4 c/(2 s̄), 0)"},
    BorderPlace{3, 2, "(c̄ (z3 (1+c)/2 - z4 c c̄/(2 s̄)), s̄ (z3 (1+c)/2 - z4 c c̄/(2 s̄)))"}};

/// The points of border_places, in their order. tangent is the factor of z3 in t_22 over cos(pi/n): tan(pi/n)
/// as printed, 1 where z3 has the factor cos(pi/n) instead.
template <class R>
std::array<RingPoint<R>, border_places.size()> border_formulas(const std::array<R, 5>& h,
                                                               const R& one_plus_cosine, const R& tangent) {
  const R half = fraction<R>(1, 2);
  const R cosine = half * one_plus_cosine;  // cos^2(pi/n)
  const R sine = R(1) - cosine;             // sin^2(pi/n)
  const R c = one_plus_cosine - R(1);
  const auto turned = [&](const R& along, const R& across) {
    // z c̄ + z' s̄ and z s̄ - z' c̄ for z = along/(2 c̄), z' = across s̄
    return RingPoint<R>{half * along + across * sine, half * along - across * cosine};
  };
  const R spoke = cosine * (half * h[3] - half * c * h[4]);
  return {turned(h[2], R(2) * h[1]),
          turned(h[0], h[1]),
          turned(h[0], R(0)),
          RingPoint<R>{R(2) * h[4], R(0)},
          turned(h[3], h[4]),
          turned(h[3], R(0)),
          RingPoint<R>{half * h[3] * tangent - half * c * h[4], R(0)},
          RingPoint<R>{spoke, spoke}};
}

}  // namespace subdiv
