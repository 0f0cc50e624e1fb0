#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace subdiv {

/// Memory for large results that are written once, from first to last: elements are not initialised (so that
/// memory is not written twice), and large pages are asked for (touching fresh memory page by small page
/// costs more than the arithmetic that fills it).
template <class T>
struct FreshAllocator {
  /// What allocators name their elements' type.
  using value_type = T;
  /// 2 MiB: memory of this size on is aligned to it.
  static constexpr std::size_t large_page = std::size_t{1} << 21U;

  FreshAllocator() = default;
  /// From one of other elements: allocators have no state.
  template <class U>
  FreshAllocator(const FreshAllocator<U>& /*other*/) {}

  /// Memory for n elements; throws std::bad_alloc.
  T* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    void* const memory = ::operator new(bytes, alignment(bytes));
#ifdef __linux__
    // An advice: where it is not taken, nothing is lost.
    if (bytes >= large_page) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
    return static_cast<T*>(memory);
  }
  /// Gives memory for n elements back.
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n * sizeof(T))); }

  /// Leaves an element of a trivial type as it is.
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  /// Constructs an element from arguments.
  template <class U, class... Arguments>
  void construct(U* p, Arguments&&... arguments) {
    std::construct_at(p, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const FreshAllocator& /*a*/, const FreshAllocator& /*b*/) { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t(bytes >= large_page ? large_page : alignof(std::max_align_t));
  }
};

/// A vector whose resize() leaves new elements of trivial types uninitialised.
template <class T>
using FreshVector = std::vector<T, FreshAllocator<T>>;

}  // namespace subdiv
