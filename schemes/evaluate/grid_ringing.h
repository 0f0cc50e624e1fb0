#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "schemes/evaluate/moving_polygon.h"

namespace subdiv {

/// Grid surfaces by Ringing (js-report 13): the points of all rows move along their trajectories, and the
/// transversal curves of consecutive frames bound strips of quads. The surface is the tensor product of
/// `along` (the trajectories) and `across` (the transversal curves). Refined point v of the transversal curve
/// of frame t is vertex t * across + v, so that quads share their vertices and closed directions close.

/// The refined vertices and quads of a grid in both directions.
struct SurfaceSize {
  std::size_t along = 0;   ///< transversal curves
  std::size_t across = 0;  ///< points of each of them
  std::size_t strips = 0;  ///< between consecutive curves
  std::size_t quads = 0;   ///< of each strip

  [[nodiscard]] std::size_t vertex(std::size_t t, std::size_t v) const {
    /// The number of the vertex in row t and column v, both from 0.
    return (t == along ? 0 : t) * across + (v == across ? 0 : v);
  }
  /// The quad between the curves t, t + 1 and their points v, v + 1, around.
  [[nodiscard]] std::array<std::size_t, 4> corners(std::size_t t, std::size_t v) const {
    return {vertex(t, v), vertex(t + 1, v), vertex(t + 1, v + 1), vertex(t, v + 1)};
  }
};

/// Throws std::overflow_error beyond 2^62 vertices.
template <class R, class Point>
SurfaceSize surface_size(const ControlGrid<Point>& grid, const Refinement<R>& along,
                         const Refinement<R>& across) {
  constexpr std::size_t most = std::size_t{1} << 62U;
  SurfaceSize size;
  size.along = refined_points(grid.columns(), along.scheme.arity(), along.depth);
  size.across = refined_points(grid.rows, across.scheme.arity(), across.depth);
  if (size.across > 0 && size.along > most / size.across)
    throw std::overflow_error("too many points: " + std::to_string(size.along) + " curves of " +
                              std::to_string(size.across) + " points");
  size.strips = size.along - (grid.columns().closed || size.along == 0 ? 0 : 1);
  size.quads = size.across - (grid.rows.closed || size.across == 0 ? 0 : 1);
  return size;
}

/// A quad with its corners in the order of SurfaceSize::corners; they live as long as the call that hands
/// them over.
template <class Point>
struct Quad {
  std::array<std::size_t, 4> vertices;  ///< numbers, from 0
  std::array<const Point*, 4> corners;  ///< the points
};

/// What an evaluation kept and computed, as counted on the rings that it ran.
struct SurfaceWork {
  std::size_t motion_rings = 0;            ///< rings a level, of trajectories
  std::size_t display_rings = 0;           ///< and of transversal curves, at the same time
  std::size_t motion_points_a_level = 0;   ///< of all motion rings together
  std::size_t display_points_a_level = 0;  ///< of all display rings together
  std::size_t control_points = 0;          ///< of transversal control polygons, held beside the rings
  std::size_t curve_points = 0;            ///< of refined transversal curves, held beside the rings
  std::size_t curves = 0;                  ///< evaluations of a transversal curve
  std::size_t computed_along = 0;          ///< points computed by motion rings, all levels below the controls
  std::size_t computed_across = 0;         ///< and by display rings

  /// 5 (n + 2) for n rows, J_{a,b} and two display rings.
  [[nodiscard]] std::size_t points_a_level() const { return motion_points_a_level + display_points_a_level; }
  [[nodiscard]] std::size_t rings() const { return motion_rings + display_rings; }
};

namespace detail {

template <class R, class Point>
void count_motion(SurfaceWork& work, const MovingPolygon<R, Point>& motion) {
  work.motion_rings = motion.rings();
  work.motion_points_a_level = motion.points_per_level();
  work.computed_along = 0;
  for (std::size_t level = 1; level < motion.levels(); ++level) work.computed_along += motion.computed(level);
}

/// One finished curve, with the number of display rings that ran beside each other.
template <class R, class Point>
void count_display(SurfaceWork& work, const Ringing<R, Point>& display, std::size_t rings) {
  work.display_rings = std::max(work.display_rings, rings);
  work.display_points_a_level = std::max(work.display_points_a_level, rings * display.points_per_level());
  for (std::size_t level = 1; level < display.levels(); ++level)
    work.computed_across += display.computed(level);
  ++work.curves;
}

}  // namespace detail

/// The papers' construction: two display rings, driven by two consecutive points of every motion ring, run
/// beside each other along each strip. quad(const Quad<Point>&) is called for every quad, strip by strip. A
/// transversal curve bounds two strips and is evaluated for each of them. Throws as MovingPolygon, Ringing
/// and surface_size do.
template <class R, class Point, class Visit>
SurfaceWork quads_by_two_rings(const ControlGrid<Point>& grid, const Refinement<R>& along,
                               const Refinement<R>& across, Visit&& quad) {
  const SurfaceSize size = surface_size(grid, along, across);
  SurfaceWork work;
  MovingPolygon<R, Point> motion(along.scheme, grid, along.depth);
  ControlPolygon<Point> here = motion.polygon();
  work.control_points = here.points.size() + motion.polygon().points.size();
  for (std::size_t t = 0; t < size.strips && size.across > 0; ++t) {
    motion.advance();
    Ringing<R, Point> near(across.scheme, here, across.depth);
    Ringing<R, Point> far(across.scheme, motion.polygon(), across.depth);
    const std::array<Point, 2> first{near.point(), far.point()};
    std::array<Point, 2> last = first;
    for (std::size_t v = 0; v < size.quads; ++v) {
      near.advance();
      far.advance();
      std::array<Point, 2> next = near.done() ? first : std::array<Point, 2>{near.point(), far.point()};
      quad(Quad<Point>{size.corners(t, v), {&last[0], &last[1], &next[1], &next[0]}});
      last = std::move(next);
    }
    detail::count_display(work, near, 2);
    detail::count_display(work, far, 2);
    here = motion.polygon();
  }
  detail::count_motion(work, motion);
  return work;
}

/// The same quads in the same order with one display ring: each transversal curve is evaluated once. The
/// price is memory for the curve before (and for the first one, when the trajectories are closed).
template <class R, class Point, class Visit>
SurfaceWork quads_evaluated_once(const ControlGrid<Point>& grid, const Refinement<R>& along,
                                 const Refinement<R>& across, Visit&& quad) {
  const SurfaceSize size = surface_size(grid, along, across);
  SurfaceWork work;
  MovingPolygon<R, Point> motion(along.scheme, grid, along.depth);
  work.control_points = motion.polygon().points.size();
  std::vector<Point> first;
  std::vector<Point> before;  // the curve of frame t; its points give way to those of frame t + 1
  const auto strip = [&](std::size_t t, auto&& next_point) {
    Point near_first = before.front();
    Point near = near_first;
    Point far = next_point();
    before.front() = far;
    for (std::size_t v = 0; v < size.quads; ++v) {
      const bool wraps = v + 1 == size.across;
      Point next_near = wraps ? near_first : before[v + 1];
      Point next_far = wraps ? before.front() : next_point();
      quad(Quad<Point>{size.corners(t, v), {&near, &far, &next_far, &next_near}});
      if (!wraps) before[v + 1] = next_far;
      near = std::move(next_near);
      far = std::move(next_far);
    }
  };
  for (std::size_t t = 0; t < size.along && size.across > 0; ++t) {
    if (t > 0) motion.advance();
    Ringing<R, Point> display(across.scheme, motion.polygon(), across.depth);
    const auto next_point = [&] {
      Point point = display.point();
      display.advance();
      return point;
    };
    if (t == 0) {
      before.reserve(size.across);
      for (std::size_t v = 0; v < size.across; ++v) before.push_back(next_point());
      if (size.strips == size.along) first = before;
    } else {
      strip(t - 1, next_point);
    }
    detail::count_display(work, display, 1);
  }
  if (!first.empty()) {
    std::size_t v = 0;
    strip(size.along - 1, [&] { return first[v++]; });
  }
  work.curve_points = before.size() + first.size();
  detail::count_motion(work, motion);
  return work;
}

/// The whole surface as a stream: vertex(const Point&) for every vertex in the order of their indices, and
/// quad(const std::array<std::size_t, 4>&) for every quad, as soon as its corners are there. Nothing is kept
/// but rings and one control polygon: constant memory a row, however fine the surface, and every curve is
/// evaluated once. Throws as quads_by_two_rings does.
template <class R, class Point, class Vertex, class Face>
SurfaceWork stream_surface(const ControlGrid<Point>& grid, const Refinement<R>& along,
                           const Refinement<R>& across, Vertex&& vertex, Face&& quad) {
  const SurfaceSize size = surface_size(grid, along, across);
  SurfaceWork work;
  MovingPolygon<R, Point> motion(along.scheme, grid, along.depth);
  work.control_points = motion.polygon().points.size();
  const auto strip = [&](std::size_t t) {
    for (std::size_t v = 0; v < size.quads; ++v) quad(size.corners(t, v));
  };
  for (std::size_t t = 0; t < size.along && size.across > 0; ++t) {
    if (t > 0) motion.advance();
    Ringing<R, Point> display(across.scheme, motion.polygon(), across.depth);
    for (const Point& point : display) vertex(point);
    if (t > 0) strip(t - 1);
    detail::count_display(work, display, 1);
  }
  if (size.along > 0 && size.strips == size.along) strip(size.along - 1);
  detail::count_motion(work, motion);
  return work;
}

}  // namespace subdiv
