#include <algorithm>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/cli/verbs.h"
#include "experiments/mesh_file.h"
#include "experiments/mesh_pictures.h"
#include "experiments/ring_files.h"
#include "schemes/argument.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/evaluate/ring_surface.h"
#include "schemes/expression_ring.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

enum class Output { none, grouped_obj, off, ply, picture };

Output output_of(const std::filesystem::path& path) {
  if (path.empty()) return Output::none;
  if (path == "-" || path.string().starts_with("/dev/")) return Output::grouped_obj;
  if (path.extension() == ".svg") return Output::picture;
  const std::optional<MeshFormat> format = mesh_format(path);
  if (!format) {
    throw InputError(path.string() +
                     ": surfaces are written to .obj, .off, .ply or .svg files, or to - for standard output");
  }
  if (*format == MeshFormat::obj) return Output::grouped_obj;
  return *format == MeshFormat::off ? Output::off : Output::ply;
}

enum class Control { none, obj, bv };

Control control_of(const std::filesystem::path& path) {
  if (path.empty()) return Control::none;
  if (path.extension() == ".obj") return Control::obj;
  if (path.extension() == ".bv") return Control::bv;
  throw InputError("--control-points " + path.string() +
                   ": control points are written to .obj files, with free-form surfaces, or .bv files");
}

SpeedSchedule schedule_of(const std::string& text) {
  std::vector<Algebraic> speeds;
  const auto place = [&](std::string_view word) {
    return fmt::format("--sigma {}, {}: ", in_quotes(text), in_quotes(std::string(word)));
  };
  if (!text.empty()) {
    for (const std::string_view word : split_outside_parentheses(text, ',')) {
      if (word.empty())
        throw InputError(
            fmt::format("--sigma {}: a speed is missing; expected speeds between 0 and 1, one a "
                        "step, such as 1/2,3/4",
                        in_quotes(text)));
      try {
        speeds.push_back(evaluate_constant<Algebraic>(Expression::parse(word)));
      } catch (const InputError& error) {
        throw InputError(place(word) + error.what());
      }
    }
  }
  constexpr std::size_t most = 1000;
  if (speeds.size() > most)
    throw InputError(fmt::format("--sigma: {} steps, more than {}", speeds.size(), most));
  try {
    return SpeedSchedule(std::move(speeds));
  } catch (const InputError& error) {
    throw InputError(std::string("--sigma: ") + error.what());
  }
}

struct QuadMesh {
  MeshTopology topology;
  std::vector<Point3> points;
};

void require_no_fault(const QuadMesh& mesh, const RingsOptions& options) {
  const std::optional<RingFault> fault = find_ring_fault(mesh.topology);
  if (!fault) return;
  std::string remedy = fault->remedy;
  if (fault->step_helps) {
    remedy +=
        options.catmull_clark_steps == 0 ? ": --catmull-clark-step" : "; give --catmull-clark-step once more";
  }
  const std::string after = options.catmull_clark_steps == 0
                                ? ""
                                : fmt::format(" after {} Catmull-Clark step{}", options.catmull_clark_steps,
                                              options.catmull_clark_steps == 1 ? "" : "s");
  throw InputError(fmt::format("{}{}: {}; {}", options.input, after, fault->what, remedy));
}

QuadMesh quad_mesh(const RingsOptions& options) {
  const MeshFile file = read_mesh(options.input);
  if (file.faces.faces() == 0)
    throw InputError(options.input + ": no faces; expected a mesh of quads, .obj, .off or .ply");
  QuadMesh mesh{surface_of(file), file.points};
  const MeshScheme<double> scheme = catmull_clark<double>();
  for (int step = 0; step < options.catmull_clark_steps; ++step) {
    constexpr int most = 1 << 28;
    if (mesh.topology.half_edges() > most)
      throw InputError("--catmull-clark-step: more half-edges than can be numbered; give it less often");
    mesh.points = refined_points(mesh.topology, scheme, mesh.points);
    mesh.topology = split_into_quads(mesh.topology);
  }
  require_no_fault(mesh, options);
  return mesh;
}

std::size_t count(const RingSurface& surface, std::size_t group) {
  return surface.begin[group + 1] - surface.begin[group];
}

double share(const RingHole& hole) { return hole.first_size > 0 ? hole.size / hole.first_size : 0; }

Json report_json(const RingSurface& surface, const SpeedSchedule& schedule, const RingsOptions& options) {
  const auto number = [](double x) { return fmt::format("{}", x); };
  Json json = {{"input", options.input},
               {"catmull_clark_steps", options.catmull_clark_steps},
               {"speeds", Json::array()},
               {"patches", Json::array()},
               {"rounding", number(surface.rounding)},
               {"holes", Json::array()}};
  for (const Algebraic& sigma : schedule.speeds()) json["speeds"].push_back(sigma.to_string());
  for (std::size_t g = 0; g < surface.groups(); ++g)
    json["patches"].push_back({{"group", group_name(surface, g)}, {"count", count(surface, g)}});
  for (const RingHole& hole : surface.holes) {
    json["holes"].push_back({{"vertex", hole.vertex + 1},
                             {"valence", hole.valence},
                             {"filled", options.fill},
                             {"first_size", number(hole.first_size)},
                             {"size", number(hole.size)},
                             {"share", number(share(hole))}});
  }
  return json;
}

std::string report_text(const RingSurface& surface, const RingsOptions& options) {
  std::string text = fmt::format("{:<10}{:>10}\n", "group", "patches");
  for (std::size_t g = 0; g < surface.groups(); ++g) {
    if (count(surface, g) > 0)
      text += fmt::format("{:<10}{:>10}\n", group_name(surface, g), count(surface, g));
  }
  if (surface.holes.empty()) return text + "\nno extraordinary vertices: no rings, no holes\n";
  text += fmt::format("\n{:>8}{:>9}{:>14}{:>22}\n", options.fill ? "cap at" : "hole at", "valence", "size",
                      "share of the first");
  for (const RingHole& hole : surface.holes) {
    text +=
        fmt::format("{:>8}{:>9}{:>14.6g}{:>22.6g}\n", hole.vertex + 1, hole.valence, hole.size, share(hole));
  }
  return text + fmt::format("\ncoordinates of rings are rounded by at most {:.1e}{}\n", surface.rounding,
                            options.catmull_clark_steps > 0 ? ", Catmull-Clark steps apart" : "");
}

void write_surface_file(OutputFile& file, Output output, const RingSurface& surface,
                        const RingsOptions& options, bool closed) {
  const auto pieces = static_cast<std::size_t>(options.tessellation);
  constexpr std::size_t most_drawn = std::size_t{1} << 20;
  if (output == Output::picture && surface.patches.size() > most_drawn / (pieces * pieces)) {
    throw InputError(
        fmt::format("--tessellation {}: {} quads, more than {}, which a picture shows; take less", pieces,
                    surface.patches.size() * pieces * pieces, most_drawn));
  }
  const GroupedMesh mesh = tessellated(surface, options.tessellation);
  switch (output) {
    case Output::picture:
      write_picture(file, mesh_quads(mesh.faces, mesh.points), closed && options.fill && !options.rings_only);
      break;
    case Output::grouped_obj:
      write_grouped_obj(file, mesh, surface);
      break;
    case Output::off:
    case Output::ply:
      write_mesh(file, output == Output::off ? MeshFormat::off : MeshFormat::ply, mesh.faces, mesh.points);
      break;
    case Output::none:
      break;
  }
}

int write_rings(const RingsOptions& options) {
  const Output output = output_of(options.out);
  const Control control = control_of(options.control_points);
  if (output == Output::none && control == Control::none && !options.json)
    throw InputError(
        "nothing to write: -o OUTPUT for the surface, --control-points FILE for its patches, or "
        "--json for the holes alone");
  const bool surface_shown = output != Output::none && is_standard_output(options.out);
  const bool control_shown = control != Control::none && is_standard_output(options.control_points);
  if (options.json && (surface_shown || control_shown)) {
    throw InputError("--json: standard output takes the " +
                     (surface_shown ? "surface (-o " + options.out
                                    : "patches (--control-points " + options.control_points) +
                     "); write one of them to a file");
  }
  if (output != Output::none && control != Control::none &&
      have_same_target(options.out, options.control_points))
    throw InputError("--control-points " + options.control_points + ": -o " + options.out +
                     " writes this file; the patches need another one");
  const SpeedSchedule schedule = schedule_of(options.sigma);
  const QuadMesh mesh = quad_mesh(options);
  RingSurface surface;
  try {
    surface = ring_surface(mesh.topology, mesh.points, schedule,
                           {.regular_faces = !options.rings_only, .fill = options.fill});
  } catch (const InputError& error) {
    throw InputError(options.input + ": " + error.what());
  }
  std::optional<OutputFile> surface_file;
  std::optional<OutputFile> control_file;
  if (output != Output::none) {
    surface_file.emplace(options.out);
    write_surface_file(*surface_file, output, surface, options, mesh.topology.is_closed());
    surface_file->close();
  }
  if (control != Control::none) {
    control_file.emplace(options.control_points);
    (control == Control::obj ? write_control_obj : write_control_bv)(*control_file, surface);
    control_file->close();
  }
  if (surface_file) surface_file->finish();
  if (control_file) control_file->finish();
  if (options.json) {
    std::cout << report_json(surface, schedule, options).dump(2) << '\n';
  } else {
    (surface_shown || control_shown ? std::cerr : std::cout) << report_text(surface, options);
  }
  return ExitCode::done;
}

}  // namespace

int rings(const RingsOptions& options) {
  try {
    return write_rings(options);
  } catch (const std::bad_alloc&) {
    throw InputError(
        fmt::format("{}: there is not enough memory; take a smaller --tessellation", options.input));
  }
}

}  // namespace subdiv::cli
