#pragma once

#include <stdexcept>
#include <vector>

#include "schemes/algebra/matrix.h"
#include "schemes/mask.h"

namespace subdiv {

namespace detail {

/// Coefficients c_n = sum over i - j = n of a_i b_j of the product a(z) b(1/z).
template <class R>
Laurent<R> correlation(const Mask<R>& a, const Mask<R>& b) {
  if (a.arity != b.arity) throw std::domain_error("inner products need masks of the same arity");
  return a.symbol * reverse(b.symbol);
}

/// factor * sum over n of c_n g_{m k - n}, for all k.
template <class R>
Laurent<R> refine_inner_products(const Laurent<R>& c, const Laurent<R>& g, int arity, const R& factor) {
  return factor * residue_class(c * g, 0, arity);
}

}  // namespace detail

/// g_k = integral of phi(t) psi^(d)(t - k) dt for the basis functions phi, psi of two stationary schemes of
/// arity m whose integrals are 1; d = 0 or 1. By the refinement equations g_k = m^(d-1) sum over n of c_n
/// g_{m k - n} with c = a(z) b(1/z), so g is the eigenvector for m^(1-d) of a finite matrix, normalised by
/// sum g_k = 1 (d = 0) or sum k g_k = 1 and sum g_k = 0 (d = 1). Exact over any exact field (Warren & Weimer,
/// Subdivision Methods for Geometric Design, p. 165). The schemes must converge, for d = 1 psi to a C^1 limit
/// or a B-spline of degree 1 at least; throws std::domain_error when the equations do not determine g.
template <ExactRing R>
Laurent<R> inner_products(const Mask<R>& phi, const Mask<R>& psi, int derivative = 0) {
  if (derivative != 0 && derivative != 1)
    throw std::domain_error("inner products: derivative must be 0 or 1");
  const int m = phi.arity;
  const Laurent<R> c = detail::correlation(phi, psi);
  // psi and phi live on [first, last] / (m - 1), so g lives on [c.first, c.last] / (m - 1).
  const int low = -floor_divide(-c.first(), m - 1);
  const int high = floor_divide(c.last(), m - 1);
  const Eigen::Index n = high - low + 1;
  const Eigen::Index conditions = derivative + 1;
  Matrix<R> system = zero_matrix<R>(n + conditions, n);
  Vector<R> right = Vector<R>::Constant(n + conditions, R(0));
  const R eigenvalue = derivative == 0 ? R(m) : R(1);
  for (int k = low; k <= high; ++k) {
    for (int l = low; l <= high; ++l) {
      const R entry = c[m * k - l];
      system(k - low, l - low) = k == l ? entry - eigenvalue : entry;
    }
    system(n, k - low) = R(1);
    if (derivative == 1) system(n + 1, k - low) = R(k);
  }
  right(n + derivative) = R(1);
  const auto g = solve(system, right);
  if (!g) throw std::domain_error("inner products: the refinement equations do not determine them");
  return Laurent<R>(low, std::vector<R>(g->data(), g->data() + n));
}

/// The same for any two schemes of one arity: steps before the repeating ones refine the inner products of
/// the rest, g_k = m^(d-1) sum of c_n g'_{m k - n}.
template <ExactRing R>
Laurent<R> inner_products(const Scheme<R>& phi, const Scheme<R>& psi, int derivative = 0) {
  Laurent<R> g = inner_products(phi.last(), psi.last(), derivative);
  const std::size_t steps = std::max(phi.steps.size(), psi.steps.size()) - 1;
  const int m = phi.arity();
  const R factor = derivative == 0 ? fraction<R>(1, m) : R(1);
  for (std::size_t k = steps; k-- > 0;) {
    g = detail::refine_inner_products(detail::correlation(phi.step(k), psi.step(k)), g, m, factor);
  }
  return g;
}

}  // namespace subdiv
