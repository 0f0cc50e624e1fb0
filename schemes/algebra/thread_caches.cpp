#include "schemes/algebra/thread_caches.h"

#include <flint/flint.h>

namespace subdiv {

void release_thread_caches() { flint_cleanup(); }

}  // namespace subdiv
