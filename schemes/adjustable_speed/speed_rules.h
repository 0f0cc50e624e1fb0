#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "schemes/adjustable_speed/knot_line.h"
#include "schemes/adjustable_speed/sector_stencil.h"

namespace subdiv {

/// Adjustable speed subdivision (Karciauskas & Peters: Adjustable speed surface subdivision, 2009): bicubic
/// splines around an extraordinary vertex of valence n on knots in geometric progression, 0, a, a/q, a/q^2,
/// q = 1 - sigma, in every direction. One step inserts q a; sigma in (0, 1) is the speed, 1/2 is
/// Catmull-Clark after a change of knots.
///
/// The net has two rings around the vertex, numbered as fan_topology(4, n, 2) does: place (i, j) is the
/// paper's p with the label (3 - i)(3 - j) (figure 5, left), sectors counter-clockwise. All rules but the
/// vertex's own are tensor products of knot insertion; nothing here rounds in exact rings.

/// a_1, a_2, a_3 of a knot line, up to a common factor.
template <class R>
using LineKnots = std::array<R, 3>;

/// q^2, q, 1.
template <class R>
LineKnots<R> speed_knots(const R& sigma) {
  const R q = R(1) - sigma;
  return {q * q, q, R(1)};
}
/// 1/q^2 times those: a_1 = 1.
template <class R>
LineKnots<R> unit_speed_knots(const R& sigma) {
  const R q = R(1) - sigma;
  return {R(1), R(1) / q, R(1) / (q * q)};
}
/// Of Catmull-Clark nets: 1, 2, 3.
template <class R>
LineKnots<R> uniform_knots() {
  return {R(1), R(2), R(3)};
}

/// One step along a line: P'_0, P'_1, P'_2, P'_3. P'_0 is that of a regular vertex.
template <class R>
std::array<LineWeights<R>, 4> inserted_rows(const R& sigma) {
  const R q = R(1) - sigma;
  const R inserted = q * q * q;
  using Line = KnotLine<R>;
  const Line line(speed_knots(sigma), {R(0) - inserted, inserted});
  return {line.polar(Line::zero, Line::other + 1, Line::other),
          line.polar(Line::first, Line::zero, Line::other + 1),
          line.polar(Line::second, Line::first, Line::other + 1),
          line.polar(Line::third, Line::second, Line::first)};
}

/// The Bezier points of the piece between a_1 and 0, from a_1 inwards: f(a, a, a), f(a, a, 0), f(a, 0, 0),
/// f(0, 0, 0).
template <class R>
std::array<LineWeights<R>, 4> bezier_rows(const R& sigma) {
  using Line = KnotLine<R>;
  const Line line(speed_knots(sigma));
  return {line.polar(Line::first, Line::first, Line::first), line.polar(Line::first, Line::first, Line::zero),
          line.polar(Line::first, Line::zero, Line::zero), line.polar(Line::zero, Line::zero, Line::zero)};
}

/// P_0, P_1, P_2 over other knots with the same a_1 for the same surface where it is kept: the piece on
/// [0, a_1] to second order at a_1 (its tensor border), the point P_0 itself.
template <class R>
std::array<LineWeights<R>, 3> changed_rows(const LineKnots<R>& from, const LineKnots<R>& to) {
  using Line = KnotLine<R>;
  const Line line(from, {to[1], to[2]});
  return {LineWeights<R>{R(0), R(1), R(0), R(0)}, line.polar(Line::first, Line::zero, Line::other),
          line.polar(Line::first, Line::other, Line::other + 1)};
}

/// The new points of one sector, at sector_places(4, 3): those of the refined net first, then the third ring,
/// which the surface ring between the old net and the new one still needs (paper (3), (4)).
template <class R>
std::vector<SectorStencil<R>> refined_places(const R& sigma) {
  const std::array<LineWeights<R>, 4> rows = inserted_rows(sigma);
  std::vector<SectorStencil<R>> result;
  for (const FanPlace& place : sector_places(4, 3))
    result.push_back(
        tensor_stencil(rows[static_cast<std::size_t>(place.a)], rows[static_cast<std::size_t>(place.b)]));
  return result;
}

/// The rule of the vertex: 1 - beta - gamma of itself, beta of the mean of its edge neighbours (1, 0), gamma
/// of the mean of the (1, 1).
template <class R>
struct VertexWeights {
  R beta;   ///< of the edge neighbours
  R gamma;  ///< of the diagonal ones
};
/// Paper (1): those that keep the limit point of Catmull-Clark; for n = 4 knot insertion's own.
template <class R>
VertexWeights<R> vertex_weights(const R& sigma, int valence) {
  const R q = R(1) - sigma;
  const R below = R(9) + R(valence - 4) * (q + R(1)) * (q + R(1));
  return {R(18) * sigma * q * (sigma * sigma + q) / below, R(9) * sigma * sigma * q * q / below};
}

/// The Bezier coefficients of one sector's tensor border: b_(i, j), 0 <= i, j <= 3, at 4 i + j, (0, 0) the
/// corner on the bisectrix farthest from the vertex, (3, 0) on the next spoke, (0, 3) on the first one. (3,
/// 3) is not defined by the net (paper (13)).
template <class R>
std::array<std::optional<SectorStencil<R>>, 16> tensor_border(const R& sigma) {
  const std::array<LineWeights<R>, 4> rows = bezier_rows(sigma);
  std::array<std::optional<SectorStencil<R>>, 16> result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (i < 3 || j < 3) result[4 * i + j] = tensor_stencil(rows[i], rows[j]);
    }
  }
  return result;
}

/// The net over other knots (changed_rows), at sector_places(4, 2); the vertex keeps its place. From uniform
/// knots to unit_speed_knots(sigma): paper (11). From those of one speed to those of another: how the speed
/// is changed between steps.
template <class R>
std::vector<SectorStencil<R>> changed_places(const LineKnots<R>& from, const LineKnots<R>& to) {
  const std::array<LineWeights<R>, 3> rows = changed_rows(from, to);
  std::vector<SectorStencil<R>> result;
  for (const FanPlace& place : sector_places(4, 2))
    result.push_back(
        tensor_stencil(rows[static_cast<std::size_t>(place.a)], rows[static_cast<std::size_t>(place.b)]));
  return result;
}

}  // namespace subdiv
