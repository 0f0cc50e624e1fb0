#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/jet.h"
#include "schemes/algebra/laurent.h"
#include "schemes/algebra/polynomial.h"
#include "schemes/algebra/rational.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/algebra/real.h"
#include "schemes/algebra/univariate.h"

namespace subdiv::testing {

using Generator = std::mt19937_64;

/// A whole number from lower to upper; the same on every platform, unlike std::uniform_int_distribution.
inline int random_int(Generator& generator, int lower, int upper) {
  return lower + static_cast<int>(generator() % static_cast<std::uint64_t>(upper - lower + 1));
}

inline Rational random_rational(Generator& generator) {
  return {random_int(generator, -30, 30), random_int(generator, 1, 12)};
}

/// A multiple of 1/8 so small that sums and products of three of them are exact in double.
inline Rational random_dyadic(Generator& generator) { return {random_int(generator, -40, 40), 8}; }

/// Random elements of a ring, and what "equal" can mean in it: equality where the ring decides it or where
/// the elements chosen make its arithmetic exact, overlap for intervals.
template <class R>
struct Samples;

template <>
struct Samples<Rational> {
  static Rational draw(Generator& generator) { return random_rational(generator); }
  static bool agree(const Rational& a, const Rational& b) { return a == b; }
};

template <>
struct Samples<double> {
  static double draw(Generator& generator) { return random_dyadic(generator).to_double(); }
  static bool agree(double a, double b) { return a == b; }
};

template <>
struct Samples<Real> {
  static Real draw(Generator& generator) { return from_rational<Real>(random_dyadic(generator)); }
  static bool agree(const Real& a, const Real& b) { return a == b; }
};

template <>
struct Samples<Interval> {
  static Interval draw(Generator& generator) { return Interval(random_rational(generator)); }
  static bool agree(const Interval& a, const Interval& b) { return a.overlaps(b); }
};

template <int N>
struct Samples<ceres::Jet<double, N>> {
  using Jet = ceres::Jet<double, N>;
  static Jet draw(Generator& generator) {
    Jet result(random_dyadic(generator).to_double());
    for (int i = 0; i < N; ++i) result.v[i] = random_dyadic(generator).to_double();
    return result;
  }
  static bool agree(const Jet& a, const Jet& b) { return a.a == b.a && a.v == b.v; }
};

template <>
struct Samples<UnivariatePolynomial> {
  static UnivariatePolynomial draw(Generator& generator) {
    std::vector<Rational> coefficients;
    for (int i = random_int(generator, 0, 4); i > 0; --i) coefficients.push_back(random_rational(generator));
    return UnivariatePolynomial(coefficients);
  }
  static bool agree(const UnivariatePolynomial& a, const UnivariatePolynomial& b) { return a == b; }
};

template <>
struct Samples<Polynomial> {
  static Polynomial draw(Generator& generator) {
    Polynomial result;
    for (int terms = random_int(generator, 0, 4); terms > 0; --terms) {
      Polynomial term(random_rational(generator));
      for (int factors = random_int(generator, 0, 3); factors > 0; --factors) {
        term *= Polynomial::variable(random_int(generator, 0, 2));
      }
      result += term;
    }
    return result;
  }
  static bool agree(const Polynomial& a, const Polynomial& b) { return a == b; }
};

template <>
struct Samples<RationalFunction> {
  static RationalFunction draw(Generator& generator) {
    const Polynomial above = Samples<Polynomial>::draw(generator);
    Polynomial below = Samples<Polynomial>::draw(generator);
    if (below.is_zero()) below = Polynomial(1);
    return RationalFunction(above) / RationalFunction(below);
  }
  static bool agree(const RationalFunction& a, const RationalFunction& b) { return a == b; }
};

/// Numbers p + q sqrt(2): a field of its own, so that degrees stay small.
template <>
struct Samples<Algebraic> {
  static Algebraic draw(Generator& generator) {
    return Algebraic(random_rational(generator)) + Algebraic(random_rational(generator)) * sqrt(Algebraic(2));
  }
  static bool agree(const Algebraic& a, const Algebraic& b) { return a == b; }
};

template <class R>
struct Samples<Laurent<R>> {
  static Laurent<R> draw(Generator& generator) {
    std::vector<R> coefficients;
    for (int i = random_int(generator, 0, 4); i > 0; --i) coefficients.push_back(Samples<R>::draw(generator));
    return Laurent<R>(random_int(generator, -3, 3), std::move(coefficients));
  }
  static bool agree(const Laurent<R>& a, const Laurent<R>& b) {
    for (int i = std::min(a.first(), b.first()); i <= std::max(a.last(), b.last()); ++i) {
      if (!Samples<R>::agree(a[i], b[i])) return false;
    }
    return true;
  }
};

}  // namespace subdiv::testing
