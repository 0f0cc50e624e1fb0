#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/evaluate/surface_ring.h"

namespace subdiv {

/// The edges of a patch: first_i where i = 0, last_i where i = 3, likewise j.
enum class PatchEdge { first_i, last_i, first_j, last_j };

/// The three layers of coefficients next to an edge, which settle derivatives up to the second across it:
/// [0] on the edge; along it the other index ascends.
template <class P>
std::array<std::array<P, 4>, 3> edge_layers(const BezierPatch<P>& patch, PatchEdge edge) {
  std::array<std::array<P, 4>, 3> result{};
  const bool last = edge == PatchEdge::last_i || edge == PatchEdge::last_j;
  const bool i_is_fixed = edge == PatchEdge::first_i || edge == PatchEdge::last_i;
  for (std::size_t layer = 0; layer < 3; ++layer) {
    const std::size_t fixed = last ? 3 - layer : layer;
    for (std::size_t k = 0; k < 4; ++k) result[layer][k] = patch[i_is_fixed ? 4 * fixed + k : 4 * k + fixed];
  }
  return result;
}

/// Whether two patches with the same edge, of widths a and b across it and in the same direction along it,
/// join with equal derivatives up to the second. In rings whose zero test decides.
template <class P, class R>
bool joins_c2(const std::array<std::array<P, 4>, 3>& one, const R& a,
              const std::array<std::array<P, 4>, 3>& other, const R& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    P first{};
    add_weighted(first, b, one[0][k]);
    add_weighted(first, R(0) - b, one[1][k]);
    add_weighted(first, a, other[0][k]);
    add_weighted(first, R(0) - a, other[1][k]);
    P second{};
    for (const auto& [weight, layer] : {std::pair{R(1), 0U}, std::pair{R(-2), 1U}, std::pair{R(1), 2U}}) {
      add_weighted(second, b * b * weight, one[layer][k]);
      add_weighted(second, R(0) - a * a * weight, other[layer][k]);
    }
    if (!(one[0][k] == other[0][k]) || !(first == P{}) || !(second == P{})) return false;
  }
  return true;
}

/// The four cubic Bernstein polynomials at the place part/whole, 0 <= part <= whole. Reversed exactly, bit by
/// bit, at whole - part.
inline std::array<double, 4> bernstein(double part, double whole) {
  const double t = part / whole;
  const double u = (whole - part) / whole;
  return {u * u * u, 3 * (u * u) * t, 3 * (t * t) * u, t * t * t};
}

/// The cubic with these coefficients; the same bits from either end.
inline std::array<double, 3> cubic_point(const std::array<double, 4>& weights,
                                         const std::array<std::array<double, 3>, 4>& points) {
  std::array<double, 3> result{};
  for (std::size_t d = 0; d < result.size(); ++d) {
    result[d] = (weights[0] * points[0][d] + weights[3] * points[3][d]) +
                (weights[1] * points[1][d] + weights[2] * points[2][d]);
  }
  return result;
}

/// Of a patch at (i, j) = (u, v), both in [0, 1]: the point and its derivatives.
struct PatchJet {
  std::array<double, 3> point{};  ///< the place in space
  std::array<double, 3> u{};      ///< the derivative with respect to u
  std::array<double, 3> v{};      ///< with respect to v
  std::array<double, 3> uu{};     ///< the second derivatives
  std::array<double, 3> uv{};     ///< likewise
  std::array<double, 3> vv{};     ///< likewise
};
/// By Bernstein polynomials and their derivatives.
inline PatchJet patch_jet(const BezierPatch<std::array<double, 3>>& patch, double u, double v) {
  // Bernstein polynomials of degree 3 and their derivatives.
  const auto basis = [](double t) {
    const double s = 1 - t;
    return std::array<std::array<double, 4>, 3>{
        {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
         {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t},
         {6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t}}};
  };
  const auto along_i = basis(u);
  const auto along_j = basis(v);
  PatchJet jet;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& b = patch[4 * i + j];
      add_weighted(jet.point, along_i[0][i] * along_j[0][j], b);
      add_weighted(jet.u, along_i[1][i] * along_j[0][j], b);
      add_weighted(jet.v, along_i[0][i] * along_j[1][j], b);
      add_weighted(jet.uu, along_i[2][i] * along_j[0][j], b);
      add_weighted(jet.uv, along_i[1][i] * along_j[1][j], b);
      add_weighted(jet.vv, along_i[0][i] * along_j[2][j], b);
    }
  }
  return jet;
}

/// The point of a patch with the Bernstein polynomials of i and of j.
inline std::array<double, 3> patch_point(const BezierPatch<std::array<double, 3>>& patch,
                                         const std::array<double, 4>& along_i,
                                         const std::array<double, 4>& along_j) {
  std::array<std::array<double, 3>, 4> rows{};
  for (std::size_t i = 0; i < 4; ++i)
    rows[i] = cubic_point(along_j, {patch[4 * i], patch[4 * i + 1], patch[4 * i + 2], patch[4 * i + 3]});
  return cubic_point(along_i, rows);
}

}  // namespace subdiv
