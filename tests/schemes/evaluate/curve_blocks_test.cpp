#include "schemes/evaluate/curve_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "schemes/evaluate/ringing.h"
#include "tests/schemes/evaluate/sample_schemes.h"

namespace subdiv {
namespace {

using testing::binary_and_ternary_schemes;
using testing::j;
using testing::powers;
using testing::q;
using testing::Rationals;

template <class T>
CoordinateArrays<T> one_coordinate(const ControlPolygon<Rational>& controls) {
  CoordinateArrays<T> arrays{controls.topology, {{}}};
  for (const Rational& x : controls.points) arrays.coordinates[0].push_back(static_cast<T>(x.to_double()));
  return arrays;
}

/// Points without pattern in [-1, 1].
template <class T>
CoordinateArrays<T> scattered(const Topology& topology, std::size_t dimension) {
  std::mt19937 numbers(7);
  std::uniform_real_distribution<T> distribution(-1, 1);
  CoordinateArrays<T> arrays{topology, std::vector<std::vector<T>>(dimension)};
  for (std::vector<T>& values : arrays.coordinates)
    for (std::size_t i = 0; i < topology.points; ++i) values.push_back(distribution(numbers));
  return arrays;
}

template <class T>
using Arrays = std::vector<AlignedVector<T>>;

/// What the blocks of a stream hold, put together.
template <class T>
Arrays<T> streamed(const CurveBlocks<T>& curve, std::size_t first, std::size_t last) {
  Arrays<T> result(curve.dimension());
  std::size_t next = first;
  curve.for_each_block(first, last, [&](const CurveBlock<T>& block) {
    EXPECT_EQ(block.first, next);
    EXPECT_EQ(block.coordinates.size(), curve.dimension());
    for (std::size_t c = 0; c < block.coordinates.size(); ++c)
      result[c].insert(result[c].end(), block.coordinates[c], block.coordinates[c] + block.count);
    next += block.count;
  });
  EXPECT_EQ(next, last);
  return result;
}

template <class T>
Arrays<T> streamed(const CurveBlocks<T>& curve) {
  return streamed(curve, 0, curve.size());
}

template <class T>
Arrays<T> part(const Arrays<T>& all, std::size_t first, std::size_t last) {
  Arrays<T> result;
  for (const AlignedVector<T>& values : all) {
    result.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(first),
                        values.begin() + static_cast<std::ptrdiff_t>(last));
  }
  return result;
}

/// First-order bound of the rounding errors: one of the weights, of each product and of each sum a stage, and
/// what stages make of earlier errors.
template <class T>
T error_bound(const BlockStages<T>& stages, T largest_point) {
  T bound = largest_point;
  T roundings = 1;  // that of the control points, or of the exact result
  for (const BlockTable<T>& table : stages.tables) {
    T norm = 0;
    for (std::size_t i = 0; i < table.outputs; ++i) {
      T sum = 0;
      for (int o = table.window.first; o <= table.window.last; ++o)
        sum += std::abs(table.weights[table.place(o, i)]);
      norm = std::max(norm, sum);
    }
    bound *= norm;
    roundings += static_cast<T>(table.window.size() + 2);
  }
  return roundings * std::numeric_limits<T>::epsilon() / 2 * bound;
}

template <class T>
void expect_near_exact(const Scheme<Rational>& scheme, const ControlPolygon<Rational>& controls, int depth) {
  const CoordinateArrays<T> arrays = one_coordinate<T>(controls);
  const CurveBlocks<T> curve(scheme, arrays, depth);
  const Arrays<T> points = streamed(curve);
  const T bound = error_bound(curve.stages(), arrays.coordinates[0].back());  // of 2^i the last is largest
  Ringing<Rational, Rational> rings(scheme, controls, depth);
  for (const T point : points[0]) {
    ASSERT_FALSE(rings.done());
    ASSERT_NEAR(point, static_cast<T>(rings.point().to_double()), bound)
        << scheme.name << ", " << controls.points.size() << " points, depth " << depth;
    rings.advance();
  }
  EXPECT_TRUE(rings.done());
}

int largest_depth(const Scheme<Rational>& scheme) { return scheme.arity() == 2 ? 9 : 6; }

TEST(CurveBlocks, ClosedCurvesFollowTheExactRings) {
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    for (const int n : {1, 2, 3, 7}) {
      for (int depth = 0; depth <= largest_depth(scheme); ++depth) {
        expect_near_exact<double>(scheme, closed_polygon(powers(n)), depth);
        expect_near_exact<float>(scheme, closed_polygon(powers(n)), depth);
      }
    }
  }
}

TEST(CurveBlocks, OpenCurvesFollowTheExactRings) {
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    const IndexWindow window = ring_window(scheme);
    const auto before = static_cast<std::size_t>(-window.first);
    const auto after = static_cast<std::size_t>(window.last);
    for (const std::size_t spans : {0U, 1U, 4U}) {
      const auto controls = open_polygon(powers(static_cast<int>(before + after + spans + 1)), before, after);
      for (int depth = 0; depth <= largest_depth(scheme); ++depth)
        expect_near_exact<double>(scheme, controls, depth);
    }
  }
}

TEST(CurveBlocks, AnyNumberOfCoordinates) {
  for (const std::size_t dimension : {0U, 1U, 2U, 5U, 17U}) {
    const auto arrays = scattered<double>({11, true, 0, 0}, dimension);
    const Arrays<double> points = streamed(CurveBlocks<double>(j(q(3, 2)), arrays, 8));
    for (std::size_t c = 0; c < dimension; ++c) {
      const CoordinateArrays<double> one{arrays.topology, {arrays.coordinates[c]}};
      EXPECT_EQ(streamed(CurveBlocks<double>(j(q(3, 2)), one, 8))[0], points[c]);
    }
  }
}

TEST(CurveBlocks, BeginsAndEndsAnywhereWithTheSameBits) {
  std::mt19937 numbers(1);
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    for (const int depth : {0, 1, 3, 7, 9}) {
      const auto arrays = scattered<double>({23, true, 0, 0}, 2);
      const CurveBlocks<double> curve(scheme, arrays, depth);
      const Arrays<double> all = streamed(curve);
      for (int trial = 0; trial < 12; ++trial) {
        std::array<std::size_t, 2> ends{numbers() % (curve.size() + 1), numbers() % (curve.size() + 1)};
        if (trial == 0) ends = {curve.size(), curve.size()};
        std::sort(ends.begin(), ends.end());
        EXPECT_EQ(streamed(curve, ends[0], ends[1]), part(all, ends[0], ends[1])) << scheme.name << depth;
      }
    }
  }
}

/// Several chunks, on several threads, into memory that begins at a cache line or does not.
template <class T>
void expect_same_bits_written(const Scheme<Rational>& scheme, std::size_t points, int depth) {
  const auto arrays = scattered<T>({points, true, 0, 0}, 3);
  const CurveBlocks<T> curve(scheme, arrays, depth);
  const Arrays<T> all = streamed(curve);
  constexpr T untouched = 1000;
  for (const std::size_t offset : {0U, 1U, 5U}) {
    for (const int threads : {1, 2, 5}) {
      for (const Stores stores : {Stores::chosen, Stores::cached, Stores::past_caches}) {
        for (const std::size_t first : {std::size_t{0}, std::size_t{1000}, curve.size() / 2 + 3}) {
          const std::size_t last = curve.size() - first / 7;
          Arrays<T> written(3, AlignedVector<T>(offset + last - first + 2, untouched));
          std::array<T*, 3> out{};
          for (std::size_t c = 0; c < 3; ++c) out[c] = written[c].data() + offset;
          curve.write(first, last, out, {threads, stores});
          EXPECT_EQ(part(written, offset, offset + last - first), part(all, first, last));
          for (const auto& values : written) {
            EXPECT_TRUE(std::all_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(offset),
                                    [](T x) { return x == untouched; }));
            EXPECT_TRUE(std::all_of(values.end() - 2, values.end(), [](T x) { return x == untouched; }));
          }
        }
      }
    }
  }
}

TEST(CurveBlocks, WritesTheSameBitsOnAnyNumberOfThreads) {
  expect_same_bits_written<double>(j(q(3, 2)), 300, 10);
  expect_same_bits_written<float>(j(q(3, 2)), 300, 10);
  expect_same_bits_written<double>(binary_and_ternary_schemes().back(), 300, 6);
  expect_same_bits_written<double>(stationary("B9", bspline<Rational>(9)), 100'000, 1);
  expect_same_bits_written<float>(stationary("B0", bspline<Rational>(0)), 100'000, 2);
}

TEST(CurveBlocks, WritesInterleaved) {
  for (const std::size_t dimension : {1U, 2U, 3U, 4U}) {
    const auto arrays = scattered<double>({40, true, 0, 0}, dimension);
    const CurveBlocks<double> curve(j(q(1, 2)), arrays, 13);
    const Arrays<double> all = streamed(curve);
    constexpr std::size_t first = 77;
    for (const int threads : {1, 3}) {
      std::vector<double> points((curve.size() - first) * dimension);
      curve.write_interleaved(first, curve.size(), points.data(), threads);
      for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_EQ(points[i], all[i % dimension][first + i / dimension]);
    }
  }
}

TEST(CurveBlocks, SumsTheSameBitsOnAnyNumberOfThreads) {
  for (const auto& [scheme, points, depth] :
       {std::tuple{j(q(3, 2)), 300U, 11}, std::tuple{binary_and_ternary_schemes().back(), 900U, 6},
        std::tuple{j(q(1)), 5U, 2}}) {
    const auto arrays = scattered<double>({points, true, 0, 0}, 3);
    const CurveBlocks<double> curve(scheme, arrays, depth);
    const Arrays<double> all = streamed(curve);
    const std::vector<double> sum = curve.sum();
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(sum[c], std::accumulate(all[c].begin(), all[c].end(), 0.0),
                  1e-10 * static_cast<double>(curve.size()));
    }
    for (const int threads : {2, 3, 8}) EXPECT_EQ(curve.sum(threads), sum);
  }
}

TEST(CurveBlocks, SumsOfMeansAreKnown) {  // a primal step doubles the sum: each rule's columns add up to 2
  const CoordinateArrays<float> arrays{{4, true, 0, 0}, {{1, 2, 4, 8}, {1, 1, 1, 1}}};
  const CurveBlocks<float> curve(j(q(1)), arrays, 4);
  EXPECT_EQ(curve.sum(), (std::vector<double>{15 * 16, 4 * 16}));
}

/// Sends the dispatch to one instruction set, and back.
class Target {
 public:
  explicit Target(std::int64_t target) { hwy::GetChosenTarget().Update(target); }
  ~Target() { hwy::GetChosenTarget().DeInit(); }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
};

template <class T>
void expect_same_bits_on_all_targets(const Scheme<Rational>& scheme, int depth) {
  const auto arrays = scattered<T>({31, true, 0, 0}, 3);
  const CurveBlocks<T> curve(scheme, arrays, depth);
  const Arrays<T> all = streamed(curve);
  const std::vector<double> sum = curve.sum();
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const Target chosen(target);
    EXPECT_EQ(streamed(curve), all) << hwy::TargetName(target);
    EXPECT_EQ(curve.sum(), sum) << hwy::TargetName(target);
    for (const std::size_t offset : {0U, 3U}) {
      Arrays<T> written(3, AlignedVector<T>(offset + curve.size()));
      std::array<T*, 3> out{};
      for (std::size_t c = 0; c < 3; ++c) out[c] = written[c].data() + offset;
      curve.write(out, {1, Stores::past_caches});
      EXPECT_EQ(part(written, offset, offset + curve.size()), all) << hwy::TargetName(target);
    }
  }
}

TEST(CurveBlocks, SameBitsOnEveryInstructionSet) {
  EXPECT_GE(hwy::SupportedAndGeneratedTargets().size(), 1U);
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    for (const int depth : {1, 3, 8}) {
      expect_same_bits_on_all_targets<double>(scheme, depth);
      expect_same_bits_on_all_targets<float>(scheme, depth);
    }
  }
}

TEST(CurveBlocks,
     StreamsInConstantMemory) {  // by construction: all memory is counted, none depends on points
  const auto three = scattered<double>({3, true, 0, 0}, 3);
  const auto many = scattered<double>({100'000, true, 0, 0}, 3);
  EXPECT_EQ(CurveBlocks<double>(j(q(1)), three, 14).stream_bytes(),
            CurveBlocks<double>(j(q(1)), many, 14).stream_bytes());
  EXPECT_LT(CurveBlocks<double>(j(q(1)), three, 28).stream_bytes(), 100'000U);
  EXPECT_LT(CurveBlocks<double>(j(q(1)), three, 58).stream_bytes(), 200'000U);
}

TEST(CurveBlocks, ThreePointsAtDepth28) {  // 805 million points: parts of them, as Ringing gives them
  const ControlPolygon<double> triangle = closed_polygon(std::vector<double>{1, -2, 7});
  const CoordinateArrays<double> arrays{triangle.topology, {triangle.points}};
  const CurveBlocks<double> curve(j(q(3, 2)), arrays, 28);
  EXPECT_EQ(curve.size(), std::size_t{3} << 28U);
  constexpr std::size_t count = 3000;
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    Ringing<double, double> rings(stationary("J", jspline(1.5)), triangle, 28,
                                  static_cast<long long>(vertex));
    const Arrays<double> points = streamed(curve, vertex << 28U, (vertex << 28U) + count);
    for (const double point : points[0]) {
      EXPECT_NEAR(point, rings.point(), 28 * 6 * 7 * 0x1p-52);
      rings.advance();
    }
  }
  EXPECT_EQ(streamed(curve, curve.size() - count, curve.size())[0].size(), count);
}

TEST(CurveBlocks, RefusesMorePointsThanCanBeCounted) {
  const CoordinateArrays<double> arrays{{3, true, 0, 0}, {{1, 2, 3}}};
  EXPECT_NO_THROW(CurveBlocks<double>(j(q(1)), arrays, 60));
  EXPECT_THROW(CurveBlocks<double>(j(q(1)), arrays, 61), std::overflow_error);
  EXPECT_THROW(CurveBlocks<double>(j(q(1)), arrays, -1), std::invalid_argument);
}

TEST(CurveBlocks, LongPolygonsAtSmallDepth) {
  constexpr std::size_t n = 100'000;
  const auto arrays = scattered<double>({n, true, 0, 0}, 1);
  const CurveBlocks<double> curve(stationary("J", jspline(1.5)), arrays, 3);
  const Arrays<double> points = streamed(curve);
  const auto controls = closed_polygon(arrays.coordinates[0]);
  Ringing<double, double> rings(stationary("J", jspline(1.5)), controls, 3);
  for (const double point : points[0]) {
    ASSERT_NEAR(point, rings.point(), 32 * 0x1p-52);
    rings.advance();
  }
}

TEST(CurveBlocks, RefusesWhatDoesNotFit) {
  const CoordinateArrays<double> uneven{{3, true, 0, 0}, {{1, 2, 3}, {1, 2}}};
  EXPECT_THROW(CurveBlocks<double>(j(q(1)), uneven, 3), std::invalid_argument);
  const CoordinateArrays<double> open{{6, false, 1, 1}, {{1, 2, 3, 4, 5, 6}}};
  EXPECT_THROW(CurveBlocks<double>(j(q(1, 2)), open, 3), std::out_of_range);
  EXPECT_NO_THROW(CurveBlocks<double>(j(q(1)), open, 3));  // the cubic B-spline needs no more
  const CoordinateArrays<double> closed{{3, true, 0, 0}, {{1, 2, 3}}};
  const CurveBlocks<double> curve(j(q(1)), closed, 3);
  EXPECT_THROW((void)curve.stream(0, 25), std::out_of_range);
  EXPECT_THROW((void)curve.stream(3, 2), std::out_of_range);
  EXPECT_THROW(curve.write({}), std::invalid_argument);
}

TEST(CurveBlocks, NothingOfAnEmptyPolygon) {
  const CoordinateArrays<double> empty{{0, true, 0, 0}, {{}, {}}};
  const CurveBlocks<double> curve(j(q(1)), empty, 9);
  EXPECT_EQ(curve.size(), 0U);
  EXPECT_EQ(curve.stream().next().count, 0U);
  EXPECT_EQ(curve.sum(3), (std::vector<double>{0, 0}));
}

TEST(CurveBlocks, WhatIsNotFiniteSpoilsTheBlocksInReachAlone) {
  constexpr std::size_t n = 40;
  constexpr long long spoiled = 20;
  for (const Scheme<Rational>& scheme : binary_and_ternary_schemes()) {
    for (const int depth : {0, 2, 8}) {
      for (const double value :
           {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        auto arrays = scattered<double>({n, true, 0, 0}, 1);
        const Arrays<double> before = streamed(CurveBlocks<double>(scheme, arrays, depth));
        arrays.coordinates[0][spoiled] = value;
        const CurveBlocks<double> curve(scheme, arrays, depth);
        const Arrays<double> after = streamed(curve);
        const std::size_t spacing = curve.size() / n;
        const Laurent<Rational> symbol = iterated_symbol(scheme, depth);
        const IndexWindow reach = curve.reach();
        for (std::size_t i = 0; i < curve.size(); ++i) {
          const auto t = static_cast<long long>(i / spacing);
          const bool in_reach = t + reach.first <= spoiled && spoiled <= t + reach.last;
          if (!in_reach) {
            ASSERT_EQ(before[0][i], after[0][i]) << scheme.name;
          }
          const long long power = static_cast<long long>(i) - spoiled * static_cast<long long>(spacing);
          if (!is_zero(symbol[static_cast<int>(power)])) {
            ASSERT_TRUE(in_reach);
            ASSERT_FALSE(std::isfinite(after[0][i])) << scheme.name;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace subdiv
