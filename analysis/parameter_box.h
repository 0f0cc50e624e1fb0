#pragma once

#include <cstddef>
#include <vector>

#include "schemes/algebra/rational.h"

namespace subdiv {

/// Parameters x_i in [lower_i, upper_i].
struct ParameterBox {
  std::vector<Rational> lower;  ///< one a parameter
  std::vector<Rational> upper;  ///< one a parameter, not below lower

  /// The product of the sides' lengths.
  [[nodiscard]] Rational volume() const {
    Rational product(1);
    for (std::size_t k = 0; k < lower.size(); ++k) product *= upper[k] - lower[k];
    return product;
  }
};

}  // namespace subdiv
