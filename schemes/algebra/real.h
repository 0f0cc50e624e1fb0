#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// A floating-point number of 100 decimal digits: for solving in high precision. Never a proof; Interval is.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                           boost::multiprecision::et_off>;

template <>
struct RingTraits<Real> {
  static constexpr bool exact = false;
  static Real from_rational(const Rational& q) {
    mpq_t raw;
    mpq_init(raw);
    fmpq_get_mpq(raw, q.raw());
    Real result;
    mpfr_set_q(result.backend().data(), raw, MPFR_RNDN);
    mpq_clear(raw);
    return result;
  }
  static bool is_zero(const Real& x) { return x == 0; }
};

/// The exact value of a finite Real.
inline Rational to_rational(const Real& x) {
  mpz_t mantissa;
  mpz_init(mantissa);
  const long exponent = mpfr_get_z_2exp(mantissa, x.backend().data());
  Rational result;
  fmpz_set_mpz(fmpq_numref(result.raw()), mantissa);
  mpz_clear(mantissa);
  return result.sign() == 0 ? result : result * Rational::power_of_two(exponent);
}

}  // namespace subdiv
