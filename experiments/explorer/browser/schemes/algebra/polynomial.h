#pragma once

// Stands in for the header of the same name in the browser, where there is no FLINT: the ring is only named
// there.

#include "schemes/algebra/rational.h"

namespace subdiv {
class Polynomial {};

}  // namespace subdiv
