#pragma once

#include <cstddef>
#include <functional>

namespace subdiv {

/// Calls work(chunk) once for each 0 <= chunk < chunks, on up to `threads` threads (the caller's among them;
/// at least one), in no particular order. The first exception of any call ends the others' taking of chunks
/// and is thrown here, as is std::system_error when a thread cannot be started.
void for_each_chunk(std::size_t chunks, int threads, const std::function<void(std::size_t)>& work);

}  // namespace subdiv
