#pragma once

#include <string>

namespace subdiv {

/// Words that the definitions of the experiment mesh-smoothness share.
inline const std::string eigenvalue_condition =
    "Eigenvalues at a vertex of valence n: 1 simple in mode 0, lambda real, positive and simple in mode 1, "
    "all others but lambda's double in mode n - 1 smaller in modulus (Reif 1995). ";
inline const std::string directional_scheme = "The directional extension of J_s. ";
inline const std::string literal_scheme = "(1-s) Kobbelt + s Catmull-Clark. ";

}  // namespace subdiv
