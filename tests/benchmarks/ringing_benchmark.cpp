// Evaluation of a curve of J_{3/2} in 3D, 16.8 million points from 1024 control points at depth 14, beside
// the memory it is written to. Items are points. One run gives the ratios:
//   benchmarks --benchmark_filter=ringing

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
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
  static AlignedVector<double> memory(3 * points, 0.0);
  return {memory.data(), memory.data() + points, memory.data() + 2 * points};
}

// ---- What is measured, once through
// -------------------------------------------------------------------------

void fill() {
  for (double* const out : buffer()) std::fill_n(out, points, s);
  benchmark::ClobberMemory();
}

/// From a source in the first cache, past the caches.
void fill_past_caches() {
  static const AlignedVector<double> source(512, s);
  for (double* const out : buffer()) {
    for (std::size_t i = 0; i < points; i += source.size())
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

void write_blocks(int threads, Stores stores = Stores::past_caches) {
  const std::array<double*, 3> out = buffer();
  curve().write(out, {threads, stores});
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

void ringing_fill(benchmark::State& state) { measure(state, fill); }
void ringing_fill_past_caches(benchmark::State& state) { measure(state, fill_past_caches); }
void ringing_appendix_summed(benchmark::State& state) { measure(state, sum_of_appendix); }
void ringing_rings_summed(benchmark::State& state) { measure(state, sum_of_rings); }
void ringing_level_by_level(benchmark::State& state) { measure(state, level_by_level); }
void ringing_blocks_summed(benchmark::State& state) {
  measure(state, [&] { sum_of_blocks(static_cast<int>(state.range(0))); });
}
void ringing_blocks_written(benchmark::State& state) {
  measure(state, [&] { write_blocks(static_cast<int>(state.range(0))); });
}
void ringing_blocks_written_cached(benchmark::State& state) {
  measure(state, [&] { write_blocks(static_cast<int>(state.range(0)), Stores::cached); });
}
void ringing_blocks_interleaved(benchmark::State& state) {
  measure(state, [&] { write_interleaved_blocks(static_cast<int>(state.range(0))); });
}

// ---- Side by side
// ---------------------------------------------------------------------------------------------

template <class Work>
double seconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// How many times as long `slow` takes as `fast`, in turns, so that both meet the same machine. The best time
/// of each counts.
template <class Slow, class Fast>
void compare(benchmark::State& state, const Slow& slow, const Fast& fast) {
  constexpr int turns = 7;
  fast();
  double best_slow = 0;
  double best_fast = 0;
  for (auto unused : state) {
    for (int turn = 0; turn < turns; ++turn) {
      const double slow_time = seconds(slow);
      const double fast_time = seconds(fast);
      best_slow = best_slow == 0 ? slow_time : std::min(best_slow, slow_time);
      best_fast = best_fast == 0 ? fast_time : std::min(best_fast, fast_time);
    }
  }
  state.counters["ratio"] = best_slow / best_fast;
}

void ringing_ratio_summed_to_appendix(benchmark::State& state) {
  compare(state, sum_of_appendix, [] { sum_of_blocks(1); });
}
void ringing_ratio_rings_to_appendix(benchmark::State& state) {
  compare(state, sum_of_appendix, sum_of_rings);
}
void ringing_ratio_written_to_bandwidth(benchmark::State& state) {
  const bool past = seconds(fill_past_caches) < seconds(fill);
  compare(state, past ? fill_past_caches : fill, [] { write_blocks(1); });
}
void ringing_ratio_written_to_level_by_level(benchmark::State& state) {
  compare(state, level_by_level, [] { write_blocks(1); });
}
void ringing_ratio_two_threads_summed(benchmark::State& state) {
  compare(state, [] { sum_of_blocks(1); }, [] { sum_of_blocks(2); });
}
void ringing_ratio_two_threads_written(benchmark::State& state) {
  compare(state, [] { write_blocks(1); }, [] { write_blocks(2); });
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
BENCHMARK(ringing_blocks_written_cached)->Apply(on_threads);
BENCHMARK(ringing_blocks_interleaved)->Apply(on_threads);
BENCHMARK(ringing_ratio_summed_to_appendix)->Apply(side_by_side);
BENCHMARK(ringing_ratio_rings_to_appendix)->Apply(side_by_side);
BENCHMARK(ringing_ratio_written_to_bandwidth)->Apply(side_by_side);
BENCHMARK(ringing_ratio_written_to_level_by_level)->Apply(side_by_side);
BENCHMARK(ringing_ratio_two_threads_summed)->Apply(side_by_side);
BENCHMARK(ringing_ratio_two_threads_written)->Apply(side_by_side);

}  // namespace
}  // namespace subdiv
