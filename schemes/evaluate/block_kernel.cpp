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

/// A copy in steps of one vector, each written where a vector of memory begins.
template <class T>
class Copier {
 public:
  HWY_INLINE explicit Copier(const Copy<T>& copy)
      : from_(copy.from), to_(copy.to), end_(copy.to + copy.count) {
    while (to_ != end_ && reinterpret_cast<std::uintptr_t>(to_) % (lanes * sizeof(T)) != 0) *to_++ = *from_++;
    last_ = end_ - static_cast<std::size_t>(end_ - to_) % lanes;
  }
  HWY_INLINE void step() {
    if (to_ == last_) return;
    hn::Stream(hn::LoadU(Tag<T>(), from_), Tag<T>(), to_);
    from_ += lanes;
    to_ += lanes;
  }
  HWY_INLINE void finish() {
    while (to_ != last_) step();
    while (to_ != end_) *to_++ = *from_++;
  }

 private:
  const T* HWY_RESTRICT from_;
  T* HWY_RESTRICT to_;
  T* end_;
  T* last_;
  const std::size_t lanes = hn::Lanes(Tag<T>());
};

template <class T>
class NoCopier {
 public:
  HWY_INLINE explicit NoCopier(const Copy<T>& /*copy*/) {}
  HWY_INLINE void step() const {}
  HWY_INLINE void finish() const {}
};

// Sums of terms in two chains, of even and of odd o, that are added at the end: the chains run side by side.
// Mul and Add, not MulAdd: see the header.

template <class T, class Lanes>
HWY_INLINE Lanes term(const T* HWY_RESTRICT weights, Lanes point) {
  return hn::Mul(hn::Load(Tag<T>(), weights), point);
}

template <class T, class Lanes>
HWY_INLINE Lanes two_chains(const T* HWY_RESTRICT /*weights*/, Lanes one, Lanes other) {
  return hn::Add(one, other);
}
/// The next term belongs to `one`, the one after it to `other`.
template <class T, class Lanes, class... Rest>
HWY_INLINE Lanes two_chains(const T* HWY_RESTRICT weights, Lanes one, Lanes other, Lanes point,
                            Rest... rest) {
  return two_chains(weights + line_values<T>, other, hn::Add(one, term(weights, point)), rest...);
}

template <class T, class Lanes>
HWY_INLINE Lanes weighted_sum(const T* HWY_RESTRICT weights, Lanes point) {
  return term(weights, point);
}
template <class T, class Lanes, class... Rest>
HWY_INLINE Lanes weighted_sum(const T* HWY_RESTRICT weights, Lanes point0, Lanes point1, Rest... rest) {
  constexpr std::size_t line = line_values<T>;
  return two_chains(weights + 2 * line, term(weights, point0), term(weights + line, point1), rest...);
}

/// One block: the points of its window are kept in registers.
template <class Copier, class T, class... Lanes>
HWY_INLINE void block(Copier& copier, const T* HWY_RESTRICT weights, std::size_t lines, T* HWY_RESTRICT out,
                      Lanes... points) {
  const Tag<T> tag;
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t lane = 0; lane < line_values<T>; lane += hn::Lanes(tag)) {
      hn::StoreU(weighted_sum(weights + lane, points...), tag, out + lane);
      copier.step();
    }
    weights += sizeof...(points) * line_values<T>;
    out += line_values<T>;
  }
}

template <class Copier, class T, std::size_t... o>
void blocks_of_window(const Copy<T>& copy, const BlockTable<T>& table, const T* HWY_RESTRICT points,
                      std::size_t blocks, T* HWY_RESTRICT out, std::index_sequence<o...> /*window*/) {
  const Tag<T> tag;
  const T* const weights = table.weights.data();
  const std::size_t lines = table.lines();
  const std::size_t outputs = table.outputs;
  Copier copier(copy);
  for (std::size_t b = 0; b < blocks; ++b)
    block(copier, weights, lines, out + b * outputs, hn::Set(tag, points[b + o])...);
  copier.finish();
}

template <class Copier, class T>
void blocks_of_any_window(const Copy<T>& copy, const BlockTable<T>& table, const T* HWY_RESTRICT points,
                          std::size_t blocks, T* HWY_RESTRICT out) {
  const Tag<T> tag;
  const auto window = static_cast<std::size_t>(table.window.size());
  const std::size_t lines = table.lines();
  Copier copier(copy);
  for (std::size_t b = 0; b < blocks; ++b) {
    const T* HWY_RESTRICT weights = table.weights.data();
    T* HWY_RESTRICT line_out = out + b * table.outputs;
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t lane = 0; lane < line_values<T>; lane += hn::Lanes(tag)) {
        const T* HWY_RESTRICT weight = weights + lane;
        auto one = term(weight, hn::Set(tag, points[b]));
        auto other = term(weight += line_values<T>, hn::Set(tag, points[b + 1]));
        for (std::size_t o = 2; o < window; ++o) {
          const auto next = hn::Add(one, term(weight += line_values<T>, hn::Set(tag, points[b + o])));
          one = other;
          other = next;
        }
        hn::StoreU(hn::Add(one, other), tag, line_out + lane);
        copier.step();
      }
      weights += window * line_values<T>;
      line_out += line_values<T>;
    }
  }
  copier.finish();
}

template <class Copier, class T>
HWY_INLINE void apply(const Copy<T>& copy, const BlockTable<T>& table, const T* points, std::size_t blocks,
                      T* out) {
  const auto of_size = [&](auto size) { blocks_of_window<Copier>(copy, table, points, blocks, out, size); };
  switch (table.window.size()) {
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
      return blocks_of_any_window<Copier>(copy, table, points, blocks, out);
  }
}

template <class T>
HWY_INLINE void apply_and_copy(const BlockTable<T>& table, const T* points, std::size_t blocks, T* out,
                               const Copy<T>& copy) {
  if (copy.count == 0) {
    apply<NoCopier<T>>(copy, table, points, blocks, out);
  } else {
    apply<Copier<T>>(copy, table, points, blocks, out);
  }
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
void apply_double(const BlockTable<double>& table, const double* points, std::size_t blocks, double* out,
                  const Copy<double>& copy) {
  apply_and_copy(table, points, blocks, out, copy);
}
void copy_double(const Copy<double>& copy) { Copier<double>(copy).finish(); }
void add_double(const double* values, std::size_t count, double* lanes) { add(values, count, lanes); }
void apply_float(const BlockTable<float>& table, const float* points, std::size_t blocks, float* out,
                 const Copy<float>& copy) {
  apply_and_copy(table, points, blocks, out, copy);
}
void copy_float(const Copy<float>& copy) { Copier<float>(copy).finish(); }
void add_float(const float* values, std::size_t count, float* lanes) { add(values, count, lanes); }

}  // namespace HWY_NAMESPACE
}  // namespace subdiv::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace subdiv::detail {
HWY_EXPORT(apply_double);
HWY_EXPORT(copy_double);
HWY_EXPORT(add_double);
HWY_EXPORT(apply_float);
HWY_EXPORT(copy_float);
HWY_EXPORT(add_float);

void apply_table(const BlockTable<double>& table, const double* points, std::size_t blocks, double* out,
                 const Copy<double>& copy) {
  HWY_DYNAMIC_DISPATCH(apply_double)(table, points, blocks, out, copy);
}
void copy_past_caches(const Copy<double>& copy) { HWY_DYNAMIC_DISPATCH(copy_double)(copy); }
void add_to_lanes(const double* values, std::size_t count, double* lanes) {
  HWY_DYNAMIC_DISPATCH(add_double)(values, count, lanes);
}

void apply_table(const BlockTable<float>& table, const float* points, std::size_t blocks, float* out,
                 const Copy<float>& copy) {
  HWY_DYNAMIC_DISPATCH(apply_float)(table, points, blocks, out, copy);
}
void copy_past_caches(const Copy<float>& copy) { HWY_DYNAMIC_DISPATCH(copy_float)(copy); }
void add_to_lanes(const float* values, std::size_t count, float* lanes) {
  HWY_DYNAMIC_DISPATCH(add_float)(values, count, lanes);
}

void finish_copies() { hwy::FlushStream(); }

}  // namespace subdiv::detail
#endif
