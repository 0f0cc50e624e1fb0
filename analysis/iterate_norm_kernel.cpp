#include "analysis/iterate_norm_kernel.h"

#include <utility>

// Highway compiles this file once for each instruction set and chooses among the results at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/iterate_norm_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace subdiv::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, tile_padding>;
using Lanes = hn::Vec<Tag>;

/// One entry of matrix times vector for as many classes as there are lanes; the length is known to the
/// compiler.
template <std::size_t... j>
HWY_INLINE Lanes row_times_column(Tag tag, const double* HWY_RESTRICT row, const double* HWY_RESTRICT column,
                                  std::size_t stride, std::index_sequence<j...>) {
  Lanes sum = hn::Zero(tag);
  ((sum = hn::MulAdd(hn::Set(tag, row[j]), hn::LoadU(tag, column + j * stride), sum)), ...);
  return sum;
}

template <std::size_t... l>
HWY_INLINE Lanes column_norm(Tag tag, const double* HWY_RESTRICT matrix, const double* HWY_RESTRICT column,
                             std::size_t stride, std::index_sequence<l...> range) {
  Lanes norm = hn::Zero(tag);
  ((norm = hn::Add(norm, hn::Abs(row_times_column(tag, matrix + sizeof...(l) * l, column, stride, range)))),
   ...);
  return norm;
}

template <std::size_t n>
double largest_norm_of_size(const double* HWY_RESTRICT table, std::size_t stride, std::size_t count,
                            const double* HWY_RESTRICT matrix) {
  const Tag tag;
  Lanes best = hn::Zero(tag);
  for (std::size_t r = 0; r < count; r += hn::Lanes(tag)) {
    best = hn::Max(best, column_norm(tag, matrix, table + r, stride, std::make_index_sequence<n>()));
  }
  return hn::GetLane(hn::MaxOfLanes(tag, best));
}

double largest_norm_of_any_size(const double* HWY_RESTRICT table, std::size_t stride, std::size_t count,
                                const double* HWY_RESTRICT matrix, std::size_t n) {
  const Tag tag;
  Lanes best = hn::Zero(tag);
  for (std::size_t r = 0; r < count; r += hn::Lanes(tag)) {
    Lanes norm = hn::Zero(tag);
    for (std::size_t l = 0; l < n; ++l) {
      Lanes sum = hn::Zero(tag);
      for (std::size_t j = 0; j < n; ++j) {
        sum = hn::MulAdd(hn::Set(tag, matrix[n * l + j]), hn::LoadU(tag, table + j * stride + r), sum);
      }
      norm = hn::Add(norm, hn::Abs(sum));
    }
    best = hn::Max(best, norm);
  }
  return hn::GetLane(hn::MaxOfLanes(tag, best));
}

double largest_norm(const double* table, std::size_t stride, std::size_t count, const double* matrix,
                    std::size_t n) {
  switch (n) {
    case 1:
      return largest_norm_of_size<1>(table, stride, count, matrix);
    case 2:
      return largest_norm_of_size<2>(table, stride, count, matrix);
    case 3:
      return largest_norm_of_size<3>(table, stride, count, matrix);
    case 4:
      return largest_norm_of_size<4>(table, stride, count, matrix);
    case 5:
      return largest_norm_of_size<5>(table, stride, count, matrix);
    case 6:
      return largest_norm_of_size<6>(table, stride, count, matrix);
    default:
      return largest_norm_of_any_size(table, stride, count, matrix, n);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace subdiv::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace subdiv::detail {
HWY_EXPORT(largest_norm);

double largest_norm_in_tile(const double* table, std::size_t stride, std::size_t count, const double* matrix,
                            std::size_t n) {
  return HWY_DYNAMIC_DISPATCH(largest_norm)(table, stride, count, matrix, n);
}
}  // namespace subdiv::detail
#endif
