#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "schemes/evaluate/grid_ringing.h"

namespace subdiv {

/// Geomorphs (jsplines 11): between the levels k and k + 1 the picture runs linearly, over t in [0, 1], from
/// J_{0,1}(P_k), the polygon P_k with its mid-points inserted, to J_s(P_k).

/// Linear subdivision: J_{0,1} for arity 2, the m-ary refinement of the hat function otherwise.
template <class R>
Mask<R> linear_step(int arity) {
  Laurent<R> hat;
  for (int i = 1 - arity; i < arity; ++i)
    hat += fraction<R>(arity - std::abs(i), arity) * Laurent<R>::monomial(i);
  return {arity, std::move(hat)};
}

/// The scheme whose step number `depth` (counted from 1) is replaced; later steps are those of the original.
template <class R>
Scheme<R> with_step(const Scheme<R>& scheme, int depth, const Mask<R>& mask) {
  if (depth < 1) throw std::invalid_argument("a geomorph leads to a level of at least 1");
  const auto place = static_cast<std::size_t>(depth - 1);
  Scheme<R> result{scheme.name, {}};
  for (std::size_t k = 0; k < std::max(place + 2, scheme.steps.size()); ++k)
    result.steps.push_back(k == place ? mask : scheme.step(k));
  return result;
}

/// A scheme that gives, after `depth` >= 1 steps, the curve at time t on its way from level depth - 1 to
/// level depth: its last step is (1 - t) J_{0,1} + t J_s. Every evaluator takes it. Throws
/// std::invalid_argument for a smaller depth.
template <class R>
Scheme<R> geomorph(const Scheme<R>& scheme, int depth, const R& t) {
  const int m = scheme.arity();
  const Mask<R>& smooth = scheme.step(static_cast<std::size_t>(std::max(depth, 1) - 1));
  return with_step(scheme, depth, Mask<R>{m, (R(1) - t) * linear_step<R>(m).symbol + t * smooth.symbol});
}

/// The vertices of a surface at time t on its way from depths one less in both directions, in the order of
/// stream_surface, whose quads join them: (1 - t) (J_{0,1} x J_{0,1})(P) + t (J_s x J_s)(P). Blending the
/// step of each direction instead would bend the vertices' paths. Calls vertex(const Point&). Throws as
/// geomorph and stream_surface do.
template <class R, class Point, class Vertex>
void stream_geomorph(const ControlGrid<Point>& grid, const Refinement<R>& along, const Refinement<R>& across,
                     const R& t, Vertex&& vertex) {
  const SurfaceSize size = surface_size(grid, along, across);
  const Scheme<R> flat_across = geomorph(across.scheme, across.depth, R(0));
  MovingPolygon<R, Point> flat_motion(geomorph(along.scheme, along.depth, R(0)), grid, along.depth);
  MovingPolygon<R, Point> motion(along.scheme, grid, along.depth);
  for (std::size_t i = 0; i < size.along && size.across > 0; ++i) {
    if (i > 0) flat_motion.advance();
    if (i > 0) motion.advance();
    Ringing<R, Point> flat(flat_across, flat_motion.polygon(), across.depth);
    Ringing<R, Point> smooth(across.scheme, motion.polygon(), across.depth);
    for (; !smooth.done(); smooth.advance(), flat.advance()) {
      const Point point = (R(1) - t) * flat.point() + t * smooth.point();
      vertex(point);
    }
  }
}

}  // namespace subdiv
