#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/report/output_file.h"
#include "schemes/evaluate/ring_surface.h"
#include "schemes/mesh/mesh_topology.h"

namespace subdiv {

/// Each patch as pieces x pieces quads, patch by patch in their order: the faces of group k of the surface
/// are begin[k] .. begin[k + 1] - 1. Points on edges of patches that are equal are one vertex. Along the
/// outermost line of a ring, where one patch outside meets two, the faces outside have more corners: those of
/// the quads inside; so the mesh has no cracks.
struct GroupedMesh {
  std::vector<Point3> points;
  PolygonFaces faces;
  std::vector<std::size_t> begin;
};
/// pieces >= 1. Throws InputError for more faces than an int counts.
[[nodiscard]] GroupedMesh tessellated(const RingSurface& surface, int pieces);

/// "regular", "ring_1", .., "cap".
[[nodiscard]] std::string group_name(const RingSurface& surface, std::size_t group);

/// OBJ with the groups that have faces, "g ring_1" and so on.
void write_grouped_obj(OutputFile& file, const GroupedMesh& mesh, const RingSurface& surface);

/// The coefficients as free-form OBJ: cstype bezier, deg 3 3, a surf element a patch with 16 vertices of its
/// own, in groups. b_(i, j) with i running first, as OBJ lists control points; u goes with i.
void write_control_obj(OutputFile& file, const RingSurface& surface);
/// The same for BezierView (.bv): patches of kind 5, degrees 3 3, b_(i, j) row by row (j runs first), each
/// with its group.
void write_control_bv(OutputFile& file, const RingSurface& surface);

}  // namespace subdiv
