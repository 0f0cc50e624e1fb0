#include "experiments/mesh_file.h"

#include <utility>

#include <fmt/format.h>

#include "experiments/mesh_formats.h"
#include "schemes/input_error.h"

namespace subdiv {

std::optional<MeshFormat> mesh_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".ply") return MeshFormat::ply;
  return std::nullopt;
}

MeshFile read_mesh(const std::filesystem::path& path) {
  const std::optional<MeshFormat> format = mesh_format(path);
  if (!format) throw InputError(path.string() + ": meshes are read from .obj, .off or .ply files");
  MeshFile mesh;
  mesh.path = path;
  FileReader reader(path);
  switch (*format) {
    case MeshFormat::obj:
      read_obj(reader, mesh);
      break;
    case MeshFormat::off:
      read_off(reader, mesh);
      break;
    case MeshFormat::ply:
      read_ply(reader, mesh);
      break;
  }
  mesh.faces.vertices = mesh.points.size();
  return mesh;
}

std::string MeshFile::place(std::size_t face) const {
  return fmt::format("{}:{}{}:", path.string(), binary ? " byte " : "", places[face]);
}

MeshTopology surface_of(const MeshFile& mesh) {
  try {
    return MeshTopology(mesh.faces);
  } catch (const InputError&) {  // named once more, with its place
    const std::optional<MeshFault> fault = find_fault(mesh.faces);
    if (!fault || fault->face >= mesh.places.size()) throw;
    throw InputError(fmt::format("{} face {} {}: {}", mesh.place(fault->face), fault->face + 1, fault->what,
                                 fault->remedy));
  }
}

}  // namespace subdiv
