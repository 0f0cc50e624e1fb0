#pragma once

#include <cstddef>

namespace subdiv::detail {

/// Tables of class vectors are padded with zeros to a multiple of this many classes.
inline constexpr std::size_t tile_padding = 32;

/// max over 0 <= r < count of sum over l of |sum over j of matrix[n l + j] table[j stride + r]|, in double
/// arithmetic: each inner sum has n products, in any order, fused or not. count is a multiple of
/// tile_padding. Uses the widest vectors of the processor it runs on.
[[nodiscard]] double largest_norm_in_tile(const double* table, std::size_t stride, std::size_t count,
                                          const double* matrix, std::size_t n);

}  // namespace subdiv::detail
