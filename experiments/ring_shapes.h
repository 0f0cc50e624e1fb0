#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "schemes/algebra/rational.h"
#include "schemes/evaluate/ring_surface.h"

namespace subdiv {

/// A mesh and the surface that rings of given speeds make of it.
struct RingModel {
  MeshTopology mesh;
  std::vector<Point3> points;

  [[nodiscard]] RingSurface surface(const std::vector<Rational>& speeds, bool fill) const;
};

/// Nets of three rings around a vertex over convex quadrics, the same on every machine; valences 3, 5, 6, 7,
/// 8 in turn. Place (a, b) of sector k lies at (x, y) = a u_k + b u_{k+1}, u_k = (cos, sin)(2 pi k/n), and z
/// = -(A x^2 + 2 B x y + C y^2)/1000; coordinates are times 100, rounded to integers. A = 50 + r, C = 50 + r,
/// B = (r - 50)/2, each r the next output of the Mersenne twister MT19937 with this seed modulo 101.
[[nodiscard]] std::vector<RingModel> convex_nets(unsigned seed, int count);

/// The greatest mean curvature less the least, over all rings (the cap left out), at the points i/8, j/8 of
/// each patch, times the size of the first border.
[[nodiscard]] double curvature_spread(const RingSurface& surface);

/// The greatest angle, in degrees, between the normals of neighbouring patches of the cap of the one
/// extraordinary vertex, along their common edges at i/32. The surface is filled.
[[nodiscard]] double cap_fault(const RingSurface& surface);

/// The unit normal of a patch.
[[nodiscard]] Eigen::Vector3d patch_normal(const BezierPatch<Point3>& patch, double u, double v);

}  // namespace subdiv
