#pragma once

#include "experiments/file_reader.h"
#include "experiments/mesh_file.h"

// The readers behind read_mesh: each fills faces, points, places and binary.
namespace subdiv {

void read_obj(FileReader& reader, MeshFile& mesh);
void read_off(FileReader& reader, MeshFile& mesh);
void read_ply(FileReader& reader, MeshFile& mesh);

}  // namespace subdiv
