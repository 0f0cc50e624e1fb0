#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "experiments/experiment.h"
#include "experiments/plane_diagram.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/evaluate/surface_ring.h"

namespace subdiv {

/// The parts of the experiment with the figures that explain adjustable speed: a figure and its claim each.
void add_speed_knot_lines(Results& results, std::span<const ClaimHead> heads);      // figure 3
void add_speed_derivation(Results& results, std::span<const ClaimHead> heads);      // 4
void add_speed_indices(Results& results, std::span<const ClaimHead> heads);         // 5
void add_speed_border_indices(Results& results, std::span<const ClaimHead> heads);  // 10

/// The valence of the vertices drawn.
inline constexpr int drawn_valence = 5;

/// Sector k of n around a point, the first one upright; (a, b) steps along its first spoke and the next one.
[[nodiscard]] Spot in_sector(Spot centre, int k, double a, double b);

/// Points over Q(sigma), sigma = x_0.
using SymbolicPoint = std::array<RationalFunction, 2>;

/// A regular net, n = 4, over the knots 0, 1, 1/q, 1/q^2: in each direction a point stands at the mean of its
/// three knots. The splines are then the coordinates themselves.
[[nodiscard]] SectorNet<SymbolicPoint> mean_net();

/// Do the first `count` coefficients (i, j), at 4 i + j, stand at from - (i/3, j/3) size?
[[nodiscard]] bool equal_steps(const BezierPatch<SymbolicPoint>& patch, const SymbolicPoint& from,
                               const SymbolicPoint& size, std::size_t count);

}  // namespace subdiv
