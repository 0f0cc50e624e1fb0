#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "schemes/evaluate/bezier_patch.h"
#include "schemes/evaluate/mesh_refinement.h"
#include "schemes/evaluate/speed_schedule.h"
#include "schemes/evaluate/surface_ring.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// Catmull-Clark surfaces with rings of adjustable speed (Karciauskas & Peters: Adjustable speed surface
/// subdivision, 2009): a mesh of quads as bicubic Bezier patches. A face whose corners all are regular (4
/// faces; 2 at the border, 1 at its corners) is one patch of the uniform bicubic spline; at borders the mesh
/// is continued by 2 P_0 - P_1, which is what catmull_clark() does there. The n faces around an
/// extraordinary vertex are m rings of 3 n patches, one ring a step, and what the last one leaves open: n
/// patches of the cap, or a hole. All join C2 but for the cap, which is C2 outwards alone.

/// What keeps a mesh from having these rings: two extraordinary vertices or one and a border vertex in one
/// face, faces that are no quads, vertices that are extraordinary at the border or of valence 2.
struct RingFault {
  int vertex = 0;           ///< from 0
  std::string what;         ///< "vertex 3 has valence 5 and shares a face with vertex 8 of the border"
  bool step_helps = false;  ///< whether Catmull-Clark steps mend it: one among quads
  std::string remedy;       ///< "a Catmull-Clark step puts two edges between them"
};
/// The first fault, those that no step mends before the others.
[[nodiscard]] std::optional<RingFault> find_ring_fault(const MeshTopology& mesh);

/// What the rings around one vertex leave open. Its size is the greatest distance of the corners of its
/// boundary from the limit point; that of the first border is the size without rings.
struct RingHole {
  int vertex = 0;         ///< from 0
  int valence = 0;        ///< of the vertex
  double first_size = 0;  ///< without rings
  double size = 0;        ///< with all rings
};

/// Where one patch outside meets two inside: along its edge, in ascending order of its other index, the edges
/// of `inner` follow each other, from 0 to `split` and from there to 1; descending where `reversed`.
struct RingJoint {
  std::size_t outer = 0;                      ///< the patch outside
  PatchEdge outer_edge = PatchEdge::first_i;  ///< its edge
  std::array<std::size_t, 2> inner{};         ///< the patches inside
  PatchEdge inner_edge = PatchEdge::first_i;  ///< the edge of both
  bool reversed = false;                      ///< whether the outer edge runs the other way
  double split = 0;                           ///< where the inner ones meet, between 0 and 1
};

/// Patches in groups: 0 the regular faces, k = 1 .. m ring k of every extraordinary vertex, m + 1 the caps.
/// Group k is patches[begin[k]] .. patches[begin[k + 1] - 1].
struct RingSurface {
  std::vector<BezierPatch<Point3>> patches;  ///< all groups, one after the other
  std::vector<std::size_t> begin{0};         ///< where each group begins, and the end
  std::vector<RingHole> holes;               ///< one for each extraordinary vertex
  std::vector<RingJoint> joints;             ///< all along the rings' outermost lines
  double rounding = 0;  ///< no coordinate of a ring is farther from that of the exact rules

  [[nodiscard]] std::size_t groups() const { return begin.size() - 1; }
};

/// What a surface consists of.
struct RingSurfaceOptions {
  bool regular_faces = true;  ///< else group 0 is empty
  bool fill = false;          ///< else the last group is empty
};

/// Throws InputError for a fault, for coordinates beyond 1e290, and where fewer than three decimal digits of
/// a ring or a hole are left in double: for the steps, for coordinates near the least positive double, or for
/// a mesh far from the origin. Linear in the number of patches. Corners of patches that meet are equal bit by
/// bit, and so are their whole edges where two patches share one. Along the outermost line of a ring one
/// patch outside meets two, which the joints say; two extraordinary vertices a knight's move apart split an
/// edge between them in two places, unless the speed is 1/2.
[[nodiscard]] RingSurface ring_surface(const MeshTopology& mesh, const std::vector<Point3>& points,
                                       const SpeedSchedule& schedule, const RingSurfaceOptions& options = {});

}  // namespace subdiv
