#include "experiments/cli/refine_mesh.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "analysis/mesh/limit_mesh.h"
#include "experiments/mesh_file.h"
#include "experiments/mesh_pictures.h"
#include "schemes/algebra/rational.h"
#include "schemes/catalogue.h"
#include "schemes/evaluate/indexed_mesh.h"
#include "schemes/input_error.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

/// An .svg file, or a mesh; devices and standard output take OBJ.
struct MeshOutput {
  bool picture = false;
  MeshFormat format = MeshFormat::obj;
};

MeshOutput mesh_output(const std::filesystem::path& path) {
  if (path == "-" || path.string().starts_with("/dev/")) return {};
  if (path.extension() == ".svg") return {.picture = true};
  if (const std::optional<MeshFormat> format = mesh_format(path)) return {.format = *format};
  throw InputError(path.string() +
                   ": meshes are written to .obj, .off, .ply or .svg files, or to - for standard output");
}

/// Throws InputError for options that say nothing about meshes.
void refuse_options(const RefineOptions& options) {
  struct Refused {
    bool given;
    const char* name;
    const char* reason;
  };
  const char* borders = "the borders of a mesh follow the scheme's own rule";
  for (const auto& [given, name, reason] :
       {Refused{!options.open.empty(), "--open", borders},
        Refused{!options.open_across.empty(), "--open-across", borders},
        Refused{!options.grid.empty(), "--grid", "the faces of a mesh say how its points are joined"},
        Refused{!options.details.empty(), "--details", "details belong to the points of a curve"},
        Refused{!options.retrofit.empty(), "--retrofit", "it is for closed curves"}}) {
    if (given) throw InputError(fmt::format("{}: {}; leave it out for meshes", name, reason));
  }
}

/// The counts of a mesh, level by level: exact ones, which may be far beyond any integer type.
struct Counts {
  Rational vertices;
  Rational edges;
  Rational faces;
  Rational corners;

  [[nodiscard]] Counts next(MeshSplit split) const {
    if (split == MeshSplit::triangles) {
      return {vertices + edges, Rational(2) * edges + corners, Rational(4) * faces, Rational(4) * corners};
    }
    return {vertices + edges + faces, Rational(2) * edges + corners, corners, Rational(4) * corners};
  }
  /// Vertices and corners are numbered by ints.
  [[nodiscard]] bool fit() const {
    const Rational most(std::numeric_limits<int>::max());
    return vertices <= most && corners <= most;
  }
};

Counts counts_after(const MeshTopology& mesh, MeshSplit split, int levels) {
  Counts counts{Rational(mesh.vertices()), Rational(mesh.edges()), Rational(mesh.faces()),
                Rational(mesh.half_edges())};
  for (int level = 0; level < levels; ++level) counts = counts.next(split);
  return counts;
}

void require_levels(const MeshTopology& mesh, MeshSplit split, const RefineOptions& options, bool picture) {
  const Rational most_drawn(1L << 20);
  const auto fits = [&](int levels) {
    const Counts counts = counts_after(mesh, split, levels);
    return counts.fit() && (!picture || counts.faces <= most_drawn);
  };
  if (fits(options.levels)) return;
  int possible = options.levels;
  while (possible > 0 && !fits(possible)) --possible;
  const auto faces = [&](int levels) { return counts_after(mesh, split, levels).faces.to_string(); };
  throw InputError(fmt::format("--levels {}: {} faces, more than {}; {}", options.levels,
                               faces(options.levels), picture ? "a picture shows" : "can be numbered",
                               fits(possible) ? fmt::format("--levels {} makes {}", possible, faces(possible))
                                              : "the faces of the mesh alone are too many"));
}

/// Schemes for triangles take nothing else.
void require_triangles(const MeshFile& file, const MeshSchemeDescription& scheme) {
  for (std::size_t f = 0; f < file.faces.faces(); ++f) {
    if (file.faces.face(f).size() == 3) continue;
    std::vector<std::string> others;
    for (const MeshFamily& family : mesh_catalogue()) {
      if (family.split == MeshSplit::quads && !family.rings_only) others.push_back(family.name);
    }
    throw InputError(fmt::format("{} face {} has {} corners, and {} refines triangles; {} take any faces",
                                 file.place(f), f + 1, file.faces.face(f).size(), scheme.family->name,
                                 joined(others, "and")));
  }
}

MeshSchemeDescription evaluated_mesh_scheme(const std::string& text) {
  MeshSchemeDescription scheme = parse_mesh_scheme(text);
  if (scheme.family->rings_only) {
    throw InputError(
        in_quotes(text) + " makes rings of surface around extraordinary vertices: subdivlab rings " +
        "INPUT --sigma 1/2 -o OUTPUT; refine takes other schemes for meshes, such as catmull-clark");
  }
  if (!scheme.free_parameters.empty()) {
    throw InputError(in_quotes(text) + ": " + joined(scheme.free_parameters, "and") +
                     " has no value; meshes are refined for numbers, such as jspline-mesh:s=1/2");
  }
  return scheme;
}

MeshFile mesh_input(const RefineOptions& options) {
  std::vector<std::string> curves;
  for (const Family& family : catalogue()) curves.push_back(family.name);
  const std::string fitting = fmt::format("; {} is a scheme for meshes, and curves and grids take {}",
                                          options.scheme, joined(curves));
  if (std::filesystem::path(options.input).extension() == ".csv")
    throw InputError(options.input + ": points without faces; expected an .obj, .off or .ply file" + fitting);
  MeshFile file = read_mesh(options.input);
  if (file.faces.faces() == 0 && !file.points.empty())
    throw InputError(options.input + ": vertices and no faces, as of a curve or a grid" + fitting);
  return file;
}

int threads_of(const RefineOptions& options) {
  if (options.threads > 0) return options.threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// The limit positions of the vertices of the last level, with normals.
IndexedMesh limit_points(const MeshFile& input, const MeshTopology& mesh, const MeshScheme<double>& scheme,
                         const RefineOptions& options) {
  if (options.levels == 0 && mesh.sides() == 0)
    throw InputError("--limit: faces of different numbers of corners become quads by a step: --levels 1");
  try {
    return limit_mesh(mesh, input.points, scheme, options.levels, threads_of(options));
  } catch (const std::domain_error& error) {
    throw InputError("--limit: " + options.scheme + ": " + error.what());
  }
}

void write_refined(OutputFile& file, const MeshOutput& output, const MeshFile& input,
                   const MeshTopology& mesh, const MeshScheme<double>& scheme, const RefineOptions& options) {
  if ((options.levels == 0 && !options.limit) || input.faces.faces() == 0) {  // nothing changes
    if (output.picture) {
      write_picture(file, mesh_quads(input.faces, input.points), mesh.is_closed());
    } else {
      write_mesh(file, output.format, input.faces, input.points);
    }
    return;
  }
  const IndexedMesh refined =
      options.limit ? limit_points(input, mesh, scheme, options)
                    : refine_mesh(mesh, input.points, scheme, options.levels, threads_of(options));
  if (output.picture) {
    write_picture(file, mesh_quads(refined), mesh.is_closed());
  } else {
    write_mesh(file, output.format, refined);
  }
}

}  // namespace

bool is_about_meshes(const RefineOptions& options) {
  const std::optional<MeshFormat> format = mesh_format(options.input);
  return names_mesh_scheme(options.scheme) || (format && *format != MeshFormat::obj);
}

int refine_mesh_file(const RefineOptions& options) {
  const MeshSchemeDescription scheme = evaluated_mesh_scheme(options.scheme);
  refuse_options(options);
  const MeshOutput output = mesh_output(options.out);
  const MeshFile input = mesh_input(options);
  const MeshTopology mesh = surface_of(input);
  if (scheme.family->split == MeshSplit::triangles) require_triangles(input, scheme);
  require_levels(mesh, scheme.family->split, options, output.picture);

  OutputFile file(options.out);
  try {
    write_refined(file, output, input, mesh, mesh_scheme<double>(scheme), options);
  } catch (const std::bad_alloc&) {
    throw InputError(
        fmt::format("--levels {}: there is not enough memory; use fewer levels", options.levels));
  }
  file.finish();
  return ExitCode::done;
}

}  // namespace subdiv::cli
