#include "schemes/evaluate/parallel_chunks.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace subdiv {

void for_each_chunk(std::size_t chunks, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex failing;
  std::exception_ptr failure;
  const auto take_chunks = [&] {
    try {
      for (std::size_t chunk = next++; chunk < chunks; chunk = next++) work(chunk);
    } catch (...) {
      next = chunks;
      const std::scoped_lock lock(failing);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    const std::size_t most = std::min(static_cast<std::size_t>(std::max(threads, 1)), chunks);
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < most; ++i) others.emplace_back(take_chunks);
    take_chunks();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace subdiv
