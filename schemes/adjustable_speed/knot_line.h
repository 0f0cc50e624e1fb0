#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// Weights of the control points P_{-1}, P_0, P_1, P_2 of a knot line.
template <class R>
using LineWeights = std::array<R, 4>;

/// Cubic splines along a line of control points through an extraordinary vertex, with knots symmetric about
/// it: -a_3, -a_2, -a_1, 0, a_1, a_2, a_3, 0 < a_1 < a_2 < a_3. With f the polar form of the piece on [0,
/// a_1] (symmetric, affine in each argument, f(u, u, u) the curve; Ramshaw 1987),
///
///   P_0 = f(-a_1, 0, a_1) at the vertex, P_1 = f(0, a_1, a_2) and P_2 = f(a_1, a_2, a_3) outwards,
///   P_{-1} = f(-a_2, -a_1, 0) mirrored.
///
/// Knot insertion, Bezier points and the change to other knots are all values of f. Knots are told apart by
/// their places in the list, so that a weight that vanishes for all knots is exactly 0 in any ring R.
template <class R>
class KnotLine {
 public:
  static constexpr std::size_t zero = 2;    ///< the place of the knot 0 in the list
  static constexpr std::size_t first = 3;   ///< a_1
  static constexpr std::size_t second = 4;  ///< a_2
  static constexpr std::size_t third = 5;   ///< a_3
  static constexpr std::size_t other = 6;   ///< others[0]; others[1] follows, ..

  /// a_1, a_2, a_3, and other numbers that are used as arguments.
  explicit KnotLine(const std::array<R, 3>& knots, const std::vector<R>& others = {})
      : values_{R(0) - knots[1], R(0) - knots[0], R(0), knots[0], knots[1], knots[2]} {
    values_.insert(values_.end(), others.begin(), others.end());
  }

  /// f at three places of the list, knots before others and outer ones before inner ones: de Boor's
  /// algorithm.
  [[nodiscard]] LineWeights<R> polar(std::size_t x, std::size_t y, std::size_t z) const {
    std::array<LineWeights<R>, 4> level{unit(0), unit(1), unit(2), unit(3)};
    std::size_t left = 3;
    for (const std::size_t argument : {x, y, z}) {
      for (std::size_t i = 0; i < left; ++i)
        level[i] = between(level[i], level[i + 1], 3 - left + i, i + 3, argument);
      --left;
    }
    return level[0];
  }

 private:
  static LineWeights<R> unit(std::size_t i) {
    LineWeights<R> result{R(0), R(0), R(0), R(0)};
    result[i] = R(1);
    return result;
  }
  /// The affine function with the value `at_low` at the knot `low` and `at_high` at the knot `high`.
  [[nodiscard]] LineWeights<R> between(const LineWeights<R>& at_low, const LineWeights<R>& at_high,
                                       std::size_t low, std::size_t high, std::size_t argument) const {
    if (argument == low) return at_low;
    if (argument == high) return at_high;
    const R width = values_[high] - values_[low];
    const R below = (values_[high] - values_[argument]) / width;
    const R above = (values_[argument] - values_[low]) / width;
    LineWeights<R> result{R(0), R(0), R(0), R(0)};
    for (std::size_t i = 0; i < result.size(); ++i) {  // zeros stay so whatever is known of the knots
      if (!is_zero(at_low[i])) add_product(result[i], below, at_low[i]);
      if (!is_zero(at_high[i])) add_product(result[i], above, at_high[i]);
    }
    return result;
  }

  std::vector<R> values_;
};

}  // namespace subdiv
