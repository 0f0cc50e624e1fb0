#pragma once

// Stands in for the header of the same name in the browser, where there is no FLINT: the ring is only named
// there.

#include "schemes/algebra/polynomial.h"

namespace subdiv {
class RationalFunction {};
}  // namespace subdiv
