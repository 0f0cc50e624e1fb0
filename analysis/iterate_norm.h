#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include "analysis/enclosure.h"
#include "schemes/algebra/laurent.h"
#include "schemes/algebra/matrix.h"
#include "schemes/algebra/ring.h"
#include "schemes/mask.h"

// Norms of the iterates of a difference scheme (Warren & Weimer, Subdivision Methods for Geometric Design,
// 2002, p. 77; Rossignac & Schaefer, J-splines, section 3). Let d(z) = sum d_i z^i be the difference symbol
// of a scheme of arity m, and
//
//   D_k(z) = d(z) d(z^m) ... d(z^(m^(k-1))),    norm_k = max over 0 <= r < m^k of  sum over l of |(D_k)_{r +
//   m^k l}|,
//
// the infinity norm of k steps of the difference scheme at once. The scheme is C^c when norm_k < 1 for one k.
// Norms are submultiplicative: norm_{i+j} <= norm_i norm_j.
//
// The residue classes form a tree. With d_0 its lowest coefficient and v(r) in R^n the vector (D_k)_{r + m^k
// l}, 0 <= l < n,
//
//   v(r + m^k e) = A_e v(r),   (A_e)_{l j} = d_{e + m l - j},   0 <= e < m,   v = (1, 0, .., 0) for k = 0,
//
// and the largest column sum of |A_{e_k} .. A_{e_1}| over all words is norm_k again.

namespace subdiv {

/// d(z) = m^c a(z) / (1 + z + .. + z^(m-1))^(c+1), which refines the differences of the c-th divided
/// differences, for continuity C^c, c >= 0 (std::domain_error); nothing when the division is not exact.
template <ExactRing R>
std::optional<Laurent<R>> difference_symbol(const Mask<R>& mask, int continuity) {
  if (continuity < 0) throw std::domain_error("the order of continuity is at least 0");
  Laurent<R> scale(1);
  for (int i = 0; i < continuity; ++i) scale *= Laurent<R>(mask.arity);
  return divide_exactly(scale * mask.symbol, pow(smoothing_factor<R>(mask.arity), continuity + 1));
}

/// The length n of the class vectors: the classes modulo m^k of D_k never have more than n coefficients.
template <class R>
int class_size(const Laurent<R>& d, int arity) {
  return std::max(1, (d.size() - 1 + arity - 2) / (arity - 1));
}

/// A_0 .. A_{m-1}, n x n: (A_e)_{l j} = d_{first + e + m l - j}.
template <class R>
std::vector<Matrix<R>> class_matrices(const Laurent<R>& d, int arity) {
  const int n = class_size(d, arity);
  std::vector<Matrix<R>> result;
  for (int e = 0; e < arity; ++e) {
    Matrix<R> a = zero_matrix<R>(n, n);
    for (int l = 0; l < n; ++l) {
      for (int j = 0; j < n; ++j) a(l, j) = d[d.first() + e + arity * l - j];
    }
    result.push_back(std::move(a));
  }
  return result;
}

namespace detail {

template <class R>
R one_norm(const Vector<R>& v) {
  R sum(0);
  for (Eigen::Index i = 0; i < v.size(); ++i) sum = sum + abs(v(i));
  return sum;
}

/// Raises best to the largest norm of a class below the vector v, `left` levels down. norms[i] = norm_i for i
/// < k, so that no class below v can pass |v| norms[left].
template <class R>
void raise_to_norm(const std::vector<Matrix<R>>& a, const std::vector<R>& norms, std::size_t left,
                   const Vector<R>& v, R& best) {
  const R norm = one_norm(v);
  if (left == 0) {
    if (best < norm) best = norm;
    return;
  }
  if (left < norms.size() && !(best < norm * norms[left])) return;
  for (const Matrix<R>& step : a) raise_to_norm(a, norms, left - 1, Vector<R>(step * v), best);
}

}  // namespace detail

/// norm_0 = 1, norm_1, .., norm_k, exact, over an ordered exact field (rationals, real algebraic numbers).
/// Subtrees that cannot reach the maximum are left out, but the worst case stays m^k vectors: for moderate k.
template <ExactRing R>
std::vector<R> iterate_norms(const Laurent<R>& d, int arity, int k) {
  if (k < 0) throw std::domain_error("the power of an iterate is at least 0");
  const std::vector<Matrix<R>> a = class_matrices(d, arity);
  Vector<R> start = Vector<R>::Constant(a[0].rows(), R(0));
  start(0) = R(1);
  std::vector<R> norms{R(1)};
  for (int i = 1; i <= k; ++i) {
    R best(0);
    detail::raise_to_norm(a, norms, static_cast<std::size_t>(i), start, best);
    norms.push_back(best);
  }
  return norms;
}

/// norm_k, certified: all m^k classes in double arithmetic, tile by tile, with a proven bound of the rounding
/// errors. Memory is megabytes; time grows like m^k (m^k <= 2^36, std::domain_error). The width is a small
/// multiple of k n 2^-53 times products of norm_i.
[[nodiscard]] Enclosure iterate_norm_enclosure(const Laurent<Rational>& d, int arity, int k);

}  // namespace subdiv
