#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/experiment.h"
#include "schemes/algebra/laurent.h"
#include "schemes/algebra/rational.h"

namespace subdiv::notes {

/// A point as a combination of control points: P_i is z^i.
using Combination = Laurent<Rational>;

[[nodiscard]] inline Combination control_point(int i) { return Combination::monomial(i); }
/// P_0 .. P_n.
[[nodiscard]] std::vector<Combination> control_points(int n);
/// "(P0 + 3 P1 + 3 P2 + P3)/8"; weights are not negative.
[[nodiscard]] std::string to_string(const Combination& point);

[[nodiscard]] std::span<const ClaimHead> bezier_heads();
[[nodiscard]] Results run_bezier();
[[nodiscard]] std::span<const ClaimHead> spline_heads();
[[nodiscard]] Results run_splines();
[[nodiscard]] std::span<const ClaimHead> mesh_heads();
[[nodiscard]] Results run_meshes();

}  // namespace subdiv::notes
