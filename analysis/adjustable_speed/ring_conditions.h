#pragma once

#include <string>
#include <vector>

#include "analysis/adjustable_speed/characteristic_ring.h"

namespace subdiv {

/// Signs of Bezier differences that make the characteristic ring regular and injective (in the manner of
/// Karciauskas & Peters, section III, who take them at samples). Let b be the coefficients of the corner
/// patch or of the patch at the first spoke. If
///
///   the x of all b(i+1, j) - b(i, j) are negative, the y positive,
///   the x and the y of all b(i, j+1) - b(i, j) are negative,
///
/// then so are the derivatives f_i and f_j, whose Bezier coefficients these are, on the closed patch, and the
/// Jacobian x_i y_j - y_i x_j is positive there. The patch at the next spoke is a mirror image, orientation
/// included. Patches join C^1 across their borders, the spokes and the ring's borders, with sizes sigma and q
/// (characteristic_ring_joins.h), so that the whole map is a local homeomorphism: regular.
///
/// Injective: let also the end of the outer border's half on the first spoke have x > 0. This half runs from
/// the bisectrix, y = 0, along the corner and the side with falling x, so that it stays in x > 0; it ends on
/// the spoke at the angle -pi/n. Within a half plane the argument changes by the angle between the ends, pi/n
/// for each of the 2 n halves, in one direction: the outer border winds once around 0. By the covering
/// argument of analysis/mesh/characteristic_map.h, with f(q x) = lambda f(x) in place of f(x/2) = lambda
/// f(x), f is injective.
///
/// Points are those of characteristic_ring.h: x and y are scaled by positive numbers, which changes no sign.
template <class R>
struct RingCondition {
  std::string name;  ///< "corner x b(1,0)-b(0,0)"
  int sign;          ///< that of the value, strictly
  R value;           ///< the difference, or the end's x
};

/// All of them: 48 of each patch, and the end on the spoke.
template <class R>
std::vector<RingCondition<R>> ring_conditions(const RingSector<RingPoint<R>>& sector) {
  std::vector<RingCondition<R>> result;
  const auto add_patch = [&](const std::string& patch, const BezierPatch<RingPoint<R>>& b) {
    const auto add = [&](std::size_t k, std::size_t i, std::size_t j, std::size_t next, int sign) {
      const std::size_t here = 4 * i + j;
      const auto label = [](std::size_t slot) {
        return "b(" + std::to_string(slot / 4) + "," + std::to_string(slot % 4) + ")";
      };
      result.push_back({patch + (k == 0 ? " x " : " y ") + label(next) + "-" + label(here), sign,
                        b[next][k] - b[here][k]});
    };
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        if (i < 3) {
          add(0, i, j, 4 * (i + 1) + j, -1);
          add(1, i, j, 4 * (i + 1) + j, 1);
        }
        if (j < 3) {
          add(0, i, j, 4 * i + j + 1, -1);
          add(1, i, j, 4 * i + j + 1, -1);
        }
      }
    }
  };
  add_patch("corner", sector.corner);
  add_patch("side", sector.first_side);
  result.push_back({"side x b(0,3)", 1, sector.first_side[3][0]});
  return result;
}

}  // namespace subdiv
