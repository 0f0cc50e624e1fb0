#pragma once

#include "schemes/algebra/ring.h"
#include "schemes/algebra/turn.h"

namespace subdiv {

/// A complex number x + i y over any ring: std::complex is defined for floating-point numbers alone.
template <class R>
struct PlaneNumber {
  R x = R(0);  ///< the real part
  R y = R(0);  ///< the imaginary part

  friend PlaneNumber operator+(const PlaneNumber& a, const PlaneNumber& b) { return {a.x + b.x, a.y + b.y}; }
  friend PlaneNumber operator-(const PlaneNumber& a, const PlaneNumber& b) { return {a.x - b.x, a.y - b.y}; }
  friend PlaneNumber operator*(const PlaneNumber& a, const PlaneNumber& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
  friend PlaneNumber operator*(const R& c, const PlaneNumber& a) { return {c * a.x, c * a.y}; }
};

/// x - i y.
template <class R>
PlaneNumber<R> conjugate(const PlaneNumber<R>& a) {
  return {a.x, R(0) - a.y};
}

/// The determinant of the columns a, b: the imaginary part of conj(a) b.
template <class R>
R determinant(const PlaneNumber<R>& a, const PlaneNumber<R>& b) {
  return a.x * b.y - a.y * b.x;
}

/// e^{2 pi i k/n}, n >= 1; k may be negative.
template <class R>
PlaneNumber<R> turn(int k, int n) {
  return {cosine_of_turn<R>(k, n), cosine_of_turn<R>(4 * k - n, 4 * n)};
}

}  // namespace subdiv
