#include "schemes/evaluate/mesh_refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "schemes/evaluate/parallel_chunks.h"
#include "schemes/evaluate/patch_kernel.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/input_error.h"
#include "schemes/mesh/border_layers.h"

namespace subdiv {
namespace {

/// The deepest patch: its tables still fit the fastest cache.
constexpr int deepest_patch = 4;
/// Rows or faces that a thread takes at once.
constexpr std::size_t rows_at_once = 4096;
constexpr std::size_t faces_at_once = 64;

struct SignatureHash {
  std::size_t operator()(const std::vector<int>& signature) const {
    std::uint64_t hash = signature.size();
    for (const int i : signature) {
      hash = (hash ^ static_cast<std::uint32_t>(i)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29U;
    }
    return hash;
  }
};

/// Work on 0 .. count - 1 in runs of `at_once`.
template <class Work>
void in_runs(std::size_t count, std::size_t at_once, int threads, const Work& work) {
  for_each_chunk((count + at_once - 1) / at_once, threads,
                 [&](std::size_t chunk) { work(chunk * at_once, std::min(count, (chunk + 1) * at_once)); });
}

std::vector<char> regular_vertices(const MeshTopology& mesh) {
  const int regular = mesh.sides() == 4 ? 4 : 6;
  std::vector<char> result(static_cast<std::size_t>(mesh.vertices()));
  for (int v = 0; v < mesh.vertices(); ++v)
    result[static_cast<std::size_t>(v)] = !mesh.is_border(v) && mesh.valence(v) == regular ? 1 : 0;
  return result;
}

/// The first `faces` faces of the mesh in patches; nothing when their neighbourhoods are of more kinds than
/// `most_kinds`, not counting the regular one.
std::optional<PatchStage> patch_stage(const MeshTopology& mesh, int faces, const MeshScheme<double>& scheme,
                                      int depth, const FinalRule& final_rule, std::size_t most_kinds) {
  PatchStage stage;
  stage.grid = patch_grid(mesh.sides(), depth);
  RegularPatch regular_patch(scheme, stage.grid, final_rule);
  stage.tables.push_back(regular_patch.table());
  const std::vector<char> regular = regular_vertices(mesh);
  std::unordered_map<std::vector<int>, int, SignatureHash> kinds;
  NeighbourhoodFinder finder(mesh);
  Neighbourhood neighbourhood;
  stage.table_of_face.reserve(static_cast<std::size_t>(faces));
  stage.controls.reserve(static_cast<std::size_t>(faces) * regular_patch.table().controls.size());
  stage.controls_begin.reserve(static_cast<std::size_t>(faces) + 1);
  for (int f = 0; f < faces; ++f) {
    if (regular_patch.add_controls(mesh, regular, f, stage.controls)) {
      stage.table_of_face.push_back(0);
    } else {
      finder.find(f, scheme.sight, neighbourhood);
      const auto [kind, is_new] =
          kinds.try_emplace(neighbourhood.signature, static_cast<int>(stage.tables.size()));
      if (kinds.size() > most_kinds) return std::nullopt;
      if (is_new) stage.tables.push_back(patch_table(mesh, neighbourhood, scheme, stage.grid, final_rule));
      stage.table_of_face.push_back(kind->second);
      for (const int k : stage.tables[static_cast<std::size_t>(kind->second)].controls)
        stage.controls.push_back(neighbourhood.vertices[static_cast<std::size_t>(k)]);
    }
    stage.controls_begin.push_back(stage.controls.size());
  }
  return stage;
}

/// As many kinds of neighbourhoods as are worth their tables: one costs the stencils of some hundred faces,
/// one more level without patches those of four times the faces. Once no two irregular vertices are seen at
/// once, there are as many as must be.
std::size_t worthwhile_kinds(const MeshTopology& mesh, const MeshScheme<double>& scheme, int apart) {
  constexpr std::size_t few = 8;
  constexpr std::size_t faces_per_kind = 128;
  if (apart >= 2 * scheme.sight) return std::numeric_limits<std::size_t>::max();
  return few + static_cast<std::size_t>(mesh.faces()) / faces_per_kind;
}

/// Writes the points of one face's patch that it owns.
class PatchWriter {
 public:
  PatchWriter(const PatchStage& stage, std::span<const Point3> from, std::span<Point3> to)
      : stage_(stage), mesh_(stage.mesh), numbering_(stage.mesh, stage.grid), from_(from), to_(to) {
    const std::size_t padded = (stage.grid.size() + patch_line - 1) / patch_line * patch_line;
    points_.resize(padded);
  }

  void write(int face) {
    const auto f = static_cast<std::size_t>(face);
    const PatchTable& table = stage_.tables[static_cast<std::size_t>(stage_.table_of_face[f])];
    controls_.resize(table.controls.size());
    const int* control = stage_.controls.data() + stage_.controls_begin[f];
    for (std::size_t k = 0; k < controls_.size(); ++k)
      controls_[k] = from_[static_cast<std::size_t>(control[k])];
    if (controls_.empty()) controls_.emplace_back();  // a table of zeros reads none
    const auto inner = static_cast<std::size_t>(stage_.grid.inner_points());
    const std::size_t direct = inner / patch_line;  // lines that go where they belong
    Point3* const own = to_.data() + numbering_.first_inner(face);
    detail::apply_patch_table(table, controls_.data()->data(), 0, direct, own->data());
    detail::apply_patch_table(table, controls_.data()->data(), direct, table.lines(), points_.data()->data());
    const Point3* next = points_.data();
    std::copy_n(next, inner - direct * patch_line, own + direct * patch_line);
    next += inner - direct * patch_line;
    const int side_points = stage_.grid.side_points();
    for (int q = 0; q < stage_.grid.sides; ++q, next += side_points) {
      const int h = stage_.grid.sides * face + q;
      if (numbering_.owns_edge(h)) std::copy_n(next, side_points, to_.data() + numbering_.first_on_edge(h));
    }
    for (int q = 0; q < stage_.grid.sides; ++q, ++next) {
      const int h = stage_.grid.sides * face + q;
      if (numbering_.owns_origin(h)) to_[static_cast<std::size_t>(mesh_.origin(h))] = *next;
    }
  }

 private:
  const PatchStage& stage_;
  const MeshTopology& mesh_;
  PatchNumbering numbering_;
  std::span<const Point3> from_;
  std::span<Point3> to_;
  std::vector<Point3> controls_;
  std::vector<Point3> points_;
};

void apply(const PatchStage& stage, std::span<const Point3> from, std::span<Point3> to, int threads) {
  in_runs(stage.table_of_face.size(), faces_at_once, threads, [&](std::size_t begin, std::size_t end) {
    PatchWriter writer(stage, from, to);
    for (std::size_t f = begin; f < end; ++f) writer.write(static_cast<int>(f));
  });
  // Vertices of no face belong to no patch.
  for (int v = 0; v < stage.mesh.vertices(); ++v) {
    if (stage.mesh.outgoing(v) < 0) to[static_cast<std::size_t>(v)] = from[static_cast<std::size_t>(v)];
  }
}

void apply(const StencilRows& rows, std::span<const Point3> from, std::span<Point3> to, int threads) {
  in_runs(rows.size(), rows_at_once, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) to[row] = rows.point(row, from);
  });
}

std::size_t vertices_of(const StencilRows& rows) { return rows.size(); }
std::size_t vertices_of(const PatchStage& stage) { return PatchNumbering(stage.mesh, stage.grid).vertices(); }

StencilRows step_rows(const MeshTopology& mesh, const MeshScheme<double>& scheme) {
  StencilRows rows;
  for_each_stencil(mesh, scheme, [&](int /*number*/, const Stencil<double>& stencil) { rows.add(stencil); });
  return rows;
}

/// The mesh that a stage makes of the given one.
MeshTopology refined_by(const MeshTopology& mesh, const PatchGrid& grid) {
  const PatchNumbering numbering(mesh, grid);
  std::vector<int> origin(numbering.faces() * static_cast<std::size_t>(grid.sides));
  std::vector<int> opposite(origin.size());
  numbering.corners(origin, 1);
  numbering.opposites(opposite, 1);
  return {grid.sides, static_cast<int>(numbering.vertices()), std::move(origin), std::move(opposite)};
}

void check_size(const MeshTopology& mesh, const MeshScheme<double>& scheme, int levels) {
  if (levels < 0) throw std::invalid_argument("there are no negative levels");
  if (scheme.split == MeshSplit::triangles && mesh.sides() != 3) {
    for (int f = 0; f < mesh.faces(); ++f) {
      if (mesh.degree(f) == 3) continue;
      throw InputError(fmt::format("face {} has {} corners: {} refines triangles only", f + 1, mesh.degree(f),
                                   scheme.name));
    }
  }
  const double half_edges = static_cast<double>(mesh.half_edges()) * std::pow(4.0, levels);
  if (half_edges > std::numeric_limits<int>::max()) {
    int most = 0;
    for (double count = 4.0 * mesh.half_edges(); count <= std::numeric_limits<int>::max(); count *= 4) ++most;
    throw InputError(
        fmt::format("{} levels make {:.3g} faces of {}: this mesh can be refined by 0 to {} levels", levels,
                    half_edges / 4, mesh.faces(), most));
  }
}

}  // namespace

void StencilRows::add(const Stencil<double>& stencil) {
  for (const auto& [vertex, weight] : stencil.terms()) {
    vertices.push_back(vertex);
    weights.push_back(weight);
  }
  begin.push_back(vertices.size());
}

Point3 StencilRows::point(std::size_t row, std::span<const Point3> points) const {
  Point3 sum{0, 0, 0};
  for (std::size_t i = begin[row]; i < begin[row + 1]; ++i) {
    const Point3& p = points[static_cast<std::size_t>(vertices[i])];
    for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += weights[i] * p[d];
  }
  return sum;
}

std::size_t PatchNumbering::vertices() const {
  return static_cast<std::size_t>(mesh_->vertices()) +
         static_cast<std::size_t>(mesh_->edges()) * static_cast<std::size_t>(grid_->side_points()) +
         static_cast<std::size_t>(mesh_->faces()) * static_cast<std::size_t>(grid_->inner_points());
}

std::size_t PatchNumbering::faces() const {
  return static_cast<std::size_t>(mesh_->faces()) * static_cast<std::size_t>(grid_->faces());
}

int PatchNumbering::first_inner(int face) const {
  return mesh_->vertices() + mesh_->edges() * grid_->side_points() + face * grid_->inner_points();
}

int PatchNumbering::first_on_edge(int h) const {
  return mesh_->vertices() + mesh_->edge(h) * grid_->side_points();
}

void PatchNumbering::corners(std::span<int> out, int threads) const {
  const std::size_t size = grid_->cells.size();
  in_runs(static_cast<std::size_t>(mesh_->faces()), faces_at_once, threads,
          [&](std::size_t begin, std::size_t end) {
            std::vector<int> number(grid_->size());
            for (std::size_t f = begin; f < end; ++f) {
              const int face = static_cast<int>(f);
              auto next = number.begin() + grid_->inner_points();
              std::iota(number.begin(), next, first_inner(face));
              for (int q = 0; q < grid_->sides; ++q) {
                const int h = grid_->sides * face + q;
                const auto side_end = next + grid_->side_points();
                std::iota(next, side_end, first_on_edge(h));
                if (!owns_edge(h)) std::reverse(next, side_end);
                next = side_end;
              }
              for (int q = 0; q < grid_->sides; ++q) *next++ = mesh_->origin(grid_->sides * face + q);
              int* to = out.data() + f * size;
              for (const int point : grid_->cells) *to++ = number[static_cast<std::size_t>(point)];
            }
          });
}

void PatchNumbering::opposites(std::span<int> out, int threads) const {
  const std::size_t size = grid_->cells.size();
  const int n = grid_->steps;
  in_runs(static_cast<std::size_t>(mesh_->faces()), faces_at_once, threads,
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
              const int first = static_cast<int>(f * size);
              int* const to = out.data() + f * size;
              for (std::size_t i = 0; i < size; ++i) to[i] = first + grid_->opposites[i];
              for (int q = 0; q < grid_->sides; ++q) {
                const int o = mesh_->opposite(grid_->sides * static_cast<int>(f) + q);
                const auto side = [&](int half_edge, int step) {  // by half-edges of the coarse face
                  const int at = half_edge % grid_->sides * n + step;
                  return grid_->side_half_edges[static_cast<std::size_t>(at)];
                };
                for (int t = 0; t < n; ++t) {
                  to[side(q, t)] =
                      o < 0 ? -1 : o / grid_->sides * static_cast<int>(size) + side(o, n - 1 - t);
                }
              }
            }
          });
}

MeshRefinement::MeshRefinement(const MeshTopology& mesh, const MeshScheme<double>& scheme, int levels,
                               const FinalRule& final_rule)
    : control_vertices_(static_cast<std::size_t>(mesh.vertices())), result_(mesh) {
  check_size(mesh, scheme, levels);
  int left = mesh.faces() == 0 ? 0 : levels;
  // Other polygons are split into quads once, by rules that need no layers.
  if (left > 0 && scheme.split == MeshSplit::quads && mesh.sides() != 4) {
    steps_.emplace_back(step_rows(result_, scheme));
    result_ = split_into_quads(result_);
    --left;
  }
  // The mesh with the layers added beyond its border: its faces begin with those of result_.
  const bool has_layers = (left > 0 || final_rule) && !scheme.border_rules.empty() && !result_.is_closed();
  MeshTopology whole;
  if (has_layers) {
    BorderLayers<double> layers = border_layers(result_, scheme.border_rules);
    StencilRows rows;
    for (int v = 0; v < result_.vertices(); ++v) rows.add(Stencil<double>(v));
    for (const auto& stencil : layers.added) rows.add(stencil);
    steps_.emplace_back(std::move(rows));
    whole = std::move(layers.mesh);
  }
  const auto refine_both = [&](const auto& refine) {
    result_ = refine(result_);
    if (has_layers) whole = refine(whole);
  };
  const auto current = [&]() -> const MeshTopology& { return has_layers ? whole : result_; };
  for (int apart = 1; left > 0;) {  // steps between two vertices of the mesh at the start
    const int depth = left % deepest_patch == 0 ? deepest_patch : left % deepest_patch;
    const bool last = depth == left;
    auto stage = patch_stage(current(), last ? result_.faces() : current().faces(), scheme, depth,
                             last ? final_rule : FinalRule(), worthwhile_kinds(current(), scheme, apart));
    if (!stage) {
      steps_.emplace_back(step_rows(current(), scheme));
      refine_both([&](const MeshTopology& m) { return split(m, scheme.split); });
      --left;
      apart *= 2;
      continue;
    }
    left -= depth;
    apart <<= depth;
    stage->mesh = last ? result_ : current();
    steps_.emplace_back(std::move(*stage));
    if (!last) refine_both([&](const MeshTopology& m) { return refined_by(m, last_stage()->grid); });
  }
  if (last_stage() == nullptr && (has_layers || final_rule)) {  // of each vertex but those of the layers
    std::vector<int> kept(static_cast<std::size_t>(result_.vertices()));
    std::iota(kept.begin(), kept.end(), 0);
    for (int h = 0; has_layers && h < result_.half_edges(); ++h)
      kept[static_cast<std::size_t>(result_.origin(h))] = whole.origin(h);
    StencilRows rows;
    const auto rule = final_rule ? final_rule(current()) : nullptr;
    for (const int v : kept) rows.add(rule ? rule(v) : Stencil<double>(v));
    steps_.emplace_back(std::move(rows));
  }
  sides_ = result_.sides();
}

const PatchStage* MeshRefinement::last_stage() const {
  return steps_.empty() ? nullptr : std::get_if<PatchStage>(&steps_.back());
}

std::size_t MeshRefinement::vertices() const {
  const PatchStage* const stage = last_stage();
  return stage == nullptr ? static_cast<std::size_t>(result_.vertices()) : vertices_of(*stage);
}

std::size_t MeshRefinement::faces() const {
  const PatchStage* const stage = last_stage();
  return stage == nullptr ? static_cast<std::size_t>(result_.faces())
                          : PatchNumbering(stage->mesh, stage->grid).faces();
}

void MeshRefinement::points(std::span<const Point3> control, std::span<Point3> out, int threads) const {
  if (control.size() != control_vertices_ || out.size() != vertices())
    throw std::invalid_argument(
        "points: one for each vertex of the control mesh in, of the refined mesh out");
  if (steps_.empty()) {
    std::copy(control.begin(), control.end(), out.begin());
    return;
  }
  std::vector<Point3> before;
  std::vector<Point3> after;
  std::span<const Point3> from = control;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const bool last = k + 1 == steps_.size();
    if (!last) after.resize(std::visit([](const auto& step) { return vertices_of(step); }, steps_[k]));
    const std::span<Point3> to = last ? out : std::span<Point3>(after);
    std::visit([&](const auto& step) { apply(step, from, to, threads); }, steps_[k]);
    std::swap(before, after);
    from = before;
  }
}

void MeshRefinement::corners(std::span<int> out, int threads) const {
  if (out.size() != faces() * static_cast<std::size_t>(sides_))
    throw std::invalid_argument("corners: as many as the refined mesh has half-edges");
  if (const PatchStage* const stage = last_stage()) {
    PatchNumbering(stage->mesh, stage->grid).corners(out, threads);
  } else {
    std::copy(result_.origins().begin(), result_.origins().end(), out.begin());
  }
}

void MeshRefinement::opposites(std::span<int> out, int threads) const {
  if (out.size() != faces() * static_cast<std::size_t>(sides_))
    throw std::invalid_argument("opposites: as many as the refined mesh has half-edges");
  if (const PatchStage* const stage = last_stage()) {
    PatchNumbering(stage->mesh, stage->grid).opposites(out, threads);
  } else {
    std::copy(result_.opposites().begin(), result_.opposites().end(), out.begin());
  }
}

}  // namespace subdiv
