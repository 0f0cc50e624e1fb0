#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.h"
#include "schemes/algebra/laurent.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// Parts of the experiments of polyloops, each settling its own heads.
/// polyloop-local: which radius of curvature is better, and the figures of polyloops 1.
[[nodiscard]] Results run_polyloop_radii();
/// polyloop-curves: limit points, smoothness and areas; distances from the polygon and popping; jerk and
/// shape.
[[nodiscard]] Results run_polyloop_limits();
[[nodiscard]] Results run_polyloop_distances();
[[nodiscard]] Results run_polyloop_jerks();

/// J0, J2, J4, J5, J6, J8: the curves that repeat one step, from inner to outer.
[[nodiscard]] const std::vector<std::string>& stationary_polyloop_curves();

/// A point or vector of the plane.
template <class R>
Vector<R> pair_of(R x, R y) {
  Vector<R> result(2);
  result(0) = std::move(x);
  result(1) = std::move(y);
  return result;
}

}  // namespace subdiv
