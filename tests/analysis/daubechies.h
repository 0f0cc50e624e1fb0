#pragma once

#include <acb_poly.h>

#include "analysis/transition_matrices.h"
#include "schemes/algebra/univariate.h"

namespace subdiv::testing {

/// The low-pass symbol of Daubechies of order n (2n taps), from its definition (Ten Lectures on Wavelets,
/// 1992, section 6.1): 2 ((1+z)/2)^n b(z), where b(z) b(1/z) = P(y), y = (2 - z - 1/z) / 4, P(y) = sum over k
/// < n of C(n-1+k, k) y^k, and b has the roots outside the unit circle. (The reversed choice has the same
/// smoothness.)
inline NormalForm<Interval> daubechies(int n, long precision = 256) {
  std::vector<Rational> p{Rational(1)};
  for (int k = 1; k < n; ++k) p.push_back(p.back() * Rational(n - 1 + k, k));
  acb_poly_t b;
  acb_poly_t linear;
  acb_poly_init(b);
  acb_poly_init(linear);
  acb_poly_one(b);
  acb_t y;
  acb_t z;
  acb_t other;
  acb_init(y);
  acb_init(z);
  acb_init(other);
  for (const ComplexRoot& root : complex_roots(UnivariatePolynomial(p), precision)) {
    // z^2 + (4y - 2) z + 1 = 0: z = 1 - 2y +- 2 sqrt(y^2 - y).
    acb_set_arb_arb(y, root.real.raw(), root.imaginary.raw());
    acb_mul(z, y, y, precision);
    acb_sub(z, z, y, precision);
    acb_sqrt(z, z, precision);
    acb_mul_2exp_si(z, z, 1);
    acb_mul_2exp_si(y, y, 1);
    acb_sub_ui(y, y, 1, precision);
    acb_neg(other, z);
    acb_sub(z, z, y, precision);
    acb_sub(other, other, y, precision);
    arb_t size;
    arb_init(size);
    acb_abs(size, z, precision);
    arb_sub_ui(size, size, 1, precision);
    if (arb_is_negative(size) != 0) acb_swap(z, other);
    arb_clear(size);
    // (x - z) / (1 - z)
    acb_poly_set_coeff_si(linear, 1, 1);
    acb_neg(other, z);
    acb_poly_set_coeff_acb(linear, 0, other);
    acb_add_ui(other, other, 1, precision);
    acb_poly_scalar_div(linear, linear, other, precision);
    acb_poly_mul(b, b, linear, precision);
  }
  std::vector<Interval> coefficients;
  for (long i = 0; i < acb_poly_length(b); ++i) {
    Interval c = Interval(0).with_precision(precision);
    acb_poly_get_coeff_acb(y, b, i);
    arb_set(c.raw(), acb_realref(y));
    coefficients.push_back(c);
  }
  acb_clear(y);
  acb_clear(z);
  acb_clear(other);
  acb_poly_clear(b);
  acb_poly_clear(linear);
  return {2, n, 0, Laurent<Interval>(0, coefficients)};
}

}  // namespace subdiv::testing
