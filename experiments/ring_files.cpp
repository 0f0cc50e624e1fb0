#include "experiments/ring_files.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

#include "experiments/report/curve_writer.h"
#include "schemes/evaluate/bezier_patch.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

struct PointHash {
  std::size_t operator()(const Point3& p) const {
    std::size_t result = 0;
    for (const double x : p) {
      std::uint64_t bits = 0;
      const double one_zero = x + 0.0;  // -0 and 0 are one number
      std::memcpy(&bits, &one_zero, sizeof(bits));
      constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U;
      constexpr int half = 32;
      result = (result ^ bits) * odd;
      result ^= result >> half;
    }
    return result;
  }
};

class Tessellation {
 public:
  explicit Tessellation(int pieces) : side_(static_cast<std::size_t>(pieces) + 1) {
    for (int k = 0; k <= pieces; ++k) weights_.push_back(bernstein(k, pieces));
  }
  void add(const BezierPatch<Point3>& patch) {
    const std::size_t last = side_ - 1;
    numbers_.resize(side_ * side_);
    for (std::size_t i = 0; i <= last; ++i) {
      for (std::size_t j = 0; j <= last; ++j) {
        const Point3 point = patch_point(patch, weights_[i], weights_[j]);
        const bool on_edge = i == 0 || j == 0 || i == last || j == last;
        numbers_[i * side_ + j] = on_edge ? shared(point) : added(point);
      }
    }
    for (std::size_t i = 0; i < last; ++i) {
      for (std::size_t j = 0; j < last; ++j) {
        const std::size_t k = i * side_ + j;
        for (const std::size_t corner : {k, k + side_, k + side_ + 1, k + 1})
          mesh.corners.push_back(numbers_[corner]);
      }
    }
  }

  IndexedMesh mesh;

 private:
  int added(const Point3& point) {
    mesh.points.push_back(point);
    return static_cast<int>(mesh.points.size()) - 1;
  }
  int shared(const Point3& point) {
    const auto [place, is_new] = places_.try_emplace(point, static_cast<int>(mesh.points.size()));
    return is_new ? added(point) : place->second;
  }

  std::size_t side_;
  std::vector<std::array<double, 4>> weights_;
  std::vector<int> numbers_;
  std::unordered_map<Point3, int, PointHash> places_;
};

void append_coordinates(std::string& text, const Point3& point) {
  for (std::size_t d = 0; d < point.size(); ++d) {
    if (d > 0) text += ' ';
    append_number(text, point[d]);
  }
}

void write_vertex(OutputFile& file, std::string& text, const Point3& point) {
  text = "v ";
  append_coordinates(text, point);
  file.write(text += '\n');
}

/// visit(group, patch) for all patches in their order.
template <class Visit>
void for_each_patch(const RingSurface& surface, const Visit& visit) {
  for (std::size_t g = 0; g < surface.groups(); ++g) {
    for (std::size_t p = surface.begin[g]; p < surface.begin[g + 1]; ++p) visit(g, p);
  }
}

}  // namespace

GroupedMesh tessellated(const RingSurface& surface, int pieces) {
  const auto most = static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4;
  const auto squared = static_cast<std::size_t>(pieces) * static_cast<std::size_t>(pieces);
  if (surface.patches.size() > most / squared) {
    throw InputError(fmt::format("{} patches of {} x {} quads are more than can be numbered; take fewer",
                                 surface.patches.size(), pieces, pieces));
  }
  Tessellation tessellation(pieces);
  for (const BezierPatch<Point3>& patch : surface.patches) tessellation.add(patch);
  GroupedMesh result{std::move(tessellation.mesh), {}};
  for (const std::size_t first : surface.begin) result.begin.push_back(first * squared);
  return result;
}

std::string group_name(const RingSurface& surface, std::size_t group) {
  if (group == 0) return "regular";
  return group + 1 < surface.groups() ? fmt::format("ring_{}", group) : "cap";
}

void write_grouped_obj(OutputFile& file, const GroupedMesh& mesh, const RingSurface& surface) {
  std::string text;
  for (const Point3& point : mesh.mesh.points) write_vertex(file, text, point);
  for (std::size_t g = 0; g + 1 < mesh.begin.size(); ++g) {
    if (mesh.begin[g] == mesh.begin[g + 1]) continue;
    file.write("g " + group_name(surface, g) + "\n");
    for (std::size_t f = mesh.begin[g]; f < mesh.begin[g + 1]; ++f) {
      const int* c = &mesh.mesh.corners[4 * f];
      file.write(fmt::format("f {} {} {} {}\n", c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1));
    }
  }
}

void write_control_obj(OutputFile& file, const RingSurface& surface) {
  std::string text;
  for (const BezierPatch<Point3>& patch : surface.patches) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 4; ++i) write_vertex(file, text, patch[4 * i + j]);
    }
  }
  file.write("cstype bezier\ndeg 3 3\n");
  for_each_patch(surface, [&](std::size_t group, std::size_t patch) {
    if (patch == surface.begin[group]) file.write("g " + group_name(surface, group) + "\n");
    text = "surf 0 1 0 1";
    for (std::size_t k = 1; k <= 16; ++k) text += fmt::format(" {}", 16 * patch + k);
    file.write(text += "\nparm u 0 1\nparm v 0 1\nend\n");
  });
}

void write_control_bv(OutputFile& file, const RingSurface& surface) {
  std::string text;
  for_each_patch(surface, [&](std::size_t group, std::size_t patch) {
    if (patch == surface.begin[group])
      file.write(fmt::format("Group {} {}\n", group, group_name(surface, group)));
    file.write("5\n3 3\n");
    for (const Point3& point : surface.patches[patch]) {
      text.clear();
      append_coordinates(text, point);
      file.write(text += '\n');
    }
  });
}

}  // namespace subdiv
