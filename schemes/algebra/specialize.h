#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// A polynomial or rational function of the one variable x_i, at x_i = value in any field. A variable x_j
/// with j > i, and over an exact field a pole, throws std::domain_error; variables with j < i are taken to be
/// 0.
template <class Function, class R>
R specialize(const Function& f, int i, const R& value) {
  std::vector<R> point(static_cast<std::size_t>(i) + 1, R(0));
  point.back() = value;
  return f.evaluate(std::span<const R>(point));
}

}  // namespace subdiv
