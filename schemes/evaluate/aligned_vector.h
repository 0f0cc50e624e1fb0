#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace subdiv {

/// A cache line, which is also the widest vector register in use.
inline constexpr std::size_t cache_line = 64;

/// Memory that begins at a cache line.
template <class T>
struct CacheLineAllocator {
  /// What allocators name their elements' type.
  using value_type = T;
  CacheLineAllocator() = default;
  /// From one of other elements: allocators have no state.
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}
  /// Memory for n elements; throws std::bad_alloc.
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(cache_line)));
  }
  /// Gives memory for n elements back.
  void deallocate(T* p, std::size_t /*n*/) { ::operator delete(p, std::align_val_t(cache_line)); }
  friend bool operator==(const CacheLineAllocator& /*a*/, const CacheLineAllocator& /*b*/) { return true; }
};

/// A vector whose elements begin at a cache line.
template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace subdiv
