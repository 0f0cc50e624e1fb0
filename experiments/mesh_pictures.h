#pragma once

#include <span>
#include <vector>

#include "experiments/report/output_file.h"
#include "experiments/surface_pictures.h"
#include "schemes/evaluate/indexed_mesh.h"

namespace subdiv {

/// The faces of a mesh, to be drawn: triangles as quads whose last two corners are the same, faces with more
/// than four corners as triangles around their first.
[[nodiscard]] std::vector<SpaceQuad> mesh_quads(const IndexedMesh& mesh);
[[nodiscard]] std::vector<SpaceQuad> mesh_quads(const PolygonFaces& faces, std::span<const Point3> points);

/// A picture of filled polygons in one SVG file, in a frame that fits them: seen from the front, the right
/// and above (z points upwards), lit, nearer ones before those behind. `closed` leaves out what faces away.
/// Throws InputError when a coordinate is not finite.
void write_picture(OutputFile& file, std::vector<SpaceQuad> quads, bool closed);

}  // namespace subdiv
