#pragma once

#include <vector>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// p at the eigenvalue x_7 = value (eigenvalues.h).
[[nodiscard]] Polynomial at_eigenvalue(const Polynomial& p, const Rational& value);

/// Appends the values of the parameter x_i at which a root of an irreducible factor of a characteristic
/// polynomial may cross the circle |x| = radius: where the factor vanishes at +-radius, or has a common root
/// with its mirror image at the circle. A factor that is its own mirror image has a root on or outside the
/// circle everywhere and adds nothing.
void append_crossings(const Polynomial& factor, const Rational& radius, int parameter,
                      std::vector<Algebraic>& critical);

}  // namespace subdiv
