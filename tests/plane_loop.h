#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace subdiv::test {

/// A closed polygon in the plane, in doubles: the second route of tests about curves.
using Points = std::vector<std::array<double, 2>>;

/// One step of J_{a,b}, from the stencils of jsplines 1.
inline Points refined(const Points& p, double a, double b) {
  const std::size_t n = p.size();
  Points fine(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = [&](std::size_t k, std::size_t c) { return p[(i + n + k - 1) % n][c]; };
    for (const std::size_t c : {0U, 1U}) {
      fine[2 * i][c] = (a * at(0, c) + (8 - 2 * a) * at(1, c) + a * at(2, c)) / 8;
      fine[2 * i + 1][c] =
          ((b - 1) * at(0, c) + (9 - b) * at(1, c) + (9 - b) * at(2, c) + (b - 1) * at(3, c)) / 16;
    }
  }
  return fine;
}

/// Its signed area, positive counter-clockwise.
inline double area(const Points& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& next = p[(i + 1) % p.size()];
    sum += p[i][0] * next[1] - p[i][1] * next[0];
  }
  return sum / 2;
}

}  // namespace subdiv::test
