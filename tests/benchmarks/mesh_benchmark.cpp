// Refinement of closed meshes of 10,000 faces by four levels, connectivity and positions, beside CGAL and
// OpenMesh where they are installed. Items are faces of the result. One run gives the ratios:
//   benchmarks --benchmark_filter=mesh

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <malloc.h>

#include <benchmark/benchmark.h>

#include "schemes/evaluate/indexed_mesh.h"
#include "schemes/evaluate/mesh_refinement.h"
#include "schemes/mesh/mesh_catalogue.h"

#if defined(SUBDIVLAB_HAS_CGAL) || defined(SUBDIVLAB_HAS_OPENMESH)
#include "tests/cross/reference/reference.h"
#endif

namespace subdiv {
namespace {

constexpr int levels = 4;

struct Input {
  PolygonFaces faces;
  std::vector<Point3> points;
};

/// The surface of a cube, n x n squares a side, blown up; each square cut in two for triangles. Valence 3 at
/// the corners (4 or more among triangles).
Input blown_cube(int n, bool triangles) {
  Input input;
  std::map<std::array<int, 3>, long long> numbers;
  const auto number = [&](const std::array<int, 3>& p) {
    const auto [at, added] = numbers.try_emplace(p, static_cast<long long>(input.points.size()));
    if (added) {
      Point3 q{};
      for (std::size_t d = 0; d < 3; ++d) q[d] = 2.0 * p[d] / n - 1;
      const double length = std::hypot(q[0], q[1], q[2]) * (1 + 0.1 * std::sin(5 * q[0] + 3 * q[1] * q[2]));
      for (double& x : q) x /= length;
      input.points.push_back(q);
    }
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int a, int b) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = side == n ? a : b;  // counter-clockwise from outside
            p[(axis + 2) % 3] = side == n ? b : a;
            return number(p);
          };
          const auto a = at(i, j);
          const auto b = at(i + 1, j);
          const auto c = at(i + 1, j + 1);
          const auto d = at(i, j + 1);
          if (triangles) {
            input.faces.add_face(std::array{a, b, c});
            input.faces.add_face(std::array{a, c, d});
          } else {
            input.faces.add_face(std::array{a, b, c, d});
          }
        }
      }
    }
  }
  input.faces.vertices = input.points.size();
  return input;
}

const Input& quads() {
  static const Input input = blown_cube(41, false);  // 10,086
  return input;
}
const Input& triangles() {
  static const Input input = blown_cube(29, true);  // 10,092
  return input;
}

/// A number of bytes in /proc/self/status, such as VmHWM, the greatest memory in use since the last reset.
double status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != name + ":") continue;
    double kilobytes = 0;
    status >> kilobytes;
    return 1024 * kilobytes;
  }
  return 0;
}

void mesh_refined(benchmark::State& state, const Input& input, const char* name) {
  const MeshTopology mesh(input.faces);
  const MeshScheme<double> scheme = mesh_scheme<double>(parse_mesh_scheme(name));
  const auto threads = static_cast<int>(state.range(0));
  // The first large pages of a process may take as long as ten refinements.
  benchmark::DoNotOptimize(refine_mesh(mesh, input.points, scheme, levels, threads).points.data());
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  const double before = status_bytes("VmRSS");
  std::size_t faces = 0;
  for (auto _ : state) {
    const IndexedMesh refined = refine_mesh(mesh, input.points, scheme, levels, threads);
    faces = refined.faces();
    benchmark::DoNotOptimize(refined.points.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(faces) * state.iterations());
  state.counters["peak_bytes_a_face"] = (status_bytes("VmHWM") - before) / static_cast<double>(faces);
}

/// Positions on fixed connectivity, prepared once, into memory that is written again and again.
void mesh_positions(benchmark::State& state, const Input& input, const char* name) {
  const MeshRefinement refinement(MeshTopology(input.faces), mesh_scheme<double>(parse_mesh_scheme(name)),
                                  levels);
  std::vector<Point3> out(refinement.vertices());
  for (auto _ : state) {
    refinement.points(input.points, out, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(refinement.faces()) * state.iterations());
  state.SetBytesProcessed(static_cast<std::int64_t>(out.size() * sizeof(Point3)) * state.iterations());
}

/// The memory that positions are written to, written alone.
void mesh_memory(benchmark::State& state) {
  std::vector<Point3> out(quads().faces.faces() << (2 * levels));
  double value = 0;
  for (auto _ : state) {
    std::fill(out.begin(), out.end(), Point3{value, value, value});
    value += 1;
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(out.size()) * state.iterations());
  state.SetBytesProcessed(static_cast<std::int64_t>(out.size() * sizeof(Point3)) * state.iterations());
}

#if defined(SUBDIVLAB_HAS_CGAL) || defined(SUBDIVLAB_HAS_OPENMESH)
using Other = cross::Reference (*)(const PolygonFaces&, const std::vector<Point3>&, int);

void mesh_other(benchmark::State& state, const Input& input, Other other) {
  std::size_t faces = 0;
  for (auto _ : state) {
    const cross::Reference refined = other(input.faces, input.points, levels);
    state.SetIterationTime(refined.seconds);
    faces = refined.faces;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(faces) * state.iterations());
}
#endif

#ifdef SUBDIVLAB_HAS_CGAL
BENCHMARK_CAPTURE(mesh_other, cgal_catmull_clark, quads(), cross::cgal_catmull_clark)->UseManualTime();
BENCHMARK_CAPTURE(mesh_other, cgal_loop, triangles(), cross::cgal_loop)->UseManualTime();
#endif
#ifdef SUBDIVLAB_HAS_OPENMESH
BENCHMARK_CAPTURE(mesh_other, openmesh_catmull_clark, quads(), cross::openmesh_catmull_clark)
    ->UseManualTime();
BENCHMARK_CAPTURE(mesh_other, openmesh_loop, triangles(), cross::openmesh_loop)->UseManualTime();
BENCHMARK_CAPTURE(mesh_other, openmesh_butterfly, triangles(), cross::openmesh_butterfly)->UseManualTime();
#endif
BENCHMARK_CAPTURE(mesh_refined, catmull_clark, quads(), "catmull-clark")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(mesh_refined, jspline, quads(), "jspline-mesh:s=1/2")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(mesh_refined, loop, triangles(), "loop")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(mesh_refined, butterfly, triangles(), "butterfly")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(mesh_positions, catmull_clark, quads(), "catmull-clark")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(mesh_positions, loop, triangles(), "loop")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(mesh_positions, butterfly, triangles(), "butterfly")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(mesh_memory)->UseRealTime();

}  // namespace
}  // namespace subdiv
