#pragma once

namespace subdiv {

/// Frees what FLINT and Arb keep for the calling thread: a thread that computes calls it at its end, or the
/// memory is lost. Numbers made in the thread live on.
void release_thread_caches();

}  // namespace subdiv
