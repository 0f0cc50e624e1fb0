#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace subdiv::test {

/// One step of J_s on values, zero beyond both ends, by the coefficients of jsplines equation (1).
inline std::vector<double> refine(const std::vector<double>& p, double s) {
  const std::vector<double> mask{(s - 1) / 16, s / 8, (9 - s) / 16, 1 - s / 4,
                                 (9 - s) / 16, s / 8, (s - 1) / 16};
  std::vector<double> fine(2 * p.size() + 5, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < mask.size(); ++k) fine[2 * i + k] += mask[k] * p[i];
  }
  return fine;
}

/// The largest difference of an order.
inline double largest_difference(std::vector<double> p, int order) {
  for (int i = 0; i < order; ++i) {
    for (std::size_t j = 1; j < p.size(); ++j) p[j - 1] = p[j] - p[j - 1];
    p.pop_back();
  }
  double largest = 0;
  for (const double x : p) largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace subdiv::test
