// Evaluation of a curve of J_{3/2} in 3D, 16.8 million points from 1024 control points at depth 14, beside
// the memory it is written to. Items are points. One run gives the ratios:
//   benchmarks --benchmark_filter=ringing

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

#include <Eigen/Core>
#include <benchmark/benchmark.h>

#include "schemes/evaluate/block_kernel.h"
#include "schemes/evaluate/curve_blocks.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"
#include "tests/benchmarks/ring_stepper.h"

namespace subdiv {
namespace {

using testing::RingStepper;
using Point = Eigen::Vector3d;

constexpr std::size_t control_points = 1024;
constexpr int depth = 14;
constexpr double s = 1.5;
constexpr std::size_t points = control_points << depth;
constexpr std::size_t bytes = 3 * sizeof(double) * points;

std::vector<Point> loop() {
  std::vector<Point> result;
  for (std::size_t i = 0; i < control_points; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    result.emplace_back(std::cos(t), std::sin(3 * t), std::sin(t * t));
  }
  return result;
}

Scheme<double> scheme() { return stationary("J", jspline(s)); }

const CoordinateArrays<double>& arrays() {
  static const CoordinateArrays<double> result = [] {
    CoordinateArrays<double> controls{{control_points, true, 0, 0}, std::vector<std::vector<double>>(3)};
    for (const Point& p : loop())
      for (int c = 0; c < 3; ++c) controls.coordinates[static_cast<std::size_t>(c)].push_back(p[c]);
    return controls;
  }();
  return result;
}

const CurveBlocks<double>& curve() {
  static const CurveBlocks<double> result(scheme(), arrays(), depth);
  return result;
}

/// A buffer for the whole curve, reused by all benchmarks, whose pages are there.
std::array<double*, 3> buffer() {
  static AlignedVector<double> memory(3 * points + line_values<double>, 0.0);
  return {memory.data(), memory.data() + points, memory.data() + 2 * points};
}

// ---- What is measured, once through
// -------------------------------------------------------------------------

/// A part of the curve and of the buffer.
struct Part {
  std::size_t first = 0;
  std::size_t last = points;
};

void fill(const Part& part) {
  for (double* const out : buffer()) std::fill(out + part.first, out + part.last, s);
  benchmark::ClobberMemory();
}

/// From a source in the first cache, past the caches.
void fill_past_caches(const Part& part) {
  static const AlignedVector<double> source(512, s);
  for (double* const out : buffer()) {
    for (std::size_t i = part.first; i < part.last; i += source.size())
      detail::copy_past_caches({source.data(), out + i, source.size()});
  }
  detail::finish_copies();
  benchmark::ClobberMemory();
}

void sum_of_appendix() {
  std::vector<RingStepper::Point> controls;
  for (const Point& p : loop()) controls.push_back({p[0], p[1], p[2]});
  RingStepper stepper(controls, s, depth);
  RingStepper::Point sum;
  for (std::size_t i = 0; i < points; ++i) {
    const RingStepper::Point p = stepper.next();
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  }
  benchmark::DoNotOptimize(sum);
}

void sum_of_rings() {
  const ControlPolygon<Point> controls = closed_polygon(loop());
  Ringing<double, Point> rings(scheme(), controls, depth);
  Point sum = Point::Zero();
  for (const Point& p : rings) sum += p;
  benchmark::DoNotOptimize(sum);
}

void level_by_level() {
  benchmark::DoNotOptimize(refine_level_by_level(scheme(), closed_polygon(loop()), depth));
}

void sum_of_blocks(int threads) { benchmark::DoNotOptimize(curve().sum(threads)); }

/// Into arrays that begin `offset` values behind the begin of a cache line.
void write_blocks(const Part& part, int threads, Stores stores = Stores::past_caches,
                  std::size_t offset = 0) {
  std::array<double*, 3> out = buffer();
  for (double*& p : out) p += part.first + offset;
  curve().write(part.first, part.last, out, {threads, stores});
  benchmark::ClobberMemory();
}

void write_interleaved_blocks(int threads) {
  curve().write_interleaved(0, points, buffer()[0], threads);
  benchmark::ClobberMemory();
}

// ---- Each alone
// -----------------------------------------------------------------------------------------------

template <class Work>
void measure(benchmark::State& state, const Work& work) {
  work();
  for (auto unused : state) work();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

void ringing_fill(benchmark::State& state) {
  measure(state, [] { fill(Part()); });
}
void ringing_fill_past_caches(benchmark::State& state) {
  measure(state, [] { fill_past_caches(Part()); });
}
void ringing_appendix_summed(benchmark::State& state) { measure(state, sum_of_appendix); }
void ringing_rings_summed(benchmark::State& state) { measure(state, sum_of_rings); }
void ringing_level_by_level(benchmark::State& state) { measure(state, level_by_level); }
void ringing_blocks_summed(benchmark::State& state) {
  measure(state, [&] { sum_of_blocks(static_cast<int>(state.range(0))); });
  state.counters["stream_bytes"] = static_cast<double>(curve().stream_bytes());
  state.counters["table_bytes"] = static_cast<double>(curve().stages().bytes());
}
void ringing_blocks_written(benchmark::State& state) {
  measure(state, [&] { write_blocks(Part(), static_cast<int>(state.range(0))); });
}
void ringing_blocks_written_in_caches(benchmark::State& state) {
  measure(state, [&] { write_blocks(Part(), static_cast<int>(state.range(0)), Stores::cached); });
}
void ringing_blocks_interleaved(benchmark::State& state) {
  measure(state, [&] { write_interleaved_blocks(static_cast<int>(state.range(0))); });
}

/// Three points at a depth that no memory would hold, and many points at a small one.
void measure_streaming(benchmark::State& state, std::size_t controls, int steps) {
  CoordinateArrays<double> polygon{{controls, true, 0, 0}, std::vector<std::vector<double>>(3)};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < controls; ++i)
      polygon.coordinates[c].push_back(arrays().coordinates[c][i % control_points]);
  const CurveBlocks<double> streamed(scheme(), polygon, steps);
  for (auto unused : state) benchmark::DoNotOptimize(streamed.sum());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(streamed.size()));
  state.counters["stream_bytes"] = static_cast<double>(streamed.stream_bytes());
  state.counters["table_bytes"] = static_cast<double>(streamed.stages().bytes());
}
void ringing_three_points_at_depth_28(benchmark::State& state) { measure_streaming(state, 3, 28); }
void ringing_ten_million_points_at_depth_3(benchmark::State& state) {
  measure_streaming(state, 10'000'000, 3);
}

// ---- Side by side

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// How many times as long `slow` takes as `fast`, in turns of one part after the other, so that both meet the
/// same machine: the median of the turns. The clock counts this process alone, or the time that passes.
template <class Slow, class Fast>
void compare(benchmark::State& state, double (*clock)(), int parts, const Slow& slow, const Fast& fast) {
  constexpr std::size_t turns = 5;
  const std::size_t size = points / static_cast<std::size_t>(parts);
  std::vector<double> ratios;
  for (auto unused : state) {
    for (std::size_t turn = 0; turn <= turns; ++turn) {
      double slow_time = 0;
      double fast_time = 0;
      for (std::size_t first = 0; first < points; first += size) {
        const Part part{first, first + size};
        const double begin = clock();
        slow(part);
        const double middle = clock();
        fast(part);
        slow_time += middle - begin;
        fast_time += clock() - middle;
      }
      if (turn > 0) ratios.push_back(slow_time / fast_time);  // the first one touches everything
    }
  }
  std::sort(ratios.begin(), ratios.end());
  state.counters["ratio"] = ratios[turns / 2];
}

void ringing_ratio_summed_to_appendix(benchmark::State& state) {
  compare(
      state, processor_time, 1, [](const Part&) { sum_of_appendix(); },
      [](const Part&) { sum_of_blocks(1); });
}
void ringing_ratio_rings_to_appendix(benchmark::State& state) {
  compare(
      state, processor_time, 1, [](const Part&) { sum_of_appendix(); }, [](const Part&) { sum_of_rings(); });
}
void ringing_ratio_written_to_level_by_level(benchmark::State& state) {
  compare(
      state, processor_time, 1, [](const Part&) { level_by_level(); },
      [](const Part& p) { write_blocks(p, 1); });
}
constexpr int memory_parts = 64;
void ringing_ratio_written_to_bandwidth(benchmark::State& state) {
  compare(state, processor_time, memory_parts, fill_past_caches, [](const Part& p) { write_blocks(p, 1); });
}
void ringing_ratio_written_to_cached_bandwidth(benchmark::State& state) {
  compare(state, processor_time, memory_parts, fill, [](const Part& p) { write_blocks(p, 1); });
}
void ringing_ratio_written_off_lines_to_bandwidth(benchmark::State& state) {
  compare(state, processor_time, memory_parts, fill_past_caches,
          [](const Part& p) { write_blocks(p, 1, Stores::past_caches, 2); });
}
void ringing_ratio_two_threads_summed(benchmark::State& state) {
  compare(state, wall_time, 1, [](const Part&) { sum_of_blocks(1); }, [](const Part&) { sum_of_blocks(2); });
}
void ringing_ratio_two_threads_written(benchmark::State& state) {
  compare(
      state, wall_time, 1, [](const Part& p) { write_blocks(p, 1); },
      [](const Part& p) { write_blocks(p, 2); });
}

void alone(benchmark::internal::Benchmark* b) { b->Unit(benchmark::kMillisecond)->UseRealTime(); }
void on_threads(benchmark::internal::Benchmark* b) {
  alone(b);
  b->ArgName("threads")->Arg(1)->Arg(2);
}
void side_by_side(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);
}

BENCHMARK(ringing_fill)->Apply(alone);
BENCHMARK(ringing_fill_past_caches)->Apply(alone);
BENCHMARK(ringing_appendix_summed)->Apply(alone);
BENCHMARK(ringing_rings_summed)->Apply(alone);
BENCHMARK(ringing_level_by_level)->Apply(alone);
BENCHMARK(ringing_blocks_summed)->Apply(on_threads);
BENCHMARK(ringing_blocks_written)->Apply(on_threads);
BENCHMARK(ringing_blocks_written_in_caches)->Apply(on_threads);
BENCHMARK(ringing_blocks_interleaved)->Apply(on_threads);
BENCHMARK(ringing_three_points_at_depth_28)->Apply(alone);
BENCHMARK(ringing_ten_million_points_at_depth_3)->Apply(alone);
BENCHMARK(ringing_ratio_summed_to_appendix)->Apply(side_by_side);
BENCHMARK(ringing_ratio_rings_to_appendix)->Apply(side_by_side);
BENCHMARK(ringing_ratio_written_to_bandwidth)->Apply(side_by_side);
BENCHMARK(ringing_ratio_written_to_cached_bandwidth)->Apply(side_by_side);
BENCHMARK(ringing_ratio_written_off_lines_to_bandwidth)->Apply(side_by_side);
BENCHMARK(ringing_ratio_written_to_level_by_level)->Apply(side_by_side);
BENCHMARK(ringing_ratio_two_threads_summed)->Apply(side_by_side);
BENCHMARK(ringing_ratio_two_threads_written)->Apply(side_by_side);

}  // namespace
}  // namespace subdiv
