#pragma once

#include <nlohmann/json.hpp>

#include "analysis/curve_measures.h"

namespace subdiv::cli {

/// The estimates of polyloops 1 at every vertex and edge of a polygon: velocity, acceleration, unit tangent
/// and normal, the radii of curvature by a circle and by a parabola, the jerk of the edge that begins at the
/// vertex and its normal component. Consecutive vertices are a unit of time apart; vertices count from 0.
[[nodiscard]] nlohmann::ordered_json local_estimates_json(const Polyline& polyline);
/// The same as a table on standard output, coordinates after each other.
void print_local_estimates(const Polyline& polyline);

/// Throws InputError for an open polygon of fewer than three points, and where a curvature leaves the
/// doubles, as the two above do.
void require_local_estimates(const Polyline& polyline);

}  // namespace subdiv::cli
