#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {

/// Coefficients of x^0, x^1, .. in intervals.
using IntervalPolynomial = std::vector<Interval>;

/// p(x) by Horner's rule; encloses the values at all points of x.
[[nodiscard]] Interval value_at(const IntervalPolynomial& p, const Interval& x);

/// A family of real polynomials middle + t slope with |t| <= half_width, coefficient by coefficient each with
/// slopes of its own: a polynomial whose coefficients depend on a parameter, on an interval of it.
struct PolynomialFamily {
  IntervalPolynomial middle;          ///< at t = 0
  IntervalPolynomial slope;           ///< with respect to t
  Interval half_width = Interval(0);  ///< of the interval of t

  [[nodiscard]] int degree() const { return static_cast<int>(middle.size()) - 1; }
  /// Encloses the values of all at x.
  [[nodiscard]] Interval value(const Interval& x) const;
};

/// All complex roots of the midpoint polynomial, in double precision: not proved.
[[nodiscard]] std::vector<std::complex<double>> approximate_roots(const IntervalPolynomial& p);

/// Enclosures of all complex roots, by Arb, for quadratics by the formula; real roots are marked by the
/// imaginary part 0. Nothing when they cannot be isolated from each other.
[[nodiscard]] std::optional<std::vector<ComplexRoot>> enclosed_roots(const IntervalPolynomial& p);

/// Counts the roots of a family inside circles, with proof, from approximate roots z_j of the middle and q =
/// lead times the product of the x - z_j. (Each member may be scaled to the middle's leading coefficient.)
/// By discs: the roots of a member p of degree n lie in the discs around z_j of radius n |p(z_j)| /
/// |q'(z_j)|, as many in each connected part of their union as it has discs (Smith: Error bounds for zeros of
/// a polynomial based upon Gerschgorin's theorems, 1970). By Rouche, which multiple roots do not trouble: |p
/// - q| < |q| on the circle. By signs: one root alone beyond a smaller circle is real, and the signs at +-r
/// tell on which side of r it lies.
class RootCounter {
 public:
  /// fine: z_j to the precision of the intervals, else to that of doubles.
  RootCounter(PolynomialFamily p, bool fine);

  [[nodiscard]] const PolynomialFamily& family() const { return p_; }
  /// The sign of all members at x times that of their leading coefficients; 0 when not known.
  [[nodiscard]] int relative_sign(const Interval& x) const;

  /// |z_j|, largest first: not proved.
  [[nodiscard]] const std::vector<Interval>& moduli() const { return moduli_; }
  /// The number of roots of each member with |x| < radius; nothing when it is not proved.
  [[nodiscard]] std::optional<int> within(const Interval& radius) const;

  /// Is it proved that no member has a real root with |x| >= radius? (By discs that miss the real axis.)
  [[nodiscard]] bool complex_beyond(const Interval& radius) const;

 private:
  void find_discs();
  [[nodiscard]] std::optional<int> within_discs(const Interval& radius) const;
  [[nodiscard]] std::optional<int> within_by_distance(const Interval& radius) const;
  [[nodiscard]] std::optional<int> within_a_gap(const Interval& radius) const;

  PolynomialFamily p_;
  struct Point {
    Interval real;
    Interval imaginary;
    Interval modulus;
    Interval reach;  // radius of the disc
  };
  std::vector<Point> roots_;  // z_j, largest first
  std::vector<Interval> moduli_;
  IntervalPolynomial offset_;  // p - (the middle) is at most t times this, |t| <= width_
  Interval width_ = Interval(0);
  IntervalPolynomial deviation_;  // bounds of the coefficients of p - q
  Interval lead_ = Interval(0);
};

}  // namespace subdiv
