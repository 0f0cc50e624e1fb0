#pragma once

#include <cstddef>

#include "schemes/evaluate/block_table.h"

// The inner loops of evaluation by blocks, for the widest vectors of the processor they run on. Every result
// has the same operations in the same order whatever the width of the vectors: products and sums are rounded
// one by one, never fused, so that all instruction sets give the same bits.

namespace subdiv::detail {

/// One coordinate of `blocks` consecutive blocks: out[outputs b + i] = sum over o of weights[stride o + i]
/// points[b + o], 0 <= o < window, terms added in the order of o. The last block writes up to the end of its
/// stride.
void apply_table(const double* weights, std::size_t stride, std::size_t outputs, std::size_t window,
                 const double* points, std::size_t blocks, double* out);
void apply_table(const float* weights, std::size_t stride, std::size_t outputs, std::size_t window,
                 const float* points, std::size_t blocks, float* out);

/// The same past the caches (non-temporal stores where the platform has them), for outputs = stride and `out`
/// at the begin of a cache line. After the last block, and before others read, finish_stores().
void apply_table_past_caches(const double* weights, std::size_t stride, std::size_t window,
                             const double* points, std::size_t blocks, double* out);
void apply_table_past_caches(const float* weights, std::size_t stride, std::size_t window,
                             const float* points, std::size_t blocks, float* out);
void finish_stores();

/// Copies past the caches where `to` allows; finish_stores() as above.
void copy_past_caches(const double* from, std::size_t count, double* to);
void copy_past_caches(const float* from, std::size_t count, float* to);

/// Partial sums that do not depend on the width of vectors: value i is added to lane i modulo their number.
template <class T>
inline constexpr std::size_t sum_lanes = 4 * line_values<T>;

void add_to_lanes(const double* values, std::size_t count, double* lanes);
void add_to_lanes(const float* values, std::size_t count, float* lanes);

}  // namespace subdiv::detail
