#include "schemes/evaluate/parallel_chunks.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

TEST(ParallelChunks, EveryChunkOnce) {
  for (const int threads : {-1, 0, 1, 2, 7}) {
    for (const std::size_t chunks : {0U, 1U, 5U, 1000U}) {
      std::vector<std::atomic<int>> calls(chunks);
      for_each_chunk(chunks, threads, [&](std::size_t chunk) { ++calls[chunk]; });
      for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
    }
  }
}

TEST(ParallelChunks, ExceptionsReachTheCaller) {
  for (const int threads : {1, 3}) {
    std::atomic<int> calls = 0;
    EXPECT_THROW(for_each_chunk(100'000, threads,
                                [&](std::size_t chunk) {
                                  ++calls;
                                  if (chunk == 5) throw std::domain_error("chunk 5");
                                }),
                 std::domain_error);
    EXPECT_GE(calls, 6);
  }
}

}  // namespace
}  // namespace subdiv
