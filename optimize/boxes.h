#pragma once

#include <array>
#include <vector>

#include "optimize/problem.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// A box of parameters with exact ends.
struct Box {
  std::vector<Range> sides;  ///< one a parameter

  /// The middle, rounded to balls at the precision in bits.
  [[nodiscard]] std::vector<Interval> centre(long precision) const {
    std::vector<Interval> result;
    for (const Range& side : sides) result.emplace_back((side.lower + side.upper) / Rational(2), precision);
    return result;
  }
  /// Half the sides' lengths, rounded to balls.
  [[nodiscard]] std::vector<Interval> radius(long precision) const {
    std::vector<Interval> result;
    for (const Range& side : sides) result.emplace_back((side.upper - side.lower) / Rational(2), precision);
    return result;
  }
  /// A ball around each side.
  [[nodiscard]] std::vector<Interval> balls(long precision) const {
    std::vector<Interval> result;
    for (const Range& side : sides) result.push_back(Interval::hull(side.lower, side.upper, precision));
    return result;
  }
  /// Whether the box o is a part of this one; both closed.
  [[nodiscard]] bool contains(const Box& o) const {
    for (std::size_t j = 0; j < sides.size(); ++j) {
      if (o.sides[j].lower < sides[j].lower || sides[j].upper < o.sides[j].upper) return false;
    }
    return true;
  }
  /// Cut in the middle of one side.
  [[nodiscard]] std::array<Box, 2> halves(std::size_t side) const {
    std::array<Box, 2> result{*this, *this};
    const Rational middle = (sides[side].lower + sides[side].upper) / Rational(2);
    result[0].sides[side].upper = middle;
    result[1].sides[side].lower = middle;
    return result;
  }
};

}  // namespace subdiv
