#include "analysis/circle_crossings.h"

#include <cstddef>

#include "analysis/eigenvalues.h"
#include "analysis/real_set.h"

namespace subdiv {
namespace {

/// x^n p(radius^2 / x): its roots are those of p mirrored at the circle of this radius.
Polynomial mirrored(const Polynomial& p, const Rational& radius) {
  const std::vector<Polynomial> c = p.coefficients_in(eigenvalue_variable);
  const std::size_t n = c.size() - 1;
  Polynomial result;
  for (std::size_t i = 0; i <= n; ++i) {
    result += c[i] * Polynomial(pow(radius, 2 * static_cast<long>(i))) *
              pow(Polynomial::variable(eigenvalue_variable), static_cast<unsigned>(n - i));
  }
  return result;
}

}  // namespace

Polynomial at_eigenvalue(const Polynomial& p, const Rational& value) {
  return p.substitute(eigenvalue_variable, Polynomial(value));
}

void append_crossings(const Polynomial& factor, const Rational& radius, int parameter,
                      std::vector<Algebraic>& critical) {
  append_real_roots(at_eigenvalue(factor, radius), parameter, critical);
  append_real_roots(at_eigenvalue(factor, -radius), parameter, critical);
  if (factor.degree(eigenvalue_variable) > 1) {
    append_real_roots(resultant(factor, mirrored(factor, radius), eigenvalue_variable), parameter, critical);
  }
}

}  // namespace subdiv
