#pragma once

#include "experiments/cli/verbs.h"

namespace subdiv::cli {

/// Whether the scheme or the file is one for meshes: then refine means refine_mesh_file.
[[nodiscard]] bool is_about_meshes(const RefineOptions& options);

/// Refines the mesh of an .obj, .off or .ply file and writes it, or its picture, whole or not at all.
[[nodiscard]] int refine_mesh_file(const RefineOptions& options);

}  // namespace subdiv::cli
