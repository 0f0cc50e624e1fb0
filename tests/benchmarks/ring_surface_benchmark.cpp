// Catmull-Clark surfaces with rings of adjustable speed. Items are patches: their number a second is the same
// for meshes of any size and any number of rings.
//   benchmarks --benchmark_filter=ring_surface

#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/ring_files.h"
#include "schemes/evaluate/nested_rings.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/evaluate/ring_surface.h"
#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/fan.h"
#include "tests/sample_meshes.h"

namespace subdiv {
namespace {

struct Mesh {
  MeshTopology topology;
  std::vector<Point3> points;
};

/// `copies` of a mesh with vertices of valence 3, 5 and 10 side by side, after `steps` Catmull-Clark steps.
Mesh input(int copies, int steps) {
  PolygonFaces faces = sample::quads_of(sample::bipyramid(5));
  for (int i = 1; i < copies; ++i)
    faces = sample::joined(std::move(faces), sample::quads_of(sample::bipyramid(5)));
  Mesh mesh{MeshTopology(faces), sample::random_points<double>(static_cast<int>(faces.vertices), 3U)};
  for (int i = 0; i < steps; ++i) {
    mesh.points = refined_points(mesh.topology, catmull_clark<double>(), mesh.points);
    mesh.topology = split_into_quads(mesh.topology);
  }
  return mesh;
}

SpeedSchedule schedule(std::size_t steps) {
  std::vector<Algebraic> speeds(steps, Algebraic(Rational(3, 5)));
  return SpeedSchedule(std::move(speeds));
}

void run(benchmark::State& state, const Mesh& mesh, const SpeedSchedule& speeds) {
  std::size_t patches = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const RingSurface surface = ring_surface(mesh.topology, mesh.points, speeds, {true, true});
    patches = surface.patches.size();
    benchmark::DoNotOptimize(surface.patches.data());
  }
  state.counters["patches"] = static_cast<double>(patches);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(patches));
}

/// Nearly all faces are regular.
void ring_surface_of_regular_faces(benchmark::State& state) {
  run(state, input(1, static_cast<int>(state.range(0))), schedule(2));
}
/// All faces are in rings: as many extraordinary vertices as there are copies, times a constant.
void ring_surface_of_many_vertices(benchmark::State& state) {
  run(state, input(static_cast<int>(state.range(0)), 1), schedule(2));
}
/// By the number of rings.
void ring_surface_of_many_rings(benchmark::State& state) {
  run(state, input(64, 1), schedule(static_cast<std::size_t>(state.range(0))));
}

/// Rings around one vertex alone, by their number and its valence.
void ring_surface_around_a_vertex(benchmark::State& state) {
  const SpeedSchedule speeds = schedule(static_cast<std::size_t>(state.range(0)));
  const auto valence = static_cast<int>(state.range(1));
  const auto weights = speeds.weights(valence);
  const SectorNet<Point3> net(
      valence, sample::random_points<double>(1 + valence * static_cast<int>(SectorNet<Point3>::places), 5U));
  for ([[maybe_unused]] const auto _ : state) {
    const auto rings =
        nested_rings<Point3, double>(net, speeds.steps(), [&](std::size_t k) { return weights[k]; });
    benchmark::DoNotOptimize(rings.hole.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(1) * 3);
}

/// Quads of the tessellation, 4 x 4 a patch.
void ring_surface_tessellated(benchmark::State& state) {
  const Mesh mesh = input(1, static_cast<int>(state.range(0)));
  const RingSurface surface = ring_surface(mesh.topology, mesh.points, schedule(2), {true, true});
  std::size_t faces = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const GroupedMesh result = tessellated(surface, 4);
    faces = result.faces.faces();
    benchmark::DoNotOptimize(result.points.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(faces));
}

BENCHMARK(ring_surface_of_regular_faces)->DenseRange(3, 8)->Unit(benchmark::kMillisecond);
BENCHMARK(ring_surface_of_many_vertices)->RangeMultiplier(4)->Range(4, 256)->Unit(benchmark::kMillisecond);
BENCHMARK(ring_surface_of_many_rings)->DenseRange(2, 10, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(ring_surface_around_a_vertex)
    ->ArgsProduct({{1, 2, 4, 8}, {3, 5, 50}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(ring_surface_tessellated)->DenseRange(3, 6)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace subdiv
