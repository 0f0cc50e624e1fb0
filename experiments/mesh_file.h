#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/output_file.h"
#include "schemes/evaluate/indexed_mesh.h"
#include "schemes/mesh/mesh_topology.h"

// Own readers: the libraries of the distribution repair meshes or say nothing of the line at fault, and here
// both matter.
namespace subdiv {

enum class MeshFormat { obj, off, ply };

/// By the extension .obj, .off or .ply.
[[nodiscard]] std::optional<MeshFormat> mesh_format(const std::filesystem::path& path);

/// A mesh as a file lists it, vertices without faces included.
struct MeshFile {
  std::filesystem::path path;
  PolygonFaces faces;
  std::vector<Point3> points;
  std::vector<std::size_t> places;  // of each face: its line from 1, in binary files its first byte from 0
  bool binary = false;

  /// "FILE:LINE:" of a face, or "FILE: byte N:".
  [[nodiscard]] std::string place(std::size_t face) const;
};

/// Reads the vertices and faces of
///   OBJ  "v x y z" and "f a b c ..", corners as a, a/b, a//c or a/b/c, negative ones counted from the last
///        vertex above; colours after the coordinates and all other elements do not count;
///   OFF  text, with C, N or ST before the word (colours, normals, texture), which do not count;
///   PLY  ascii or binary, of either byte order: x, y, z of element vertex and the list vertex_indices (or
///        vertex_index) of element face; others are skipped.
/// Memory is a few times the file's size at most, whatever its header claims. Throws InputError with the line
/// or the byte for anything else, NaN and infinities included.
[[nodiscard]] MeshFile read_mesh(const std::filesystem::path& path);

/// The surface that the faces are. Throws InputError "FILE:LINE: face 12 ..: remedy" when they are none
/// (find_fault).
[[nodiscard]] MeshTopology surface_of(const MeshFile& mesh);

/// Writes a mesh: OBJ and OFF with the shortest decimals that read back as the same doubles, PLY in binary,
/// the low byte first; with normals where the mesh has them (OFF: NOFF). Throws InputError when a coordinate
/// is not finite.
void write_mesh(OutputFile& file, MeshFormat format, const IndexedMesh& mesh);
void write_mesh(OutputFile& file, MeshFormat format, const PolygonFaces& faces,
                std::span<const Point3> points);

}  // namespace subdiv
