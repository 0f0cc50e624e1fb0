#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "schemes/evaluate/aligned_vector.h"
#include "schemes/evaluate/control_polygon.h"
#include "schemes/index_window.h"
#include "schemes/mask.h"

namespace subdiv {

/// Values of type T in a cache line.
template <class T>
inline constexpr std::size_t line_values = cache_line / sizeof(T);

/// Some steps of a scheme at once, d of arity m: one rule of arity B = m^d,
///
///   P'_{B q + i} = sum over o in the window of T_{o i} P_{q + o},   0 <= i < B,
///
/// T_{o i} = S_{i - B o}, S the symbol of those steps. Six points a block for J_s, whatever d >= 2.
template <class T>
struct BlockTable {
  std::size_t outputs = 1;  ///< B
  IndexWindow window;       ///< o
  IndexWindow support;      ///< powers of S: P'_n depends on P_j only if n - B j lies here
  /// T_{o i} cache line by cache line of outputs, the last one padded by zeros; within a line by o, then by
  /// i.
  AlignedVector<T> weights;

  [[nodiscard]] std::size_t lines() const { return (outputs + line_values<T> - 1) / line_values<T>; }
  [[nodiscard]] std::size_t padding() const { return lines() * line_values<T> - outputs; }
  /// Where T_{o i} stands.
  [[nodiscard]] std::size_t place(int o, std::size_t i) const {
    const auto row = i / line_values<T> * static_cast<std::size_t>(window.size()) +
                     static_cast<std::size_t>(o - window.first);
    return row * line_values<T> + i % line_values<T>;
  }
  [[nodiscard]] std::size_t bytes() const { return weights.size() * sizeof(T); }
};

namespace detail {
inline double rounded(double x) { return x; }
inline double rounded(float x) { return x; }
template <class R>
double rounded(const R& x) {
  return x.to_double();
}
}  // namespace detail

/// Steps step .. step + count - 1 of a scheme as a table. It is computed in R and rounded once (by way of
/// double): over the rationals every entry is the nearest double.
template <class T, class R>
BlockTable<T> block_table(const Scheme<R>& scheme, int step, int count) {
  Scheme<R> steps{scheme.name, {}};
  for (int k = step; k < step + count; ++k) steps.steps.push_back(scheme.step(static_cast<std::size_t>(k)));
  const Laurent<R> symbol = iterated_symbol(steps, count);
  BlockTable<T> table;
  table.outputs = refined_spacing(scheme.arity(), count);
  table.support = {symbol.first(), symbol.last()};
  const int B = static_cast<int>(table.outputs);
  if (symbol.is_zero()) {
    table.window = {0, 0};
  } else {
    table.window = {-floor_divide(symbol.last(), B), floor_divide(B - 1 - symbol.first(), B)};
  }
  table.weights.assign(table.lines() * static_cast<std::size_t>(table.window.size()) * line_values<T>, T(0));
  for (int n = symbol.first(); n <= symbol.last(); ++n) {
    const int i = residue(n, B);
    table.weights[table.place((i - n) / B, static_cast<std::size_t>(i))] =
        static_cast<T>(detail::rounded(symbol[n]));
  }
  return table;
}

/// All steps down to a depth as tables, each applied to the points of the one before.
template <class T>
struct BlockStages {
  int arity = 2;                      ///< m
  int depth = 0;                      ///< all steps together
  std::vector<BlockTable<T>> tables;  ///< at least one: no step at all is the table 1

  /// The footprint of the tables.
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const BlockTable<T>& table : tables) sum += table.bytes();
    return sum;
  }
};

/// The last table makes nearly all points: it is to fit the fastest cache beside its points (2^6 x 6 doubles
/// for J_s: 3 KiB). Those before it may be larger.
inline constexpr std::size_t last_table_outputs = 64;
/// Of the tables before the last one.
inline constexpr std::size_t inner_table_outputs = 256;

/// Throws std::invalid_argument for a negative depth, std::overflow_error when arity^depth is beyond 2^62.
template <class T, class R>
BlockStages<T> block_stages(const Scheme<R>& scheme, int depth) {
  if (depth < 0) throw std::invalid_argument("a refinement depth is at least 0");
  (void)refined_spacing(scheme.arity(), depth);
  std::vector<int> counts;
  for (int left = depth; left > 0 || counts.empty(); left -= counts.back()) {
    const std::size_t most = counts.empty() ? last_table_outputs : inner_table_outputs;
    int count = std::min(left, 1);
    while (count < left && refined_spacing(scheme.arity(), count + 1) <= most) ++count;
    counts.push_back(count);
  }
  BlockStages<T> stages{scheme.arity(), depth, {}};
  int step = 0;
  for (auto count = counts.rbegin(); count != counts.rend(); step += *count++)
    stages.tables.push_back(block_table<T>(scheme, step, *count));
  return stages;
}

}  // namespace subdiv
