#include "schemes/algebra/turn.h"

#include <numeric>

namespace subdiv {

template <>
Algebraic cosine_of_turn<Algebraic>(int k, int n) {
  Algebraic result;
  const int common = std::gcd(2 * k, n);
  qqbar_cos_pi(result.raw(), 2 * k / common, static_cast<ulong>(n / common));
  return result;
}

template <>
Interval cosine_of_turn<Interval>(int k, int n) {
  return cos(pi() * Interval(fraction<Rational>(2L * k, n)));
}

}  // namespace subdiv
