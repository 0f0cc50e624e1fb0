#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// A power series in u cut off after N terms, c_0 + c_1 u + .. + c_{N-1} u^(N-1): the ring R[u] / u^N.
/// Evaluating a formula at x + u gives the Taylor coefficients f^(k)(x) / k!; over intervals, c_{N-1} at a
/// ball encloses f^(N-1) / (N-1)! on all of it, which is the remainder of Taylor's theorem.
template <class R, std::size_t N>
struct Taylor {
  std::array<R, N> c{};  ///< c_0 .. c_{N-1}

  Taylor() : Taylor(0) {}
  /// A constant.
  Taylor(int n) {
    c.fill(R(0));
    c[0] = R(n);
  }
  /// A constant: no power of u.
  static Taylor constant(R value) {
    Taylor result;
    result.c[0] = std::move(value);
    return result;
  }
  /// x + u.
  static Taylor variable(R x) {
    Taylor result = constant(std::move(x));
    if constexpr (N > 1) result.c[1] = R(1);
    return result;
  }

  Taylor& operator+=(const Taylor& o) {
    for (std::size_t k = 0; k < N; ++k) c[k] += o.c[k];
    return *this;
  }
  Taylor& operator-=(const Taylor& o) {
    for (std::size_t k = 0; k < N; ++k) c[k] -= o.c[k];
    return *this;
  }
  Taylor& operator*=(const Taylor& o) {
    Taylor product;
    add_product(product, *this, o);
    return *this = std::move(product);
  }
  /// sum += a b.
  friend void add_product(Taylor& sum, const Taylor& a, const Taylor& b) {
    for (std::size_t j = 0; j < N; ++j) {
      if (RingTraits<R>::is_zero(a.c[j])) continue;
      for (std::size_t k = j; k < N; ++k) add_product(sum.c[k], a.c[j], b.c[k - j]);
    }
  }
  /// o.c[0] must be invertible.
  Taylor& operator/=(const Taylor& o) {
    for (std::size_t k = 0; k < N; ++k) {
      for (std::size_t j = 1; j <= k; ++j) c[k] -= c[k - j] * o.c[j];
      c[k] /= o.c[0];
    }
    return *this;
  }
  friend Taylor operator+(Taylor a, const Taylor& b) { return a += b; }
  friend Taylor operator-(Taylor a, const Taylor& b) { return a -= b; }
  friend Taylor operator*(Taylor a, const Taylor& b) { return a *= b; }
  friend Taylor operator/(Taylor a, const Taylor& b) { return a /= b; }
  friend bool operator==(const Taylor&, const Taylor&) = default;
};

template <class R, std::size_t N>
struct RingTraits<Taylor<R, N>> {
  static constexpr bool exact = RingTraits<R>::exact;
  static Taylor<R, N> from_rational(const Rational& q) {
    return Taylor<R, N>::constant(RingTraits<R>::from_rational(q));
  }
  static bool is_zero(const Taylor<R, N>& x) {
    for (const R& value : x.c) {
      if (!RingTraits<R>::is_zero(value)) return false;
    }
    return true;
  }
};

}  // namespace subdiv
