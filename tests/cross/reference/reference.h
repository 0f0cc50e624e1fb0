#pragma once

#include <cstddef>
#include <vector>

#include "schemes/evaluate/indexed_mesh.h"

namespace subdiv::cross {

/// What another library makes of a closed mesh.
struct Reference {
  std::vector<Point3> points;
  std::size_t faces = 0;
  double seconds = 0;  // of the refinement alone, without the making of the library's mesh
};

/// CGAL, Subdivision_method_3. Loop's own weights of 1987; Warren's as a mask of this project's in CGAL's
/// traversal.
[[nodiscard]] Reference cgal_catmull_clark(const PolygonFaces& faces, const std::vector<Point3>& points,
                                           int levels);
[[nodiscard]] Reference cgal_loop(const PolygonFaces& faces, const std::vector<Point3>& points, int levels);
[[nodiscard]] Reference cgal_warren(const PolygonFaces& faces, const std::vector<Point3>& points, int levels);

/// OpenMesh: CatmullClarkT, LoopT (the weights of 1987), ModifiedButterflyT (the butterfly scheme where all
/// valences are 6).
[[nodiscard]] Reference openmesh_catmull_clark(const PolygonFaces& faces, const std::vector<Point3>& points,
                                               int levels);
[[nodiscard]] Reference openmesh_loop(const PolygonFaces& faces, const std::vector<Point3>& points,
                                      int levels);
[[nodiscard]] Reference openmesh_butterfly(const PolygonFaces& faces, const std::vector<Point3>& points,
                                           int levels);

}  // namespace subdiv::cross
