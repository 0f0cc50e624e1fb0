#pragma once

#include <cstddef>

#include "schemes/evaluate/block_table.h"

// The inner loops of evaluation by blocks, for the widest vectors of the processor they run on. Every result
// has the same operations in the same order whatever the width of the vectors: products and sums are rounded
// one by one, never fused, so that all instruction sets give the same bits.

namespace subdiv::detail {

/// Values to be copied while others are computed.
template <class T>
struct Copy {
  const T* from = nullptr;
  T* to = nullptr;
  std::size_t count = 0;
};

/// One coordinate of `blocks` consecutive blocks: out[B b + i] = sum over o of T_{o i} points[b + o], o
/// counted from the window's first, 0 <= i < B = table.outputs. Terms of even o are added in their order,
/// those of odd o too, then both sums. Writes whole cache lines: up to table.padding() values behind the last
/// block.
///
/// The copy goes past the caches (non-temporal stores where the platform has them), bit by bit, so that the
/// memory works while the processor computes; before others read it, finish_copies().
void apply_table(const BlockTable<double>& table, const double* points, std::size_t blocks, double* out,
                 const Copy<double>& copy = {});
void apply_table(const BlockTable<float>& table, const float* points, std::size_t blocks, float* out,
                 const Copy<float>& copy = {});

/// The copy alone.
void copy_past_caches(const Copy<double>& copy);
void copy_past_caches(const Copy<float>& copy);
void finish_copies();

/// Partial sums that do not depend on the width of vectors: value i is added to lane i modulo their number.
template <class T>
inline constexpr std::size_t sum_lanes = 4 * line_values<T>;

void add_to_lanes(const double* values, std::size_t count, double* lanes);
void add_to_lanes(const float* values, std::size_t count, float* lanes);

}  // namespace subdiv::detail
