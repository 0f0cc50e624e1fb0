#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace subdiv::test {

// The rule by which experiments/data/simple-polygons.csv was made; see the README there.

using IntegerPolygon = std::vector<std::array<std::int64_t, 2>>;

/// Twice the area of the triangle a b c.
inline std::int64_t turn(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b,
                         const std::array<std::int64_t, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline std::int64_t twice_area(const IntegerPolygon& p) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += turn(p[0], p[i], p[i + 1]);
  return sum;
}

/// Whether c lies on the segment ab, its ends included; the three are collinear.
inline bool between(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b,
                    const std::array<std::int64_t, 2>& c) {
  for (const std::size_t k : {0U, 1U}) {
    if (c[k] < std::min(a[k], b[k]) || c[k] > std::max(a[k], b[k])) return false;
  }
  return true;
}

/// Whether two segments have a point in common.
inline bool meet(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b,
                 const std::array<std::int64_t, 2>& c, const std::array<std::int64_t, 2>& d) {
  const auto sign = [](std::int64_t x) { return (x > 0) - (x < 0); };
  const int ab_c = sign(turn(a, b, c));
  const int ab_d = sign(turn(a, b, d));
  const int cd_a = sign(turn(c, d, a));
  const int cd_b = sign(turn(c, d, b));
  if (ab_c * ab_d < 0 && cd_a * cd_b < 0) return true;
  return (ab_c == 0 && between(a, b, c)) || (ab_d == 0 && between(a, b, d)) ||
         (cd_a == 0 && between(c, d, a)) || (cd_b == 0 && between(c, d, b));
}

/// The first pair i < j of edges, not neighbours, that meet; {0, 0} when there is none.
inline std::array<std::size_t, 2> first_meeting(const IntegerPolygon& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (meet(p[i], p[i + 1], p[j], p[(j + 1) % n])) return {i, j};
    }
  }
  return {0, 0};
}

inline bool has_straight_vertex(const IntegerPolygon& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(p[i], p[(i + 1) % n], p[(i + 2) % n]) == 0) return true;
  }
  return false;
}

class PolygonRule {
 public:
  explicit PolygonRule(std::uint32_t seed) : random_(seed) {}

  /// Vertices in n directions, at distances from 30 to 100.
  IntegerPolygon star(std::size_t n) {
    IntegerPolygon p;
    for (std::size_t i = 0; i < n; ++i) {
      const auto r = static_cast<double>(draw(30, 100));
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      p.push_back({std::lround(r * std::cos(angle)), std::lround(r * std::sin(angle))});
    }
    return p;
  }
  /// Points of a square, untangled: as long as two edges meet, the path between the first two is reversed.
  IntegerPolygon scattered(std::size_t n) {
    constexpr int most_reversals = 1000;
    IntegerPolygon p;
    for (std::size_t i = 0; i < n; ++i) {
      const std::int64_t x = draw(-100, 100);
      const std::int64_t y = draw(-100, 100);
      p.push_back({x, y});
    }
    for (int k = 0; k < most_reversals; ++k) {
      const auto [i, j] = first_meeting(p);
      if (j == 0) break;
      std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    }
    return p;
  }

  /// `count` polygons of 4 to 12 vertices in turn, star-shaped and scattered ones in turn, counter-clockwise;
  /// those that are not simple or have a straight vertex are drawn again.
  std::vector<IntegerPolygon> family(std::size_t count) {
    constexpr std::size_t least = 4;
    constexpr std::size_t sizes = 9;
    std::vector<IntegerPolygon> result;
    while (result.size() < count) {
      const std::size_t n = least + result.size() % sizes;
      IntegerPolygon p = result.size() % 2 == 0 ? star(n) : scattered(n);
      if (first_meeting(p)[1] != 0 || has_straight_vertex(p)) continue;
      if (twice_area(p) < 0) std::reverse(p.begin(), p.end());
      result.push_back(std::move(p));
    }
    return result;
  }

 private:
  std::int64_t draw(std::int64_t least, std::int64_t greatest) {
    return least + static_cast<std::int64_t>(random_() % static_cast<std::uint32_t>(greatest - least + 1));
  }
  std::mt19937 random_;
};

constexpr std::uint32_t family_seed = 20080229;
constexpr std::size_t family_size = 200;

}  // namespace subdiv::test
