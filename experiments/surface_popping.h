#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "analysis/silhouette.h"
#include "schemes/evaluate/control_grid.h"
#include "schemes/mask.h"

namespace subdiv {

using DoubleGrid = ControlGrid<Eigen::Vector3d>;

/// The picture of a torus after `depth` steps in both directions: the triangles that run counter-clockwise in
/// it. As many of them cover a point as run the other way round, for the surface is closed, so that they
/// alone cover the whole picture.
[[nodiscard]] std::vector<PictureTriangle> picture_of(const DoubleGrid& grid, const Scheme<double>& scheme,
                                                      int depth, const View& view);

/// The same at time t of the geomorph that leads from level depth - 1 to level depth.
[[nodiscard]] std::vector<PictureTriangle> picture_of_geomorph(const DoubleGrid& grid,
                                                               const Scheme<double>& scheme, int depth,
                                                               double t, const View& view);

/// The largest share of the picture that changes between consecutive ones of the geomorph's pictures at times
/// 0, 1/pictures, .., 1.
[[nodiscard]] double largest_change(const DoubleGrid& grid, const Scheme<double>& scheme, int depth,
                                    int pictures, const View& view, int lines);

/// How much the picture pops when level depth follows level depth - 1: the area that one of the two pictures
/// covers alone, as a share of the area that the earlier one covers.
[[nodiscard]] double silhouette_disparity(const DoubleGrid& grid, const Scheme<double>& scheme, int depth,
                                          const View& view, int lines);

/// A control grid and the direction that it is seen from.
struct ViewedGrid {
  DoubleGrid grid;
  Eigen::Vector3d direction;
};

/// Rough tori with integer coordinates, the same on every machine. Rows and columns: 4 to 7 of each. The
/// point of row i, column j is that of a torus with radii 20 and 8, rounded to integers, moved in each
/// coordinate by an integer of -3 .. 3. Directions have integer coordinates of -9 .. 9 and are not vertical.
/// Drawn from the 64-bit Mersenne twister, remainders of its numbers in this order: rows, columns, the three
/// moves of each point, direction.
[[nodiscard]] std::vector<ViewedGrid> rough_tori(std::uint64_t seed, int count);

}  // namespace subdiv
