#include "schemes/evaluate/block_kernel.h"

#include <cstdint>
#include <utility>

// Highway compiles this file once for each instruction set and chooses among the results at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "schemes/evaluate/block_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Highway's own order: its stores past the caches come after the target is chosen.
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace subdiv::detail {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Tag = hn::CappedTag<T, line_values<T>>;

/// Where results go.
template <class T>
struct Cached {
  template <class Lanes>
  HWY_INLINE void operator()(Lanes values, T* out) const {
    hn::StoreU(values, Tag<T>(), out);
  }
};
template <class T>
struct PastCaches {
  template <class Lanes>
  HWY_INLINE void operator()(Lanes values, T* out) const {
    hn::Stream(values, Tag<T>(), out);
  }
};

/// One block: the points of its window are kept in registers. Mul and Add, not MulAdd: see the header.
template <class Store, class T, class First, class... Rest>
HWY_INLINE void block(Store store, const T* HWY_RESTRICT weights, std::size_t stride, T* HWY_RESTRICT out,
                      First first, Rest... rest) {
  const Tag<T> tag;
  for (std::size_t i = 0; i < stride; i += hn::Lanes(tag)) {
    const T* HWY_RESTRICT row = weights + i;
    auto sum = hn::Mul(hn::Load(tag, row), first);
    ((row += stride, sum = hn::Add(sum, hn::Mul(hn::Load(tag, row), rest))), ...);
    store(sum, out + i);
  }
}

template <class Store, class T, std::size_t... o>
void blocks_of_window(Store store, const T* HWY_RESTRICT weights, std::size_t stride, std::size_t outputs,
                      const T* HWY_RESTRICT points, std::size_t blocks, T* HWY_RESTRICT out,
                      std::index_sequence<o...> /*window*/) {
  const Tag<T> tag;
  for (std::size_t b = 0; b < blocks; ++b)
    block(store, weights, stride, out + b * outputs, hn::Set(tag, points[b + o])...);
}

template <class Store, class T>
void blocks_of_any_window(Store store, const T* HWY_RESTRICT weights, std::size_t stride, std::size_t outputs,
                          std::size_t window, const T* HWY_RESTRICT points, std::size_t blocks,
                          T* HWY_RESTRICT out) {
  const Tag<T> tag;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t i = 0; i < stride; i += hn::Lanes(tag)) {
      auto sum = hn::Mul(hn::Load(tag, weights + i), hn::Set(tag, points[b]));
      for (std::size_t o = 1; o < window; ++o) {
        sum = hn::Add(sum, hn::Mul(hn::Load(tag, weights + stride * o + i), hn::Set(tag, points[b + o])));
      }
      store(sum, out + b * outputs + i);
    }
  }
}

template <class Store, class T>
HWY_INLINE void apply(Store store, const T* weights, std::size_t stride, std::size_t outputs,
                      std::size_t window, const T* points, std::size_t blocks, T* out) {
  const auto of_size = [&](auto size) {
    blocks_of_window(store, weights, stride, outputs, points, blocks, out, size);
  };
  switch (window) {
    case 1:
      return of_size(std::make_index_sequence<1>());
    case 2:
      return of_size(std::make_index_sequence<2>());
    case 3:
      return of_size(std::make_index_sequence<3>());
    case 4:
      return of_size(std::make_index_sequence<4>());
    case 5:
      return of_size(std::make_index_sequence<5>());
    case 6:
      return of_size(std::make_index_sequence<6>());
    case 7:
      return of_size(std::make_index_sequence<7>());
    case 8:
      return of_size(std::make_index_sequence<8>());
    default:
      return blocks_of_any_window(store, weights, stride, outputs, window, points, blocks, out);
  }
}

template <class T>
HWY_INLINE void copy(const T* HWY_RESTRICT from, std::size_t count, T* HWY_RESTRICT to) {
  const Tag<T> tag;
  const std::size_t lanes = hn::Lanes(tag);
  std::size_t i = 0;
  while (i < count && reinterpret_cast<std::uintptr_t>(to + i) % (lanes * sizeof(T)) != 0) {
    to[i] = from[i];
    ++i;
  }
  for (; i + lanes <= count; i += lanes) hn::Stream(hn::LoadU(tag, from + i), tag, to + i);
  for (; i < count; ++i) to[i] = from[i];
}

template <class T>
HWY_INLINE void add(const T* HWY_RESTRICT values, std::size_t count, T* HWY_RESTRICT lanes) {
  const Tag<T> tag;
  const std::size_t n = hn::Lanes(tag);
  const std::size_t whole = count / sum_lanes<T> * sum_lanes<T>;
  for (std::size_t lane = 0; lane < sum_lanes<T>; lane += 4 * n) {
    auto sum0 = hn::LoadU(tag, lanes + lane);
    auto sum1 = hn::LoadU(tag, lanes + lane + n);
    auto sum2 = hn::LoadU(tag, lanes + lane + 2 * n);
    auto sum3 = hn::LoadU(tag, lanes + lane + 3 * n);
    for (std::size_t i = lane; i < whole; i += sum_lanes<T>) {
      sum0 = hn::Add(sum0, hn::LoadU(tag, values + i));
      sum1 = hn::Add(sum1, hn::LoadU(tag, values + i + n));
      sum2 = hn::Add(sum2, hn::LoadU(tag, values + i + 2 * n));
      sum3 = hn::Add(sum3, hn::LoadU(tag, values + i + 3 * n));
    }
    hn::StoreU(sum0, tag, lanes + lane);
    hn::StoreU(sum1, tag, lanes + lane + n);
    hn::StoreU(sum2, tag, lanes + lane + 2 * n);
    hn::StoreU(sum3, tag, lanes + lane + 3 * n);
  }
  for (std::size_t i = whole; i < count; ++i) lanes[i - whole] += values[i];
}

// What the dispatch chooses among has no overloads.
void apply_double(const double* weights, std::size_t stride, std::size_t outputs, std::size_t window,
                  const double* points, std::size_t blocks, double* out) {
  apply(Cached<double>(), weights, stride, outputs, window, points, blocks, out);
}
void apply_past_caches_double(const double* weights, std::size_t stride, std::size_t window,
                              const double* points, std::size_t blocks, double* out) {
  apply(PastCaches<double>(), weights, stride, stride, window, points, blocks, out);
}
void apply_float(const float* weights, std::size_t stride, std::size_t outputs, std::size_t window,
                 const float* points, std::size_t blocks, float* out) {
  apply(Cached<float>(), weights, stride, outputs, window, points, blocks, out);
}
void apply_past_caches_float(const float* weights, std::size_t stride, std::size_t window,
                             const float* points, std::size_t blocks, float* out) {
  apply(PastCaches<float>(), weights, stride, stride, window, points, blocks, out);
}
void copy_double(const double* from, std::size_t count, double* to) { copy(from, count, to); }
void copy_float(const float* from, std::size_t count, float* to) { copy(from, count, to); }
void add_double(const double* values, std::size_t count, double* lanes) { add(values, count, lanes); }
void add_float(const float* values, std::size_t count, float* lanes) { add(values, count, lanes); }

}  // namespace HWY_NAMESPACE
}  // namespace subdiv::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace subdiv::detail {
HWY_EXPORT(apply_double);
HWY_EXPORT(apply_float);
HWY_EXPORT(apply_past_caches_double);
HWY_EXPORT(copy_double);
HWY_EXPORT(apply_past_caches_float);
HWY_EXPORT(copy_float);
HWY_EXPORT(add_double);
HWY_EXPORT(add_float);

void apply_table(const double* weights, std::size_t stride, std::size_t outputs, std::size_t window,
                 const double* points, std::size_t blocks, double* out) {
  HWY_DYNAMIC_DISPATCH(apply_double)(weights, stride, outputs, window, points, blocks, out);
}
void apply_table(const float* weights, std::size_t stride, std::size_t outputs, std::size_t window,
                 const float* points, std::size_t blocks, float* out) {
  HWY_DYNAMIC_DISPATCH(apply_float)(weights, stride, outputs, window, points, blocks, out);
}
void apply_table_past_caches(const double* weights, std::size_t stride, std::size_t window,
                             const double* points, std::size_t blocks, double* out) {
  HWY_DYNAMIC_DISPATCH(apply_past_caches_double)(weights, stride, window, points, blocks, out);
}
void copy_past_caches(const double* from, std::size_t count, double* to) {
  HWY_DYNAMIC_DISPATCH(copy_double)(from, count, to);
}
void apply_table_past_caches(const float* weights, std::size_t stride, std::size_t window,
                             const float* points, std::size_t blocks, float* out) {
  HWY_DYNAMIC_DISPATCH(apply_past_caches_float)(weights, stride, window, points, blocks, out);
}
void copy_past_caches(const float* from, std::size_t count, float* to) {
  HWY_DYNAMIC_DISPATCH(copy_float)(from, count, to);
}
void finish_stores() { hwy::FlushStream(); }
void add_to_lanes(const double* values, std::size_t count, double* lanes) {
  HWY_DYNAMIC_DISPATCH(add_double)(values, count, lanes);
}
void add_to_lanes(const float* values, std::size_t count, float* lanes) {
  HWY_DYNAMIC_DISPATCH(add_float)(values, count, lanes);
}
}  // namespace subdiv::detail
#endif
