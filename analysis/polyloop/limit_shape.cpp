#include "analysis/polyloop/limit_shape.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "analysis/polyloop/transfer_function.h"
#include "schemes/algebra/turn.h"

namespace subdiv {

std::vector<Algebraic> mode_gains(const Laurent<Rational>& weights, int n) {
  if (n < 1) throw std::domain_error("a closed polyloop has at least one vertex");
  const Laurent<Algebraic> exact = map_coefficients(weights, [](const Rational& q) { return Algebraic(q); });
  std::vector<Algebraic> gains;
  for (int k = 0; k <= n / 2; ++k)
    gains.push_back(transfer_at_cosine(exact, cosine_of_turn<Algebraic>(k, n)));
  return gains;
}

std::vector<int> slowest_modes(const Laurent<Rational>& weights, int n) {
  const std::vector<Algebraic> gains = mode_gains(weights, n);
  std::vector<int> result;
  Algebraic largest(-1);
  for (std::size_t k = 1; k < gains.size(); ++k) {
    const Algebraic modulus = abs(gains[k]);
    if (modulus < largest) continue;
    if (modulus > largest) result.clear();
    largest = modulus;
    result.push_back(static_cast<int>(k));
  }
  return result;
}

Algebraic ellipse_end(int n) {
  if (n < 4) throw std::domain_error("polyloops of fewer than four vertices have no mode beyond 1");
  const Algebraic first = Algebraic(1) - cosine_of_turn<Algebraic>(1, n);
  const Algebraic last = Algebraic(1) - cosine_of_turn<Algebraic>(n / 2, n);
  return Algebraic(2) / (first + last);
}

HalfAxes limit_ellipse(const Polyline& polygon) {
  if (!polygon.topology.closed || polygon.coordinates.size() != 2)
    throw std::invalid_argument("the limit ellipse is that of a closed plane polygon");
  const std::size_t n = polygon.coordinates[0].size();
  std::complex<double> forward;
  std::complex<double> backward;
  for (std::size_t j = 0; j < n; ++j) {
    const std::complex<double> point(polygon.coordinates[0][j], polygon.coordinates[1][j]);
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    forward += point * std::polar(1.0, -angle);
    backward += point * std::polar(1.0, angle);
  }
  if (n < 3) return {};
  const double a = std::abs(forward) / static_cast<double>(n);
  const double b = std::abs(backward) / static_cast<double>(n);
  return {a + b, std::abs(a - b)};
}

}  // namespace subdiv
